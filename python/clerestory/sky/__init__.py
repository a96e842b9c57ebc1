"""Skies: the CIE general skies and the patches a sky is divided into."""

from clerestory.sky.basis import BASES, patch_coordinates, sky_basis
from clerestory.sky.cie import GENERAL_SKIES, relative_luminance
from clerestory.sky.cie_sky import CieSky
from clerestory.sky.horizontal import horizontal_over_zenith
from clerestory.sky.patches import patch_means

__all__ = [
    "BASES",
    "GENERAL_SKIES",
    "CieSky",
    "horizontal_over_zenith",
    "patch_coordinates",
    "patch_means",
    "relative_luminance",
    "sky_basis",
]
