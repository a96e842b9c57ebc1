"""Sums over the leaves of a tensor tree, cell by cell of a grid."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from clerestory.bsdf.shirley_chiu import Floats

if TYPE_CHECKING:
    from clerestory.bsdf.tree_block import TreeBlock


def hemispherical_grid(tree: TreeBlock) -> Floats:
    """What :meth:`TreeBlock.hemispherical` returns: exact sums, a leaf's share given to each cell it covers."""
    corner, width, value = tree.leaves
    cells = 2**tree.depth
    known = tree.rank - 2
    share = np.pi * value * width**2
    first = np.rint(corner[:, :known] * cells).astype(np.int64)
    wide = np.rint(width * cells).astype(np.int64)
    # each leaf adds its share over a box of cells: corners of a running sum, then the sum itself
    change = np.zeros((cells + 1,) * known)
    for corners in range(2**known):
        upper = (corners >> np.arange(known)) & 1
        sign = -1.0 if int(upper.sum()) % 2 else 1.0
        np.add.at(change, tuple((first + upper * wide[:, None]).T), sign * share)
    for axis in range(known):
        change = np.cumsum(change, axis=axis)
    grid = change[(slice(0, cells),) * known]
    return np.asarray(grid if tree.rank == 4 else grid[: max(1, cells // 2)])
