"""Light followed forwards through a room by its mirrors, windows and walls, many rays at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from clerestory import _native
from clerestory.room.material import Material
from clerestory.room.scene import Room
from clerestory.room.window import normal_of

Array = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]

SUN, GLAZING, MIRROR, DIFFUSE, INTERFACE, SKY = "sun", "glazing", "mirror", "diffuse", "interface", "sky"
"""What a vertex of a path is."""

#: Steps that a path takes at most, whatever it meets.
_MOST_STEPS = 16
#: Rays at once; the strongest are followed.
_MOST_RAYS = 20_000


@dataclass(frozen=True, eq=False)
class WindowFrame:
    """A window's axes as rows (right, up, into the room), its plane, and what fills it."""

    name: str
    surface: int
    axes: Array
    corner: Array
    outline: Array
    glazing: _native.Glazing

    def inward(self, directions: Array) -> Array:
        """World directions in the window's axes."""
        return np.asarray(directions @ self.axes.T)

    def outward(self, directions: Array) -> Array:
        """Directions of the window's axes in the world's."""
        return np.asarray(directions @ self.axes)


@dataclass(frozen=True, eq=False)
class Rays:
    """Light on its way: one row each.

    Attributes
    ----------
    origin, direction : (n, 3)
    power : (n,)
        Share of the light that fell on the window where the path began.
    vertex : (n,)
        Where it comes from, a row of the walk's vertices.
    turned : (n,)
        Total reflections on the way.
    mirrored : (n,) of bool
    bounces : (n,)
        Diffuse reflections on the way.
    """

    origin: Array
    direction: Array
    power: Array
    vertex: Indices
    turned: Indices
    mirrored: npt.NDArray[np.bool_]
    bounces: Indices

    def __len__(self) -> int:
        return len(self.power)

    def at(self, rows: Any, **changed: Any) -> Rays:
        """Some of them, with other values."""
        values = {name: getattr(self, name)[rows] for name in self.__dataclass_fields__}
        return Rays(**(values | changed))


def materials_of(room: Room) -> dict[str, Material]:
    """Material of each opaque thing by its name."""
    found = {one.name: one.material for one in room.surfaces}
    return found | {one.name: one.material for one in room.meshes}


class Surroundings:
    """What the rays of a walk meet: the scene with what each of its surfaces does."""

    def __init__(self, room: Room) -> None:
        self.room, self.scene = room, room.scene
        self.names, kinds = list(self.scene.surfaces), list(self.scene.kinds)
        materials = materials_of(room)
        found = [materials.get(name) for name in self.names]
        self.diffuse = np.array([0.0 if one is None else one.diffuse_reflectance for one in found])
        self.specular = np.array([0.0 if one is None else one.specular_reflectance for one in found])
        self.is_window = np.array([kind == "window" for kind in kinds])
        self.is_interface = np.array([kind == "interface" for kind in kinds])
        self.normal = np.full((len(self.names), 3), np.nan)
        for surface in room.surfaces:
            self.normal[self.names.index(surface.name)] = normal_of(np.array(surface.outline_m))
        self.windows = {frame.surface: frame for frame in self._frames()}
        for index, frame in self.windows.items():
            self.normal[index] = frame.axes[2]
        corners = np.asarray(self.scene.triangles()[0]).reshape(-1, 3)
        self.low, self.high = corners.min(axis=0), corners.max(axis=0)
        #: how far a ray starts off the surface that it leaves [m]
        self.step = 1e-7 * (1.0 + float(np.abs(corners).max()))

    def _frames(self) -> Iterator[WindowFrame]:
        for window in self.room.windows:
            outline = np.array(window.outline_m)
            inwards = normal_of(outline)
            level = abs(inwards[2]) > 1.0 - 1e-10
            up = np.array(window.up if window.up is not None else (0.0, 1.0, 0.0) if level else (0.0, 0.0, 1.0))
            up = up - (up @ inwards) * inwards
            up /= np.linalg.norm(up)
            axes = np.stack([np.cross(up, inwards), up, inwards])
            native = window.glazing.glazing()
            yield WindowFrame(window.name, self.names.index(window.name), axes, outline[0], outline, native)

    def meets(self, origin: Array, direction: Array) -> tuple[Array, Indices]:
        """Distance and surface that each ray meets first, -1 the sky, off what it starts on."""
        distance, surface = self.scene.closest(origin + self.step * direction, direction)
        return np.asarray(distance) + self.step, np.asarray(surface, dtype=np.int64)

    def normals(self, rays: Rays, distance: Array, surface: Indices) -> Array:
        """Unit normals where rays met surfaces, against the rays; of meshes from three close rays."""
        found = self.normal[surface].copy()
        curved = np.isnan(found[:, 0])
        if curved.any():
            found[curved] = self._slopes(rays.at(curved), distance[curved])
        facing = (found * rays.direction).sum(axis=1) > 0.0
        found[facing] *= -1.0
        return found

    def _slopes(self, rays: Rays, distance: Array) -> Array:
        across, along = tangents(rays.direction)
        near = 1e-4 * np.maximum(distance, 1e-2)[:, None]
        places = [rays.origin + distance[:, None] * rays.direction]
        for aside in (across, along):
            start = rays.origin + near * aside
            reach, _ = self.meets(start, rays.direction)
            off = np.abs(reach - distance) < 100.0 * near[:, 0]
            reach = np.where(off, reach, distance)
            places.append(start + reach[:, None] * rays.direction)
        normal = np.cross(places[1] - places[0], places[2] - places[0])
        length = np.linalg.norm(normal, axis=1, keepdims=True)
        return np.asarray(np.where(length > 0.0, normal / np.where(length > 0.0, length, 1.0), -rays.direction))


class Walk:
    """Paths as a tree of vertices: each knows where its light came from.

    Parameters
    ----------
    around : Surroundings
    least_power : float
        Light weaker than this is followed no further.
    bounces : int
        Diffuse reflections that are followed.
    beyond_m : float
        How far light is drawn that meets nothing.
    """

    def __init__(self, around: Surroundings, *, least_power: float, bounces: int, beyond_m: float) -> None:
        self.around, self.least_power, self.bounces, self.beyond_m = around, least_power, bounces, beyond_m
        self.position = np.empty((0, 3))
        self.parent, self.surface = np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64)
        self.power = np.empty(0)
        self.event = np.empty(0, dtype="U9")
        self.turned, self.mirrored = np.empty(0, dtype=np.int64), np.empty(0, dtype=bool)
        self._drawn = 0

    def add(self, position: Array, event: Any, rays: Rays, surface: Indices) -> Indices:
        """Adds a vertex at the end of each ray; their rows."""
        first = len(self.position)
        self.position = np.concatenate([self.position, position])
        self.parent = np.concatenate([self.parent, rays.vertex])
        self.surface = np.concatenate([self.surface, surface])
        self.power = np.concatenate([self.power, rays.power])
        self.event = np.concatenate([self.event, np.broadcast_to(np.asarray(event, dtype="U9"), len(position))])
        self.turned = np.concatenate([self.turned, rays.turned])
        self.mirrored = np.concatenate([self.mirrored, rays.mirrored])
        return np.arange(first, first + len(position))

    def follow(self, rays: Rays) -> None:
        """Follows light until it is weak, absorbed or outside."""
        for _ in range(_MOST_STEPS):
            rays = rays.at(rays.power >= self.least_power)
            if len(rays) > _MOST_RAYS:
                rays = rays.at(np.argsort(-rays.power, kind="stable")[:_MOST_RAYS])
            if len(rays) == 0:
                return
            rays = self._step(rays)

    def _step(self, rays: Rays) -> Rays:
        around = self.around
        distance, surface = around.meets(rays.origin, rays.direction)
        out = surface < 0
        reach = np.where(out, self.beyond_m, distance)
        position = rays.origin + reach[:, None] * rays.direction
        window, interface = around.is_window[surface] & ~out, around.is_interface[surface] & ~out
        mirror = (around.specular[surface] > around.diffuse[surface]) & ~out
        event = np.select([out, window, interface, mirror], [SKY, GLAZING, INTERFACE, MIRROR], DIFFUSE)
        vertex = self.add(position, event, rays, surface)
        here = rays.at(slice(None), origin=position, vertex=vertex)
        opaque = ~(out | window | interface)
        following = [*self._reflected(here.at(opaque), distance[opaque], surface[opaque], rays.at(opaque))]
        # after a diffuse reflection what meets a window is drawn no further
        for index in np.unique(surface[window & (rays.bounces == 0)]):
            met = (surface == index) & (rays.bounces == 0)
            following += self.through(here.at(met), around.windows[int(index)])
        return joined(following) if following else rays.at(slice(0, 0))

    def _reflected(self, here: Rays, distance: Array, surface: Indices, before: Rays) -> Iterator[Rays]:
        if len(here) == 0:
            return
        around = self.around
        normal = around.normals(before, distance, surface)
        specular = here.power * around.specular[surface]
        shines = (specular >= self.least_power) & (here.bounces == 0)
        if shines.any():
            way = here.direction[shines]
            mirrored = way - 2.0 * (way * normal[shines]).sum(axis=1, keepdims=True) * normal[shines]
            yield here.at(
                shines, direction=mirrored, power=specular[shines], mirrored=np.ones(int(shines.sum()), dtype=bool)
            )
        diffuse = here.power * around.diffuse[surface]
        goes_on = (diffuse >= self.least_power) & (here.bounces < self.bounces)
        if goes_on.any():
            count = int(goes_on.sum())
            spread = well_spread(self._drawn, count)
            self._drawn += count
            yield here.at(
                goes_on,
                direction=cosine_weighted(normal[goes_on], spread),
                power=diffuse[goes_on],
                bounces=here.bounces[goes_on] + 1,
            )

    def through(self, here: Rays, window: WindowFrame) -> list[Rays]:
        """What leaves a window on either side: a beam for each lobe, a drawn direction where it spreads light."""
        made: list[Rays] = []
        if len(here) == 0:
            return made
        incident, which = np.unique(window.inward(here.direction).round(12), axis=0, return_inverse=True)
        which = which.ravel()
        for index, way in enumerate(incident):
            rows = np.flatnonzero(which == index)
            own = here.at(rows)
            way = way / np.linalg.norm(way)
            for leaves, power, turned in lobes_of(window.glazing, way, self.least_power):
                made.append(
                    own.at(
                        slice(None),
                        direction=np.tile(window.outward(leaves), (len(rows), 1)),
                        power=own.power * power,
                        turned=own.turned + turned,
                    )
                )
            if window.glazing.spreads:
                made.append(self._scattered(own, way, window))
        return made

    def _scattered(self, own: Rays, way: Array, window: WindowFrame) -> Rays:
        """One direction for each ray, in proportion to power; the share that a window spreads, averaged over them."""
        share = float(np.asarray(window.glazing.spread(way[None]))[0])
        drawn = np.asarray(window.glazing.scatter(np.tile(way, (len(own), 1)), self._drawn))
        self._drawn += len(own)
        leaves = ~np.isnan(drawn[:, 0])
        return own.at(leaves, direction=window.outward(drawn[leaves]), power=own.power[leaves] * share)


def lobes_of(glazing: _native.Glazing, way: Array, least_power: float) -> Iterator[tuple[Array, float, int]]:
    """Direction, share and total reflections of each beam that leaves, strongest first."""
    directions, powers, turned, _, _ = glazing.lobes(np.ascontiguousarray(way[None]))
    for k in np.argsort(-np.asarray(powers), kind="stable"):
        if powers[k] >= least_power:
            yield directions[k], float(powers[k]), int(turned[k])


def joined(rays: list[Rays]) -> Rays:
    """All of several groups."""
    return Rays(**{name: np.concatenate([getattr(one, name) for one in rays]) for name in Rays.__dataclass_fields__})


def tangents(normals: Array) -> tuple[Array, Array]:
    """Two unit vectors across each of some."""
    helper = np.where(np.abs(normals[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    across = np.cross(helper, normals)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    return across, np.cross(normals, across)


def well_spread(first: int, count: int) -> Array:
    """Points of the unit square that fill it evenly, whichever run of them is taken: (count, 2).

    The additive sequence of the plastic number (theory/room.md, eq. 17).
    """
    plastic = 1.324717957244746
    steps = np.arange(first + 1, first + count + 1)[:, None] * np.array([1.0 / plastic, 1.0 / plastic**2])
    return np.asarray((0.5 + steps) % 1.0)


def cosine_weighted(normals: Array, spread: Array) -> Array:
    """Directions about normals, as dense as the cosine of their angle."""
    across, along = tangents(normals)
    radius, turn = np.sqrt(spread[:, :1]), 2.0 * np.pi * spread[:, 1:]
    height = np.sqrt(np.maximum(0.0, 1.0 - spread[:, :1]))
    return np.asarray(radius * np.cos(turn) * across + radius * np.sin(turn) * along + height * normals)
