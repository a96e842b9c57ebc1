"""The lines at the top of an EPW file: place, clock and how many rows an hour has."""

from __future__ import annotations

import re
from dataclasses import dataclass

from clerestory.errors import ClerestoryError
from clerestory.site import Site
from clerestory.weather.clock import WEEKDAYS, zone_name
from clerestory.weather.lines import Lines

_ROW = re.compile(r"\s*\d{1,4}\s*,\s*\d{1,2}\s*,\s*\d{1,2}\s*,")
_LOCATION_FIELDS = 10


@dataclass(frozen=True)
class Header:
    """What stands above the rows of an EPW file."""

    place: str
    site: Site
    offset_hours: float
    records_per_hour: int
    first_weekday: int | None
    location_line: int
    rows_from: int
    notes: tuple[str, ...]


def read_header(lines: Lines) -> Header:
    """Header of an EPW file; its lines may come in any order, and only LOCATION must be there.

    Raises
    ------
    ClerestoryError
        If there is no LOCATION, or place and clock cannot be read.
    """
    named: dict[str, tuple[int, str]] = {}
    first = len(lines.text) + 1
    for number, text in enumerate(lines.text, 1):
        if _ROW.match(text):
            first = number
            break
        named.setdefault(text.split(",")[0].strip().upper(), (number, text))
    if "LOCATION" not in named:
        begins = lines.text[0][:40] if lines.text else ""
        raise lines.wrong(1, f"an EPW file must have a line LOCATION,city,…, got {begins!r} first")
    number, text = named["LOCATION"]
    notes: list[str] = []
    fields = [field.strip() for field in text.split(",")][1:]
    while len(fields) >= _LOCATION_FIELDS and not fields[-1]:
        fields.pop()
    wanted = _LOCATION_FIELDS - 1
    if len(fields) < wanted:
        raise lines.wrong(number, f"LOCATION must have {wanted} fields after it, got {len(fields)}")
    if len(fields) > wanted:
        # a comma within the city's name: numbers are counted from the end
        notes.append(f"LOCATION has {len(fields) - wanted} commas too many: the first fields are taken as one name")
        fields = [" ".join(fields[: len(fields) - wanted + 1]), *fields[len(fields) - wanted + 1 :]]
    city, region, country = fields[:3]
    latitude, longitude, offset, elevation = (
        lines.number(number, name, field)
        for name, field in zip(("latitude", "longitude", "time zone", "elevation"), fields[5:9], strict=True)
    )
    if not -12.0 <= offset <= 14.0:
        raise lines.wrong(number, f"time zone must lie in -12..14 hours, got {offset:g}")
    if elevation <= -9999.0 or elevation >= 9999.0:
        notes.append(f"elevation {elevation:g} is a code for missing: 0 m is taken")
        elevation = 0.0
    try:
        site = Site(latitude_deg=latitude, longitude_deg=longitude, elevation_m=elevation, timezone=zone_name(offset))
    except ClerestoryError as error:
        raise lines.wrong(number, str(error)) from None
    per_hour, weekday = _data_periods(lines, named.get("DATA PERIODS"), notes)
    return Header(
        place=", ".join(part for part in (city, region, country) if part and part != "-") or "no name",
        site=site,
        offset_hours=offset,
        records_per_hour=per_hour,
        first_weekday=weekday,
        location_line=number,
        rows_from=first,
        notes=tuple(notes),
    )


def _data_periods(lines: Lines, found: tuple[int, str] | None, notes: list[str]) -> tuple[int, int | None]:
    """Rows an hour and the weekday of the first day, from a line like DATA PERIODS,1,1,Data,Sunday, 1/ 1,12/31."""
    if found is None:
        notes.append("no line DATA PERIODS: one row an hour is taken")
        return 1, None
    number, text = found
    fields = [field.strip() for field in text.split(",")] + [""] * 5
    periods, per_hour = (lines.number(number, name, fields[k]) for k, name in ((1, "periods"), (2, "rows an hour")))
    if periods != 1:
        raise lines.wrong(number, f"DATA PERIODS must be one period, got {periods:g}; split the file")
    if per_hour < 1 or per_hour > 60 or 60 % per_hour:
        raise lines.wrong(number, f"rows an hour must divide 60, got {per_hour:g}")
    day = fields[4].lower()
    return int(per_hour), WEEKDAYS.index(day) if day in WEEKDAYS else None
