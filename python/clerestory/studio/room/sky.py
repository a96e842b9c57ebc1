"""The sky and the sun of a request: a CIE sky, an overcast one, or that of an hour of a weather file."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import pandas as pd

from clerestory.errors import ClerestoryError
from clerestory.rules import not_negative, one_of, within
from clerestory.site import Site
from clerestory.sky.availability import shows_sun, usual_diffuse_horizontal_lx
from clerestory.sky.cie import TRADITIONAL_OVERCAST
from clerestory.sky.cie_sky import CieSky
from clerestory.sky.perez_sky import PerezSky
from clerestory.studio.room.asked import AskedRoom
from clerestory.studio.room.numbers import whole
from clerestory.studio.room.sun_answers import altitude_azimuth, moment
from clerestory.studio.room.weather import weather_of
from clerestory.sun import sun_distance_au
from clerestory.sunlight import LUMINOUS_SOLAR_CONSTANT_LX, checked_turbidity, share_through_air
from clerestory.weather import Weather

#: No sky is brighter than the sun outside the air [lx].
_MOST_LX = 200_000.0
#: Fields of each kind of sky.
FIELDS: dict[str, tuple[str, ...]] = {
    "cie": ("sky_type", "luminous_turbidity", "diffuse_horizontal_illuminance_lx"),
    "overcast": ("diffuse_horizontal_illuminance_lx",),
    "weather": ("path", "timezone"),
}


@dataclass(frozen=True)
class Moment:
    """Light outside at one time.

    Attributes
    ----------
    sky : CieSky, PerezSky or None
        None by night.
    altitude_deg, azimuth_deg : float
        Of the sun, as seen through the air; of a weather file in the middle of the hour.
    direct_normal_lx, diffuse_horizontal_lx : float
    about : str
        In words, with what had to be assumed.
    """

    sky: CieSky | PerezSky | None
    altitude_deg: float
    azimuth_deg: float
    direct_normal_lx: float
    diffuse_horizontal_lx: float
    about: str


def moment_of(asked: AskedRoom, values: Any, day_of_year: Any, hour: Any) -> Moment:
    """The light outside at a time of a room's site.

    Raises
    ------
    ClerestoryError
        If a field is wrong, or the room has no site.
    """
    if not isinstance(values, dict):
        raise ClerestoryError(f"sky must be a table, got {values!r}")
    kind = one_of("kind of sky", values.get("kind"), tuple(FIELDS))
    for name in values:
        one_of("a field of sky", name, ("kind", *FIELDS[kind]))
    if kind == "weather":
        weather = weather_of(asked.root, asked.root, values.get("path"), values.get("timezone"))
        return _of_weather(weather, day_of_year, hour)
    site = asked.site
    if site is None:
        raise ClerestoryError("sky must be that of a weather file, or the room have a [site]")
    sky_type = TRADITIONAL_OVERCAST if kind == "overcast" else whole("sky_type", values.get("sky_type"), 1, 16)
    given = values.get("diffuse_horizontal_illuminance_lx")
    turbidity = not_negative("luminous_turbidity", values.get("luminous_turbidity", 4.0))
    if given is not None:
        given = within("diffuse_horizontal_illuminance_lx", given, 0.0, _MOST_LX)
    return _of_cie(site, sky_type, given, turbidity, moment(site, day_of_year, hour))


@lru_cache(maxsize=256)
def _of_cie(site: Site, sky_type: int, given: float | None, turbidity: float, now: pd.Timestamp) -> Moment:
    altitude, azimuth = (float(one[0]) for one in altitude_azimuth(site, [now]))
    if altitude <= 0.0:
        return Moment(None, altitude, azimuth, 0.0, 0.0, "night: the sun is below the horizon")
    direct = 0.0
    if shows_sun(sky_type):
        outside = LUMINOUS_SOLAR_CONSTANT_LX / float(sun_distance_au(pd.DatetimeIndex([now]))[0]) ** 2
        direct = outside * float(share_through_air(site, altitude, checked_turbidity(turbidity)))
    diffuse = float(usual_diffuse_horizontal_lx(sky_type, altitude) if given is None else given)
    sky = CieSky(
        sky_type=sky_type,
        sun_altitude_deg=min(altitude, 90.0),
        sun_azimuth_deg=azimuth,
        diffuse_horizontal_illuminance_lx=diffuse,
        direct_normal_illuminance_lx=direct,
    )
    assumed = "" if given is not None else "; diffuse illuminance as such skies usually have (IES 1984)"
    return Moment(sky, altitude, azimuth, direct, diffuse, sky.description + assumed)


def _of_weather(weather: Weather, day_of_year: Any, hour: Any) -> Moment:
    first = weather.times[0]
    now = moment(weather.site, day_of_year, hour, year=int(weather.times[len(weather) // 2].year))
    # the last minute of a year is in its last interval
    now = max(first, min(now, weather.times[-1]))
    sky = weather.sky(now)
    if sky.diffuse_horizontal_irradiance_w_m2 <= 0.0 and sky.direct_normal_illuminance_lx <= 0.0:
        return Moment(None, sky.sun_altitude_deg, sky.sun_azimuth_deg, 0.0, 0.0, "no light in the weather file")
    return Moment(
        sky,
        sky.sun_altitude_deg,
        sky.sun_azimuth_deg,
        sky.direct_normal_illuminance_lx,
        sky.diffuse_horizontal_lx,
        f"{sky.description}, {weather.source}: mean of the hour",
    )


def direction_is_up(now: Moment) -> bool:
    """Whether the sun gives light."""
    return bool(now.altitude_deg > 0.0 and now.direct_normal_lx > 0.0 and np.isfinite(now.direct_normal_lx))
