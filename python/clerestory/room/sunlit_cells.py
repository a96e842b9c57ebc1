"""Beams among so many facets that polygons would take too long: a grid of rays instead, one for each cell."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from clerestory.room.convex import Polygon, area, shared
from clerestory.room.sunlit import Plane, Shade
from clerestory.room.surroundings import Array, Indices, Surroundings

#: Cells along the longer side of the box about a beam.
_CELLS = 48


def cells_of(
    around: Surroundings, plane: Plane, direction: Array, pieces: Sequence[Polygon]
) -> list[tuple[Shade, list[Polygon]]]:
    """What each cell of a beam meets, as `visible` tells it; neighbours in a row on one flat are one.

    What is smaller than a cell may be missed, and edges are as rough as the cells.
    """
    corners, rows, middles = _grid(pieces)
    origin = plane.space([(float(x), float(y)) for x, y in middles])
    way = np.tile(direction, (len(origin), 1))
    distance, surface = around.meets(origin, way)
    met = surface >= 0
    normal = np.zeros_like(origin)
    normal[met] = around.normals(origin[met], way[met], distance[met], surface[met])
    # distance of the met plane as a + b x + c y over the plane of the beam
    steep = np.where(met, (normal * direction).sum(axis=1), 1.0)
    slopes = -(normal @ plane.axes[:2].T) / steep[:, None]
    level = distance - (slopes * middles).sum(axis=1)
    found: list[tuple[Shade, list[Polygon]]] = []
    fills = _fills(pieces, corners)
    kinds = np.column_stack([surface, np.where(met[:, None], np.column_stack([level, slopes]).round(6), 0.0)])
    for first, last in _runs(kinds, rows):
        if not met[first]:
            continue
        box = [*corners[first][:1], *corners[last][1:3], *corners[first][3:]]
        inside = [box] if fills else [one for piece in pieces if (one := shared(piece, box)) and area(one) > 1e-12]
        flat = (float(level[first]), float(slopes[first, 0]), float(slopes[first, 1]))
        if inside:
            found.append((Shade(box, flat, int(surface[first])), inside))
    return found


def sky_cells(
    around: Surroundings, plane: Plane, towards: Array, pieces: Sequence[Polygon]
) -> tuple[list[Polygon], float, Indices]:
    """Pieces that see the sky along a direction, the share not hidden by what is opaque, and how often each hides."""
    corners, rows, middles = _grid(pieces)
    origin = plane.space([(float(x), float(y)) for x, y in middles])
    _, surface = around.meets(origin, np.tile(towards, (len(origin), 1)))
    fills = _fills(pieces, corners)
    inside = np.array([fills or any(shared(piece, box) for piece in pieces) for box in corners])
    opaque = (surface >= 0) & ~around.is_window[surface] & inside
    left = []
    for first, last in _runs(np.column_stack([surface]), rows):
        if surface[first] < 0:
            box = [*corners[first][:1], *corners[last][1:3], *corners[first][3:]]
            left += [box] if fills else [one for piece in pieces if (one := shared(piece, box))]
    hidden = np.bincount(surface[opaque], minlength=len(around.names))
    return left, 1.0 - float(opaque.sum()) / max(1, int(inside.sum())), hidden


def _grid(pieces: Sequence[Polygon]) -> tuple[list[Polygon], Indices, Array]:
    """Cells of the box about pieces, the row of each, and their middles."""
    points = np.array([point for piece in pieces for point in piece])
    low, size = points.min(axis=0), np.maximum(np.ptp(points, axis=0), 1e-9)
    count = np.maximum(1, np.ceil(size / size.max() * _CELLS)).astype(int)
    step = size / count
    y, x = (index.ravel() for index in np.mgrid[0 : count[1], 0 : count[0]])
    start = low + np.column_stack([x, y]) * step
    steps = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * step
    boxes = [[(float(u), float(v)) for u, v in box] for box in start[:, None] + steps]
    return boxes, y, np.asarray(start + step / 2.0)


def _fills(pieces: Sequence[Polygon], boxes: Sequence[Polygon]) -> bool:
    """Whether pieces are all of the cells."""
    whole = area(boxes[0]) * len(boxes)
    return sum(map(area, pieces)) > (1.0 - 1e-9) * whole


def _runs(kinds: Array, rows: Indices) -> list[tuple[int, int]]:
    """First and last of each run of like neighbours in a row."""
    same = (kinds[1:] == kinds[:-1]).all(axis=1) & (rows[1:] == rows[:-1])
    starts = np.flatnonzero(np.concatenate([[True], ~same]))
    ends = np.concatenate([starts[1:] - 1, [len(kinds) - 1]])
    return list(zip(starts.tolist(), ends.tolist(), strict=True))
