"""The patches that a sky is divided into."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from clerestory._native import SkyBasis
from clerestory.errors import ClerestoryError

BASES = ("tregenza145", "reinhart577", "reinhart2305", "troplux5221")
"""The usual divisions of the sky; any ``reinhart{144 m² + 1}`` is one too."""


@lru_cache(maxsize=8)
def sky_basis(name: str) -> SkyBasis:
    """A division of the sky into patches, with the ground as the last.

    Parameters
    ----------
    name : str
        ``"tregenza145"``, ``"reinhart577"``, ``"reinhart2305"`` … (144 m² + 1 patches) or ``"troplux5221"``
        (145 × 36 + 1: each of the 144 patches below the zenith in 6 × 6, the zenith cap in 37 of one area).

    Returns
    -------
    SkyBasis
        Rings from the horizon up, clockwise from north in each, then the zenith, then the ground
        (theory/sky.md, eq. 7).

    Raises
    ------
    ClerestoryError
        If no basis has that name.
    """
    if not isinstance(name, str):
        raise ClerestoryError(f"basis must be a name such as {', '.join(BASES)}, got {name!r}")
    return SkyBasis(name)


def patch_coordinates(name: str) -> dict[str, Any]:
    """Coordinates of the dimension "patch": centre, size and kind of each patch of a basis."""
    basis = sky_basis(name)
    centres = np.asarray(basis.centres)
    altitude = np.degrees(np.arcsin(np.clip(centres[:, 2], -1.0, 1.0)))
    azimuth = np.degrees(np.arctan2(centres[:, 0], centres[:, 1])) % 360.0
    degrees = {"units": "degree"}
    return {
        "patch": ("patch", np.arange(len(centres)), {"long_name": "patch: rings from the horizon up, then the ground"}),
        "patch_altitude_deg": ("patch", altitude, {"long_name": "altitude of the patch's centre", **degrees}),
        "patch_azimuth_deg": (
            "patch",
            azimuth,
            {"long_name": "azimuth of the patch's centre, clockwise from north", **degrees},
        ),
        "patch_solid_angle_sr": (
            "patch",
            np.asarray(basis.solid_angles),
            {"long_name": "solid angle of the patch", "units": "sr"},
        ),
    }
