"""The 45/45 prismatic sheet from both sides against Radiance."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from tests.validation.claim import Claim, Measured

from clerestory.medium import Medium
from clerestory.panels import PrismaticPanel
from clerestory.plots.style import COLOURS, blank, degrees, styled

TABLE = Path(__file__).parents[2] / "data/panel/prism4545_radiance_rtrace.csv"
COLUMNS = {
    "T_down": "transmittance_undeflected",
    "T_up": "transmittance_deflected",
    "T_total": "transmittance",
    "R_total": "reflectance",
}
SIDES = {"flat": "back", "prism": "front"}


def prismatic(ridges: str) -> PrismaticPanel:
    """The sheet of the table."""
    return PrismaticPanel(pitch_mm=1.0, lower_deg=45, upper_deg=45, base_mm=1.0, ridges=ridges, medium=Medium(n=1.49))


def claim(thorough: bool) -> Claim:
    """Largest difference beyond what a row lacks to 1, side by side."""
    measured, fine = [], np.arange(0.25, 90.0, 0.5)
    with styled():
        figure = blank(7.2, 3.9)
        both = figure.subplots(1, 2, sharey=True)
        for axes, (side, rows) in zip(both, pd.read_csv(TABLE, comment="#").groupby("incident_side"), strict=True):
            panel = prismatic(SIDES[side])
            solved = panel.angular(elevation_deg=rows.theta_deg, polarisation="averaged", tolerance=1e-8)
            beyond = []
            for column, name in COLUMNS.items():
                kept = (rows.theta_deg > 0).to_numpy() | column.endswith("total")
                off = np.abs(solved[name].values[:, 0] - rows[column].to_numpy())
                beyond.append((off - (1.0 - rows["sum"].to_numpy()))[kept].max())
            measured.append(Measured(f"light on the {side}: largest difference beyond that", float(max(beyond)), 0.003))
            curve = panel.angular(elevation_deg=fine, polarisation="averaged").squeeze()
            for number, (column, word) in enumerate(
                {"T_up": "upwards", "T_down": "downwards", "R_total": "back"}.items()
            ):
                axes.plot(fine, curve[COLUMNS[column]], color=COLOURS[number], label=word)
                axes.plot(rows.theta_deg, rows[column], "o", color=COLOURS[number], markersize=3.5)
            axes.set(xlabel="Elevation of the incident light", ylim=(0, 1), title=f"Light on the {side} side")
            degrees(axes.xaxis, 15.0)
        both[0].set_ylabel("Share of the light (dots: Radiance)")
        both[1].legend()
    return Claim(measured, figure)
