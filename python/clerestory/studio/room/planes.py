"""Where illuminance is shown: the room's own sensors, and grids that lie on its surfaces."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from clerestory.errors import ClerestoryError
from clerestory.room.scene import Room
from clerestory.room.sensors import SensorGrid, Sensors
from clerestory.room.surface import Surface
from clerestory.room.window import normal_of
from clerestory.rules import one_of, positive

Array = npt.NDArray[np.float64]

#: Sensors of a plane that the studio computes, and how many a grid that it lays out itself has about.
MOST_SENSORS = 4000
_USUAL = 160
#: The smallest surface that is offered as a plane, as a share of the largest.
_LEAST_SHARE = 0.15
_LOOKS = 64


def plane_names(room: Room) -> list[str]:
    """Names of planes: the room's own groups of sensors, then ``on`` and the name of each large surface."""
    own = [one.name or one.surface if isinstance(one, SensorGrid) else one.name for one in room.sensors]
    areas = {surface.name: _area(surface) for surface in room.surfaces}
    inside = [name for name, area in areas.items() if area >= _LEAST_SHARE * max(areas.values())]
    return own + [f"on {name}" for name in inside]


def plane_sensors(room: Room, name: Any, spacing_m: Any = None) -> tuple[Sensors, SensorGrid | None]:
    """The sensors of a plane, and the grid that they are, if they are one.

    Parameters
    ----------
    room : Room
    name : str, optional
        One of `plane_names`; default the first.
    spacing_m : float, optional
        Of a grid that lies on a surface; default so that it has some 160 sensors.

    Raises
    ------
    ClerestoryError
        If there is no such plane, or it has too many sensors.
    """
    names = plane_names(room)
    chosen = one_of("surface", names[0] if name is None else name, names)
    own = names.index(chosen)
    if own < len(room.sensors):
        asked = room.sensors[own]
    else:
        surface = next(one for one in room.surfaces if f"on {one.name}" == chosen)
        spacing = _spacing(surface) if spacing_m is None else positive("spacing_m", spacing_m)
        flip = not _looks_in(room, surface)
        asked = SensorGrid(spacing_m=spacing, height_m=0.0, surface=surface.name, flip=flip, name=chosen)
    if isinstance(asked, SensorGrid):
        _check_count(asked, room)
    placed = asked.on(room.surfaces)
    if len(placed) > MOST_SENSORS:
        raise ClerestoryError(f"spacing_m must leave at most {MOST_SENSORS} sensors on a plane, got {len(placed)}")
    return placed, asked if isinstance(asked, SensorGrid) else None


def told(room: Room, name: Any = None, spacing_m: Any = None) -> dict[str, Any]:
    """A plane as the page draws it; ``cells`` are the four corners of each sensor's square."""
    sensors, grid = plane_sensors(room, name, spacing_m)
    cells = None if grid is None else _cells(room, sensors, grid)
    return {
        "name": sensors.name,
        "points_m": sensors.points_m,
        "normals": sensors.normals,
        "cells": cells,
        "row": sensors.row,
        "column": sensors.column,
        "rows": None if sensors.row is None else int(sensors.row.max()) + 1,
        "columns": None if sensors.column is None else int(sensors.column.max()) + 1,
        "spacing_m": None if grid is None else grid.spacing_m,
    }


def _cells(room: Room, sensors: Sensors, grid: SensorGrid) -> Array:
    corners = np.array(next(one for one in room.surfaces if one.name == grid.surface).outline_m)
    across = corners[1] - corners[0]
    across = across / np.linalg.norm(across)
    along = np.cross(normal_of(corners), across)
    steps = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]) * grid.spacing_m
    return np.asarray(sensors.points_m[:, None] + steps[:, :1] * across + steps[:, 1:] * along)


def _check_count(grid: SensorGrid, room: Room) -> None:
    """Fails before a grid is laid out that no machine could hold."""
    surface = next((one for one in room.surfaces if one.name == grid.surface), None)
    if surface is None:
        return
    corners = np.array(surface.outline_m)
    size = np.linalg.norm(corners.max(axis=0) - corners.min(axis=0))
    if (size / grid.spacing_m) ** 2 > 50 * MOST_SENSORS:
        raise ClerestoryError(
            f"spacing_m must leave at most {MOST_SENSORS} sensors on a plane, got {grid.spacing_m:g} m"
        )


def _area(surface: Surface) -> float:
    corners = np.array(surface.outline_m)
    return float(0.5 * np.linalg.norm(np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)))


def _spacing(surface: Surface) -> float:
    """Of a grid with about the usual number of sensors, to 5 cm."""
    return max(0.05, float(np.round(np.sqrt(_area(surface) / _USUAL) / 0.05) * 0.05))


def _looks_in(room: Room, surface: Surface) -> bool:
    """Whether the right-hand normal points to the side from which less of the sky is seen."""
    corners = np.array(surface.outline_m)
    normal = normal_of(corners)
    turn = np.pi * (1.0 + np.sqrt(5.0)) * np.arange(_LOOKS)
    height = (np.arange(_LOOKS) + 0.5) / _LOOKS
    ring = np.sqrt(1.0 - height**2)
    first = (corners[1] - corners[0]) / np.linalg.norm(corners[1] - corners[0])
    second = np.cross(normal, first)
    looks = height[:, None] * normal + ring[:, None] * (np.cos(turn)[:, None] * first + np.sin(turn)[:, None] * second)
    middle = corners.mean(axis=0)
    free = []
    for side in (1.0, -1.0):
        origin = np.tile(middle + side * 1e-3 * normal, (_LOOKS, 1))
        _, met = room.scene.closest(origin, side * looks)
        free.append(float((np.asarray(met) < 0).mean()))
    return free[0] <= free[1]
