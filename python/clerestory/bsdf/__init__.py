"""BSDFs: matrices and tensor trees of what a window element does to light, and the files that hold them."""

from clerestory.bsdf.band import Band
from clerestory.bsdf.bsdf import Bsdf
from clerestory.bsdf.checking import Finding
from clerestory.bsdf.energyplus import EnergyPlusGap, EnergyPlusLayer, energyplus_objects
from clerestory.bsdf.energyplus_file import write_energyplus
from clerestory.bsdf.klems import KLEMS_BASES, KlemsBasis, klems_basis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.layers import LayeredBand, LayeredBsdf, layered_band, layered_bsdf
from clerestory.bsdf.radiance_matrix import read_radiance_matrix, write_radiance_matrix
from clerestory.bsdf.radiance_scene import radiance_snippet
from clerestory.bsdf.rebasing import in_basis
from clerestory.bsdf.told import BsdfWarning
from clerestory.bsdf.tree_block import TreeBlock

__all__ = [
    "KLEMS_BASES",
    "Band",
    "Bsdf",
    "BsdfWarning",
    "EnergyPlusGap",
    "EnergyPlusLayer",
    "Finding",
    "KlemsBasis",
    "KlemsBlock",
    "LayeredBand",
    "LayeredBsdf",
    "TreeBlock",
    "energyplus_objects",
    "in_basis",
    "klems_basis",
    "layered_band",
    "layered_bsdf",
    "radiance_snippet",
    "read_radiance_matrix",
    "write_energyplus",
    "write_radiance_matrix",
]
