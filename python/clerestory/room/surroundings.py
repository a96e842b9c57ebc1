"""What light that is followed forwards meets: the scene with what each of its surfaces does."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from clerestory import _native
from clerestory.room.material import Material
from clerestory.room.scene import Room
from clerestory.room.window import normal_of

Array = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class WindowFrame:
    """A window's axes as rows (right, up, into the room), its plane, and what fills it."""

    name: str
    surface: int
    axes: Array
    outline: Array
    glazing: _native.Glazing
    _solved: dict[bytes, tuple[Array, Array, Indices]] = field(default_factory=dict)

    @property
    def corner(self) -> Array:
        """The first of its corners."""
        return np.asarray(self.outline[0])

    def inward(self, directions: Array) -> Array:
        """World directions in the window's axes."""
        return np.asarray(directions @ self.axes.T)

    def outward(self, directions: Array) -> Array:
        """Directions of the window's axes in the world's."""
        return np.asarray(directions @ self.axes)

    def lobes(self, direction: Array, least_power: float) -> Iterator[tuple[Array, float, int]]:
        """Direction, share and total reflections of each beam that light of a direction becomes, strongest first.

        Parameters
        ----------
        direction : array, shape (3,)
            Of travel, in the world's axes.
        least_power : float
            Weaker ones are left out.
        """
        directions, powers, turned = self.solved(direction)
        strong = np.flatnonzero(powers >= least_power)
        for k in strong[np.argsort(-powers[strong], kind="stable")]:
            yield self.outward(directions[k]), float(powers[k]), int(turned[k])

    def solved(self, direction: Array) -> tuple[Array, Array, Indices]:
        """Directions in the window's axes, powers and total reflections of all beams, found once for a direction."""
        key = np.asarray(direction).round(12).tobytes()
        if key not in self._solved:
            way = self.inward(direction)
            found = self.glazing.lobes(np.ascontiguousarray(way[None] / np.linalg.norm(way)))
            self._solved[key] = (np.asarray(found[0]), np.asarray(found[1]), np.asarray(found[2], dtype=np.int64))
        return self._solved[key]


class Surroundings:
    """A room's scene, ready for light from its windows.

    Parameters
    ----------
    room : Room
    """

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
        self.triangles, self.of_surface = (np.asarray(values) for values in self.scene.triangles())
        #: how far a ray starts off the surface that it leaves [m]
        self.step = 1e-7 * (1.0 + float(np.abs(self.triangles).max()))

    def _frames(self) -> Iterator[WindowFrame]:
        for window in self.room.windows:
            outline = np.array(window.outline_m)
            inwards = normal_of(outline)
            level = abs(inwards[2]) > 1.0 - 1e-10
            up = np.array(window.up if window.up is not None else (0.0, 1.0, 0.0) if level else (0.0, 0.0, 1.0))
            up = up - (up @ inwards) * inwards
            up /= np.linalg.norm(up)
            axes = np.stack([np.cross(up, inwards), up, inwards])
            yield WindowFrame(window.name, self.names.index(window.name), axes, outline, window.glazing.glazing())

    def meets(self, origin: Array, direction: Array) -> tuple[Array, Indices]:
        """Distance and surface that each ray meets first, -1 the sky, off what it starts on."""
        distance, surface = self.scene.closest(origin + self.step * direction, direction)
        return np.asarray(distance) + self.step, np.asarray(surface, dtype=np.int64)

    def normals(self, origin: Array, direction: Array, distance: Array, surface: Indices) -> Array:
        """Unit normals where rays met surfaces, against the rays; those of a mesh from three rays close together."""
        found = self.normal[surface].copy()
        unknown = np.isnan(found[:, 0])
        if unknown.any():
            found[unknown] = self._slopes(origin[unknown], direction[unknown], distance[unknown])
        facing = (found * direction).sum(axis=1) > 0.0
        found[facing] *= -1.0
        return found

    def _slopes(self, origin: Array, direction: Array, distance: Array) -> Array:
        near = 1e-4 * np.maximum(distance, 1e-2)[:, None]
        places = [origin + distance[:, None] * direction]
        for aside in tangents(direction):
            start = origin + near * aside
            reach, _ = self.meets(start, direction)
            # beyond an edge it is another face: take this one as square to the ray
            reach = np.where(np.abs(reach - distance) < 100.0 * near[:, 0], reach, distance)
            places.append(start + reach[:, None] * direction)
        normal = np.cross(places[1] - places[0], places[2] - places[0])
        return np.asarray(normal / np.linalg.norm(normal, axis=1, keepdims=True))


def materials_of(room: Room) -> dict[str, Material]:
    """Material of each opaque thing by its name."""
    found = {one.name: one.material for one in room.surfaces}
    return found | {one.name: one.material for one in room.meshes}


def tangents(normals: Array) -> tuple[Array, Array]:
    """Two unit vectors across each of some."""
    helper = np.where(np.abs(normals[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    across = np.cross(helper, normals)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    return across, np.cross(normals, across)
