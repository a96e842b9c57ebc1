"""Weather from and to WEA files, as Radiance's `gendaymtx` reads."""

from __future__ import annotations

import os

import numpy as np
import pandas as pd

from clerestory.errors import ClerestoryError
from clerestory.site import Site
from clerestory.weather.clock import check_dates, moments, one_calendar, zone_name
from clerestory.weather.columns import DIFFUSE, DIRECT, LIMITS, LONG_NAMES, ZERO_OFFSET_W_M2
from clerestory.weather.daylight import checked_site
from clerestory.weather.gaps import filled
from clerestory.weather.lines import Lines, read_lines
from clerestory.weather.weather import Weather

_NEEDED = ("latitude", "longitude", "time_zone")


def read_wea(
    path: str | os.PathLike[str],
    *,
    site: Site | None = None,
    interval_minutes: float | None = None,
    max_gap_hours: float | None = 3.0,
) -> Weather:
    """Weather from a WEA file.

    Parameters
    ----------
    path : path
        Its times are the middles of intervals. Longitude and time zone count to the west, as everywhere in Radiance.
    site : Site, optional
        Instead of the file's own.
    interval_minutes : float, optional
        Default the shortest step between two rows, at most 60.
    max_gap_hours : float, optional, default 3
        As in `read_epw`; None keeps the rows as they are, for a file of chosen hours.

    Returns
    -------
    Weather
        A WEA file says no years: its rows are dated in one, with a leap day if it has one.

    Raises
    ------
    ClerestoryError
        If the file cannot be understood: path, line, rule, value.
    """
    lines = read_lines(path)
    header, first = _header(lines)
    numbers, clock, values = _rows(lines, first)
    check_dates(lines, numbers, clock[:, 0].astype(np.int64), clock[:, 1].astype(np.int64))
    months, days = clock[:, 0].astype(np.int64), clock[:, 1].astype(np.int64)
    years, notes = one_calendar(None, months, days, None)
    index = moments(lines, numbers, years, months, days, 60.0 * clock[:, 2]).tz_localize(
        zone_name(-header["time_zone"][1] / 15.0)
    )
    steps = np.diff(index.tz_localize(None).to_numpy()) / np.timedelta64(1, "m")
    interval = interval_minutes or min([60.0, *steps])
    frame = pd.DataFrame({DIRECT: values[:, 0], DIFFUSE: values[:, 1]}, index=index)
    place = site
    mirrored: tuple[str, ...] = ()
    if place is None:
        place, mirrored = checked_site(
            frame,
            _site(lines, header),
            interval_minutes=interval,
            wrong=lambda message: lines.wrong(header["longitude"][0], message),
        )

    def wrong_at(when: pd.Timestamp, message: str) -> ClerestoryError:
        return lines.wrong(int(numbers[max(int(index.searchsorted(when, side="right")) - 1, 0)]), message)

    frame, gaps = filled(frame, place, interval_minutes=interval, max_gap_hours=max_gap_hours, wrong_at=wrong_at)
    if site is not None:
        frame = frame.tz_convert(site.timezone)
    return Weather(
        site=place,
        frame=frame,
        interval_minutes=interval,
        source=lines.path.name,
        notes=(*lines.notes, *notes, *mirrored, *gaps),
    )


def wea_text(weather: Weather) -> str:
    """The text of a WEA file."""
    site = weather.site
    offset = min(when.utcoffset().total_seconds() for when in weather.times[:: max(1, len(weather) // 400)]) / 3600.0
    standard = weather.times.tz_convert(zone_name(offset))
    place = "_".join(weather.source.split()) or "unnamed"
    rows = [
        f"place {place}",
        f"latitude {site.latitude_deg:.6g}",
        f"longitude {-site.longitude_deg:.6g}",
        f"time_zone {-15.0 * offset:g}",
        f"site_elevation {site.elevation_m:g}",
        "weather_data_file_units 1",
    ]
    hours = (standard - standard.normalize()) / pd.Timedelta(hours=1)
    data = weather.frame[[DIRECT, DIFFUSE]].to_numpy()
    rows += [
        f"{when.month} {when.day} {hour:.4f} {direct:.6g} {diffuse:.6g}"
        for when, hour, (direct, diffuse) in zip(standard, hours, data, strict=True)
    ]
    return "\n".join(rows) + "\n"


def _header(lines: Lines) -> tuple[dict[str, tuple[int, float]], int]:
    """Numbers of the header with their lines, and the line where rows begin."""
    found: dict[str, tuple[int, float]] = {}
    first = len(lines.text) + 1
    for number, text in enumerate(lines.text, 1):
        words = text.split()
        if not words or words[0].startswith("#") or words[0] == "place":
            continue
        if words[0][0].isdigit():
            first = number
            break
        if len(words) < 2:
            raise lines.wrong(number, f"a header line must be a word and a number, got {text!r}")
        found[words[0]] = (number, lines.number(number, words[0], words[1]))
    for name in _NEEDED:
        if name not in found:
            raise lines.wrong(
                min(first, len(lines.text)), f"a WEA file must say {name} before its rows, got {sorted(found)}"
            )
    number, west = found["time_zone"]
    if not -14.0 * 15.0 <= west <= 12.0 * 15.0:
        raise lines.wrong(number, f"time_zone must lie in -210..180 degrees west, got {west:g}")
    number, units = found.get("weather_data_file_units", (0, 1.0))
    if units != 1:
        raise lines.wrong(
            number, f"weather_data_file_units must be 1 (direct normal and diffuse horizontal in W/m2), got {units:g}"
        )
    return found, first


def _site(lines: Lines, header: dict[str, tuple[int, float]]) -> Site:
    try:
        return Site(
            latitude_deg=header["latitude"][1],
            longitude_deg=-header["longitude"][1],
            elevation_m=header.get("site_elevation", (0, 0.0))[1],
            timezone=zone_name(-header["time_zone"][1] / 15.0),
        )
    except ClerestoryError as error:
        raise lines.wrong(header["latitude"][0], str(error)) from None


def _rows(lines: Lines, first: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    numbers, clock, values = [], [], []
    for number, text in enumerate(lines.text[first - 1 :], first):
        words = text.split()
        if not words or words[0].startswith("#"):
            continue
        if len(words) < 5:
            raise lines.wrong(number, f"a row must be month day hour direct diffuse, got {text.strip()!r}")
        row = [lines.number(number, "month, day, hour and irradiances", word) for word in words[:5]]
        if not (row[0] % 1.0 == 0.0 and row[1] % 1.0 == 0.0 and 1.0 <= row[0] <= 12.0 and 1.0 <= row[1] <= 31.0):
            raise lines.wrong(number, f"month and day must be a date, got {words[0]} {words[1]}")
        if not 0.0 <= row[2] <= 24.0:
            raise lines.wrong(number, f"hour must lie in 0..24, got {row[2]:g}")
        for column, k in ((DIRECT, 3), (DIFFUSE, 4)):
            if row[k] >= 9999.0 or row[k] <= -9000.0:
                row[k] = np.nan
            elif row[k] > LIMITS[column][1] or row[k] < -ZERO_OFFSET_W_M2:
                raise lines.wrong(
                    number, f"{LONG_NAMES[column]} must lie in 0..{LIMITS[column][1]:g} W/m2, got {row[k]:g}"
                )
        numbers.append(number)
        clock.append(row[:3])
        values.append(np.maximum(row[3:], 0.0))
    if not numbers:
        raise lines.wrong(len(lines.text), "there must be rows of weather after the header, got none")
    return np.array(numbers), np.array(clock), np.array(values)
