"""Cross-sections drawn as DXF: polylines with bulges, lines, arcs and circles of the model space."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from clerestory.drawing.line import Face, Outline, Point
from clerestory.errors import ClerestoryError
from clerestory.rules import one_of

Lines = tuple[list[Outline], list[Face]]
#: A chain of points, and the bulge of the piece after each but the last.
Chain = tuple[list[Point], list[float]]

#: What may stand beside the drawing.
_NOTES = {"TEXT", "MTEXT", "DIMENSION", "POINT", "HATCH", "LEADER", "MULTILEADER", "VIEWPORT"}
#: Ends nearer than this share of the drawing's size meet.
_NEAR = 1e-6


def dxf_lines(path: str | os.PathLike[str], *, layers: Mapping[str, int] | None, unit_mm: float | None) -> Lines:
    """The outlines and faces of a DXF file, in mm."""
    where = Path(path)
    document = _document(where)
    scale = _unit(where, document) if unit_mm is None else unit_mm
    space = list(document.modelspace())
    for name in layers or ():
        one_of(f"{where}: layer", name, dict.fromkeys(entity.dxf.layer for entity in space))
    chains: dict[int, list[Chain]] = {}
    for entity in space:
        medium = 1
        if layers is not None:
            if entity.dxf.layer not in layers:
                continue
            medium = layers[entity.dxf.layer]
        chain = _chain(where, entity, scale)
        if chain is not None:
            chains.setdefault(medium, []).append(chain)
    if not chains:
        raise ClerestoryError(f"{where} must hold lines, arcs or polylines, got none; draw them in the model space")
    outlines: list[Outline] = []
    faces: list[Face] = []
    for medium, pieces in chains.items():
        size = max(abs(x) for points, _ in pieces for point in points for x in point)
        for points, bulges in _strung(pieces, _NEAR * size):
            if math.dist(points[0], points[-1]) <= _NEAR * size:
                outlines.append(Outline(points[:-1], medium, bulges))
            else:
                faces.append(Face(points, bulges))
    return outlines, faces


def _document(where: Path) -> Any:
    from ezdxf.filemanagement import readfile
    from ezdxf.lldxf.const import DXFError

    try:
        return readfile(where)
    except (DXFError, UnicodeDecodeError, ValueError) as error:
        raise ClerestoryError(
            f"{where} must be a DXF file, got: {' '.join(str(error).split())}; export it anew"
        ) from None
    except OSError as error:
        reason = error.strerror or " ".join(str(error).split())
        raise ClerestoryError(f"{where} must be a readable DXF file, got: {reason}; check the path") from None


def _unit(where: Path, document: Any) -> float:
    """Millimetres in a unit of the drawing; one that names none is taken to be in mm."""
    import ezdxf.units

    units: Any = ezdxf.units

    if document.units == 0:
        return 1.0
    try:
        return float(units.conversion_factor(document.units, units.MM))
    except (ValueError, KeyError, IndexError):
        raise ClerestoryError(f"{where}: units must be a length, got {document.units}; give unit_mm") from None


def _chain(where: Path, entity: Any, scale: float) -> Chain | None:
    """An entity as a chain of points; None if it is a note."""
    kind = entity.dxftype()
    if kind in _NOTES:
        return None
    if kind == "LWPOLYLINE":
        rows = [(x, y, bulge) for x, y, bulge in entity.get_points("xyb")]
        return _polyline(rows, entity.closed, scale)
    if kind == "POLYLINE" and entity.is_2d_polyline:
        rows = [(v.dxf.location.x, v.dxf.location.y, v.dxf.get("bulge", 0.0)) for v in entity.vertices]
        return _polyline(rows, entity.is_closed, scale)
    if kind == "LINE":
        return [_scaled(entity.dxf.start, scale), _scaled(entity.dxf.end, scale)], [0.0]
    if kind in ("ARC", "CIRCLE"):
        start = math.radians(entity.dxf.start_angle) if kind == "ARC" else 0.0
        end = math.radians(entity.dxf.end_angle) if kind == "ARC" else math.tau
        sweep = (end - start) % math.tau or math.tau
        return _arc(entity.dxf.center, entity.dxf.radius, start, sweep, scale)
    raise ClerestoryError(
        f"{where}, {kind} {entity.dxf.handle}: a drawing must be of LWPOLYLINE, POLYLINE, LINE, ARC and CIRCLE, got "
        f"{kind}; explode it into polylines, or leave its layer out"
    )


def _polyline(rows: list[tuple[float, float, float]], is_closed: bool, scale: float) -> Chain:
    points: list[Point] = []
    bulges: list[float] = []
    ends = rows[1:] + rows[:1] if is_closed else rows[1:]
    for (x, y, bulge), (x_end, y_end, _) in zip(rows if is_closed else rows[:-1], ends, strict=True):
        points.append((x * scale, y * scale))
        if abs(bulge) <= 1.0:
            bulges.append(bulge)
            continue
        # more than a half circle: two arcs, each of half the sweep
        half = math.tan(math.atan(bulge) / 2)
        dx, dy = (x_end - x) * scale, (y_end - y) * scale
        sagitta = 0.5 * bulge
        points.append(((x + x_end) / 2 * scale + sagitta * dy, (y + y_end) / 2 * scale - sagitta * dx))
        bulges += [half, half]
    if rows:
        last = rows[0] if is_closed else rows[-1]
        points.append((last[0] * scale, last[1] * scale))
    return points, bulges


def _arc(centre: Any, radius: float, start: float, sweep: float, scale: float) -> Chain:
    count = max(1, math.ceil(sweep / (math.pi / 2) - 1e-9))
    angles = [start + sweep * i / count for i in range(count + 1)]
    points = [((centre.x + radius * math.cos(a)) * scale, (centre.y + radius * math.sin(a)) * scale) for a in angles]
    return points, [math.tan(sweep / count / 4)] * count


def _scaled(point: Any, scale: float) -> Point:
    return point.x * scale, point.y * scale


def _strung(chains: list[Chain], near: float) -> list[Chain]:
    """Chains joined end to end where ends meet."""
    waiting = [chain for chain in chains if len(chain[0]) > 1]
    done: list[Chain] = []
    while waiting:
        points, bulges = waiting.pop(0)
        grows = True
        while grows and math.dist(points[0], points[-1]) > near:
            grows = False
            for place, (other, other_bulges) in enumerate(waiting):
                if math.dist(other[-1], points[-1]) <= near:
                    other, other_bulges = other[::-1], [-b for b in other_bulges[::-1]]
                elif math.dist(other[0], points[0]) <= near:
                    # the chain so far is turned round, so that the other goes on at its end
                    points, bulges = points[::-1], [-b for b in bulges[::-1]]
                elif math.dist(other[-1], points[0]) <= near:
                    points, bulges = points[::-1], [-b for b in bulges[::-1]]
                    other, other_bulges = other[::-1], [-b for b in other_bulges[::-1]]
                if math.dist(other[0], points[-1]) <= near:
                    points, bulges = points + other[1:], bulges + other_bulges
                    waiting.pop(place)
                    grows = True
                    break
        done.append((points, bulges))
    return done
