"""From the months, days and hours of a weather file to moments on one calendar."""

from __future__ import annotations

from calendar import isleap, monthrange
from datetime import date

import numpy as np
import numpy.typing as npt
import pandas as pd

from clerestory.weather.lines import Lines

Integers = npt.NDArray[np.int64]

WEEKDAYS = ("monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday")

_LATEST = 2023
"""Years for typical weather are sought from here back."""


def typical_year(*, leap: bool, first_weekday: int | None) -> int:
    """The latest year up to 2023 with or without a leap day whose 1 January falls on a weekday (0 Monday)."""
    return next(
        year
        for year in range(_LATEST, _LATEST - 29, -1)
        if isleap(year) == leap and first_weekday in (None, date(year, 1, 1).weekday())
    )


def check_dates(lines: Lines, numbers: Integers, months: Integers, days: Integers) -> None:
    """Raises at the first line whose day no calendar has."""
    for month, day in sorted(set(zip(months.tolist(), days.tolist(), strict=True))):
        if not (1 <= month <= 12 and 1 <= day <= monthrange(2000, month)[1]):
            line = int(numbers[np.argmax((months == month) & (days == day))])
            raise lines.wrong(line, f"month and day must be a date, got month {month}, day {day}")


def one_calendar(
    years: Integers | None, months: Integers, days: Integers, first_weekday: int | None
) -> tuple[Integers, tuple[str, ...]]:
    """The year of each row: the file's own if they are one stretch of time, else one for all, as for typical weather.

    Returns
    -------
    years : ndarray of int
    notes : tuple of str
    """
    leap = bool(((months == 2) & (days == 29)).any())
    if years is not None:
        moments = _days(years, months, days)
        real = not leap or all(isleap(int(year)) for year in set(years[(months == 2) & (days == 29)].tolist()))
        if real and (np.diff(moments) >= 0).all() and moments[-1] - moments[0] <= 366:
            return years, ()
    year = typical_year(leap=leap, first_weekday=first_weekday)
    known = "" if years is None else f" of {years.min()} to {years.max()}"
    reason = "no years in the file" if years is None else f"months{known} put together"
    begins = WEEKDAYS[date(year, 1, 1).weekday()].capitalize()
    note = f"{reason}: dated {year}, which begins on a {begins}" + (", with 29 February" if leap else "")
    return np.full_like(months, year), (note,)


def moments(
    lines: Lines, numbers: Integers, years: Integers, months: Integers, days: Integers, minutes: npt.ArrayLike
) -> pd.DatetimeIndex:
    """Moments without a zone, ``minutes`` after midnight of each date; raises where time does not go forward."""
    seconds = np.round(np.asarray(minutes, dtype=np.float64) * 60.0).astype("timedelta64[s]")
    dates = _days(years, months, days).astype("datetime64[D]").astype("datetime64[s]")
    index = pd.DatetimeIndex(dates + seconds).as_unit("ns")
    steps = np.diff(index.to_numpy())
    wrong = steps <= np.timedelta64(0, "s")
    if wrong.any():
        row = int(np.argmax(wrong)) + 1
        kind = "repeats" if steps[row - 1] == np.timedelta64(0, "s") else "comes after"
        raise lines.wrong(
            int(numbers[row]),
            f"times must go forward, got {index[row]:%d %B %H:%M}, which {kind} "
            f"{'the row before' if kind == 'repeats' else f'{index[row - 1]:%d %B %H:%M}'}; remove or sort rows",
        )
    return index


def _days(years: Integers, months: Integers, days: Integers) -> Integers:
    """Days since 1970."""
    month = ((years - 1970) * 12 + months - 1).astype("datetime64[M]").astype("datetime64[D]")
    return month.astype(np.int64) + days - 1


def zone_name(offset_hours: float) -> str:
    """An offset as a time zone, such as -5.5 as "-05:30"."""
    minutes = round(abs(offset_hours) * 60)
    return f"{'-' if offset_hours < 0 else '+'}{minutes // 60:02d}:{minutes % 60:02d}"
