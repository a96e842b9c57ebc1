"""Radial diagrams of a laser-cut panel and a prismatic sheet."""

from __future__ import annotations

import numpy as np
import pandas as pd
from tests.validation.claim import Claim, Measured
from tests.validation.laser_cut_rtrace.measure import TABLE as LASER_CUT
from tests.validation.laser_cut_series.measure import ideal
from tests.validation.prism_rtrace.measure import SIDES, prismatic
from tests.validation.prism_rtrace.measure import TABLE as PRISM

from clerestory.compare import regression
from clerestory.plots import radial

QUANTITIES = {"transmittance": "T_total", "reflectance": "R_total"}


def _r_squared(panel, rows, side):
    table = panel.angular(elevation_deg=rows.theta_deg.to_numpy(), side=side, polarisation="averaged")
    ours = np.concatenate([table[name].values[:, 0] for name in QUANTITIES])
    theirs = np.concatenate([rows[column].to_numpy() for column in QUANTITIES.values()])
    return regression("T and R", ours, theirs, np.tile(rows.theta_deg.to_numpy(), 2)).r_squared


def claim(thorough: bool) -> Claim:
    """R² of each panel, and the diagram of the sheet from both sides."""
    rows = pd.read_csv(LASER_CUT, comment="#").query("D_over_W == 0.3")
    measured = [
        Measured("laser-cut panel D/W = 0.3: R² of T and R", _r_squared(ideal(0.3, 1.49), rows, "front"), 0.99, True)
    ]
    # ridges outside: light on the ridges comes from the front, on the flat from the back
    sheet, table = prismatic("front"), pd.read_csv(PRISM, comment="#")
    for name, rows in table.groupby("incident_side"):
        side = SIDES[name]
        # at 0° the light that is exactly level grazes the edge of total reflection
        rows = rows[rows.theta_deg > 0]
        measured.append(
            Measured(f"prismatic sheet, light on the {name}: R²", _r_squared(sheet, rows, side), 0.99, True)
        )
    elevation = np.arange(-89.75, 90.0, 0.5)
    tables = [sheet.angular(elevation_deg=elevation, side=side, polarisation="averaged") for side in ("front", "back")]
    return Claim(measured, radial(*tables, title="45°/45° prismatic sheet, ridges outside"))
