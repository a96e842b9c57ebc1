"""How bright the sun is through the air."""

from __future__ import annotations

from typing import Any

import numpy as np
import pandas as pd
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.rules import not_negative
from clerestory.site import Site
from clerestory.sun import Array, sun_distance_au, sun_position

LUMINOUS_SOLAR_CONSTANT_LX = 133_100.0
"""Illuminance normal to the sun outside the atmosphere at the mean distance [lx]: 683 lm/W times the extraterrestrial
spectrum weighted by V(λ) (S. Darula, R. Kittler, C. Gueymard, Solar Energy 79(5), 2005)."""


def extraterrestrial_illuminance_lx(site: Site, times: Any) -> xr.DataArray:
    """Illuminance normal to the sun's rays outside the atmosphere.

    Parameters
    ----------
    site : Site
        Says which clock times without a zone are on.
    times : anything `Site.moments` reads

    Returns
    -------
    DataArray, dims ("time",) [lx]
        The luminous solar constant over the squared distance of the sun in astronomical units (theory/sun.md, eq. 5).
    """
    moments = site.moments(times)
    utc = moments.tz_convert("UTC")
    return xr.DataArray(
        LUMINOUS_SOLAR_CONSTANT_LX / sun_distance_au(moments) ** 2,
        dims="time",
        coords={"time": pd.DatetimeIndex(utc.tz_localize(None)).to_numpy().astype("datetime64[ns]")},
        attrs={"units": "lx", "long_name": "extraterrestrial normal illuminance"},
    )


def relative_air_mass(altitude_deg: Any) -> Any:
    r"""Way of a sunbeam through the air, that of a beam from the zenith being 1.

    Parameters
    ----------
    altitude_deg : array_like [deg]
        Apparent altitude. Below the horizon there is no way: NaN.

    Returns
    -------
    array of the same shape

    Notes
    -----
    :math:`m = 1 / (\sin h + 0.50572 (h + 6.07995)^{-1.6364})`, h in degrees (theory/sun.md, eq. 6);
    F. Kasten, A. T. Young, Applied Optics 28(22), 1989.
    """
    altitude = np.maximum(altitude_deg, 0.0)
    mass = 1.0 / (np.sin(np.radians(altitude)) + 0.50572 * (altitude + 6.07995) ** -1.6364)
    return mass + np.where(np.asarray(altitude_deg) >= 0.0, 0.0, np.nan)


def direct_normal_illuminance_lx(site: Site, times: Any, *, luminous_turbidity: float) -> xr.DataArray:
    r"""Illuminance of the cloudless sun on a plane facing it.

    Parameters
    ----------
    site : Site
        Its elevation thins the air.
    times : anything `Site.moments` reads
    luminous_turbidity : float, at least 1
        How many clean dry atmospheres would dim the sun as much: 1 a Rayleigh atmosphere, about 2.5 clear country air,
        4 to 6 towns and humid tropics.

    Returns
    -------
    DataArray, dims ("time",) [lx]
        Zero while the sun is below the horizon.

    Raises
    ------
    ClerestoryError
        If the turbidity is below that of clean air.

    Notes
    -----
    :math:`E_{vs} = E_{v0} \exp(-a_v m T_v)` with :math:`a_v = 1 / (10.1 + 0.045 m)` (theory/sun.md, eqs. 7-8).
    Turbidity for light and its use: M. Navvab, M. Karayel, E. Ne'eman, S. Selkowitz, Energy and Buildings 6, 1984 (CIE
    e-ILV 17-29-108); the extinction is R. Clear's (1982) as used by R. Kittler and S. Darula.
    """
    turbidity = checked_turbidity(luminous_turbidity)
    sun = sun_position(site, times)
    altitude = sun.apparent_altitude_deg
    share = altitude.copy(data=share_through_air(site, altitude.values, turbidity))
    illuminance: xr.DataArray = extraterrestrial_illuminance_lx(site, times) * share
    illuminance.attrs = {"units": "lx", "long_name": "direct normal illuminance", "luminous_turbidity": turbidity}
    return illuminance


def checked_turbidity(luminous_turbidity: Any) -> float:
    """A luminous turbidity that some air may have."""
    turbidity = not_negative("luminous_turbidity", luminous_turbidity)
    if turbidity < 1.0:
        raise ClerestoryError(f"luminous_turbidity must be at least 1 (clean dry air), got {turbidity:g}")
    return turbidity


def share_through_air(site: Site, altitude_deg: Any, luminous_turbidity: float) -> Array:
    """Share of the sun's light that cloudless air lets through, by its apparent altitude: 0 below the horizon.

    (theory/sun.md, eqs. 7 and 8).
    """
    from pvlib import atmosphere

    pressure_share = float(atmosphere.alt2pres(site.elevation_m)) / 101_325.0
    mass = np.asarray(relative_air_mass(altitude_deg)) * pressure_share
    extinction = 1.0 / (10.1 + 0.045 * mass)
    return np.asarray(np.nan_to_num(np.exp(-extinction * mass * luminous_turbidity)))
