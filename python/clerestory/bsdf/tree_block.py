"""One tensor tree of a BSDF: fine where light is sent, coarse elsewhere."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from clerestory.bsdf.shirley_chiu import Floats, disc_to_square
from clerestory.errors import ClerestoryError

#: Deepest a tree may be: cells of 2⁻¹² of the square's side, finer than any measurement.
DEEPEST = 12


class Leaves(NamedTuple):
    """The leaves of a tree."""

    corner: Floats
    """Lower corner of each in the unit cube, shape (leaf, rank)."""
    width: Floats
    """Edge of each, shape (leaf,)."""
    value: Floats
    """Of each [1/sr], shape (leaf,)."""


@dataclass(frozen=True, eq=False)
class TreeBlock:
    """How a window element sends light from any direction into any other, as a tree of cubes.

    Parameters
    ----------
    rank : 3 or 4
        4: the coordinates are those of the incident and of the outgoing direction of travel, each mapped from disc to
        square (theory/bsdf.md, eq. 7). 3: the element has no preferred azimuth; the first coordinate is
        (1 − sin θ)/2 of the incident direction, whose azimuth is turned to +x.
    preorder : array of shape (n,) [1/sr]
        A walk through the tree: NaN is an inner node, whose 2**rank children follow, else the value of a leaf. Bit k of
        the number of a child says which half it takes of coordinate k.

    Raises
    ------
    ClerestoryError
        If the walk ends early or late, is deeper than 12 levels, or a leaf is infinite.
    """

    rank: int
    preorder: Floats

    def __post_init__(self) -> None:
        if self.rank not in (3, 4):
            raise ClerestoryError(f"rank must be 3 or 4, got {self.rank!r}")
        try:
            preorder = np.array(self.preorder, dtype=np.float64)
        except (TypeError, ValueError):
            raise ClerestoryError(f"preorder must be numbers, got {type(self.preorder).__name__}") from None
        if preorder.ndim != 1 or not len(preorder):
            raise ClerestoryError(f"preorder must have one dimension and a value, got shape {preorder.shape}")
        if np.isinf(preorder).any():
            place = int(np.argmax(np.isinf(preorder)))
            raise ClerestoryError(f"preorder must be finite, got {preorder[place]} at entry {place}")
        preorder.flags.writeable = False
        object.__setattr__(self, "preorder", preorder)
        # how many nodes are still to come after each entry: 0 for the first time at the end
        to_come = 1 + np.cumsum(np.where(np.isnan(preorder), 2**self.rank - 1, -1))
        ended = np.flatnonzero(to_come == 0)
        if not len(ended):
            raise ClerestoryError(f"preorder must be a whole tree, but {int(to_come[-1])} nodes are missing at its end")
        if ended[0] != len(preorder) - 1:
            last, more = int(ended[0]), len(preorder) - 1 - int(ended[0])
            raise ClerestoryError(f"preorder must end with its tree at entry {last}, got {more} entries more")
        if self.depth > DEEPEST:
            raise ClerestoryError(f"preorder must be {DEEPEST} levels deep at most, got {self.depth}; merge leaves")

    @cached_property
    def _walk(self) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        """Depth of each node, its number among its siblings, and its parent, in the order of the walk."""
        size = 2**self.rank
        inner = np.isnan(self.preorder).tolist()
        depth, number, parent = [0] * len(inner), [0] * len(inner), [-1] * len(inner)
        open_nodes: list[list[int]] = []  # node, children met so far
        for node, is_inner in enumerate(inner):
            if open_nodes:
                top = open_nodes[-1]
                depth[node], number[node], parent[node] = len(open_nodes), top[1], top[0]
                top[1] += 1
            if is_inner:
                open_nodes.append([node, 0])
            else:
                while open_nodes and open_nodes[-1][1] == size:
                    open_nodes.pop()
        return np.asarray(depth), np.asarray(number), np.asarray(parent)

    @property
    def depth(self) -> int:
        """Levels below the root; the finest cells are 2**-depth wide."""
        return int(self._walk[0].max())

    @cached_property
    def leaves(self) -> Leaves:
        """Every leaf with its place."""
        depth, number, parent = self._walk
        corner = np.zeros((len(depth), self.rank))
        bits = (number[:, None] >> np.arange(self.rank)) & 1
        for level in range(1, self.depth + 1):
            nodes = np.flatnonzero(depth == level)
            corner[nodes] = corner[parent[nodes]] + bits[nodes] * 0.5**level
        leaf = ~np.isnan(self.preorder)
        return Leaves(corner[leaf], np.asarray(0.5 ** depth[leaf], dtype=np.float64), self.preorder[leaf])

    @cached_property
    def children(self) -> npt.NDArray[np.int64]:
        """Entries of the children of each inner node, in the order of the walk, shape (inner, 2**rank)."""
        _, number, parent = self._walk
        inner = np.cumsum(np.isnan(self.preorder)) - 1
        table = np.zeros((int(np.isnan(self.preorder).sum()), 2**self.rank), dtype=np.int64)
        table[inner[parent[1:]], number[1:]] = np.arange(1, len(number))
        return table

    def value_at(self, place: npt.ArrayLike) -> Floats:
        """Value of the leaf at each point of the unit cube, shape (..., rank) → (...,) [1/sr]."""
        given = np.asarray(place, dtype=np.float64)
        shape, within = given.shape[:-1], np.clip(given.reshape(-1, self.rank), 0.0, 1.0 - 1e-12)
        inner = np.cumsum(np.isnan(self.preorder)) - 1
        node = np.zeros(len(within), dtype=np.int64)
        for _ in range(self.depth):
            going = np.isnan(self.preorder[node])
            within = 2.0 * within
            half = (within >= 1.0).astype(np.int64)
            within = within - half
            child = (half << np.arange(self.rank)).sum(axis=1)
            node[going] = self.children[inner[node[going]], child[going]]
        return np.asarray(self.preorder[node].reshape(shape))

    def at(self, incident: npt.ArrayLike, outgoing: npt.ArrayLike) -> Floats:
        """Value for light that travels in along one direction and out along another [1/sr].

        Parameters
        ----------
        incident, outgoing : arrays of shape (..., 2)
            (x, y) of the directions of travel.
        """
        i, o = np.broadcast_arrays(np.asarray(incident, dtype=np.float64), np.asarray(outgoing, dtype=np.float64))
        if self.rank == 4:
            return self.value_at(np.concatenate([disc_to_square(i), disc_to_square(o)], axis=-1))
        sine = np.hypot(i[..., 0], i[..., 1])
        cos = np.where(sine > 0.0, i[..., 0] / np.where(sine > 0.0, sine, 1.0), 1.0)
        sin = np.where(sine > 0.0, i[..., 1] / np.where(sine > 0.0, sine, 1.0), 0.0)
        # the plane of incidence is turned to +x, and the outgoing direction with it
        turned = np.stack([cos * o[..., 0] + sin * o[..., 1], cos * o[..., 1] - sin * o[..., 0]], axis=-1)
        first = np.minimum(0.5 - 0.5 * np.minimum(sine, 1.0), 0.5 - 1e-9)
        return self.value_at(np.concatenate([first[..., None], disc_to_square(turned)], axis=-1))

    def hemispherical_at(self, incident: npt.ArrayLike) -> Floats:
        """Share of the power that leaves for light along each of the directions (x, y), shape (..., 2) → (...,)."""
        given = np.asarray(incident, dtype=np.float64)
        shape, flat = given.shape[:-1], given.reshape(-1, 2)
        if self.rank == 4:
            place = disc_to_square(flat)
        else:
            place = np.minimum(0.5 - 0.5 * np.hypot(flat[:, :1], flat[:, 1:]), 0.5 - 1e-9)
        place = np.clip(place, 0.0, 1.0 - 1e-12)
        corner, width, value = self.leaves
        of_leaf = np.pi * value * width**2
        known = self.rank - 2
        result = np.empty(len(flat))
        for row, point in enumerate(place):
            holds = ((corner[:, :known] <= point) & (point < corner[:, :known] + width[:, None])).all(axis=1)
            result[row] = of_leaf[holds].sum()
        return result.reshape(shape)

    def hemispherical(self) -> Floats:
        """Share of the power that leaves, mean over each cell of a grid of incidence as fine as the tree.

        Returns
        -------
        array of shape (2**depth, 2**depth) over the square, or (2**depth / 2,) over (1 − sin θ)/2 if the rank is 3
        """
        from clerestory.bsdf.tree_sums import hemispherical_grid

        return hemispherical_grid(self)

    def mean(self) -> float:
        """Share that leaves of light that comes from everywhere with one radiance (theory/bsdf.md, eq. 4)."""
        grid = self.hemispherical()
        if self.rank == 4:
            return float(grid.mean())
        edges = np.linspace(0.0, 0.5, len(grid) + 1)
        sine2 = (1.0 - 2.0 * edges) ** 2
        return float(grid @ (sine2[:-1] - sine2[1:]))

    def reversed(self) -> TreeBlock:
        """The block for light that goes the other way along the same paths (theory/bsdf.md, eq. 5).

        Exact for rank 4; a tree of rank 3 is evaluated on a grid of 2⁵ cells a side.
        """
        from clerestory.bsdf.tree_turning import turned_round

        return TreeBlock(self.rank, turned_round(self))
