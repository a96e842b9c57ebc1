"""When a room is in use, by the clock on its wall."""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import date, timedelta
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.rules import one_of

DAYS = ("monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday")

_SPAN = re.compile(r"(\d{1,2}):(\d\d)\s*-\s*(\d{1,2}):(\d\d)")
_DAY = re.compile(r"(?:(\d{4})-)?(\d\d)-(\d\d)")
_YEAR_WITH_LEAP_DAY = 2000


def _minutes(span: str) -> tuple[int, int]:
    """Minutes of the day from which and before which a span counts."""
    found = _SPAN.fullmatch(span.strip())
    if found is None:
        raise ClerestoryError(f'hours of a schedule must be spans such as "08:00-18:00", got {span!r}')
    first, first_minute, last, last_minute = (int(part) for part in found.groups())
    start, end = first * 60 + first_minute, last * 60 + last_minute
    if first_minute > 59 or last_minute > 59 or not 0 <= start < end <= 24 * 60:
        raise ClerestoryError(
            f"hours of a schedule must begin before they end on one day (00:00-24:00), got {span!r}; "
            "split a night into two spans"
        )
    return start, end


def _holiday(text: str) -> tuple[tuple[int | None, int, int], tuple[int | None, int, int]]:
    ends = []
    for part in text.split("/"):
        found = _DAY.fullmatch(part.strip())
        if found is None:
            break
        year, month, day = (None if group is None else int(group) for group in found.groups())
        try:
            date(year or _YEAR_WITH_LEAP_DAY, month or 0, day or 0)
        except ValueError:
            break
        ends.append((year, int(month or 0), int(day or 0)))
    if len(ends) != text.count("/") + 1 or len(ends) > 2 or (ends[0][0] is None) != (ends[-1][0] is None):
        raise ClerestoryError(
            f'holidays of a schedule must be days such as "12-25" or "2024-12-25", or two with / between, got {text!r}'
        )
    return ends[0], ends[-1]


@dataclass(frozen=True, kw_only=True)
class Schedule:
    """When a room is in use, by the clock on its wall.

    Parameters
    ----------
    hours : sequence of str, default ("08:00-18:00",)
        Spans of clock time; the end does not count, and may be 24:00. Each begins and ends on one day.
    days : sequence of str, default Monday to Friday
        In English, such as ``"monday"``.
    holidays : sequence of str
        Days not worked: ``"2024-06-24"`` once, ``"12-25"`` each year, ``"12-20/01-31"`` from one to the other, both
        counting.
    clock : str, optional
        Time zone of the wall clock, such as ``"America/New_York"``: its summer time is kept. Default the zone of the
        times themselves, which for weather files is standard time all the year.
    year : int, 1583..9999, optional
        Calendar year that the times are taken to be of, so that a typical year put together from many has one
        calendar. Default each time's own.

    Raises
    ------
    ClerestoryError
        If a span, a day or the clock cannot be understood.
    """

    hours: tuple[str, ...] = ("08:00-18:00",)
    days: tuple[str, ...] = DAYS[:5]
    holidays: tuple[str, ...] = ()
    clock: str | None = None
    year: int | None = None

    def __post_init__(self) -> None:
        for name in ("hours", "days", "holidays"):
            given = getattr(self, name)
            if isinstance(given, str) or not all(isinstance(one, str) for one in given):
                raise ClerestoryError(f"{name} of a schedule must be a list of texts, got {given!r}")
            object.__setattr__(self, name, tuple(given))
        for span in self.hours:
            _minutes(span)
        for day in self.days:
            one_of("days of a schedule", day, DAYS)
        for holiday in self.holidays:
            _holiday(holiday)
        if self.clock is not None:
            try:
                pd.Timestamp("2000-01-01").tz_localize(self.clock)
            except Exception as cause:
                raise ClerestoryError(
                    f'clock of a schedule must be a time zone such as "America/New_York", got {self.clock!r}'
                ) from cause
        if self.year is not None and (isinstance(self.year, bool) or not 1583 <= self.year <= 9999):
            raise ClerestoryError(f"year of a schedule must lie in 1583..9999, got {self.year!r}")

    @property
    def description(self) -> str:
        """The schedule in words."""
        parts = [", ".join(self.hours), "every day" if set(self.days) == set(DAYS) else ", ".join(self.days)]
        parts.append(f"clock of {self.clock}" if self.clock else "standard time")
        if self.holidays:
            parts.append("without " + ", ".join(self.holidays))
        return "; ".join(parts)


ANALYSIS_HOURS = Schedule(days=DAYS)
"""8 to 18 h of every day, 3650 hours: those of sDA and ASE (IES LM-83). Give it the ``clock`` of the place."""


def occupied_hours(times: Any, schedule: Schedule = ANALYSIS_HOURS) -> xr.DataArray:
    """Whether each interval falls in the hours of use.

    Parameters
    ----------
    times : DatetimeIndex with a zone
        Middle of each interval, such as ``weather.frame.index``: an interval counts if its middle does.
    schedule : Schedule, default `ANALYSIS_HOURS`

    Returns
    -------
    DataArray of bool, dims ("time",)
        `time` is in UTC without a zone, as everywhere; `local_time` the clock on the wall.

    Raises
    ------
    ClerestoryError
        If the times have no zone, or the 29th of February is asked of a year without one.
    """
    index = pd.DatetimeIndex(times)
    if index.tz is None:
        raise ClerestoryError("times of a schedule must have a time zone, got none; tz_localize them")
    wall = _in_year(index, schedule.year)
    if schedule.clock is not None:
        wall = wall.tz_convert(schedule.clock)
    minute = np.asarray(wall.hour * 60 + wall.minute)
    within = np.zeros(len(wall), dtype=bool)
    for span in schedule.hours:
        start, end = _minutes(span)
        within |= (minute >= start) & (minute < end)
    within &= np.isin(np.asarray(wall.day_of_week), [DAYS.index(day) for day in schedule.days])
    for holiday in schedule.holidays:
        within &= ~_on(holiday, wall)
    return xr.DataArray(
        within,
        dims="time",
        coords={
            "time": index.tz_convert("UTC").tz_localize(None).to_numpy().astype("datetime64[ns]"),
            "local_time": ("time", wall.tz_localize(None).to_numpy().astype("datetime64[ns]")),
        },
        attrs={"long_name": "in use", "schedule": schedule.description},
    )


def _in_year(index: pd.DatetimeIndex, year: int | None) -> pd.DatetimeIndex:
    if year is None or (index.year == year).all():
        return index
    leap_day = (index.month == 2) & (index.day == 29)
    if leap_day.any() and not pd.Timestamp(year=year, month=1, day=1).is_leap_year:
        raise ClerestoryError(f"year of a schedule must have a 29th of February as the times do, got {year}")
    clock = index.tz_localize(None)
    moved = pd.to_datetime({"year": year, "month": clock.month, "day": clock.day}) + (clock - clock.normalize())
    return pd.DatetimeIndex(moved).tz_localize(index.tz)


def _on(holiday: str, wall: pd.DatetimeIndex) -> Any:
    (year, *first), (last_year, *last) = _holiday(holiday)
    if year is not None and last_year is not None:
        begin, end = date(year, *first), date(last_year, *last)
        midnight = wall.tz_localize(None).normalize()
        return np.asarray((midnight >= pd.Timestamp(begin)) & (midnight < pd.Timestamp(end + timedelta(days=1))))
    day_of_year = np.asarray(wall.month * 100 + wall.day)
    begins, ends = first[0] * 100 + first[1], last[0] * 100 + last[1]
    if begins <= ends:
        return (day_of_year >= begins) & (day_of_year <= ends)
    return (day_of_year >= begins) | (day_of_year <= ends)
