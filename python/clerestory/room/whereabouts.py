"""Sensors that stand where no one would put one."""

from __future__ import annotations

import numpy as np

from clerestory.room.scene import Room
from clerestory.room.sensors import Sensors
from clerestory.rules import Points

_LOOKS = 64


def misplaced_sensors(room: Room, placed: list[Sensors]) -> list[str]:
    """A sentence for each group with sensors outside the room or inside a solid.

    Notes
    -----
    A sensor counts as outside when four fifths of all straight lines from it, drawn evenly over the sphere, meet
    nothing, in a room where not every sensor is so; as inside a solid when a line from it crosses that closed mesh an
    odd number of times.
    """
    open_to_sky = [_openness(room, one.points_m) > 0.8 for one in placed]
    sentences = []
    everything_open = all(outside.all() for outside in open_to_sky)
    for one, outside in zip(placed, open_to_sky, strict=True):
        if outside.any() and not everything_open:
            sentences.append(_sentence(one, outside, "outside the room"))
        for mesh in room.meshes:
            if closed(mesh.triangles):
                inside = _crossings(one.points_m, mesh.vertices_m[mesh.triangles]) % 2 == 1
                if inside.any():
                    sentences.append(_sentence(one, inside, f"inside the solid {mesh.name!r}"))
    return sentences


def _sentence(one: Sensors, wrong: np.ndarray[tuple[int, ...], np.dtype[np.bool_]], where: str) -> str:
    first = ", ".join(f"{value:g}" for value in one.points_m[int(np.argmax(wrong))])
    return f"{int(wrong.sum())} of {len(one)} sensors of {one.name!r} stand {where}, the first at ({first}) m"


def _openness(room: Room, points: Points) -> Points:
    """Share of the lines from each point, even over the sphere, that meet nothing."""
    turn = np.pi * (1.0 + np.sqrt(5.0)) * np.arange(_LOOKS)
    height = 1.0 - (2.0 * np.arange(_LOOKS) + 1.0) / _LOOKS
    ring = np.sqrt(1.0 - height**2)
    looks = np.stack([ring * np.cos(turn), ring * np.sin(turn), height], axis=1)
    _, met = room.scene.closest(np.repeat(points, _LOOKS, axis=0), np.tile(looks, (len(points), 1)))
    return np.asarray((np.asarray(met) < 0).reshape(len(points), _LOOKS).mean(axis=1), dtype=np.float64)


def closed(triangles: np.ndarray[tuple[int, ...], np.dtype[np.int64]]) -> bool:
    """Whether every edge of a mesh has exactly two triangles."""
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, count = np.unique(edges, axis=0, return_counts=True)
    return bool((count == 2).all())


def _crossings(points: Points, corners: Points) -> np.ndarray[tuple[int, ...], np.dtype[np.int64]]:
    """How often a slanting line from each point crosses the triangles, shape (t, 3, 3)."""
    direction = np.array([0.3017, 0.1913, 0.9340])
    edge_1, edge_2 = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(direction, edge_2)
    volume = (across * edge_1).sum(axis=1)
    facing = np.abs(volume) > 1e-300
    edge_1, edge_2, across, volume, start = (array[facing] for array in (edge_1, edge_2, across, volume, corners[:, 0]))
    counts = np.empty(len(points), dtype=np.int64)
    for index, point in enumerate(points):
        offset = point - start
        u = (offset * across).sum(axis=1) / volume
        turned = np.cross(offset, edge_1)
        v = turned @ direction / volume
        distance = (turned * edge_2).sum(axis=1) / volume
        counts[index] = np.count_nonzero((u >= 0.0) & (v >= 0.0) & (u + v <= 1.0) & (distance > 0.0))
    return counts
