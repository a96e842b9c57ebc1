"""The way of the sun through each window to where it lands, and on."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance
from clerestory.room.beams import Beam, Lit, Sunlight, beams_of, mirrored_outside, sun_on
from clerestory.room.convex import area
from clerestory.room.light_walk import GLAZING, MIRROR, SUN, Rays, Walk, joined
from clerestory.room.scene import Room
from clerestory.room.sensors import inside_outline
from clerestory.room.sunlit import facets_of
from clerestory.room.surroundings import Array, Surroundings, WindowFrame
from clerestory.rules import number, positive, within
from clerestory.sun import direction_of
from clerestory.sun_coefficients import SunWarning

_METRES = {"units": "m"}


def sun_paths(
    room: Room,
    *,
    altitude_deg: float,
    azimuth_deg: float,
    points: int = 24,
    bounces: int = 1,
    least_power: float = 0.01,
    beyond_m: float = 3.0,
) -> xr.Dataset:
    r"""The way of the sun through each window of a room to where it lands and on, and the patches that it lights.

    Parameters
    ----------
    room : Room
    altitude_deg, azimuth_deg : float [deg]
        Where the sun stands, clockwise from north. Below the horizon it lights nothing: there are no paths then.
    points : int, 1..10000, default 24
        About so many places of each window, in even rows, from which paths are drawn.
    bounces : int, 0..8, default 1
        Diffuse reflections that each path is drawn on for.
    least_power : float, default 0.01
        Share of the light on a window below which a beam or path is followed no further.
    beyond_m : float, default 3 [m]
        How far paths are drawn outside: towards the sun, and where they leave the room.

    Returns
    -------
    Dataset
        Dims ("window",): `cos_incidence`, of the sun on the outside, not above 0 where it is behind; `sunlit_share`
        [0..1] of its area that nothing opaque hides from the sun; `blocked_by`, the surface that hides most of it, or
        ``""``; `entering` [0..1], the share of the light on it that goes on into the room.

        Dims ("beam",): each exact direction in which light leaves a window or a mirror: `beam_source`, `beam_window`
        (by which the light came in), `beam_direction` (beam, axis), `beam_power` (share of the light on that window, or
        on the mirror outside that threw it there), `beam_strength` (illuminance across the beam over that normal to the
        sun), `beam_total_reflections`,
        `beam_kind`: ``"direct"``, ``"redirected"`` by a total reflection, or ``"reflected"`` by a mirror.

        Dims ("patch",): convex pieces of surfaces that a beam lights: `patch_beam`, `patch_surface`,
        `patch_corner_m` (patch, corner, axis), padded with NaN, `patch_source_m`, the same corners on the beam's
        source, `patch_area_m2`, `patch_strength` (illuminance over that normal to the sun). Pieces of one surface that
        meet are one patch of light; pieces of different beams may overlap, and their light adds.

        Dims ("path",): `position_m` (path, vertex, axis), padded with NaN, from outside to the last place; `event`
        (path, vertex), what is there: ``"sun"``, ``"glazing"``, ``"mirror"``, ``"diffuse"``, ``"interface"`` or
        ``"sky"``; `surface` (path, vertex); `power` (path, vertex), what arrives there as a share of the light that
        fell on the window or mirror where the path begins; `vertices`, how many there are; `path_window`; `path_kind`
        as of beams.

    Raises
    ------
    ClerestoryError
        If the room is wrong or a parameter out of range.

    Warns
    -----
    SunWarning
        If the room has boundaries between media: beams and paths end there.

    Notes
    -----
    Beams are those of `sun_coefficients`, followed forwards for the middle of the sun's disc (theory/room.md, eqs. 12
    and 16): a sensor lies in a patch if the sun's middle is seen from it by way of windows and mirrors. Patches are
    polygons cut by those that hide them, or among more than 150 facets in the way of a beam the cells of a grid of
    rays. Light that a window spreads, as a `Bsdf` does, has paths in
    directions drawn in proportion to power, and no patches. Paths that reach a diffuse surface go on in one direction
    each, spread evenly by the cosine (theory/room.md, eq. 17), and are drawn no further than the next window.
    """
    for name, value, least, most in (("points", points, 1, 10_000), ("bounces", bounces, 0, 8)):
        if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not least <= value <= most:
            raise ClerestoryError(f"{name} must be a whole number of {least}..{most}, got {value!r}")
    within("least_power", positive("least_power", least_power), 0.0, 1.0)
    positive("beyond_m", beyond_m)
    towards = direction_of(number("altitude_deg", altitude_deg), number("azimuth_deg", azimuth_deg))
    around = Surroundings(room)
    if room.interfaces:
        warnings.warn(
            f"the sun beyond interface {room.interfaces[0].name!r} is not followed and is missing from the result: "
            "put what bends light into a window as a panel",
            SunWarning,
            stacklevel=2,
        )
    facets = facets_of(around)
    seen = [sun_on(around, facets, window, towards) for window in around.windows.values()]
    lit = beams_of(around, facets, seen, towards, least_power)
    walk = Walk(around, least_power=least_power, bounces=bounces, beyond_m=beyond_m)
    starts = []
    for one in seen:
        if one.pieces:
            rays = _start(walk, one, points, towards, beyond_m)
            starts += [begun.at(begun.direction @ one.window.axes[2] > 0.0) for begun in walk.through(rays, one.window)]
    thrown = mirrored_outside(around, facets, towards, least_power)
    starts += [begun for beam in thrown if len(begun := _start_at_mirror(walk, beam, points, towards, beyond_m))]
    if starts:
        walk.follow(joined(starts))
    return xr.Dataset(
        {**_windows(around, seen, towards), **_beams(around, lit), **_patches(around, lit), **_paths(around, walk)},
        coords={"window": [one.window.name for one in seen], "axis": ["x", "y", "z"]},
        attrs=provenance(
            room=room.name,
            sun_altitude_deg=float(altitude_deg),
            sun_azimuth_deg=float(azimuth_deg),
            points=int(points),
            bounces=int(bounces),
            least_power=float(least_power),
        ),
    )


def _start(walk: Walk, seen: Sunlight, points: int, towards: Array, beyond_m: float) -> Rays:
    """Light at places of a window that the sun reaches."""
    window, count = seen.window, 0
    # between slats the sun may reach none of a few places
    for finer in (1, 16, 256):
        places = _laid_over(window, finer * points)
        lit = walk.around.meets(places, np.tile(towards, (len(places), 1)))[1] < 0
        places, count = places[lit], int(lit.sum())
        if count > 0.25 * seen.share * points:
            break
    if count > points > 1:
        places = places[np.linspace(0, count - 1, points).round().astype(int)]
    return _from_sun(walk, places, towards, beyond_m, GLAZING, window.surface)


def _from_sun(walk: Walk, places: Array, towards: Array, beyond_m: float, event: str, surface: int) -> Rays:
    """Light that comes from the sun to places of a surface."""
    count = len(places)
    rays = Rays(
        origin=places,
        direction=np.tile(-towards, (count, 1)),
        power=np.ones(count),
        vertex=np.full(count, -1),
        turned=np.zeros(count, dtype=np.int64),
        mirrored=np.zeros(count, dtype=bool),
        bounces=np.zeros(count, dtype=np.int64),
    )
    rays = rays.at(slice(None), vertex=walk.add(places + beyond_m * towards, SUN, rays, np.full(count, -1)))
    return rays.at(slice(None), vertex=walk.add(places, event, rays, np.full(count, surface)))


def _start_at_mirror(walk: Walk, beam: Beam, points: int, towards: Array, beyond_m: float) -> Rays:
    """Light at places of a mirror outside from which it goes to a window."""
    around = walk.around
    laid = [
        beam.plane.space([(float(x), float(y)) for x, y in _grid(np.array(piece), points)]) for piece in beam.pieces
    ]
    places = np.concatenate(laid)
    met = around.meets(places, np.tile(beam.direction, (len(places), 1)))[1]
    places = places[around.is_window[met] & (met >= 0)]
    if len(places) > points:
        places = places[np.linspace(0, len(places) - 1, points).round().astype(int)]
    rays = _from_sun(walk, places, towards, beyond_m, MIRROR, beam.source)
    count = len(places)
    return rays.at(
        slice(None),
        direction=np.tile(beam.direction, (count, 1)),
        power=np.full(count, beam.power),
        mirrored=np.ones(count, dtype=bool),
    )


def _laid_over(window: WindowFrame, count: int) -> Array:
    """About so many places over a window."""
    flat = (window.outline - window.corner) @ window.axes[:2].T
    return np.asarray(window.corner + _grid(flat, count) @ window.axes[:2])


def _grid(flat: Array, count: int) -> Array:
    """About so many places in a polygon of a plane: the middles of the squares of a grid."""
    low, size = flat.min(axis=0), np.ptp(flat, axis=0)
    step = float(np.sqrt(abs(area([(float(x), float(y)) for x, y in flat])) / count))
    numbers = np.maximum(1, np.round(size / step)).astype(int)
    x, y = ((np.arange(n) + 0.5) / n * length + start for n, length, start in zip(numbers, size, low, strict=True))
    grid = np.stack(np.meshgrid(x, y, indexing="xy"), axis=-1).reshape(-1, 2)
    return np.asarray(grid[inside_outline(grid, flat)])


def _windows(around: Surroundings, seen: Sequence[Sunlight], towards: Array) -> dict[str, Any]:
    entering = [_entering(one.window, towards) if one.cos > 0.0 else 0.0 for one in seen]
    return {
        "cos_incidence": ("window", [one.cos for one in seen], {"units": "1"}),
        "sunlit_share": ("window", [one.share for one in seen], {"units": "1"}),
        "blocked_by": ("window", np.array([one.blocked_by for one in seen], dtype=object)),
        "entering": ("window", entering, {"units": "1", "long_name": "share of the light that goes into the room"}),
    }


def _entering(window: WindowFrame, towards: Array) -> float:
    way = window.inward(-towards)
    directions, powers, _ = window.solved(-towards)
    beams = float(powers[directions[:, 2] > 0.0].sum())
    if window.glazing.spreads:
        drawn = np.asarray(window.glazing.scatter(np.tile(way, (512, 1)), 0))
        leaves = drawn[~np.isnan(drawn[:, 0])]
        if len(leaves):
            beams += float(np.asarray(window.glazing.spread(way[None]))[0]) * float((leaves[:, 2] > 0.0).mean())
    return beams


def _kinds(turned: Any, mirrored: Any) -> Any:
    return np.where(mirrored, "reflected", np.where(np.asarray(turned) > 0, "redirected", "direct")).astype(object)


def _beams(around: Surroundings, lit: Lit) -> dict[str, Any]:
    beams = lit.beams
    directions = np.array([one.direction for one in beams]).reshape(-1, 3)
    turned = np.array([one.turned for one in beams], dtype=np.int64)
    return {
        "beam_source": ("beam", np.array([around.names[one.source] for one in beams], dtype=object)),
        "beam_window": ("beam", np.array([around.names[one.window] for one in beams], dtype=object)),
        "beam_direction": (("beam", "axis"), directions),
        "beam_power": ("beam", np.array([one.power for one in beams]), {"units": "1"}),
        "beam_strength": ("beam", np.array([one.strength for one in beams]), {"units": "1"}),
        "beam_total_reflections": ("beam", turned),
        "beam_kind": ("beam", _kinds(turned, np.array([one.is_mirrored for one in beams], dtype=bool))),
    }


def _patches(around: Surroundings, lit: Lit) -> dict[str, Any]:
    patches = lit.patches
    most = max((len(one.corners) for one in patches), default=0)
    corners, sources = np.full((2, len(patches), most, 3), np.nan)
    for k, one in enumerate(patches):
        corners[k, : len(one.corners)], sources[k, : len(one.source)] = one.corners, one.source
    crosses = [np.cross(one.corners, np.roll(one.corners, -1, axis=0)).sum(axis=0) for one in patches]
    areas = 0.5 * np.linalg.norm(np.array(crosses).reshape(-1, 3), axis=1)
    return {
        "patch_beam": ("patch", np.array([one.beam for one in patches], dtype=np.int64)),
        "patch_surface": ("patch", np.array([around.names[one.surface] for one in patches], dtype=object)),
        "patch_corner_m": (("patch", "corner", "axis"), corners, _METRES),
        "patch_source_m": (("patch", "corner", "axis"), sources, _METRES),
        "patch_area_m2": ("patch", areas, {"units": "m2"}),
        "patch_strength": ("patch", np.array([one.strength for one in patches]), {"units": "1"}),
    }


def _paths(around: Surroundings, walk: Walk) -> dict[str, Any]:
    index = walk.chains()
    there = index >= 0
    last = np.maximum.reduce(index, axis=1, initial=-1)
    # a path comes in by the first window that it meets
    entry = np.argmax((walk.event[index] == GLAZING) & there, axis=1) if index.size else np.empty(0, dtype=np.int64)
    first = index[np.arange(len(index)), entry]
    names = np.array([*around.names, ""], dtype=object)
    steps = ("path", "vertex")
    return {
        "position_m": ((*steps, "axis"), np.where(there[..., None], walk.position[index], np.nan), _METRES),
        "event": (steps, np.where(there, walk.event[index], "").astype(object)),
        "surface": (steps, np.where(there, names[walk.surface[index]], "")),
        "power": (steps, np.where(there, walk.power[index], np.nan), {"units": "1"}),
        "vertices": ("path", there.sum(axis=1)),
        "path_window": ("path", names[walk.surface[first]]),
        "path_kind": ("path", _kinds(walk.turned[last], walk.mirrored[last])),
    }
