"""How much light a sky of which only the type is known sends down."""

from __future__ import annotations

from typing import Any

import numpy as np

from clerestory.sky.cie import Array, check_sky_type

#: Lowest, risen and exponent of the sine for skies that are clear, partly cloudy and cloudy [lx].
_CLEAR, _PARTLY, _CLOUDY = (800.0, 15_500.0, 0.5), (300.0, 45_000.0, 1.0), (300.0, 21_000.0, 1.0)


def shows_sun(sky_type: int) -> bool:
    """Whether the sun stands visible in a CIE sky: in types 7 to 15."""
    return 7 <= check_sky_type(sky_type) <= 15


def usual_diffuse_horizontal_lx(sky_type: int, sun_altitude_deg: Any) -> Array:
    r"""Diffuse horizontal illuminance that such a sky usually has.

    Parameters
    ----------
    sky_type : int, 1..16
        Types 1 to 6 and 16 count as cloudy, 7 to 10 as partly cloudy, 11 to 15 as clear.
    sun_altitude_deg : array_like [deg]

    Returns
    -------
    ndarray [lx]
        0 while the sun is below the horizon.

    Notes
    -----
    :math:`E_d = A + B \sin^C h` (theory/sky.md, eq. 9): IES Calculation Procedures Committee, *Recommended practice for
    the calculation of daylight availability*, Journal of the IES 13(4), 381-392, 1984
    (doi:10.1080/00994480.1984.10748791), after G. Gillette, W. Pierpoint, S. Treado, *A general illuminance model for
    daylight availability*, in the same issue.
    """
    kind = check_sky_type(sky_type)
    low, rise, power = _CLEAR if 11 <= kind <= 15 else _PARTLY if 7 <= kind <= 10 else _CLOUDY
    sine = np.sin(np.radians(np.asarray(sun_altitude_deg, dtype=np.float64)))
    return np.where(sine > 0.0, low + rise * np.maximum(sine, 0.0) ** power, 0.0)
