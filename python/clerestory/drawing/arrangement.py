"""From the lines of a drawing to facets that know the medium on either hand."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from clerestory.drawing.line import Face, Outline, Piece, Point
from clerestory.errors import ClerestoryError
from clerestory.profile import Facet
from clerestory.rules import one_of

#: Points nearer than this share of the pitch are one.
_NEAR = 1e-6
#: How far beside a piece its media are looked up, as a share of its length or the pitch, whichever is less.
_BESIDE = 1e-5

JOINS = ("vanish", "film")


def arranged(
    outlines: Sequence[Outline],
    faces: Sequence[Face],
    *,
    pitch_mm: float,
    between: Sequence[int] | None,
    joins: str,
) -> list[Facet]:
    """The facets of a drawing that repeats every ``pitch_mm`` upwards.

    Parameters, rules and errors as of :meth:`Profile.from_outlines`.
    """
    one_of("joins", joins, JOINS)
    layers = _layers(between, len(faces))
    for place, face in enumerate(faces, start=1):
        _check_rise(f"face {place}", face, pitch_mm)
    near = _NEAR * pitch_mm
    snap = _Snap(near, pitch_mm)
    closed = [([snap.piece(piece) for piece in outline.pieces()], outline.medium) for outline in outlines]
    open_lines = [[snap.piece(piece) for piece in face.pieces()] for face in faces]
    every = [piece for pieces, _ in closed for piece in pieces] + [piece for pieces in open_lines for piece in pieces]
    every = [piece for piece in every if math.dist(piece.start, piece.end) > near]
    split = [part for piece in every for part in _split(piece, snap.points, pitch_mm, near)]
    numbered = [(abs(_area(pieces)), place, pieces, medium) for place, (pieces, medium) in enumerate(closed, start=1)]
    regions = sorted(numbered, key=lambda region: region[0])

    def medium_at(point: Point) -> int:
        # the innermost outline around it, or the layer between faces
        for _, place, pieces, medium in regions:
            lowered = [(point[0], point[1] - k * pitch_mm) for k in _copies(pieces, point, pitch_mm)]
            around = sum(_parity(pieces, [copy]) for copy in lowered)
            if around > 1:
                raise ClerestoryError(
                    f"outline {place} must not overlap its copy one pitch higher, got pitch_mm = {pitch_mm:g}; "
                    "draw one period alone, or give its height"
                )
            if around:
                return medium
        behind = sum(
            _parity(line, [(point[0], point[1] - k * pitch_mm) for k in _copies(line, point, pitch_mm)])
            for line in open_lines
        )
        return layers[behind]

    facets = []
    for piece in _once(split, pitch_mm, near):
        (z, y), (left_z, left_y) = piece.middle()
        beside = _BESIDE * min(math.dist(piece.start, piece.end), pitch_mm)
        left = medium_at((z + beside * left_z, y + beside * left_y))
        right = medium_at((z - beside * left_z, y - beside * left_y))
        if left != right:
            facets.append(Facet(start=piece.start, end=piece.end, left=left, right=right, bulge=piece.bulge))
        elif joins == "film" and left != 0:
            facets.append(Facet(start=piece.start, end=piece.end, left=left, right=left, bulge=piece.bulge, film=0))
    return facets


class _Snap:
    """Moves points that are nearly the same, a whole number of pitches apart or none, onto one another."""

    def __init__(self, near: float, pitch_mm: float) -> None:
        self.near, self.pitch_mm = near, pitch_mm
        self.points: list[Point] = []

    def point(self, point: Point) -> Point:
        z, y = point
        for known_z, known_y in self.points:
            rise = round((y - known_y) / self.pitch_mm) * self.pitch_mm
            if abs(z - known_z) <= self.near and abs(y - known_y - rise) <= self.near:
                return known_z, known_y + rise
        self.points.append(point)
        return point

    def piece(self, piece: Piece) -> Piece:
        return Piece(self.point(piece.start), self.point(piece.end), piece.bulge)


def _layers(between: Sequence[int] | None, faces: int) -> list[int]:
    """The media before, between and behind the faces."""
    layers = [place % 2 for place in range(faces + 1)] if between is None else list(between)
    if len(layers) != faces + 1:
        raise ClerestoryError(
            f"between must name {faces + 1} media for {faces} faces, from the air in front to the air behind, "
            f"got {len(layers)}"
        )
    return layers


def _check_rise(name: str, face: Face, pitch_mm: float) -> None:
    (z0, y0), (z1, y1) = (piece_end for piece_end in (face.pieces()[0].start, face.pieces()[-1].end))
    if abs(z1 - z0) > _NEAR * pitch_mm or abs(abs(y1 - y0) - pitch_mm) > _NEAR * pitch_mm:
        raise ClerestoryError(
            f"{name} must close or rise by pitch_mm ({pitch_mm:g}), got ends ({z0:g}, {y0:g}) and ({z1:g}, {y1:g}); "
            "let it end where it began, or one pitch higher"
        )


def _split(piece: Piece, points: Sequence[Point], pitch_mm: float, near: float) -> list[Piece]:
    """A straight piece cut where another line's point, or a copy of it, lies on it."""
    if piece.bulge != 0.0:
        return [piece]
    (z0, y0), (z1, y1) = piece.start, piece.end
    length = math.hypot(z1 - z0, y1 - y0)
    along, across = ((z1 - z0) / length, (y1 - y0) / length), (-(y1 - y0) / length, (z1 - z0) / length)
    low, high = min(y0, y1) - near, max(y0, y1) + near
    shares: dict[float, Point] = {}
    for z, y in points:
        for k in range(math.ceil((low - y) / pitch_mm), math.floor((high - y) / pitch_mm) + 1):
            dz, dy = z - z0, y + k * pitch_mm - y0
            share = dz * along[0] + dy * along[1]
            if near < share < length - near and abs(dz * across[0] + dy * across[1]) <= near:
                shares[share] = (z, y + k * pitch_mm)
    stops = [piece.start, *(point for _, point in sorted(shares.items())), piece.end]
    return [Piece(a, b) for a, b in itertools.pairwise(stops) if math.dist(a, b) > near]


def _once(pieces: Sequence[Piece], pitch_mm: float, near: float) -> list[Piece]:
    """Each piece once, though it was drawn twice or a copy of it one pitch away."""
    kept: list[Piece] = []
    for piece in pieces:
        for other in kept:
            rise = round((piece.middle()[0][1] - other.middle()[0][1]) / pitch_mm) * pitch_mm
            twin = other.raised(rise)
            same = math.dist(piece.start, twin.start) <= near and math.dist(piece.end, twin.end) <= near
            reverse = math.dist(piece.start, twin.end) <= near and math.dist(piece.end, twin.start) <= near
            if (same or reverse) and math.dist(piece.middle()[0], twin.middle()[0]) <= near:
                break
        else:
            kept.append(piece)
    return kept


def _copies(pieces: Sequence[Piece], point: Point, pitch_mm: float) -> range:
    """By how many pitches copies may be raised that reach the height of ``point``."""
    heights = [y for piece in pieces for _, y in (piece.start, piece.end)]
    # an arc reaches beyond its ends by less than its chord
    reach = max(math.dist(piece.start, piece.end) for piece in pieces)
    low, high = min(heights) - reach, max(heights) + reach
    return range(math.floor((point[1] - high) / pitch_mm), math.ceil((point[1] - low) / pitch_mm) + 1)


def _parity(pieces: Sequence[Piece], points: Sequence[Point]) -> bool:
    """Whether crossings of half-lines from the points, and arcs that bow over them, are odd in number."""
    return sum(p.crosses_below(point) + p.bows_over(point) for p in pieces for point in points) % 2 == 1


def _area(pieces: Sequence[Piece]) -> float:
    """Area within a closed line, by chords alone: only its rank counts."""
    return 0.5 * sum(p.start[0] * p.end[1] - p.end[0] * p.start[1] for p in pieces)
