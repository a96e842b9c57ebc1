"""The solid parts of a cross-section as polygons, and its cuts as lines."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from clerestory._native import Profile

Floats = NDArray[np.float64]
#: Straight lines that stand for one arc.
_CHORDS = 24


@dataclass(frozen=True)
class Outline:
    """A cross-section between two heights.

    Parameters
    ----------
    solids : list of ndarray, each shape (4, 2)
        Corners z, y of trapezoids that fill all that is not air [mm].
    films : list of ndarray, each shape (2, 2)
        Ends z, y of cuts without width [mm].
    surfaces : list of ndarray, each shape (2, 2)
        Ends z, y of the boundaries between two media [mm].
    """

    solids: list[Floats]
    films: list[Floats]
    surfaces: list[Floats]


def outline(profile: Profile, low_mm: float, high_mm: float) -> Outline:
    """The part of a profile's endless stack of periods between two heights.

    Between two neighbouring heights of vertices no facet begins, ends or meets another: sorted by depth, facets there
    bound trapezoids of one medium each.
    """
    ends, _, left, right, film = profile.flattened(_CHORDS).facets()
    pitch = profile.pitch_mm
    rises = ends[:, [1, 3]]
    copies = np.arange(np.floor((low_mm - rises.max()) / pitch), np.ceil((high_mm - rises.min()) / pitch) + 1)
    shift = np.array([0.0, 1.0, 0.0, 1.0])
    lines = np.concatenate([ends + k * pitch * shift for k in copies]).reshape(-1, 2, 2)
    many = copies.size
    films = np.tile(np.array(film) >= 0, many)
    # going up, the right hand is the deeper side
    goes_up = lines[:, 1, 1] > lines[:, 0, 1]
    beyond = np.where(goes_up, np.tile(list(right), many), np.tile(list(left), many))
    clipped = [piece for piece in (_clip(line, low_mm, high_mm) for line in lines) if piece is not None]
    kept = [_clip(line, low_mm, high_mm) is not None for line in lines]
    heights = np.unique(np.round(np.concatenate([[low_mm, high_mm], *[piece[:, 1] for piece in clipped]]), 12))
    solids = []
    walls = lines[~films], beyond[~films]
    for bottom, top in pairwise(heights.tolist()):
        solids += _slab(*walls, bottom, top)
    is_film = films[kept]
    return Outline(
        solids,
        [piece for piece, f in zip(clipped, is_film, strict=True) if f],
        [piece for piece, f in zip(clipped, is_film, strict=True) if not f],
    )


def _slab(lines: Floats, beyond: NDArray[np.int64], bottom: float, top: float) -> list[Floats]:
    """Trapezoids of solid media between two heights that no line begins or ends between."""
    middle = 0.5 * (bottom + top)
    low, high = lines[:, :, 1].min(axis=1), lines[:, :, 1].max(axis=1)
    crossing = np.flatnonzero((low < middle) & (high > middle))

    def depth(y: float) -> Floats:
        (z0, y0), (z1, y1) = lines[crossing, 0].T, lines[crossing, 1].T
        depths: Floats = z0 + (z1 - z0) * (y - y0) / (y1 - y0)
        return depths

    order = np.argsort(depth(middle))
    at_bottom, at_top, medium = depth(bottom)[order], depth(top)[order], beyond[crossing][order]
    return [
        np.array([(at_bottom[i], bottom), (at_bottom[i + 1], bottom), (at_top[i + 1], top), (at_top[i], top)])
        for i in range(order.size - 1)
        if medium[i] != 0
    ]


def _clip(line: Floats, low: float, high: float) -> Floats | None:
    """The part of a line between two heights."""
    y0, y1 = line[:, 1]
    if max(y0, y1) < low or min(y0, y1) > high or (y0 == y1 and y0 in (low, high)):
        return None
    if y0 == y1:
        return line
    ends = np.clip((np.array([low, high]) - y0) / (y1 - y0), 0.0, 1.0)
    first, last = ends.min(), ends.max()
    return None if last <= first else line[0] + np.outer([first, last], line[1] - line[0])
