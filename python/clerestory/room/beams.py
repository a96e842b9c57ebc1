"""The sun's beams behind each window, and the patches that they light."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from clerestory.room.convex import Polygon, anticlockwise, area, shared
from clerestory.room.sunlit import Facets, Plane, Shade, landed, shades_of, unhidden, visible
from clerestory.room.sunlit_cells import cells_of, sky_cells
from clerestory.room.surroundings import Array, Surroundings, WindowFrame

#: Windows and mirrors that a beam goes by at most, and beams in all.
_MOST_STEPS, _MOST_BEAMS = 6, 400
#: Facets in the way of a beam, beyond which it is looked at cell by cell.
_MOST_SHADES = 150
#: Flat pieces of mirrors outside that the sun is followed from, the largest first.
_MOST_MIRRORS = 64


@dataclass(frozen=True, eq=False)
class Beam:
    """Parallel light that leaves pieces of one plane.

    Attributes
    ----------
    source : int
        Surface that it leaves, a window or a mirror.
    window : int
        Surface of the window that the light came in by, -1 while it is outside.
    direction : array, shape (3,)
    power : float
        Share of the light that fell on the window.
    strength : float
        Illuminance across it over that normal to the sun (theory/room.md, eq. 12).
    """

    source: int
    window: int
    direction: Array
    power: float
    strength: float
    turned: int
    is_mirrored: bool
    plane: Plane
    pieces: list[Polygon]


@dataclass(frozen=True, eq=False)
class Patch:
    """A convex piece of a surface that one beam lights, and the piece of the beam's source that it comes from."""

    beam: int
    surface: int
    corners: Array
    source: Array
    strength: float


@dataclass(frozen=True, eq=False)
class Sunlight:
    """What the sun sees of a window: cosine of incidence, pieces in sight by way of nothing, share by way of glass."""

    window: WindowFrame
    cos: float
    plane: Plane
    pieces: list[Polygon]
    share: float
    blocked_by: str


@dataclass
class Lit:
    """All beams and the patches that they light."""

    beams: list[Beam] = field(default_factory=list)
    patches: list[Patch] = field(default_factory=list)


def sun_on(around: Surroundings, facets: Facets, window: WindowFrame, towards: Array) -> Sunlight:
    """What of a window the sun reaches from outside."""
    cos = float(window.axes[2] @ -towards)
    plane = Plane.of(window.outline, window.axes[2])
    if cos <= 1e-9 or towards[2] <= 0.0:
        return Sunlight(window, cos, plane, [], 0.0, "")
    own = facets.corners[facets.surface == window.surface]
    counts = facets.sides[facets.surface == window.surface]
    pieces = [anticlockwise(plane.flat(corners[:n])) for corners, n in zip(own, counts, strict=True)]
    whole = sum(map(area, pieces))
    shades = shades_of(facets, plane, towards, pieces, most=_MOST_SHADES)
    if shades is None:
        left, share, often = sky_cells(around, plane, towards, pieces)
        by = around.names[int(often.argmax())] if often.any() else ""
        return Sunlight(window, cos, plane, left, share, by)
    opaque = [shade for shade in shades if not around.is_window[shade.surface]]
    in_sight = unhidden(pieces, opaque)
    hidden: dict[int, float] = {}
    for shade in opaque:
        covered = sum(area(both) for piece in pieces if (both := shared(piece, shade.outline)))
        hidden[shade.surface] = hidden.get(shade.surface, 0.0) + covered
    most = max(hidden, key=lambda surface: hidden[surface], default=None)
    by = around.names[most] if most is not None and hidden[most] > 1e-6 * whole else ""
    return Sunlight(window, cos, plane, unhidden(pieces, shades), sum(map(area, in_sight)) / whole, by)


def beams_of(around: Surroundings, facets: Facets, seen: Sequence[Sunlight], towards: Array, least_power: float) -> Lit:
    """Follows every beam by windows and mirrors to where its light is scattered."""
    lit = Lit()
    waiting = [
        (beam, 1)
        for one in seen
        if one.pieces
        for beam in _through(one.window, one.plane, one.pieces, -towards, least_power, None)
        # what the first window turns back stays outside
        if beam.direction @ one.window.axes[2] > 0.0
    ]
    waiting += [(beam, 1) for beam in mirrored_outside(around, facets, towards, least_power)]
    while waiting and len(lit.beams) < _MOST_BEAMS:
        beam, steps = waiting.pop(0)
        if beam.window >= 0:
            lit.beams.append(beam)
        following = _land(around, facets, beam, len(lit.beams) - 1, lit, least_power)
        if steps < _MOST_STEPS:
            waiting += [(one, steps + 1) for one in following]
    return lit


def mirrored_outside(around: Surroundings, facets: Facets, towards: Array, least_power: float) -> list[Beam]:
    """What mirrors that see the sun by way of nothing, as a light shelf outside, throw on."""
    if towards[2] <= 0.0:
        return []
    rows = np.flatnonzero(around.specular[facets.surface] >= least_power)
    if len(rows) > _MOST_MIRRORS:
        sizes = [_size(facets.corners[row]) for row in rows]
        rows = rows[np.argsort(sizes)[::-1][:_MOST_MIRRORS]]
    found = []
    for row in rows:
        corners, surface = facets.corners[row, : facets.sides[row]], int(facets.surface[row])
        normal = _normal(corners)
        cos = float(normal @ towards)
        if abs(cos) < 1e-6:
            continue
        plane = Plane.of(corners, normal * np.sign(cos))
        pieces = [anticlockwise(plane.flat(corners))]
        shades = shades_of(facets, plane, towards, pieces, most=_MOST_SHADES)
        pieces = sky_cells(around, plane, towards, pieces)[0] if shades is None else unhidden(pieces, shades)
        share = float(around.specular[surface])
        if pieces:
            way = 2.0 * cos * normal - towards
            found.append(Beam(surface, -1, way, share, share, 0, True, plane, pieces))
    return found


def _through(
    window: WindowFrame, plane: Plane, pieces: list[Polygon], way: Array, least_power: float, before: Beam | None
) -> Iterator[Beam]:
    """The beams that a window makes of light that travels one way."""
    power, strength, turned = (1.0, 1.0, 0) if before is None else (before.power, before.strength, before.turned)
    cos_in = abs(float(window.axes[2] @ way))
    for direction, share, reflections in window.lobes(way, least_power):
        cos_out = abs(float(window.axes[2] @ direction))
        if power * share >= least_power and cos_out > 1e-6:
            yield Beam(
                window.surface,
                before.window if before is not None and before.window >= 0 else window.surface,
                direction,
                power * share,
                strength * share * cos_in / cos_out,
                turned + reflections,
                before is not None and before.is_mirrored,
                plane,
                pieces,
            )


def _land(around: Surroundings, facets: Facets, beam: Beam, index: int, lit: Lit, least_power: float) -> list[Beam]:
    """Adds the patches of a beam; what becomes of it at windows and mirrors."""
    following: list[Beam] = []
    shades = shades_of(facets, beam.plane, beam.direction, beam.pieces, most=_MOST_SHADES)
    onward: dict[int, list[tuple[Shade, Polygon]]] = {}
    seen = cells_of(around, beam.plane, beam.direction, beam.pieces) if shades is None else visible(shades)
    for shade, pieces in seen:
        both = [one for mine in beam.pieces for piece in pieces if (one := shared(mine, piece))]
        both = [one for one in both if area(one) > 1e-10]
        if around.is_window[shade.surface] or around.specular[shade.surface] > 0.0:
            onward.setdefault(shade.surface, []).extend((shade, one) for one in both)
        # what lies outside is lit by the sun itself, and that is not asked for
        if beam.window < 0 or around.is_window[shade.surface] or around.is_interface[shade.surface]:
            continue
        for one in both:
            corners = landed(shade, beam.plane, beam.direction, one)
            normal = _normal(corners)
            cos = abs(float(normal @ beam.direction))
            source = beam.plane.space(one)
            lit.patches.append(Patch(index, shade.surface, corners, source, beam.strength * cos))
    for surface, parts in onward.items():
        following += _onward(around, beam, surface, parts, least_power)
    return following


def _onward(
    around: Surroundings, beam: Beam, surface: int, parts: list[tuple[Shade, Polygon]], least_power: float
) -> Iterator[Beam]:
    """What becomes of a beam's pieces at a window, or at each flat piece of a mirror."""
    window = around.windows.get(surface)
    if window is not None:
        plane = Plane.of(window.outline, window.axes[2])
        pieces = [anticlockwise(plane.flat(landed(shade, beam.plane, beam.direction, one))) for shade, one in parts]
        yield from _through(window, plane, pieces, beam.direction, least_power, beam)
        return
    power = beam.power * float(around.specular[surface])
    if power < least_power:
        return
    groups: dict[tuple[float, float, float], list[tuple[Shade, Polygon]]] = {}
    for shade, one in parts:
        groups.setdefault(shade.distance, []).append((shade, one))
    for same in groups.values():
        corners = [landed(shade, beam.plane, beam.direction, one) for shade, one in same]
        normal = _normal(max(corners, key=_size))
        plane = Plane.of(corners[0], normal)
        way = beam.direction - 2.0 * (beam.direction @ normal) * normal
        strength = beam.strength * float(around.specular[surface])
        pieces = [anticlockwise(plane.flat(one)) for one in corners]
        yield Beam(surface, beam.window, way, power, strength, beam.turned, True, plane, pieces)


def _normal(corners: Array) -> Array:
    total = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    return np.asarray(total / np.linalg.norm(total))


def _size(corners: Array) -> float:
    return float(np.linalg.norm(np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)))
