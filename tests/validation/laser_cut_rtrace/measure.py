"""Laser-cut panels with a fine kerf against Radiance."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from tests.validation.claim import Claim, Measured
from tests.validation.laser_cut_series.measure import ideal

from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel
from clerestory.plots.style import COLOURS, blank, degrees, styled

TABLE = Path(__file__).parents[2] / "data/panel/lcp_radiance_rtrace.csv"
COLUMNS = {
    "T_undeflected": "transmittance_undeflected",
    "T_deflected": "transmittance_deflected",
    "T_total": "transmittance",
    "R_total": "reflectance",
}


def claim(thorough: bool) -> Claim:
    """Largest difference beyond what a row lacks to 1, and the spread."""
    beyond, differences = [], []
    table = pd.read_csv(TABLE, comment="#")
    if not thorough:
        table = table[(table.theta_deg % 20 == 0) & (table.D_over_W > 0.4)]
    fine = np.arange(1.0, 90.0)
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        for number, ((n, ratio), rows) in enumerate(table.groupby(["n", "D_over_W"])):
            panel = LaserCutPanel(spacing_mm=6.0 * ratio, thickness_mm=6.0, cut_width_mm=0.006, medium=Medium(n=n))
            solved = panel.angular(elevation_deg=rows.theta_deg, polarisation="averaged", tolerance=1e-4)
            for column, name in COLUMNS.items():
                is_total = column.endswith("total")
                kept = (rows.theta_deg > 0).to_numpy() | is_total
                off = np.abs(solved[name].values[:, 0] - rows[column].to_numpy())[kept]
                beyond.append((off - (1.0 - rows["sum"].to_numpy()[kept])).max())
                differences.extend(off)
            axes.plot(rows.theta_deg, rows.T_deflected, "o", color=COLOURS[number], markersize=4)
            # a kerf so fine does not show: the line is of ideal cuts
            curve = ideal(ratio, n).angular(elevation_deg=fine, polarisation="averaged").transmittance_deflected[:, 0]
            axes.plot(fine, curve, color=COLOURS[number], label=f"D/W = {ratio:g}")
        axes.plot([], [], "o", color=COLOURS[-1], markersize=4, label="Radiance")
        axes.set(xlabel="Elevation of the incident light", ylabel="Deflected transmittance", ylim=(0, 1))
        axes.set_title("Laser-cut panel against Radiance")
        degrees(axes.xaxis, 15.0)
        axes.legend(ncols=2)
    return Claim(
        [
            Measured("largest difference beyond what the row lacks to 1", float(max(beyond)), 0.003),
            Measured("root mean square of all differences", float(np.sqrt(np.mean(np.square(differences)))), 0.003),
        ],
        figure,
    )
