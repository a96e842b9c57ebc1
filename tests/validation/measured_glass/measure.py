"""Visible transmittance and reflectance of measured panes against pywincalc."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
from tests.validation.claim import Claim, Measured

from clerestory.measured_glass import measured_glass
from clerestory.plots.style import COLOURS, blank, degrees, styled

DATA = Path(__file__).parents[2] / "data"


def claim(thorough: bool) -> Claim:
    """Largest difference a pane."""
    table = pd.read_csv(DATA / "glass_angular_pywincalc.csv", comment="#")
    measured, fine = [], np.arange(0.0, 90.5, 1.0)
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        for number, file in enumerate(("CLEAR_3.DAT", "CLEAR_6.DAT")):
            rows, glass = table[table.file == file], measured_glass(DATA / file)
            ours = glass.photopic(rows.theta_deg)
            off = max(np.abs(ours.transmittance - rows.Tvis).max(), np.abs(ours.reflectance - rows.Rvis_front).max())
            measured.append(Measured(f"{glass.thickness_mm:g} mm clear glass: T and R", float(off), 1e-5))
            curve, colour = glass.photopic(fine), COLOURS[number]
            axes.plot(fine, curve.transmittance, color=colour, label=f"{glass.thickness_mm:g} mm")
            axes.plot(fine, curve.reflectance, color=colour, alpha=0.6)
            axes.plot(rows.theta_deg, rows.Tvis, "o", color=colour, markersize=4, markerfacecolor="white")
            axes.plot(rows.theta_deg, rows.Rvis_front, "o", color=colour, markersize=4, markerfacecolor="white")
        axes.plot([], [], "o", color=COLOURS[-1], markersize=4, markerfacecolor="white", label="pywincalc")
        axes.set(xlabel="Angle of incidence", ylabel="Visible T (falling) and R (rising)", ylim=(0, 1))
        axes.set_title("Measured clear float glass")
        degrees(axes.xaxis, 15.0)
        axes.legend()
    return Claim(measured, figure)
