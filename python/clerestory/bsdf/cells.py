"""The outgoing patches or leaves of one incidence as outlines, for drawing."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from clerestory.bsdf.band import Block
from clerestory.bsdf.klems import Floats, KlemsBasis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.shirley_chiu import disc_to_square, square_to_disc

#: Longest step along a curved edge [rad].
_STEP = np.radians(2.0)


def patch_outline(basis: KlemsBasis, patch: int, step: float = _STEP) -> Floats:
    """Corners of a patch in (x, y), shape (n, 2), its curved edges in steps of 2°, or of ``step`` [rad]."""
    low, high, first, last = basis.bounds[patch]
    count = max(2, int(np.ceil((last - first) / step)) + 1)
    phi = np.linspace(first, last, count)
    edge = np.stack([np.cos(phi), np.sin(phi)], axis=1)
    return np.concatenate([np.sin(high) * edge, np.sin(low) * edge[::-1]])


def outgoing_cells(block: Block, incident: npt.ArrayLike) -> tuple[list[Floats], Floats]:
    """Outlines in (x, y) of where light of one incidence goes, and the value in each [1/sr].

    Parameters
    ----------
    block : KlemsBlock or TreeBlock
    incident : (x, y) of the direction of travel
    """
    point = np.asarray(incident, dtype=np.float64)
    if isinstance(block, KlemsBlock):
        column = int(block.incident.find(point[0], point[1]))
        return [patch_outline(block.outgoing, patch) for patch in range(len(block.outgoing))], block.values[:, column]
    corner, width, value = block.leaves
    known = block.rank - 2
    place = disc_to_square(point) if block.rank == 4 else np.array([0.5 - 0.5 * float(np.hypot(*point)) - 1e-9])
    place = np.clip(place, 0.0, 1.0 - 1e-9)
    holds = ((corner[:, :known] <= place) & (place < corner[:, :known] + width[:, None])).all(axis=1)
    turn = 0.0 if block.rank == 4 else float(np.arctan2(point[1], point[0]))
    rotation = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    squares = [_square(start, side) for start, side in zip(corner[holds, known:], width[holds], strict=True)]
    ends = np.cumsum([len(one) for one in squares])[:-1]
    return np.split(square_to_disc(np.concatenate(squares)) @ rotation, ends), value[holds]


def _square(start: Floats, side: float) -> Floats:
    return np.asarray(start + side * _unit_square(max(2, round(24 * side))))


@lru_cache(maxsize=64)
def _unit_square(count: int) -> Floats:
    """Its edges, each in ``count`` steps."""
    steps = np.linspace(0.0, 1.0, count, endpoint=False)[:, None]
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]])
    return np.concatenate([corners[k] + steps * (corners[k + 1] - corners[k]) for k in range(4)])
