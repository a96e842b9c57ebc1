"""A BSDF as what fills a window."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from clerestory import _native
from clerestory.bsdf.band import Band
from clerestory.bsdf.completing import complete, words
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.rebasing import in_basis
from clerestory.bsdf.tree_block import TreeBlock
from clerestory.errors import ClerestoryError

if TYPE_CHECKING:
    from numpy.typing import NDArray

#: Share of the power that may leave beyond what arrives: measurements scatter a little.
_MOST_SHARE = 1.01


def glazing_of_band(band: Band, name: str) -> _native.Glazing:
    """The compiled half of a window with these blocks.

    Missing blocks are filled as in :func:`~clerestory.bsdf.completing.complete`. Matrices of several bases are brought
    to that of the front transmission.

    Raises
    ------
    ClerestoryError
        If a block has negative values, or what leaves is more than 1.01 of what arrives.
    """
    blocks = dict(complete(band, name, stacklevel=5))
    for direction, block in blocks.items():
        values = block.values if isinstance(block, KlemsBlock) else block.leaves.value
        if values.min() < 0.0:
            raise ClerestoryError(
                f"{words(direction)} of {name!r} must have no negative values to fill a window, got {values.min():g}"
            )
        most = float(block.hemispherical().max())
        if most > _MOST_SHARE:
            raise ClerestoryError(
                f"{words(direction)} of {name!r} must send away no more than {_MOST_SHARE:g} of the power to fill a "
                f"window, got {most:.4g}"
            )
    if band.is_tree:
        trees = [block for block in blocks.values() if isinstance(block, TreeBlock)]
        walks: list[NDArray[np.float64]] = [np.ascontiguousarray(tree.preorder) for tree in trees]
        return _native.Glazing.bsdf_tree(trees[0].rank, *walks)
    matrices = [block for block in blocks.values() if isinstance(block, KlemsBlock)]
    into, out = matrices[0].incident, matrices[0].outgoing
    if any((block.incident, block.outgoing) != (into, out) for block in matrices):
        out, matrices = into, [in_basis(block, into) for block in matrices]
    return _native.Glazing.bsdf_matrix(into.native, out.native, *(np.ascontiguousarray(m.values) for m in matrices))
