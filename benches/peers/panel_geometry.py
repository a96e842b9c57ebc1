"""The laser-cut panel of the race, as boxes that other programs read."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

#: Proportions and index of the panel, and the incidence.
N, D_OVER_W, KERF_OVER_W, ELEVATION_DEG = 1.49, 0.3, 0.001, 40.0
#: Bars above and below the one that is lit; no light reaches the last.
BARS = 60


def boxes() -> list[tuple[Floats, Floats]]:
    """Lower and upper corners of the bars: x along the cuts, y up, z from the outside to the room, thickness 1."""
    high = 0.5 * (D_OVER_W - KERF_OVER_W)
    centres = [k * D_OVER_W for k in range(-BARS, BARS + 1)]
    return [(np.array([-500.0, y - high, 0.0]), np.array([500.0, y + high, 1.0])) for y in centres]


def quads(low: Floats, high: Floats) -> list[Floats]:
    """The six faces of a box, anticlockwise from outside, each (4, 3)."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    faces = [
        [(x0, y0, z0), (x0, y1, z0), (x1, y1, z0), (x1, y0, z0)],
        [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)],
        [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)],
        [(x0, y1, z0), (x0, y1, z1), (x1, y1, z1), (x1, y1, z0)],
        [(x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0)],
        [(x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)],
    ]
    return [np.array(face) for face in faces]


def rays(count: int) -> tuple[Floats, Floats]:
    """Origins over one period before the panel, and the common direction."""
    e = np.radians(ELEVATION_DEG)
    direction = np.array([0.0, -np.sin(e), np.cos(e)])
    y = ((np.arange(count) + 0.5) / count - 0.5) * D_OVER_W
    at = np.stack([np.zeros(count), y, np.zeros(count)], axis=1)
    return at - 0.5 * direction, direction
