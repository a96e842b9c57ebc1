"""BSDFs: matrices and tensor trees of what a window element does to light, and the files that hold them."""

from clerestory.bsdf.band import Band
from clerestory.bsdf.bsdf import Bsdf
from clerestory.bsdf.klems import KLEMS_BASES, KlemsBasis, klems_basis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.told import BsdfWarning
from clerestory.bsdf.tree_block import TreeBlock

__all__ = ["KLEMS_BASES", "Band", "Bsdf", "BsdfWarning", "KlemsBasis", "KlemsBlock", "TreeBlock", "klems_basis"]
