"""Where the sun stands."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.rules import number, within
from clerestory.site import Site

if TYPE_CHECKING:
    import pandas as pd

Array = npt.NDArray[np.float64]

SUN_DIAMETER_DEG = 0.533
"""Mean angle across the sun's disc seen from Earth [deg]."""

#: Refraction of the sun's middle as its rim rises: where it begins to be added, as pvlib has it [deg].
_REFRACTION_AT_HORIZON_DEG = 0.5667


def sun_position(
    site: Site,
    times: Any,
    *,
    pressure_pa: float | None = None,
    temperature_c: float = 12.0,
) -> xr.Dataset:
    r"""Altitude and azimuth of the sun's centre.

    Parameters
    ----------
    site : Site
    times : anything `Site.moments` reads
        With a zone, or on the wall clock of the site.
    pressure_pa : float, optional
        Of the air, for refraction; default from the site's elevation (standard atmosphere).
    temperature_c : float, default 12
        Of the air, for refraction.

    Returns
    -------
    Dataset, dims ("time",)
        `altitude_deg` without refraction, `apparent_altitude_deg` as seen through the air, `azimuth_deg` clockwise from
        north, 0..360. `time` is in UTC; the coordinate `local_time` is the wall clock of the site.

    Raises
    ------
    ClerestoryError
        If a time cannot be read, or pressure or temperature is not that of air.

    Notes
    -----
    The Solar Position Algorithm (I. Reda, A. Andreas, Solar Energy 76(5), 2004), topocentric, uncertain by 0.0003°, as
    implemented by pvlib; theory/sun.md, eqs. 1-3. Refraction is added while any of the disc stands above the horizon:

    .. math:: \Delta = \frac{P}{101000} \frac{283}{273 + T} \frac{1.02°}{60 \tan(h + 10.3 / (h + 5.11))}
    """
    moments = site.moments(times)
    places = solar_places(site, moments, pressure_pa=pressure_pa, temperature_c=temperature_c)
    utc = moments.tz_convert("UTC").tz_localize(None).to_numpy().astype("datetime64[ns]")
    local = moments.tz_localize(None).to_numpy().astype("datetime64[ns]")
    degrees = {"units": "degree"}
    return xr.Dataset(
        {
            "altitude_deg": ("time", places.altitude_deg, {"long_name": "sun altitude", **degrees}),
            "apparent_altitude_deg": (
                "time",
                places.apparent_altitude_deg,
                {"long_name": "sun altitude with refraction", **degrees},
            ),
            "azimuth_deg": (
                "time",
                places.azimuth_deg,
                {"long_name": "sun azimuth clockwise from north", **degrees},
            ),
        },
        coords={
            "time": ("time", utc, {"long_name": "time (UTC)"}),
            "local_time": ("time", local, {"long_name": f"time ({site.timezone})"}),
        },
        attrs={
            "latitude_deg": site.latitude_deg,
            "longitude_deg": site.longitude_deg,
            "elevation_m": site.elevation_m,
            "timezone": site.timezone,
        },
    )


class Places(NamedTuple):
    """Where the sun's centre stands, one value a moment [deg]: without and with refraction, clockwise from north."""

    altitude_deg: Array
    apparent_altitude_deg: Array
    azimuth_deg: Array


def solar_places(
    site: Site, moments: pd.DatetimeIndex, *, pressure_pa: float | None = None, temperature_c: float = 12.0
) -> Places:
    """As `sun_position`, of moments with a zone, in plain arrays: for one moment tables take longer than the sun."""
    from pvlib import atmosphere, spa

    within("temperature_c", temperature_c, -90.0, 60.0)
    pressure = (
        float(atmosphere.alt2pres(site.elevation_m)) if pressure_pa is None else number("pressure_pa", pressure_pa)
    )
    within("pressure_pa", pressure, 30_000.0, 110_000.0)
    _, _, apparent, altitude, azimuth, _ = spa.solar_position(
        unix_s(moments),
        site.latitude_deg,
        site.longitude_deg,
        site.elevation_m,
        pressure / 100.0,
        temperature_c,
        terrestrial_less_universal_s(moments),
        _REFRACTION_AT_HORIZON_DEG,
    )
    return Places(altitude, apparent, azimuth)


def sun_distance_au(moments: pd.DatetimeIndex) -> Array:
    """How far the sun is, in astronomical units, one value a moment."""
    from pvlib import spa

    return np.asarray(spa.earthsun_distance(unix_s(moments), terrestrial_less_universal_s(moments), 1))


def unix_s(moments: pd.DatetimeIndex) -> Array:
    """Seconds since 1970 began in Greenwich."""
    return np.asarray(moments.as_unit("ns").asi8 / 1e9)


def terrestrial_less_universal_s(moments: pd.DatetimeIndex) -> Array:
    """How far the turning Earth is behind even time, TT - UT [s], by the polynomials of Espenak and Meeus in pvlib.

    Told by plain arrays, once for each month: as pvlib asks by itself it takes longer than the sun's place.
    """
    utc = moments.tz_convert("UTC")
    months, index = np.unique(utc.year.to_numpy() * 12 + utc.month.to_numpy() - 1, return_inverse=True)
    return np.array([_late_s(int(month)) for month in months])[index]


@lru_cache(maxsize=4096)
def _late_s(month: int) -> float:
    """Of one month, counted from that of year 0."""
    from pvlib import spa

    year, month = divmod(month, 12)
    return float(spa.calculate_deltat(np.array([year]), np.array([month + 1]))[0])


def direction_of(altitude_deg: Any, azimuth_deg: Any) -> npt.NDArray[np.float64]:
    """Unit vectors towards points of the sky.

    Parameters
    ----------
    altitude_deg, azimuth_deg : array_like [deg]
        Above the horizon, and clockwise from north; broadcast against each other.

    Returns
    -------
    ndarray, shape (…, 3)
        x east, y north, z up: (cos h sin A, cos h cos A, sin h) (theory/sun.md, eq. 4).

    Raises
    ------
    ClerestoryError
        If an altitude is beyond ±90° or a value is not finite.
    """
    altitude, azimuth = np.broadcast_arrays(
        np.radians(np.asarray(altitude_deg, dtype=np.float64)), np.radians(np.asarray(azimuth_deg, dtype=np.float64))
    )
    if not (np.isfinite(altitude).all() and np.isfinite(azimuth).all()):
        raise ClerestoryError("altitude_deg and azimuth_deg must be finite, got a value that is not")
    if np.abs(altitude).max(initial=0.0) > np.pi / 2 + 1e-12:
        raise ClerestoryError(f"altitude_deg must lie in -90..90, got {np.degrees(altitude).ravel().tolist()[:3]} …")
    return np.stack([np.cos(altitude) * np.sin(azimuth), np.cos(altitude) * np.cos(azimuth), np.sin(altitude)], axis=-1)
