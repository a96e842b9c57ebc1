"""Illuminance through a rectangular opening by quadrature: no rays, no patches."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from clerestory.sky import CieSky

Array = NDArray[np.float64]


def through_opening(
    points: Array,
    normals: Array,
    rectangle: tuple[Array, Array, Array],
    luminance: Callable[[Array], Array],
    transmittance: Callable[[Array], Array] | None = None,
    nodes: int = 48,
) -> Array:
    """∫ L τ cos θ_sensor cos θ_opening / r² dA over a rectangle (corner, edge, edge), Gauss-Legendre both ways."""
    corner, first, second = (np.asarray(part, dtype=np.float64) for part in rectangle)
    across = np.cross(first, second)
    along, first_weight = _nodes(nodes)
    found = []
    for point, normal in zip(np.asarray(points), np.asarray(normals), strict=True):
        # the luminance jumps at the horizon: an upright opening is cut at the height of the point
        horizon = np.clip((point[2] - corner[2]) / second[2], 0.0, 1.0) if second[2] > 0.0 and first[2] == 0.0 else 0.0
        pieces = [_nodes(nodes, low, high) for low, high in ((0.0, horizon), (horizon, 1.0)) if high > low]
        up, second_weight = (np.concatenate(part) for part in zip(*pieces, strict=True))
        spot = corner + along[:, None, None] * first + up[None, :, None] * second
        area = np.linalg.norm(across) * np.outer(first_weight, second_weight)
        way = spot - point
        distance = np.linalg.norm(way, axis=-1)
        direction = way / distance[..., None]
        cos_sensor = np.maximum(direction @ normal, 0.0)
        cos_opening = np.abs(direction @ across) / np.linalg.norm(across)
        value = luminance(direction) * cos_sensor * cos_opening / distance**2
        if transmittance is not None:
            value = value * transmittance(cos_opening)
        found.append(float((value * area).sum()))
    return np.array(found)


def _nodes(count: int, low: float = 0.0, high: float = 1.0) -> tuple[Array, Array]:
    at, weight = leggauss(count)
    return low + (high - low) * (1.0 + at) / 2.0, (high - low) * weight / 2.0


def sky_and_ground(sky: CieSky, ground_reflectance: float) -> Callable[[Array], Array]:
    """Luminance of the sky above the horizon and of an even, unobstructed ground below it."""
    ground = ground_reflectance * sky.diffuse_horizontal_lx / np.pi
    return lambda direction: np.where(direction[..., 2] >= 0.0, sky.luminance_cd_m2(direction), ground)
