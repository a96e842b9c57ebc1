"""Weather from EnergyPlus weather files."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pandas as pd

from clerestory.errors import ClerestoryError
from clerestory.site import Site
from clerestory.weather.clock import check_dates, moments, one_calendar, zone_name
from clerestory.weather.columns import (
    DEW_POINT,
    DIFFUSE,
    DIRECT,
    DRY_BULB,
    GLOBAL,
    LIMITS,
    LONG_NAMES,
    ZERO_OFFSET_W_M2,
)
from clerestory.weather.daylight import checked_site
from clerestory.weather.epw_header import Header, read_header
from clerestory.weather.gaps import filled
from clerestory.weather.lines import Lines, read_lines
from clerestory.weather.weather import Weather

Array = npt.NDArray[np.float64]

#: Place of each column in a row, and the least value that means it is missing (EnergyPlus, *Auxiliary Programs*).
_FIELDS: dict[str, tuple[int, float]] = {
    DRY_BULB: (6, 99.9),
    DEW_POINT: (7, 99.9),
    GLOBAL: (13, 9999.0),
    DIRECT: (14, 9999.0),
    DIFFUSE: (15, 9999.0),
}
_CLOCK = ("year", "month", "day", "hour", "minute")


def read_epw(
    path: str | os.PathLike[str],
    *,
    site: Site | None = None,
    timezone: str | None = None,
    max_gap_hours: float | None = 3.0,
) -> Weather:
    """Weather from an EPW file.

    Parameters
    ----------
    path : path
        Hours in it end when they say: hour 1 is from midnight to one, and its sun that of half past midnight.
    site : Site, optional
        Instead of the file's own; its time zone is the wall clock of the result.
    timezone : str, optional
        Wall clock of the site with its summer time, such as ``"America/New_York"``; default the offset in the file,
        which is how its rows are dated in either case.
    max_gap_hours : float, optional, default 3
        Missing rows and values are filled in if at most so many hours of daylight are missing in a row; by night they
        are 0. None refuses them all.

    Returns
    -------
    Weather
        `notes` say what was found and put right. Typical years, put together from months of many, are dated in one
        year whose 1 January falls on the weekday that the file names.

    Raises
    ------
    ClerestoryError
        If the file cannot be understood: path, line, rule, value.

    Notes
    -----
    Format: EnergyPlus, *Auxiliary Programs*, "EnergyPlus Weather File (EPW) Data Dictionary". A longitude whose sign is
    contradicted by the clock and the light is mirrored, with a note (theory/weather.md).
    """
    lines = read_lines(path)
    header = read_header(lines)
    rows = _rows(lines, header)
    interval = 60.0 / header.records_per_hour
    years, notes = one_calendar(rows.clock[:, 0], rows.clock[:, 1], rows.clock[:, 2], header.first_weekday)
    middle = rows.ends_minutes - 0.5 * interval
    offset = zone_name(header.offset_hours)
    index = moments(lines, rows.numbers, years, rows.clock[:, 1], rows.clock[:, 2], middle).tz_localize(offset)
    frame = pd.DataFrame(rows.columns, index=index)

    def wrong_at(when: pd.Timestamp, message: str) -> ClerestoryError:
        return lines.wrong(int(rows.numbers[max(int(index.searchsorted(when, side="right")) - 1, 0)]), message)

    place = header.site if site is None else site
    mirrored: tuple[str, ...] = ()
    if site is None:
        place, mirrored = checked_site(
            frame, place, interval_minutes=interval, wrong=lambda message: lines.wrong(header.location_line, message)
        )
    frame, gaps = filled(frame, place, interval_minutes=interval, max_gap_hours=max_gap_hours, wrong_at=wrong_at)
    if site is not None or timezone is not None:
        place = _on_wall_clock(place, timezone or place.timezone, header, frame, lines)
        frame = frame.tz_convert(place.timezone)
    return Weather(
        site=place,
        frame=frame,
        interval_minutes=interval,
        source=f"{header.place} ({lines.path.name})",
        notes=(*lines.notes, *header.notes, *notes, *rows.notes, *mirrored, *gaps),
    )


@dataclass(frozen=True)
class _Rows:
    numbers: npt.NDArray[np.int64]
    clock: npt.NDArray[np.int64]
    ends_minutes: Array
    columns: dict[str, Array]
    notes: tuple[str, ...]


def _rows(lines: Lines, header: Header) -> _Rows:
    numbers, clock, values = [], [], []
    wanted = max(place for place, _ in _FIELDS.values()) + 1
    for number, text in enumerate(lines.text[header.rows_from - 1 :], header.rows_from):
        if not text.strip():
            continue
        fields = text.split(",")
        if len(fields) < wanted:
            raise lines.wrong(number, f"a row must have at least {wanted} fields, got {len(fields)}")
        try:
            clock.append([int(float(field)) for field in fields[:5]])
            values.append([float(fields[place] or "nan") for place, _ in _FIELDS.values()])
        except (ValueError, OverflowError):
            named = [*zip(_CLOCK, fields, strict=False), *((LONG_NAMES[c], fields[p]) for c, (p, _) in _FIELDS.items())]
            for name, field in named:
                lines.number(number, name, field or "nan")
            raise lines.wrong(number, f"year, month, day, hour and minute must be whole, got {fields[:5]}") from None
        numbers.append(number)
    if not numbers:
        raise lines.wrong(len(lines.text), "there must be rows of weather after the header, got none")
    at, when, table = np.array(numbers), np.array(clock), np.array(values)
    check_dates(lines, at, when[:, 1], when[:, 2])
    columns, notes = {}, []
    for k, (column, (_, missing)) in enumerate(_FIELDS.items()):
        found = table[:, k]
        found[found >= missing] = np.nan
        low, high = LIMITS[column]
        if column in (DIRECT, DIFFUSE, GLOBAL):
            offset = (found < low) & (found >= low - ZERO_OFFSET_W_M2)
            found[offset] = 0.0
            if offset.any():
                notes.append(f"{LONG_NAMES[column]}: {int(offset.sum())} values just below 0 are 0")
        wrong = (found < low) | (found > high)
        if wrong.any() and column in (DIRECT, DIFFUSE):
            row = int(np.argmax(wrong))
            raise lines.wrong(
                int(at[row]), f"{LONG_NAMES[column]} must lie in {low:g}..{high:g} W/m2, got {found[row]:g}"
            )
        found[wrong] = np.nan
        columns[column] = found
    return _Rows(at, when, _ends(lines, at, when, header.records_per_hour), columns, tuple(notes))


def _ends(lines: Lines, numbers: npt.NDArray[np.int64], clock: npt.NDArray[np.int64], per_hour: int) -> Array:
    """Minutes after midnight at which each row's interval ends.

    Minutes are written in more than one way, so a row's place among those of its hour counts.
    """
    hour, minute = clock[:, 3], clock[:, 4]
    wrong = (hour < 1) | (hour > 24) | (minute < 0) | (minute > 60)
    if wrong.any():
        row = int(np.argmax(wrong))
        raise lines.wrong(
            int(numbers[row]),
            f"hour must be 1..24, the one that ends, and minute 0..60, got {hour[row]} and {minute[row]}; "
            "if hours count from 0, add 1 to each",
        )
    if per_hour == 1:
        return np.asarray(60.0 * hour)
    place = np.zeros(len(hour), dtype=np.int64)
    same = np.concatenate([[False], (np.diff(clock[:, :4], axis=0) == 0).all(axis=1)])
    for later in np.flatnonzero(same):
        place[later] = place[later - 1] + 1
    if place.max() >= per_hour:
        first = int(numbers[np.argmax(place >= per_hour)])
        raise lines.wrong(first, f"an hour must have {per_hour} rows, as line DATA PERIODS says, got more")
    return np.asarray(60.0 * (hour - 1) + 60.0 * (place + 1) / per_hour)


def _on_wall_clock(place: Site, timezone: str, header: Header, frame: pd.DataFrame, lines: Lines) -> Site:
    """The site with a named clock, whose standard time must be that of the file."""
    found = Site(
        latitude_deg=place.latitude_deg,
        longitude_deg=place.longitude_deg,
        elevation_m=place.elevation_m,
        timezone=timezone,
    )
    offsets = {
        when.utcoffset().total_seconds() / 3600.0
        for when in frame.index[:: max(1, len(frame) // 400)].tz_convert(timezone)
    }
    if not any(abs(offset - header.offset_hours) < 1e-9 for offset in offsets):
        raise lines.wrong(
            header.location_line,
            f"timezone must keep the file's standard time, UTC{header.offset_hours:+g} h, got {timezone!r} with "
            f"{', '.join(f'{offset:+g} h' for offset in sorted(offsets))}",
        )
    return found


def looks_like_epw(text: str) -> bool:
    """Whether a file begins as an EPW does."""
    return re.match(r"\s*location\s*,", text, re.IGNORECASE) is not None
