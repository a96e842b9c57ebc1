"""Total transmittance of ideal laser-cut panels against that of a pane."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured

from clerestory.glass import slab
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel
from clerestory.plots.style import COLOURS, blank, degrees, styled


def claim(thorough: bool) -> Claim:
    """Largest difference over proportions, indices and incidences."""
    rng = np.random.default_rng(25)
    elevation = np.linspace(0.0, 89.0, 60 if thorough else 15)
    worst, count = 0.0, 40 if thorough else 8
    for _ in range(count):
        n, absorption = rng.uniform(1.42, 1.9), float(rng.choice([0.0, 0.01]))
        medium = Medium(n=n, absorption_per_mm=absorption)
        panel = LaserCutPanel(spacing_mm=rng.uniform(1.0, 12.0), thickness_mm=6.0, medium=medium)
        total = panel.angular(elevation_deg=elevation, tolerance=1e-9).transmittance[:, 0]
        expected = slab(elevation, n, absorption_per_mm=absorption, thickness_mm=6.0).transmittance
        worst = max(worst, float(np.abs(total - expected).max()))
    medium, fine = Medium(n=1.49), np.arange(0.0, 89.6, 0.5)
    table = LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0, medium=medium).angular(elevation_deg=fine).squeeze()
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        low = table.transmittance_undeflected
        axes.fill_between(fine, 0.0, low, color=COLOURS[5], alpha=0.5, linewidth=0, label="undeflected")
        axes.fill_between(fine, low, table.transmittance, color=COLOURS[4], alpha=0.5, linewidth=0, label="deflected")
        axes.plot(fine, slab(fine, 1.49).transmittance, color=COLOURS[-1], linewidth=1.2, label="pane, closed form")
        axes.set(xlabel="Elevation of the incident light", ylabel="Transmittance", ylim=(0, 1))
        axes.set_title("Ideal laser-cut panel D/W = 0.5 and a pane, n = 1.49")
        axes.margins(x=0.0)
        degrees(axes.xaxis, 15.0)
        axes.legend(loc="lower left")
    what = f"largest difference of total transmittance, {count} panels × {elevation.size} incidences"
    return Claim([Measured(what, worst, 2e-9)], figure)
