"""Beams of parallel light as polygons: what of a plane they come from lands where.

A beam is a piece of a plane (a window, a mirror) carried along one direction. All is done in that plane: whatever the
beam may meet is projected onto it against the direction, so that shadows are differences of convex polygons
(P. S. Heckbert, P. Hanrahan, *Beam tracing polygonal objects*, SIGGRAPH 1984).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from clerestory.room.convex import Polygon, anticlockwise, area, cut, is_convex, shared, without
from clerestory.room.surroundings import Array, Indices, Surroundings
from clerestory.room.window import normal_of

#: What lies closer to a plane than this lies in it [m].
_IN_PLANE = 1e-7
#: Of two surfaces this close the first in order is met [m].
_SAME = 1e-7


class Facets(NamedTuple):
    """Convex flat pieces of all surfaces; ``corners`` (piece, corner, 3), the last corner repeated to fill."""

    corners: Array
    sides: Indices
    surface: Indices


def facets_of(around: Surroundings) -> Facets:
    """Surfaces that are convex as they stand, the triangles of the others."""
    whole = {one.name: np.array(one.outline_m) for one in around.room.surfaces if not one.holes_m}
    whole |= {one.name: np.array(one.outline_m) for one in around.room.windows}
    whole = {name: corners for name, corners in whole.items() if is_convex(corners, normal_of(corners))}
    most = max([3, *map(len, whole.values())])
    indices = [around.names.index(name) for name in whole]
    rest = ~np.isin(around.of_surface, indices)
    triangles = around.triangles[rest]
    made = [np.concatenate([c, np.repeat(c[-1:], most - len(c), axis=0)])[None] for c in whole.values()]
    made.append(np.concatenate([triangles, np.repeat(triangles[:, 2:], most - 3, axis=1)], axis=1))
    return Facets(
        np.concatenate(made),
        np.concatenate([[len(c) for c in whole.values()], np.full(len(triangles), 3)]).astype(np.int64),
        np.concatenate([indices, around.of_surface[rest]]).astype(np.int64),
    )


@dataclass(frozen=True, eq=False)
class Plane:
    """A plane with axes as rows: two in it and its normal."""

    origin: Array
    axes: Array

    @classmethod
    def of(cls, corners: Array, normal: Array) -> Plane:
        """Through a polygon."""
        steps = np.roll(corners, -1, axis=0) - corners
        across = steps[int(np.argmax((steps**2).sum(axis=1)))]
        across = across - (across @ normal) * normal
        across = across / np.linalg.norm(across)
        return cls(corners[0], np.stack([across, np.cross(normal, across), normal]))

    def flat(self, points: Array) -> Array:
        """Places in the plane."""
        return np.asarray((points - self.origin) @ self.axes[:2].T)

    def space(self, polygon: Polygon) -> Array:
        """Corners in space."""
        return np.asarray(self.origin + np.array(polygon) @ self.axes[:2])


class Shade(NamedTuple):
    """A piece as a plane sees it against a direction: its outline there, and how far off it is, a + b x + c y."""

    outline: Polygon
    distance: tuple[float, float, float]
    surface: int


def shades_of(
    facets: Facets, plane: Plane, direction: Array, within: Sequence[Polygon], *, most: int
) -> list[Shade] | None:
    """Pieces that light from a plane along a direction may meet, where it comes from the box about some polygons.

    None if there are more than ``most``.
    """
    steep = float(direction @ plane.axes[2])
    heights = (facets.corners - plane.origin) @ plane.axes[2] * np.sign(steep)
    points = np.array([point for polygon in within for point in polygon])
    low, high = points.min(axis=0), points.max(axis=0)
    ahead = np.flatnonzero(heights.max(axis=1) > _IN_PLANE)
    heights, corners = heights[ahead], facets.corners[ahead]
    reach = heights / abs(steep)
    flat = plane.flat(corners - reach[..., None] * direction)
    # those that reach through the plane are cut before their box is known
    through = heights.min(axis=1) < -_IN_PLANE
    inside = ((flat.max(axis=1) > low) & (flat.min(axis=1) < high)).all(axis=1) | through
    if int(inside.sum()) > 4 * most:
        return None
    made: list[Shade] = []
    box = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    for k in np.flatnonzero(inside):
        count = int(facets.sides[ahead[k]])
        spots, off, levels = flat[k, :count], reach[k, :count], heights[k, :count]
        if levels.min() < -_IN_PLANE:
            spots, off = _before(spots, off, levels)
        outline = shared(anticlockwise(spots), box)
        if not outline or area(outline) < 1e-12:
            continue
        made.append(Shade(outline, _distance(spots, off), int(facets.surface[ahead[k]])))
    return made if len(made) <= most else None


def visible(shades: Sequence[Shade]) -> list[tuple[Shade, list[Polygon]]]:
    """What of each shade is met first."""
    found = []
    for index, shade in enumerate(shades):
        pieces = [shade.outline]
        for other, hiding in enumerate(shades):
            if other == index:
                continue
            # before this one, or as far and first in order
            near = _SAME if other < index else -_SAME
            a, b, c = (one - another for one, another in zip(shade.distance, hiding.distance, strict=True))
            cover = cut(hiding.outline, b, c, a + near)
            if cover:
                pieces = without(pieces, cover)
            if not pieces:
                break
        if pieces:
            found.append((shade, pieces))
    return found


def unhidden(pieces: Sequence[Polygon], shades: Sequence[Shade]) -> list[Polygon]:
    """Pieces less all shades: what sees the sky."""
    left = list(pieces)
    for shade in shades:
        left = without(left, shade.outline)
        if not left:
            break
    return left


def landed(shade: Shade, plane: Plane, direction: Array, polygon: Polygon) -> Array:
    """Corners of a polygon of the plane carried along a direction onto a shade's piece."""
    a, b, c = shade.distance
    reach = np.array([a + b * x + c * y for x, y in polygon])
    return np.asarray(plane.space(polygon) + reach[:, None] * direction)


def _distance(spots: Array, off: Array) -> tuple[float, float, float]:
    """The linear function that has these values at these spots."""
    system = np.concatenate([np.ones((len(spots), 1)), spots], axis=1)
    a, b, c = np.linalg.lstsq(system, off, rcond=None)[0]
    return float(a), float(b), float(c)


def _before(spots: Array, off: Array, levels: Array) -> tuple[Array, Array]:
    """The part of a projected piece that lies before the plane."""
    points, reach = [], []
    for k in range(len(spots)):
        if (levels[k - 1] > 0.0) != (levels[k] > 0.0):
            share = levels[k - 1] / (levels[k - 1] - levels[k])
            points.append(spots[k - 1] + share * (spots[k] - spots[k - 1]))
            reach.append(off[k - 1] + share * (off[k] - off[k - 1]))
        if levels[k] > 0.0:
            points.append(spots[k])
            reach.append(off[k])
    return np.array(points), np.array(reach)
