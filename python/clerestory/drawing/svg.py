"""Cross-sections drawn as SVG: path data, or the shapes of a file."""

from __future__ import annotations

import math
import os
import re
from pathlib import Path as FilePath
from typing import Any

from clerestory.drawing.line import Face, Outline, Point
from clerestory.errors import ClerestoryError

_COMMANDS = re.compile(r"[MmLlHhVvCcSsQqTtAaZz0-9eE+\-.,\s]*")
#: Pieces into which an arc is cut, each of at most a quarter turn.
_QUARTER = math.pi / 2
_MM_PER_INCH = 25.4

Lines = tuple[list[Outline], list[Face]]


def path_lines(name: str, data: str, *, medium: int, curve_chords: int) -> Lines:
    """The outlines and faces of SVG path data, y turned to point up; ``name`` begins an error."""
    from svgelements import Path

    matched = _COMMANDS.match(data)
    end = matched.end() if matched else 0
    if end < len(data):
        raise ClerestoryError(f"{name} must be SVG path data, got {data[end]!r} at character {end + 1}; correct it")
    if not data.strip().lower().startswith("m"):
        raise ClerestoryError(f"{name} must be SVG path data that begins with M, got {data[:20]!r}; correct it")
    try:
        segments = list(Path(data))
    except (ValueError, IndexError, TypeError, ZeroDivisionError, AttributeError) as error:
        raise ClerestoryError(f"{name} must be SVG path data, got: {error}; correct it") from None
    return _lines(name, segments, medium, curve_chords)


def svg_lines(path: str | os.PathLike[str], *, curve_chords: int) -> Lines:
    """The outlines and faces of all shapes of an SVG file.

    An element's attribute ``data-medium`` is the number of the medium inside it, 1 without.
    """
    from xml.etree.ElementTree import ParseError

    from svgelements import SVG, Path, Shape

    where = FilePath(path)
    try:
        drawing = SVG.parse(str(where), reify=True, ppi=_MM_PER_INCH)
    except OSError as error:
        raise ClerestoryError(f"{where} must be a readable file, got: {error.strerror}; check the path") from None
    except (ParseError, ValueError, IndexError, TypeError, AttributeError) as error:
        raise ClerestoryError(f"{where} must be an SVG file, got: {' '.join(str(error).split())}; correct it") from None
    outlines: list[Outline] = []
    faces: list[Face] = []
    for place, element in enumerate(drawing.elements(lambda e: isinstance(e, Shape)), start=1):
        name = f"{where}, shape {place}" + (f" ({element.id})" if element.id else "")
        word = (element.values or {}).get("data-medium", "1")
        if not str(word).isdigit():
            raise ClerestoryError(f"{name}: data-medium must be the number of a medium, got {word!r}; 1 is the first")
        found = _lines(name, list(Path(element)), int(word), curve_chords)
        outlines += found[0]
        faces += found[1]
    if not outlines and not faces:
        raise ClerestoryError(f"{where} must hold a shape, got none; draw the outline of one period of the panel")
    return outlines, faces


def _lines(name: str, segments: list[Any], medium: int, curve_chords: int) -> Lines:
    outlines: list[Outline] = []
    faces: list[Face] = []
    points: list[Point] = []
    bulges: list[float] = []

    def finish(is_closed: bool) -> None:
        nonlocal points, bulges
        if len(points) > 1:
            ends_meet = math.dist(points[0], points[-1]) < 1e-9 * max(1.0, *(abs(x) for p in points for x in p))
            if is_closed or ends_meet:
                if ends_meet:
                    outlines.append(Outline(points[:-1], medium, bulges))
                else:
                    outlines.append(Outline(points, medium, [*bulges, 0.0]))
            else:
                faces.append(Face(points, bulges))
        points, bulges = [], []

    for segment in segments:
        kind = type(segment).__name__
        if kind == "Move":
            finish(is_closed=False)
            points = [_up(name, segment.end)]
        elif kind == "Close":
            finish(is_closed=True)
        else:
            if not points:
                points = [_up(name, segment.start)]
            for middle, end in _parts(segment, kind, curve_chords):
                point = _up(name, end)
                if point == points[-1]:
                    continue
                bulges.append(0.0 if middle is None else _bulge(points[-1], _up(name, middle), point))
                points.append(point)
    finish(is_closed=False)
    return outlines, faces


def _parts(segment: Any, kind: str, curve_chords: int) -> list[tuple[Any, Any]]:
    """A segment as a list of the point half-way (None if straight) and the end of each of its parts."""
    if kind == "Line":
        return [(None, segment.end)]
    if kind == "Arc" and math.isclose(segment.rx, segment.ry, rel_tol=1e-9):
        count = max(1, math.ceil(abs(segment.sweep) / _QUARTER - 1e-9))
        return [
            (segment.point((i + 0.5) / count), segment.end if i + 1 == count else segment.point((i + 1) / count))
            for i in range(count)
        ]
    chords = [segment.point((i + 1) / curve_chords) for i in range(curve_chords - 1)]
    return [(None, point) for point in [*chords, segment.end]]


def _up(name: str, point: Any) -> Point:
    z, y = float(point.x), -float(point.y)
    if not (math.isfinite(z) and math.isfinite(y)):
        raise ClerestoryError(f"{name} must have finite coordinates, got ({z}, {y}); correct it")
    # no negative zero
    return z, y + 0.0


def _bulge(start: Point, middle: Point, end: Point) -> float:
    """Of the arc through three points: height over half the chord, above 0 if it runs to the right of the chord."""
    dz, dy = end[0] - start[0], end[1] - start[1]
    across = dz * (middle[1] - start[1]) - dy * (middle[0] - start[0])
    return -2.0 * across / (dz * dz + dy * dy)
