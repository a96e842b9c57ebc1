"""Light in a box with a window, hour by hour, by nothing but paths."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

DISC_RAD = np.radians(0.533 / 2.0)


@dataclass(frozen=True)
class Box:
    """Walls x = 0 and width, y = 0 and depth, z = 0 and height; the window is in y = 0, and south of it is outside."""

    size_m: tuple[float, float, float]
    window_m: tuple[float, float, float, float]
    transmittance: float
    #: Of the floor, the walls and the ceiling.
    reflectances: tuple[float, float, float]
    ground_reflectance: float

    def reach(self, points: Array, directions: Array) -> tuple[Array, NDArray[np.int64], NDArray[np.bool_]]:
        """Where rays end, on which of the walls (2 axis + side), and whether that is the window."""
        size = np.array(self.size_m)
        with np.errstate(divide="ignore", invalid="ignore"):
            distances = np.where(directions > 0.0, (size - points) / directions, -points / directions)
        distances[directions == 0.0] = np.inf
        axis = np.argmin(distances, axis=1)
        rows = np.arange(len(points))
        hits = points + distances[rows, axis][:, None] * directions
        wall = 2 * axis + (directions[rows, axis] > 0.0)
        left, right, low, high = self.window_m
        x, z = hits[:, 0], hits[:, 2]
        return hits, wall, (wall == 2) & (x > left) & (x < right) & (z > low) & (z < high)


@dataclass(frozen=True)
class Hours:
    """Sky and sun of so many hours: parameters a to e, scale to cd/m², illuminances and where the sun stands."""

    parameters: Array
    scale: Array
    diffuse_lx: Array
    sun_lx: Array
    sun: Array

    def luminance(self, hour: NDArray[np.int64], directions: Array, ground_reflectance: float) -> Array:
        """Towards directions, each in its hour; the ground below the horizon."""
        sine = directions[:, 2]
        cosine = np.clip((directions * self.sun[hour]).sum(axis=1), -1.0, 1.0)
        a, b, c, d, e = self.parameters[hour].T
        gradation = 1.0 + a * np.exp(b / np.maximum(sine, 0.01))
        indicatrix = 1.0 + c * np.exp(d * np.arccos(cosine)) + e * cosine**2
        ground = ground_reflectance * (self.diffuse_lx + self.sun_lx * self.sun[:, 2]) / np.pi
        return np.where(sine >= 0.0, self.scale[hour] * np.maximum(gradation * indicatrix, 0.0), ground[hour])

    @staticmethod
    def scales(parameters: Array, sun: Array, diffuse_lx: Array) -> Array:
        """What makes each sky light a horizontal plane with the diffuse illuminance, by a grid of a degree or so."""
        sine, azimuth = (np.arange(120) + 0.5) / 120.0, (np.arange(240) + 0.5) * np.pi / 120.0
        across = np.sqrt(1.0 - sine**2)[:, None]
        grid = np.stack(
            [across * np.sin(azimuth), across * np.cos(azimuth), np.broadcast_to(sine[:, None], (120, 240))], axis=-1
        ).reshape(-1, 3)
        found = np.empty(len(sun))
        for k in range(len(sun)):
            one = Hours(parameters[[k]], np.ones(1), np.ones(1), np.ones(1), sun[[k]])
            relative = one.luminance(np.zeros(len(grid), dtype=np.int64), grid, 0.0)
            found[k] = diffuse_lx[k] / (2.0 * np.pi * np.mean(relative * grid[:, 2]))
        return found


def illuminance(box: Box, hours: Hours, sensors: Array, *, paths: int, seed: int) -> tuple[Array, Array]:
    """Illuminances of horizontal sensors and their standard errors, (sensor, hour) [lx]."""
    rng = np.random.default_rng(seed)
    count, times = len(sensors), len(hours.scale)
    mean, error = np.empty((count, times)), np.empty((count, times))
    hour = np.repeat(np.arange(times), paths)
    for k, sensor in enumerate(sensors):
        points = np.tile(sensor, (len(hour), 1))
        found = np.pi * _followed(box, hours, hour, points, rng)
        through = box.reach(points, _in_disc(hours.sun[hour], rng))[2]
        found += through * box.transmittance * (hours.sun_lx * hours.sun[:, 2])[hour]
        samples = found.reshape(times, paths)
        mean[k], error[k] = samples.mean(axis=1), samples.std(axis=1, ddof=1) / np.sqrt(paths)
    return mean, error


def _followed(box: Box, hours: Hours, hour: NDArray[np.int64], points: Array, rng: np.random.Generator) -> Array:
    """Luminance that arrives along one path for each point, begun upward."""
    found = np.zeros(len(hour))
    alive = np.arange(len(hour))
    normals = np.tile([0.0, 0.0, 1.0], (len(hour), 1))
    floor, walls, ceiling = box.reflectances
    reflectance = np.array([walls, walls, walls, walls, floor, ceiling])
    inward = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=np.float64)
    while len(alive):
        directions = _lambertian(normals, rng)
        hits, wall, out = box.reach(points, directions)
        gone = alive[out]
        found[gone] += box.transmittance * hours.luminance(hour[gone], directions[out], box.ground_reflectance)
        alive, points, wall = alive[~out], hits[~out], wall[~out]
        normals = inward[wall]
        # a little off the wall, so that a ray does not end where it begins
        points = points + 1e-9 * normals
        towards = _in_disc(hours.sun[hour[alive]], rng)
        cosine = (normals * towards).sum(axis=1)
        lit = (cosine > 0.0) & box.reach(points, towards)[2]
        sun = box.transmittance * hours.sun_lx[hour[alive]] * np.maximum(cosine, 0.0) * lit
        found[alive] += reflectance[wall] / np.pi * sun
        # Russian roulette: what survives keeps its weight
        survives = rng.random(len(alive)) < reflectance[wall]
        alive, points, normals = alive[survives], points[survives], normals[survives]
    return found


def _lambertian(normals: Array, rng: np.random.Generator) -> Array:
    """Directions whose density is the cosine: a unit sphere that touches the surface."""
    sphere = rng.normal(size=normals.shape)
    directions = normals + sphere / np.linalg.norm(sphere, axis=1, keepdims=True)
    return directions / np.linalg.norm(directions, axis=1, keepdims=True)


def _in_disc(sun: Array, rng: np.random.Generator) -> Array:
    """Directions within the sun's disc."""
    radius = DISC_RAD * np.sqrt(rng.random(len(sun)))
    aside = rng.normal(size=sun.shape)
    aside -= (aside * sun).sum(axis=1, keepdims=True) * sun
    directions = sun + radius[:, None] * aside / np.linalg.norm(aside, axis=1, keepdims=True)
    return directions / np.linalg.norm(directions, axis=1, keepdims=True)
