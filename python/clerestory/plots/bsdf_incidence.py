"""The incidence that a figure of a BSDF shows, and the blocks that light takes from it."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from clerestory.bsdf import Bsdf
from clerestory.bsdf.band import Band, Block
from clerestory.errors import ClerestoryError
from clerestory.rules import one_of, within

Floats = np.ndarray[tuple[int, ...], np.dtype[np.float64]]
Side = Literal["front", "back"]


def travel_xy(elevation_deg: Any, azimuth_deg: Any = 0.0) -> Floats:
    """(x, y) of the direction in which light travels that comes from there (NOTATION.md), shape (..., 2)."""
    e, a = np.broadcast_arrays(np.radians(elevation_deg), np.radians(azimuth_deg))
    return np.stack([np.sin(a) * np.cos(e), -np.sin(e)], axis=-1)


def picked(
    bsdf: Bsdf, band: str, side: str, elevation_deg: float, azimuth_deg: float
) -> tuple[dict[str, Block], Floats]:
    """The blocks of one side that are known, by "Transmitted" and "Reflected", and (x, y) of the light.

    Raises
    ------
    ClerestoryError
        If the band is not known, nothing is known of that side, or an angle is out of its range.
    """
    one_of("side", side, ("front", "back"))
    within("elevation_deg", elevation_deg, -90.0, 90.0)
    within("azimuth_deg", azimuth_deg, -90.0, 90.0)
    chosen = band_of(bsdf, band)
    named = {"Transmitted": f"transmission_{side}", "Reflected": f"reflection_{side}"}
    blocks = {word: getattr(chosen, name) for word, name in named.items() if getattr(chosen, name) is not None}
    if not blocks:
        raise ClerestoryError(
            f"the {band} band of {bsdf.name!r} must have a block of the {side}, got none; ask the other"
        )
    return blocks, travel_xy(elevation_deg, azimuth_deg)


def band_of(bsdf: Bsdf, band: str) -> Band:
    """The band of a name, or an error that says which there are."""
    known = dict(bsdf.bands)
    return known[one_of("band", band, known)]


def incidence_words(elevation_deg: float, azimuth_deg: float, side: str) -> str:
    """The incidence for a title."""
    where = "outside" if side == "front" else "the room"
    height = "level" if elevation_deg == 0.0 else f"{abs(elevation_deg):g}° {'above' if elevation_deg > 0 else 'below'}"
    beside = "" if azimuth_deg == 0.0 else f", azimuth {azimuth_deg:g}°"
    return f"light from {where}, {height}{beside}"
