"""A year of weather in a few numbers."""

from __future__ import annotations

from typing import Any

import numpy as np

from clerestory.weather.columns import DIFFUSE, DIRECT
from clerestory.weather.light import light_of
from clerestory.weather.weather import Weather

SUNSHINE_W_M2 = 120.0
"""Direct normal irradiance above which the sun shines (World Meteorological Organization, *Guide to Instruments and
Methods of Observation*, WMO-No. 8, chapter 8)."""

_OVERCAST, _CLEAR = 1.23, 4.5


def summary(weather: Weather) -> dict[str, Any]:
    """Place, span, sums and hours of a stretch of weather.

    Returns
    -------
    dict
        `source`, `site`, `first`, `last` (middles of intervals), `intervals`, `interval_minutes`, `hours`; sums
        `direct_normal_kwh_m2`, `diffuse_horizontal_kwh_m2`, `global_horizontal_kwh_m2` (the sun on the horizontal and
        the sky), `global_horizontal_klx_h`; `daylit_hours` (any diffuse light), `sunshine_hours` (direct irradiance
        above 120 W/m²), of the daylit hours `overcast_hours` (clearness below 1.23), `clear_hours` (from 4.5) and
        `intermediate_hours`; `greatest_direct_normal_w_m2`, `greatest_diffuse_horizontal_w_m2`; `notes`.
    """
    hour = weather.interval_minutes / 60.0
    direct, diffuse = (weather.frame[column].to_numpy(dtype=np.float64) for column in (DIRECT, DIFFUSE))
    light = light_of(weather)
    up = np.where(weather.sun.apparent_altitude_deg.values > 0.0, light.sun_direction[:, 2], 0.0)
    daylit = diffuse > 0.0
    clearness = light.conditions.clearness
    counts = {
        "overcast_hours": daylit & (clearness < _OVERCAST),
        "intermediate_hours": daylit & (clearness >= _OVERCAST) & (clearness < _CLEAR),
        "clear_hours": daylit & (clearness >= _CLEAR),
    }
    site = weather.site
    return {
        "source": weather.source,
        "site": {
            "latitude_deg": site.latitude_deg,
            "longitude_deg": site.longitude_deg,
            "elevation_m": site.elevation_m,
            "timezone": site.timezone,
        },
        "first": weather.times[0].isoformat(),
        "last": weather.times[-1].isoformat(),
        "intervals": len(weather),
        "interval_minutes": weather.interval_minutes,
        "hours": len(weather) * hour,
        "direct_normal_kwh_m2": float(direct.sum() * hour / 1e3),
        "diffuse_horizontal_kwh_m2": float(diffuse.sum() * hour / 1e3),
        "global_horizontal_kwh_m2": float((direct * up + diffuse).sum() * hour / 1e3),
        "global_horizontal_klx_h": float(
            (light.direct_normal_lx * up + light.diffuse_horizontal_lx).sum() * hour / 1e3
        ),
        "daylit_hours": float(daylit.sum() * hour),
        "sunshine_hours": float((direct > SUNSHINE_W_M2).sum() * hour),
        **{name: float(which.sum() * hour) for name, which in counts.items()},
        "greatest_direct_normal_w_m2": float(direct.max()),
        "greatest_diffuse_horizontal_w_m2": float(diffuse.max()),
        "notes": list(weather.notes),
    }
