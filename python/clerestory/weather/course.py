"""How sunlight runs through a day without clouds: what lies between two readings."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from clerestory.sunlight import relative_air_mass
from clerestory.weather.columns import DIFFUSE, DIRECT, GLOBAL

Array = npt.NDArray[np.float64]


def course(column: str, altitude_deg: Array) -> Array:
    r"""A course of light through the day, up to a factor; 0 while the sun is below the horizon.

    Parameters
    ----------
    column : str
        Name of an irradiance.
    altitude_deg : ndarray
        Of the sun.

    Notes
    -----
    Direct normal :math:`0.7^{m^{0.678}}` (A. B. Meinel, M. P. Meinel, *Applied Solar Energy*, 1976), horizontal ones
    :math:`\sin h` (theory/weather.md, eq. 1).
    """
    if column == DIRECT:
        mass = relative_air_mass(np.maximum(altitude_deg, 0.0))
        return np.where(altitude_deg > 0.0, 0.7 ** (mass**0.678), 0.0)
    return np.maximum(np.sin(np.radians(altitude_deg)), 0.0)


FOLLOWS_THE_SUN = (DIRECT, DIFFUSE, GLOBAL)
"""Columns that have a course; others change evenly between readings."""
