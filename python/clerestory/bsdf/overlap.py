"""Which part of one division of the hemisphere lies in which patch of another, by projected solid angle."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from clerestory.bsdf.klems import Floats, KlemsBasis
from clerestory.bsdf.shirley_chiu import square_to_disc

if TYPE_CHECKING:
    from scipy.sparse import csr_array  # type: ignore[import-untyped]

#: The square is divided into this many points a side to find the patch of each.
_POINTS = 1024


def overlap(basis: KlemsBasis, other: KlemsBasis) -> Floats:
    """Projected solid angle that each patch of ``basis`` shares with each of ``other``, shape (basis, other) [sr].

    Both divide into rings and equal azimuths, so the overlaps are those of intervals: exact.
    """
    mine, theirs = basis.bounds, other.bounds
    sine2 = np.sin(mine[:, :2]) ** 2, np.sin(theirs[:, :2]) ** 2
    low = np.maximum(sine2[0][:, None, 0], sine2[1][None, :, 0])
    high = np.minimum(sine2[0][:, None, 1], sine2[1][None, :, 1])
    width = np.zeros_like(low)
    for turn in (-2.0 * np.pi, 0.0, 2.0 * np.pi):
        first = np.maximum(mine[:, None, 2], theirs[None, :, 2] + turn)
        last = np.minimum(mine[:, None, 3], theirs[None, :, 3] + turn)
        width += np.maximum(last - first, 0.0)
    return np.asarray(0.5 * np.maximum(high - low, 0.0) * width)


@lru_cache(maxsize=64)
def cells_in_patches(basis: KlemsBasis, level: int) -> csr_array:
    """Projected solid angle that each patch shares with each cell of the square, sparse (patch, 4**level) [sr].

    The square is that of Shirley and Chiu with 2**level cells a side; cells count (u, v), v fastest. Each of 1024²
    points of the square, one at random in each of as many squares, belongs to one patch, so a cell's parts add to its
    area exactly; a patch's parts add to its projected solid angle within about 0.2 %.
    """
    from scipy.sparse import coo_array

    side = max(_POINTS, 2**level)
    grid = np.stack(np.meshgrid(*[np.arange(side)] * 2, indexing="ij"), axis=-1).reshape(-1, 2)
    grid = (grid + np.random.default_rng(0).random(grid.shape)) / side
    disc = square_to_disc(grid)
    patch = basis.find(disc[:, 0], disc[:, 1])
    cell = (grid * 2**level).astype(np.int64)
    number = cell[:, 0] * 2**level + cell[:, 1]
    area = np.full(len(grid), np.pi / side**2)
    return coo_array((area, (patch, number)), shape=(len(basis), 4**level)).tocsr()
