"""Skies: the CIE general skies, the all-weather sky and the patches a sky is divided into."""

from clerestory.sky.basis import BASES, patch_coordinates, sky_basis
from clerestory.sky.cie import GENERAL_SKIES, relative_luminance
from clerestory.sky.cie_sky import CieSky
from clerestory.sky.horizontal import horizontal_over_zenith
from clerestory.sky.patches import patch_means
from clerestory.sky.perez_sky import PerezSky

__all__ = [
    "BASES",
    "GENERAL_SKIES",
    "CieSky",
    "PerezSky",
    "horizontal_over_zenith",
    "patch_coordinates",
    "patch_means",
    "relative_luminance",
    "sky_basis",
]
