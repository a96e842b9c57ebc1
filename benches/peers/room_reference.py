"""The reference room of the race, and what an answer is judged by."""

from __future__ import annotations

import resource
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clerestory import Glass, LaserCutPanel, Medium, Opening, Part, Room

Floats = NDArray[np.float64]

#: Inner sizes [m] along the facade, away from it and up; the window is centred in the facade, which looks south.
WIDTH_M, DEPTH_M, HEIGHT_M = 4.0, 8.0, 3.0
WINDOW_WIDTH_M, WINDOW_HEIGHT_M, SILL_M = 3.6, 1.8, 0.9
TRANSMITTANCE = 0.88
FLOOR, WALLS, CEILING, GROUND = 0.2, 0.5, 0.8, 0.2


def room(*, panel: bool = False) -> Room:
    """The room, with glass alone or with a laser-cut panel of D/W = 0.5 in the upper third of the window."""
    glass = Glass(transmittance=TRANSMITTANCE)
    cut = LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0, medium=Medium(n=1.49))
    above = (Part(glazing=cut, height_m=WINDOW_HEIGHT_M / 3.0),) if panel else ()
    parts = (*above, Part(glazing=glass))
    opening = Opening(width_m=WINDOW_WIDTH_M, height_m=WINDOW_HEIGHT_M, sill_m=SILL_M, parts=parts)
    return Room.shoebox(
        width_m=WIDTH_M,
        depth_m=DEPTH_M,
        height_m=HEIGHT_M,
        openings=[opening],
        floor=FLOOR,
        walls=WALLS,
        ceiling=CEILING,
        ground_reflectance=GROUND,
    )


def sensor_points_m() -> Floats:
    """The 128 sensors, 0.8 m up, every 0.5 m; (128, 3)."""
    return np.asarray(room().sensor_points()[0].points_m)


def rectangles_m() -> list[tuple[str, float, list[tuple[float, float, float]]]]:
    """Name, reflectance and corners of the inner faces, the facade as the four strips about the window."""
    w, d, h = WIDTH_M, DEPTH_M, HEIGHT_M
    left = (w - WINDOW_WIDTH_M) / 2.0
    right, sill, head = left + WINDOW_WIDTH_M, SILL_M, SILL_M + WINDOW_HEIGHT_M

    def facade(x0: float, x1: float, z0: float, z1: float) -> list[tuple[float, float, float]]:
        return [(x0, 0, z0), (x0, 0, z1), (x1, 0, z1), (x1, 0, z0)]

    return [
        ("floor", FLOOR, [(0, 0, 0), (w, 0, 0), (w, d, 0), (0, d, 0)]),
        ("ceiling", CEILING, [(0, 0, h), (0, d, h), (w, d, h), (w, 0, h)]),
        ("back", WALLS, [(0, d, 0), (w, d, 0), (w, d, h), (0, d, h)]),
        ("side0", WALLS, [(0, 0, 0), (0, d, 0), (0, d, h), (0, 0, h)]),
        ("side1", WALLS, [(w, 0, 0), (w, 0, h), (w, d, h), (w, d, 0)]),
        ("below", WALLS, facade(0, w, 0, sill)),
        ("above", WALLS, facade(0, w, head, h)),
        ("beside0", WALLS, facade(0, left, sill, head)),
        ("beside1", WALLS, facade(right, w, sill, head)),
    ]


def window_corners_m() -> list[tuple[float, float, float]]:
    """Anticlockwise as seen from the room."""
    left = (WIDTH_M - WINDOW_WIDTH_M) / 2.0
    right, head = left + WINDOW_WIDTH_M, SILL_M + WINDOW_HEIGHT_M
    return [(left, 0, SILL_M), (left, 0, head), (right, 0, head), (right, 0, SILL_M)]


def rms(values: Floats, reference: Floats) -> float:
    """Root mean square over the sensors of the relative error."""
    return float(np.sqrt(np.mean((values / reference - 1.0) ** 2)))


def cv_rmse(coefficients: Floats, reference: Floats) -> float:
    """Root mean square error over sensors and patches of the sky, over the mean coefficient; the ground is left out."""
    error = coefficients[:, :-1] - reference[:, :-1]
    return float(np.sqrt(np.mean(error**2)) / reference[:, :-1].mean())


def cpu_seconds(work: Callable[[], Any], *, children: bool = False) -> tuple[float, Any]:
    """User and system time of this process, or of those it starts, and what the work returns."""
    who = resource.RUSAGE_CHILDREN if children else resource.RUSAGE_SELF
    before = resource.getrusage(who)
    result = work()
    after = resource.getrusage(who)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, result
