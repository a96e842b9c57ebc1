"""The 15 CIE general skies and the traditional overcast sky, relative to the zenith."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from clerestory.errors import ClerestoryError

Array = npt.NDArray[np.float64]

TRADITIONAL_OVERCAST = 16
"""Number of the traditional overcast sky, (1 + 2 sin γ) / 3, which the 15 general skies do not contain."""


class Gradation(NamedTuple):
    """One row of the standard's Table 1: gradation a, b and indicatrix c, d, e."""

    a: float
    b: float
    c: float
    d: float
    e: float
    description: str


GENERAL_SKIES: dict[int, Gradation] = {
    1: Gradation(4.0, -0.70, 0.0, -1.0, 0.00, "overcast, steep gradation, azimuthal uniformity"),
    2: Gradation(4.0, -0.70, 2.0, -1.5, 0.15, "overcast, steep gradation, slight brightening towards the sun"),
    3: Gradation(1.1, -0.80, 0.0, -1.0, 0.00, "overcast, moderate gradation, azimuthal uniformity"),
    4: Gradation(1.1, -0.80, 2.0, -1.5, 0.15, "overcast, moderate gradation, slight brightening towards the sun"),
    5: Gradation(0.0, -1.00, 0.0, -1.0, 0.00, "uniform luminance"),
    6: Gradation(0.0, -1.00, 2.0, -1.5, 0.15, "partly cloudy, no gradation, slight brightening towards the sun"),
    7: Gradation(0.0, -1.00, 5.0, -2.5, 0.30, "partly cloudy, no gradation, brighter circumsolar region"),
    8: Gradation(0.0, -1.00, 10.0, -3.0, 0.45, "partly cloudy, no gradation, distinct solar corona"),
    9: Gradation(-1.0, -0.55, 2.0, -1.5, 0.15, "partly cloudy, obscured sun"),
    10: Gradation(-1.0, -0.55, 5.0, -2.5, 0.30, "partly cloudy, brighter circumsolar region"),
    11: Gradation(-1.0, -0.55, 10.0, -3.0, 0.45, "white-blue, distinct solar corona"),
    12: Gradation(-1.0, -0.32, 10.0, -3.0, 0.45, "clear, low turbidity"),
    13: Gradation(-1.0, -0.32, 16.0, -3.0, 0.30, "clear, polluted atmosphere"),
    14: Gradation(-1.0, -0.15, 16.0, -3.0, 0.30, "cloudless turbid, broad solar corona"),
    15: Gradation(-1.0, -0.15, 24.0, -2.8, 0.15, "white-blue turbid, broad solar corona"),
}
"""CIE S 011/E:2003 = ISO 15469:2004, Table 1."""


def check_sky_type(sky_type: Any) -> int:
    """The number of a sky, 1..16."""
    if isinstance(sky_type, bool) or sky_type not in range(1, TRADITIONAL_OVERCAST + 1):
        raise ClerestoryError(
            f"sky_type must be 1..15 (CIE general skies) or 16 (traditional overcast, (1 + 2 sin)/3), got {sky_type!r}"
        )
    return int(sky_type)


def depends_on_sun(sky_type: int) -> bool:
    """Whether a sky is brighter towards the sun."""
    return sky_type != TRADITIONAL_OVERCAST and (GENERAL_SKIES[sky_type].c != 0.0 or GENERAL_SKIES[sky_type].e != 0.0)


def gradation(sky_type: int, sin_altitude: Any) -> Array:
    """φ: how luminance changes from the horizon (1 for the general skies) to the zenith.

    (theory/sky.md, eqs. 1 and 4).
    """
    sine = np.asarray(sin_altitude, dtype=np.float64)
    if sky_type == TRADITIONAL_OVERCAST:
        return (1.0 + 2.0 * sine) / 3.0
    row = GENERAL_SKIES[sky_type]
    # exp(b / sin γ) falls to 0 at the horizon, as the standard sets it there
    with np.errstate(divide="ignore", under="ignore"):
        return np.asarray(1.0 + row.a * np.exp(row.b / np.maximum(sine, 0.0)))


def indicatrix(sky_type: int, cos_from_sun: Any) -> Array:
    """f: how luminance changes with the angle χ from the sun (theory/sky.md, eq. 2)."""
    cosine = np.clip(np.asarray(cos_from_sun, dtype=np.float64), -1.0, 1.0)
    if not depends_on_sun(sky_type):
        return np.ones_like(cosine)
    row = GENERAL_SKIES[sky_type]
    return np.asarray(1.0 + row.c * (np.exp(row.d * np.arccos(cosine)) - np.exp(row.d * np.pi / 2)) + row.e * cosine**2)


def relative_luminance(sky_type: int, sin_altitude: Any, cos_from_sun: Any, sin_sun_altitude: Any) -> Array:
    r"""Luminance of a point of the sky over that of the zenith.

    Parameters
    ----------
    sky_type : int
        1..15, a CIE general sky; 16, the traditional overcast sky.
    sin_altitude : array_like, 0..1
        Sine of the point's altitude.
    cos_from_sun : array_like, -1..1
        Cosine of the angle between the point and the sun.
    sin_sun_altitude : array_like, 0..1
        Sine of the sun's altitude.

    Returns
    -------
    ndarray, broadcast from the arguments

    Notes
    -----
    :math:`L / L_z = f(\chi) \varphi(Z) / (f(Z_s) \varphi(0))` (theory/sky.md, eq. 3); ISO 15469:2004.
    """
    return (
        indicatrix(sky_type, cos_from_sun)
        * gradation(sky_type, sin_altitude)
        / (indicatrix(sky_type, sin_sun_altitude) * gradation(sky_type, 1.0))
    )
