"""Light followed forwards through a room by its mirrors, windows and walls, many rays at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from clerestory.room.surroundings import Array, Indices, Surroundings, WindowFrame, tangents

SUN, GLAZING, MIRROR, DIFFUSE, INTERFACE, SKY = "sun", "glazing", "mirror", "diffuse", "interface", "sky"
"""What a vertex of a path is."""

#: Steps that a path takes at most, whatever it meets.
_MOST_STEPS = 16
#: Rays at once; the strongest are followed.
_MOST_RAYS = 20_000


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

    def chains(self) -> Indices:
        """Vertices of each path from its beginning to its end, -1 beyond: (path, vertex)."""
        row = np.setdiff1d(np.arange(len(self.parent)), self.parent)
        back = []
        while (row >= 0).any():
            back.append(row)
            row = np.where(row >= 0, self.parent[row], -1)
        found = np.stack(back, axis=1) if back else np.empty((0, 0), dtype=np.int64)
        count = (found >= 0).sum(axis=1)
        places = np.arange(found.shape[1])
        # turned round, so that every path begins in the first column
        turned = np.take_along_axis(found, np.maximum(count[:, None] - 1 - places, 0), axis=1)
        return np.where(places < count[:, None], turned, -1)

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
        normal = around.normals(before.origin, before.direction, distance, surface)
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
        incident, which = np.unique(here.direction.round(12), axis=0, return_inverse=True)
        for index, way in enumerate(incident):
            rows = np.flatnonzero(which.ravel() == index)
            own = here.at(rows)
            for leaves, power, turned in window.lobes(way, self.least_power):
                ways = np.tile(leaves, (len(rows), 1))
                made.append(own.at(slice(None), direction=ways, power=own.power * power, turned=own.turned + turned))
            if window.glazing.spreads:
                made.append(self._scattered(own, window.inward(way), window))
        return made

    def _scattered(self, own: Rays, way: Array, window: WindowFrame) -> Rays:
        """One direction for each ray, in proportion to power; the share that a window spreads, averaged over them."""
        share = float(np.asarray(window.glazing.spread(way[None]))[0])
        drawn = np.asarray(window.glazing.scatter(np.tile(way, (len(own), 1)), self._drawn))
        self._drawn += len(own)
        leaves = ~np.isnan(drawn[:, 0])
        return own.at(leaves, direction=window.outward(drawn[leaves]), power=own.power[leaves] * share)


def joined(rays: list[Rays]) -> Rays:
    """All of several groups."""
    return Rays(**{name: np.concatenate([getattr(one, name) for one in rays]) for name in Rays.__dataclass_fields__})


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
