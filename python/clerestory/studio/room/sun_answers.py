"""Where the sun stands at a site: now, through the day, through the year."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
import pandas as pd

from clerestory.errors import ClerestoryError
from clerestory.glazing_table import build
from clerestory.room.toml_table import Table
from clerestory.rules import within
from clerestory.site import Site
from clerestory.studio.room.numbers import whole
from clerestory.sun import direction_of, solar_places

#: The year that days are of: neither a leap year nor next to one.
YEAR = 2026
#: Days that stand for the seasons, and every which a point of an analemma is.
_SEASONS = ((172, "21 June"), (80, "21 March"), (355, "21 December"))
_ANALEMMA_DAYS = 7
_STEP_H = 0.25


def asked_site(values: Any) -> Site:
    """The site of a request."""
    made: Site = build(Site, Table(values, "site"))
    return made


def moment(site: Site, day_of_year: Any, hour: Any, *, year: int = YEAR) -> pd.Timestamp:
    """A time of the wall clock of a site; what its clock skips is an hour later, what it repeats the first.

    Parameters
    ----------
    site : Site
    day_of_year : int, 1..365
    hour : float, 0..24 [h]
    year : int
    """
    day = whole("day_of_year", day_of_year, 1, 365)
    plain = (
        pd.Timestamp(year, 1, 1) + pd.Timedelta(day - 1, unit="D") + pd.Timedelta(within("hour", hour, 0.0, 24.0), "h")
    )
    return plain.tz_localize(site.timezone, ambiguous=True, nonexistent="shift_forward")


def sun_of(site: Site, day_of_year: Any, hour: Any, *, year: bool = False) -> dict[str, Any]:
    """The sun now and its way through the day; with ``year`` the seasons, and its place at each full hour of the year.

    Altitudes are as seen through the air [degrees].
    """
    now = moment(site, day_of_year, hour)
    altitude, azimuth = altitude_azimuth(site, [now])
    day = int(day_of_year)
    sunrise, sunset = _rise_and_set(site, day)
    return {
        "time": now.isoformat(),
        "altitude_deg": float(altitude[0]),
        "azimuth_deg": float(azimuth[0]),
        "direction": direction_of(altitude, azimuth)[0],
        "is_up": bool(altitude[0] > 0.0),
        "sunrise_h": sunrise,
        "sunset_h": sunset,
        "day": _way(site, day),
        **(_year(site) if year else {}),
    }


def altitude_azimuth(site: Site, times: Any) -> tuple[Any, Any]:
    """Of the sun, as seen through the air [degrees]."""
    found = solar_places(site, pd.DatetimeIndex(times))
    return found.apparent_altitude_deg, found.azimuth_deg


def _clock(site: Site, days: Any, hours: Any, year: int = YEAR) -> pd.DatetimeIndex:
    start = pd.Timestamp(f"{year}-01-01")
    plain = pd.DatetimeIndex(start + pd.to_timedelta(days - 1, unit="D") + pd.to_timedelta(hours, unit="h"))
    return plain.tz_localize(site.timezone, ambiguous=np.ones(len(plain), dtype=bool), nonexistent="shift_forward")


def _points(site: Site, days: Any, hours: Any) -> list[dict[str, Any]]:
    days, hours = np.broadcast_arrays(np.asarray(days), np.asarray(hours, dtype=np.float64))
    altitude, azimuth = altitude_azimuth(site, _clock(site, days, hours))
    directions = direction_of(altitude, azimuth).round(5)
    return [
        {"hour": float(h), "day_of_year": int(d), "altitude_deg": float(a), "azimuth_deg": float(z), "direction": way}
        for h, d, a, z, way in zip(hours, days, altitude.round(3), azimuth.round(3), directions, strict=True)
    ]


@lru_cache(maxsize=256)
def _way(site: Site, day_of_year: int) -> list[dict[str, Any]]:
    return _points(site, day_of_year, np.arange(0.0, 24.0 + 1e-9, _STEP_H))


@lru_cache(maxsize=32)
def _year(site: Site) -> dict[str, Any]:
    seasons = [{"label": label, "day_of_year": day, "points": _way(site, day)} for day, label in _SEASONS]
    days = np.arange(1, 366, _ANALEMMA_DAYS)
    hours = np.arange(0, 24)
    points = _points(site, np.tile(days, len(hours)), np.repeat(hours, len(days)))
    loops = [points[k * len(days) : (k + 1) * len(days)] for k in range(len(hours))]
    seen = [
        {"hour": int(hour), "points": loop}
        for hour, loop in zip(hours, loops, strict=True)
        if any(point["altitude_deg"] > 0.0 for point in loop)
    ]
    return {"seasons": seasons, "analemmas": seen}


@lru_cache(maxsize=256)
def _rise_and_set(site: Site, day: int) -> tuple[float | None, float | None]:
    """Hours of sunrise and sunset on a day, to a second or so; None where there is none."""
    found: dict[bool, float] = {}
    for before, after in pairwise(_way(site, day)):
        rises = before["altitude_deg"] <= 0.0 < after["altitude_deg"]
        if rises or after["altitude_deg"] <= 0.0 < before["altitude_deg"]:
            hours = np.linspace(before["hour"], after["hour"], 16)
            altitude, _ = altitude_azimuth(site, _clock(site, np.full(len(hours), day), hours))
            order = np.argsort(altitude)
            found.setdefault(rises, float(np.interp(0.0, altitude[order], hours[order])))
    return found.get(True), found.get(False)


def checked_angles(altitude_deg: Any, azimuth_deg: Any) -> tuple[float, float]:
    """Altitude and azimuth that were given."""
    if altitude_deg is None or azimuth_deg is None:
        raise ClerestoryError("altitude_deg and azimuth_deg must both be given")
    return within("altitude_deg", altitude_deg, -90.0, 90.0), within("azimuth_deg", azimuth_deg, -360.0, 360.0)
