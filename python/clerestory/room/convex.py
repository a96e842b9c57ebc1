"""Convex polygons of a plane, cut and subtracted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import numpy.typing as npt

Point = tuple[float, float]
Polygon = list[Point]

#: Corners closer to a cutting line than this lie on it, and pieces smaller than its square are none [m].
NEAR = 1e-9


def cut(polygon: Sequence[Point], a: float, b: float, c: float) -> Polygon:
    """The part of a convex polygon where a x + b y + c is at least 0; empty if that is no more than an edge."""
    heights = [a * x + b * y + c for x, y in polygon]
    if min(heights) >= -NEAR:
        return list(polygon)
    if max(heights) <= NEAR:
        return []
    kept: Polygon = []
    for index, (here, height) in enumerate(zip(polygon, heights, strict=True)):
        before, low = polygon[index - 1], heights[index - 1]
        if (low > NEAR and height < -NEAR) or (low < -NEAR and height > NEAR):
            share = low / (low - height)
            kept.append((before[0] + share * (here[0] - before[0]), before[1] + share * (here[1] - before[1])))
        if height >= -NEAR:
            kept.append(here)
    return kept if len(kept) > 2 else []


def edges(polygon: Sequence[Point]) -> Iterable[tuple[float, float, float]]:
    """Of each edge of a polygon that runs anticlockwise the line (a, b, c), positive within, (a, b) of length 1."""
    for index, (x, y) in enumerate(polygon):
        x0, y0 = polygon[index - 1]
        along, up = x - x0, y - y0
        length = float(np.hypot(along, up))
        if length > NEAR:
            a, b = -up / length, along / length
            yield a, b, -(a * x0 + b * y0)


def shared(polygon: Sequence[Point], other: Sequence[Point]) -> Polygon:
    """What two convex polygons that run anticlockwise share."""
    if apart(polygon, other):
        return []
    found = list(polygon)
    for line in edges(other):
        found = cut(found, *line)
        if not found:
            break
    return found


def without(pieces: Sequence[Sequence[Point]], other: Sequence[Point]) -> list[Polygon]:
    """Convex pieces less a convex polygon, all anticlockwise: convex pieces again."""
    left: list[Polygon] = []
    for piece in pieces:
        if apart(piece, other) or not shared(piece, other):
            left.append(list(piece))
            continue
        rest = list(piece)
        for a, b, c in edges(other):
            outside = cut(rest, -a, -b, -c)
            if outside:
                left.append(outside)
            rest = cut(rest, a, b, c)
            if not rest:
                break
    return left


def apart(polygon: Sequence[Point], other: Sequence[Point]) -> bool:
    """Whether the boxes about two polygons share no area."""
    for axis in (0, 1):
        mine, theirs = [p[axis] for p in polygon], [p[axis] for p in other]
        if max(mine) <= min(theirs) + NEAR or max(theirs) <= min(mine) + NEAR:
            return True
    return False


def area(polygon: Sequence[Point]) -> float:
    """Positive for one that runs anticlockwise."""
    return 0.5 * sum(polygon[k - 1][0] * polygon[k][1] - polygon[k][0] * polygon[k - 1][1] for k in range(len(polygon)))


def anticlockwise(corners: npt.NDArray[np.float64]) -> Polygon:
    """Corners as a polygon that runs anticlockwise."""
    polygon = [(float(x), float(y)) for x, y in corners]
    return polygon if area(polygon) >= 0.0 else polygon[::-1]


def is_convex(corners: npt.NDArray[np.float64], normal: npt.NDArray[np.float64]) -> bool:
    """Whether a planar polygon in space turns one way only, about its normal, and once."""
    steps = np.roll(corners, -1, axis=0) - corners
    turns = np.cross(steps, np.roll(steps, -1, axis=0)) @ normal
    lengths = np.linalg.norm(steps, axis=1)
    angles = np.arctan2(turns, (steps * np.roll(steps, -1, axis=0)).sum(axis=1))
    return bool((turns >= -1e-9 * lengths.max() ** 2).all() and abs(angles.sum() - 2.0 * np.pi) < 1e-6)
