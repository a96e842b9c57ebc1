"""Panels and directions drawn at random, within what can be made and what can be met."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator

from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel, Pane, Panel, PrismaticPanel


def random_medium(rng: Generator, *, lossless: bool = False) -> Medium:
    """From n = 1.3 to 1.8; half of them absorb."""
    absorption = 0.0 if lossless or rng.random() < 0.5 else rng.uniform(0.0, 0.05)
    return Medium(n=rng.uniform(1.3, 1.8), absorption_per_mm=absorption)


def random_panel(rng: Generator, *, lossless: bool = False) -> Panel:
    """A laser-cut panel (ideal, with a kerf, tilted, cut in part), a prismatic panel or a pane."""
    medium = random_medium(rng, lossless=lossless)
    kind = rng.choice(["ideal", "kerf", "tilted", "partial", "prismatic", "pane"])
    if kind == "pane":
        return Pane(thickness_mm=rng.uniform(1.0, 20.0), medium=medium)
    if kind == "prismatic":
        return PrismaticPanel(
            pitch_mm=rng.uniform(0.5, 5.0),
            lower_deg=rng.uniform(15.0, 75.0),
            upper_deg=rng.uniform(15.0, 75.0),
            base_mm=rng.uniform(0.2, 5.0),
            ridges=str(rng.choice(["front", "back"])),
            medium=medium,
        )
    thickness, spacing = rng.uniform(2.0, 12.0), rng.uniform(1.0, 10.0)
    return LaserCutPanel(
        spacing_mm=spacing,
        thickness_mm=thickness,
        cut_width_mm=0.0 if kind == "ideal" else spacing * rng.uniform(0.01, 0.2),
        cut_tilt_deg=rng.uniform(-20.0, 20.0) if kind == "tilted" else 0.0,
        cut_depth_mm=thickness * rng.uniform(0.2, 0.95) if kind == "partial" else None,
        medium=medium,
    )


def random_incidence(rng: Generator) -> dict[str, object]:
    """Any direction on either side, evenly over the hemisphere, up to 89.9 degrees from the normal."""
    cos_i = rng.uniform(np.cos(np.radians(89.9)), 1.0)
    sin_i, turn = np.sqrt(1.0 - cos_i**2), rng.uniform(0.0, 2.0 * np.pi)
    x, y = sin_i * np.cos(turn), sin_i * np.sin(turn)
    return {
        "elevation_deg": float(np.degrees(np.arcsin(-y))),
        "azimuth_deg": float(np.degrees(np.arctan2(x, cos_i))),
        "side": str(rng.choice(["front", "back"])),
    }
