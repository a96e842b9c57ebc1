"""Lines of a drawing: straight pieces and arcs in the plane of a section, closed or open."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.rules import number

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Piece:
    """A straight line or arc (z, y) to (z, y); ``bulge`` as of :class:`~clerestory.Facet`."""

    start: Point
    end: Point
    bulge: float = 0.0

    def middle(self) -> tuple[Point, Point]:
        """The point half-way along, and the unit vector to the left there."""
        (z0, y0), (z1, y1) = self.start, self.end
        dz, dy = z1 - z0, y1 - y0
        length = math.hypot(dz, dy)
        left = (-dy / length, dz / length)
        # an anticlockwise arc runs to the right of its chord, by bulge times half the chord
        sagitta = 0.5 * self.bulge * length
        return ((z0 + z1) / 2 - sagitta * left[0], (y0 + y1) / 2 - sagitta * left[1]), left

    def crosses_below(self, point: Point) -> bool:
        """Whether the chord crosses the half-line from ``point`` towards smaller z."""
        (z0, y0), (z1, y1), (z, y) = self.start, self.end, point
        return (y0 > y) != (y1 > y) and z0 + (z1 - z0) * (y - y0) / (y1 - y0) < z

    def bows_over(self, point: Point) -> bool:
        """Whether ``point`` lies between the chord and the arc."""
        if self.bulge == 0.0:
            return False
        (z0, y0), (z1, y1), (z, y) = self.start, self.end, point
        across = (z1 - z0) * (y - y0) - (y1 - y0) * (z - z0)
        if (across < 0.0) != (self.bulge > 0.0):
            return False
        # centre to the left of the chord by (1 - b²) / 4b of its length
        lift = (1.0 - self.bulge**2) / (4.0 * self.bulge)
        centre = ((z0 + z1) / 2 - lift * (y1 - y0), (y0 + y1) / 2 + lift * (z1 - z0))
        return math.dist(centre, point) < math.dist(centre, self.start)

    def raised(self, by: float) -> Piece:
        """The same, higher by so much."""
        (z0, y0), (z1, y1) = self.start, self.end
        return Piece((z0, y0 + by), (z1, y1 + by), self.bulge)


@dataclass(frozen=True, slots=True)
class Outline:
    """A closed outline: inside is a medium, outside whatever lies around it.

    Parameters
    ----------
    points : sequence of (z, y) [mm]
        The last is joined to the first.
    medium : int, 0..255, default 1
        What is inside; 0 is air, for a hole in another outline.
    bulges : sequence of float, -1..1, optional
        Of the piece that begins at each point; 0 is straight (:class:`~clerestory.Facet`).
    """

    points: Sequence[Point]
    medium: int = 1
    bulges: Sequence[float] | None = None

    def pieces(self) -> list[Piece]:
        """Its pieces in order."""
        points = points_of("an outline", self.points, 3 if self.bulges is None else 2)
        if points[0] == points[-1]:
            points = points[:-1]
        return _joined(points, points[1:] + points[:1], self.bulges)


@dataclass(frozen=True, slots=True)
class Face:
    """An open line that rises by one pitch: a face of the panel from bottom to top.

    Parameters
    ----------
    points : sequence of (z, y) [mm]
    bulges : sequence of float, one fewer, optional
        Of the pieces between them.
    """

    points: Sequence[Point]
    bulges: Sequence[float] | None = None

    def pieces(self) -> list[Piece]:
        """Its pieces in order."""
        points = points_of("a face", self.points, 2)
        return _joined(points[:-1], points[1:], self.bulges)


def points_of(name: str, values: Any, least: int) -> list[Point]:
    """Points as pairs of floats."""
    try:
        pairs = [(z, y) for z, y in values]
    except (TypeError, ValueError):
        raise ClerestoryError(f"{name} must be a list of points (z, y), got {values!r}") from None
    if len(pairs) < least:
        raise ClerestoryError(f"{name} must have {least} points or more, got {len(pairs)}; draw the rest")
    return [(number(f"z of point {i}", z), number(f"y of point {i}", y)) for i, (z, y) in enumerate(pairs, start=1)]


def _joined(starts: list[Point], ends: list[Point], bulges: Sequence[float] | None) -> list[Piece]:
    if bulges is None:
        bulges = [0.0] * len(starts)
    if len(bulges) != len(starts):
        raise ClerestoryError(f"bulges must have one value for each of {len(starts)} pieces, got {len(bulges)}")
    numbers = [number(f"bulge {i}", bulge) for i, bulge in enumerate(bulges, start=1)]
    return [Piece(*ends) for ends in zip(starts, ends, numbers, strict=True)]
