"""The ideal laser-cut panel against the table and the series."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from tests.validation.claim import Claim, Measured
from tests.validation.laser_cut_series.series import series

from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel
from clerestory.plots.style import COLOURS, blank, degrees, styled

TABLE = Path(__file__).parents[2] / "data/panel/lcp_series_exact.csv"


def ideal(d_over_w: float, n: float) -> LaserCutPanel:
    """An ideal panel 6 mm thick."""
    return LaserCutPanel(spacing_mm=6.0 * d_over_w, thickness_mm=6.0, medium=Medium(n=n))


def _parts(panel, elevation, polarisation, tolerance):
    """T undeflected, T deflected, R specular, R back, from the lobes."""
    lobes = panel.lobes(elevation_deg=elevation, polarisation=polarisation, tolerance=tolerance)
    power, through = lobes.power.values, lobes.side.values == "back"
    # level light has no sense to reverse
    up = (lobes.elevation_deg.values > 0.0) & (elevation > 0.0)
    return np.array([power[m].sum() for m in (through & ~up, through & up, ~through & ~up, ~through & up)])


def claim(thorough: bool) -> Claim:
    """Largest differences of the four parts."""
    table = pd.read_csv(TABLE, comment="#")
    table = table if thorough else table[table.theta_deg % 15 == 0]
    from_table = from_series = 0.0
    for row in table.itertuples():
        polarisation = "resolved" if row.pol else "averaged"
        ours = _parts(ideal(row.D_over_W, row.n), row.theta_deg, polarisation, 1e-10)
        printed = np.array([row.T_undeflected, row.T_deflected, row.R_specular, row.R_retro])
        from_table = max(from_table, float(np.abs(ours - printed).max()))
        exact = series(row.theta_deg, row.n, row.D_over_W, polarisation)
        from_series = max(from_series, float(np.abs(ours - exact).max()))
    elevation, marks = np.arange(0.5, 89.6, 0.5), np.arange(5.0, 90.0, 5.0)
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        for number, ratio in enumerate((0.3, 0.5, 0.7, 1.0)):
            solved = ideal(ratio, 1.49).angular(elevation_deg=elevation).transmittance_deflected[:, 0]
            axes.plot(elevation, solved, color=COLOURS[number], label=f"D/W = {ratio}")
            points = [series(e, 1.49, ratio, "resolved")[1] for e in marks]
            axes.plot(marks, points, "o", color=COLOURS[number], markersize=4, markerfacecolor="white")
        axes.plot([], [], "o", color=COLOURS[-1], markersize=4, markerfacecolor="white", label="series")
        axes.set(xlabel="Elevation of the incident light", ylabel="Deflected transmittance", ylim=(0, 1))
        axes.set_title("Ideal laser-cut panel, n = 1.49")
        degrees(axes.xaxis, 15.0)
        axes.legend(ncols=2)
    return Claim(
        [
            Measured(f"against the table, {len(table)} rows of four parts", from_table, 1e-6),
            Measured("against the series, the same", from_series, 1e-9),
        ],
        figure,
    )
