"""Perez' all-weather model: from irradiances to the shape of a sky and to light."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from clerestory.sky.perez_tables import CLEARNESS_BINS, DIFFUSE_EFFICACY, DIRECT_EFFICACY, LUMINANCE
from clerestory.sunlight import relative_air_mass

Array = npt.NDArray[np.float64]

SOLAR_CONSTANT_W_M2 = 1367.0
"""Irradiance normal to the sun outside the atmosphere at the mean distance, as when the model was fitted [W/m²]."""

DEW_POINT_C = 11.0
"""Where none is known, as in Radiance; it matters to the efficacies alone [°C]."""

LEAST_BRIGHTNESS, MOST_BRIGHTNESS = 0.01, 0.6
_KINDLED = 0.2
"""Least brightness of the luminance's parameters for 1.065 < ε < 2.8."""
_LEAST_SINE = 0.01
"""Of the altitude in the gradation, where 1 / sin γ has no bound."""


class Conditions(NamedTuple):
    """What the model knows of each moment; equally long arrays."""

    zenith_angle_rad: Array
    clearness: Array
    brightness: Array
    bin: npt.NDArray[np.intp]


def sky_conditions(
    *,
    direct_normal_irradiance_w_m2: Any,
    diffuse_horizontal_irradiance_w_m2: Any,
    sun_altitude_deg: Any,
    extraterrestrial_irradiance_w_m2: Any = SOLAR_CONSTANT_W_M2,
) -> Conditions:
    r"""Sky clearness ε, sky brightness Δ and the bin they fall in.

    Parameters
    ----------
    direct_normal_irradiance_w_m2, diffuse_horizontal_irradiance_w_m2 : array_like [W/m²], at least 0
    sun_altitude_deg : array_like [deg]
        Below the horizon counts as on it.
    extraterrestrial_irradiance_w_m2 : array_like [W/m²]
        Normal to the sun.

    Returns
    -------
    Conditions
        Δ within 0.01..0.6.

    Notes
    -----
    :math:`\varepsilon = ((D + B)/D + \kappa Z^3) / (1 + \kappa Z^3)`, :math:`\Delta = m D / I_0` (theory/perez.md, eqs.
    1-2); R. Perez, P. Ineichen, R. Seals, J. Michalsky, R. Stewart, Solar Energy 44(5), 1990.
    """
    direct, diffuse, altitude, outside = np.broadcast_arrays(
        *(
            np.asarray(value, dtype=np.float64)
            for value in (
                direct_normal_irradiance_w_m2,
                diffuse_horizontal_irradiance_w_m2,
                np.clip(np.asarray(sun_altitude_deg, dtype=np.float64), 0.0, 90.0),
                extraterrestrial_irradiance_w_m2,
            )
        )
    )
    zenith_angle = np.pi / 2 - np.radians(altitude)
    cubed = 1.041 * zenith_angle**3
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(diffuse > 0.0, direct / diffuse, np.where(direct > 0.0, np.inf, 0.0))
    clearness = (1.0 + ratio + cubed) / (1.0 + cubed)
    brightness = np.clip(relative_air_mass(altitude) * diffuse / outside, LEAST_BRIGHTNESS, MOST_BRIGHTNESS)
    return Conditions(zenith_angle, clearness, brightness, np.searchsorted(CLEARNESS_BINS[1:], clearness, side="right"))


def luminance_parameters(conditions: Conditions) -> Array:
    r"""Parameters a to e of the relative luminance.

    Returns
    -------
    ndarray, shape (…, 5)

    Notes
    -----
    :math:`x = x_1 + x_2 Z + \Delta (x_3 + x_4 Z)`, other forms of c and d in the first bin; Δ at least 0.2 for
    1.065 < ε < 2.8 (theory/perez.md, eqs. 6-8).
    """
    zenith_angle = conditions.zenith_angle_rad
    between = (conditions.clearness > 1.065) & (conditions.clearness < 2.8)
    brightness = np.where(between, np.maximum(conditions.brightness, _KINDLED), conditions.brightness)
    rows = LUMINANCE[conditions.bin]
    z, delta = zenith_angle[..., None], brightness[..., None]
    found = np.asarray(rows[..., 0] + rows[..., 1] * z + delta * (rows[..., 2] + rows[..., 3] * z))
    overcast = conditions.bin == 0
    if overcast.any():
        c1, c2, c3, c4 = LUMINANCE[0, 2]
        d1, d2, d3, d4 = LUMINANCE[0, 3]
        z, delta = zenith_angle[overcast], brightness[overcast]
        found[overcast, 2] = np.exp((delta * (c1 + c2 * z)) ** c3) - c4
        found[overcast, 3] = -np.exp(delta * (d1 + d2 * z)) + d3 + delta * d4
    return found


def relative_luminance(parameters: Array, sin_altitude: Any, cos_from_sun: Any) -> Array:
    r"""Luminance of a point of the sky, up to a factor.

    Parameters
    ----------
    parameters : ndarray, shape (5,)
        Of `luminance_parameters`, for one moment.
    sin_altitude, cos_from_sun : array_like

    Returns
    -------
    ndarray, broadcast from the arguments
        Never negative.

    Notes
    -----
    :math:`\max(0, (1 + a e^{b / \sin\gamma}) (1 + c e^{d\chi} + e \cos^2\chi))` (theory/perez.md, eq. 5).
    """
    a, b, c, d, e = parameters
    sine = np.maximum(np.asarray(sin_altitude, dtype=np.float64), _LEAST_SINE)
    cosine = np.clip(np.asarray(cos_from_sun, dtype=np.float64), -1.0, 1.0)
    indicatrix = 1.0 + c * np.exp(d * np.arccos(cosine)) + e * cosine**2
    return np.asarray(np.maximum((1.0 + a * np.exp(b / sine)) * indicatrix, 0.0))


def precipitable_water_cm(dew_point_c: Any) -> Array:
    """Water in the air above, from the dew point at the ground (theory/perez.md, eq. 3)."""
    return np.exp(0.07 * np.asarray(dew_point_c, dtype=np.float64) - 0.075)


def diffuse_efficacy_lm_w(conditions: Conditions, *, dew_point_c: Any = DEW_POINT_C) -> Array:
    r"""Luminous efficacy of the sky's light.

    Notes
    -----
    :math:`a + b W + c \cos Z + d \ln\Delta`, never negative (theory/perez.md, eq. 3).
    """
    a, b, c, d = np.moveaxis(DIFFUSE_EFFICACY[conditions.bin], -1, 0)
    water = precipitable_water_cm(dew_point_c)
    found = a + b * water + c * np.cos(conditions.zenith_angle_rad) + d * np.log(conditions.brightness)
    return np.asarray(np.maximum(found, 0.0))


def direct_efficacy_lm_w(conditions: Conditions, *, dew_point_c: Any = DEW_POINT_C) -> Array:
    r"""Luminous efficacy of the sun.

    Notes
    -----
    :math:`a + b W + c e^{5.73 Z - 5} + d \Delta`, never negative (theory/perez.md, eq. 4).
    """
    a, b, c, d = np.moveaxis(DIRECT_EFFICACY[conditions.bin], -1, 0)
    water = precipitable_water_cm(dew_point_c)
    found = a + b * water + c * np.exp(5.73 * conditions.zenith_angle_rad - 5.0) + d * conditions.brightness
    return np.asarray(np.maximum(found, 0.0))
