"""Panes against the table and the closed form."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from tests.validation.claim import Claim, Measured

from clerestory.glass import slab
from clerestory.medium import Medium
from clerestory.panels import Pane
from clerestory.plots.style import COLOURS, blank, degrees, line_style, styled

TABLE = Path(__file__).parents[3] / "crates/optics/tests/data/glass_slab_fresnel.csv"
_THICKNESS_MM = 6.0


def _pane(n, depth):
    return Pane(thickness_mm=_THICKNESS_MM, medium=Medium(n=n, absorption_per_mm=depth / _THICKNESS_MM))


def _against_table():
    worst = 0.0
    for (n, depth), rows in pd.read_csv(TABLE, comment="#").groupby(["n", "alpha_t"]):
        rows = rows[rows.theta_deg < 90.0]
        for polarisation, columns in (("resolved", ["T_pol", "R_pol", "A_pol"]), ("averaged", ["T_avg"])):
            table = _pane(n, depth).angular(elevation_deg=rows.theta_deg, polarisation=polarisation, tolerance=1e-9)
            for column, name in zip(columns, ("transmittance", "reflectance", "absorptance"), strict=False):
                worst = max(worst, float(np.abs(table[name].values[:, 0] - rows[column]).max()))
    return worst


def _against_closed_form(count):
    rng, worst = np.random.default_rng(24), 0.0
    for _ in range(count):
        n, depth = rng.uniform(1.2, 2.0), rng.choice([0.0, 0.3]) * rng.random()
        elevation, azimuth = rng.uniform(-89.0, 89.0, 2)
        incidence = np.degrees(np.arccos(np.cos(np.radians(elevation)) * np.cos(np.radians(azimuth))))
        for polarisation in ("resolved", "averaged"):
            how = {"elevation_deg": elevation, "azimuth_deg": azimuth, "polarisation": polarisation}
            table = _pane(n, depth).angular(**how, tolerance=1e-9)
            expected = slab(incidence, n, absorption_per_mm=depth, polarisation=polarisation)
            for name in ("transmittance", "reflectance", "absorptance"):
                worst = max(worst, abs(table[name].item() - getattr(expected, name)))
    return worst


def claim(thorough: bool) -> Claim:
    """Largest differences of T, R and A."""
    elevation = np.arange(0.0, 90.0, 1.0)
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        for number, polarisation in enumerate(("resolved", "averaged")):
            table = _pane(1.49, 0.05).angular(elevation_deg=elevation, polarisation=polarisation)
            style = line_style(number)
            axes.plot(elevation, table.transmittance[:, 0], **style, label=f"T, {polarisation}")
            axes.plot(elevation, table.reflectance[:, 0], **style, alpha=0.6, label=f"R, {polarisation}")
        marks = elevation[::5]
        expected = slab(marks, 1.49, absorption_per_mm=0.05)
        closed = {"color": COLOURS[-1], "markersize": 4, "markerfacecolor": "none"}
        axes.plot(marks, expected.transmittance, "o", **closed, label="closed form")
        axes.plot(marks, expected.reflectance, "o", **closed)
        axes.set(
            xlabel="Angle of incidence", ylabel="Share of the light", ylim=(0, 1), title="Pane, n = 1.49, αd = 0.05"
        )
        degrees(axes.xaxis, 15.0)
        axes.legend()
    count = 300 if thorough else 60
    return Claim(
        [
            Measured("against the table: largest difference of T, R, A", _against_table(), 6e-7),
            Measured(f"against the closed form, {count} directions: T, R, A", _against_closed_form(count), 2e-9),
        ],
        figure,
    )
