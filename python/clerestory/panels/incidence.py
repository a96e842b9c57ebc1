"""Directions in a panel's words and as vectors: elevation, azimuth and side to x, y, z and back."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clerestory.array_rules import numbers
from clerestory.errors import ClerestoryError

Side = Literal["front", "back"]
Floats = NDArray[np.float64]

SIDES = ("front", "back")


def finite(name: str, value: ArrayLike) -> Floats:
    """``value`` as an array of finite numbers: None, text and truth values are none."""
    if value is None or np.asarray(value).dtype == np.bool_:
        raise ClerestoryError(f"{name} must be a number or a list of numbers, got {value!r}; give numbers")
    array = numbers(name, value)
    if not np.isfinite(array).all():
        raise ClerestoryError(
            f"{name} must be finite, got {array[~np.isfinite(array)].flat[0]}; replace or leave it out"
        )
    return array


def angles(name: str, value: ArrayLike) -> Floats:
    """``value`` as a list of angles between -90 and 90 degrees, shape (k,), in the order given."""
    array = np.atleast_1d(finite(name, value))
    if array.ndim != 1 or array.size == 0:
        raise ClerestoryError(f"{name} must be a number or a list of numbers, got shape {array.shape}; flatten it")
    wrong = ~((array > -90.0) & (array < 90.0))
    if wrong.any():
        raise ClerestoryError(
            f"{name} must be greater than -90 and less than 90, got {array[wrong][0]:g}; at 90 light runs along the "
            "panel and never meets it, come as near as 89.9"
        )
    return array


def incident_directions(elevation_deg: Floats, azimuth_deg: Floats, side: str) -> Floats:
    """Unit vectors along which light travels to a panel.

    Parameters
    ----------
    elevation_deg, azimuth_deg : ndarrays that broadcast, between -90 and 90 [degrees]
    side : {"front", "back"}

    Returns
    -------
    ndarray, shape (..., 3)
        (sin a cos e, -sin e, cos a cos e), z reversed on the back (NOTATION.md).
    """
    elevation, azimuth = np.radians(elevation_deg), np.radians(azimuth_deg)
    across = np.cos(azimuth) * np.cos(elevation)
    components = (np.sin(azimuth) * np.cos(elevation), -np.sin(elevation), across if side == "front" else -across)
    return np.stack(np.broadcast_arrays(*components), axis=-1)


def leaving_angles(directions: Floats) -> tuple[Floats, Floats]:
    """Elevation and azimuth of light that leaves a panel.

    Parameters
    ----------
    directions : ndarray, shape (k, 3)
        Unit vectors along which light travels away.

    Returns
    -------
    elevation_deg : ndarray, shape (k,), -90..90 [degrees]
        Above 0 for light that travels upwards.
    azimuth_deg : ndarray, shape (k,), -90..90 [degrees]
        About the panel's y axis from its normal, above 0 towards +x.
    """
    x, y, z = directions.T
    elevation = np.degrees(np.arcsin(np.clip(y, -1.0, 1.0)))
    return elevation, np.degrees(np.arctan2(x, np.abs(z)))
