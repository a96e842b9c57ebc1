"""Tensor trees for light that goes the other way."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from clerestory.bsdf.shirley_chiu import Floats, square_to_disc

if TYPE_CHECKING:
    from clerestory.bsdf.tree_block import TreeBlock

#: Levels of the grid on which a tree of rank 3 is turned round.
_LEVELS = 5


def preorder_of_grid(grid: Floats) -> Floats:
    """Walk through the tree whose leaves are the cells of a grid of shape (2**k,) * rank, coordinate 0 first."""
    rank, levels = grid.ndim, int(grid.shape[0]).bit_length() - 1
    if levels == 0:
        return np.array(grid.reshape(1), dtype=np.float64)
    bits = grid.reshape((2,) * (rank * levels))
    # coordinate d, bit b stands on axis d * levels + b; children count coordinate 0 fastest
    order = [d * levels + b for b in range(levels) for d in reversed(range(rank))]
    walk = bits.transpose(order).reshape(-1, 1)
    for _ in range(levels):
        walk = walk.reshape(-1, 2**rank * walk.shape[1])
        walk = np.concatenate([np.full((len(walk), 1), np.nan), walk], axis=1)
    return np.ascontiguousarray(walk.reshape(-1))


def turned_round(tree: TreeBlock) -> Floats:
    """Walk through the tree with the incident and the outgoing direction exchanged and negated (theory/bsdf.md, eq. 5).

    Rank 4 is exact. Rank 3 has no place for it in general and is evaluated on a grid of 2⁵ cells a side.
    """
    if tree.rank == 4:
        # the map of disc on square keeps −: a coordinate u becomes 1 − u, so each half becomes the other
        child = np.arange(16)
        source = 15 - (((child & 3) << 2) | (child >> 2))
        return _reordered(tree, source)
    cells = 2**_LEVELS
    u = (np.arange(cells) + 0.5) / cells
    sine = np.abs(1.0 - 2.0 * u)
    out = square_to_disc(np.stack(np.meshgrid(u, u, indexing="ij"), axis=-1))
    incident = np.stack([sine, np.zeros(cells)], axis=-1)[:, None, None, :]
    grid = tree.at(-out[None], -np.broadcast_to(incident, (cells, cells, cells, 2)))
    grid[cells // 2 :] = 0.0
    return preorder_of_grid(grid)


def _reordered(tree: TreeBlock, source: np.ndarray[tuple[int, ...], np.dtype[np.int64]]) -> Floats:
    """Walk in which child k of every node is what child ``source[k]`` was."""
    inner, children = np.isnan(tree.preorder), tree.children
    number = np.cumsum(inner) - 1
    walk: list[int] = []
    to_visit = [0]
    turned = children[:, source[::-1]].tolist()
    numbers, is_inner = number.tolist(), inner.tolist()
    while to_visit:
        node = to_visit.pop()
        walk.append(node)
        if is_inner[node]:
            to_visit.extend(turned[numbers[node]])
    return tree.preorder[walk]
