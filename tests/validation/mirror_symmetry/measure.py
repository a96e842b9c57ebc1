"""Random panels beside their mirror images."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from tests.validation.accounts import accounts, disagreement
from tests.validation.claim import Claim, Measured
from tests.validation.random_panels import random_incidence, random_panel

from clerestory.panels import LaserCutPanel, PrismaticPanel
from clerestory.plots.style import COLOURS, blank, degrees, styled


def upside_down(panel):
    """The panel mirrored in a horizontal plane."""
    if isinstance(panel, LaserCutPanel):
        return replace(panel, cut_tilt_deg=-panel.cut_tilt_deg)
    if isinstance(panel, PrismaticPanel):
        return replace(panel, lower_deg=panel.upper_deg, upper_deg=panel.lower_deg)
    return panel


_UPSIDE_DOWN = [0, 1, 2, 4, 3]


def claim(thorough: bool) -> Claim:
    """Largest differences, up against down and left against right."""
    rng = np.random.default_rng(22)
    up_down, left_right = [], []
    for _ in range(40 if thorough else 8):
        panel, incidence = random_panel(rng), random_incidence(rng)
        here = accounts(panel, incidence, tolerance=1e-5)
        from_below = incidence | {"elevation_deg": -incidence["elevation_deg"]}
        from_right = incidence | {"azimuth_deg": -incidence["azimuth_deg"]}
        below = accounts(upside_down(panel), from_below, tolerance=1e-5)
        up_down.append(disagreement(here, replace(below, shares=below.shares[_UPSIDE_DOWN])))
        right = accounts(panel, from_right, tolerance=1e-5)
        left_right.append(np.abs(right.shares - here.shares).max())
    elevation = np.arange(-88.0, 88.5, 4.0)
    tilted = LaserCutPanel(spacing_mm=5.0, thickness_mm=6.0, cut_tilt_deg=12.0, medium="pmma")
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        for panel, sign, style in ((tilted, 1.0, "-"), (upside_down(tilted), -1.0, (0, (4, 4)))):
            table = panel.angular(elevation_deg=sign * elevation, wavelength_nm=550.0, tolerance=1e-4).squeeze()
            label = "tilt +12°, at e" if sign > 0 else "tilt −12°, at −e"
            axes.plot(
                elevation, table.transmittance_deflected, linestyle=style, color=COLOURS[int(sign < 0)], label=label
            )
        axes.set(xlabel="Elevation e of the incident light", ylabel="Deflected transmittance", title="Mirror symmetry")
        degrees(axes.xaxis, 30.0)
        axes.legend()
    count = len(up_down)
    return Claim(
        [
            Measured(f"up against down over what is not known, {count} panels", float(np.max(up_down)), 1.0),
            Measured(f"left against right, {count} panels", float(np.max(left_right)), 1e-12),
        ],
        figure,
    )
