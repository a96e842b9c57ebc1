"""Diffuse horizontal illuminance of a CIE sky."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.polynomial import Chebyshev
from numpy.polynomial.legendre import leggauss

from clerestory.sky.cie import Array, depends_on_sun, gradation, indicatrix

_ALTITUDE_NODES = 160
_AZIMUTH_NODES = 240
_SUN_NODES = 24


def horizontal_over_zenith(sky_type: int, sin_sun_altitude: Any) -> Array:
    r"""Unobstructed diffuse horizontal illuminance of a CIE sky whose zenith has unit luminance.

    Parameters
    ----------
    sky_type : int, 1..16
    sin_sun_altitude : array_like, 0..1

    Returns
    -------
    ndarray of the same shape [lx per cd/m²]

    Notes
    -----
    :math:`E / L_z = \int f \varphi \sin\gamma\, d\omega / (f(Z_s) \varphi(0))` (theory/sky.md, eq. 5):
    Gauss-Legendre in sin γ, equal steps in azimuth, and a Chebyshev series in the sun's zenith angle; right to 2e-6.
    """
    sine = np.asarray(sin_sun_altitude, dtype=np.float64)
    zenith_angle = np.arccos(np.clip(sine, 0.0, 1.0))
    return _weighted_sky(sky_type)(zenith_angle) / (indicatrix(sky_type, sine) * gradation(sky_type, 1.0))


@lru_cache(maxsize=32)
def _weighted_sky(sky_type: int) -> Chebyshev:
    """∫ f φ sin γ dω as a series in the sun's zenith angle."""
    if not depends_on_sun(sky_type):
        return Chebyshev([_integral(sky_type, 0.0)], domain=[0.0, np.pi / 2])
    series: Chebyshev = Chebyshev.interpolate(
        lambda angles: np.array([_integral(sky_type, angle) for angle in angles]), _SUN_NODES, domain=[0.0, np.pi / 2]
    )
    return series


def _integral(sky_type: int, sun_zenith_angle: float) -> float:
    sine, weights = _sines()
    # the sky is symmetric about the sun's meridian: half of it, twice
    azimuth = (np.arange(_AZIMUTH_NODES) + 0.5) * np.pi / _AZIMUTH_NODES
    cos_from_sun = sine[:, None] * np.cos(sun_zenith_angle) + (
        np.sqrt(1.0 - sine**2)[:, None] * np.sin(sun_zenith_angle) * np.cos(azimuth)
    )
    mean_indicatrix = indicatrix(sky_type, cos_from_sun).mean(axis=1)
    return float(2.0 * np.pi * np.sum(weights * sine * gradation(sky_type, sine) * mean_indicatrix))


@lru_cache(maxsize=1)
def _sines() -> tuple[Array, Array]:
    nodes, weights = leggauss(_ALTITUDE_NODES)
    return (1.0 + nodes) / 2.0, weights / 2.0
