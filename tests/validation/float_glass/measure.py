"""An 8 mm pane against Edmonds (2000) and Tregenza-Sharples."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured

from clerestory.glass import edmonds_greenup_compagnon, tregenza_sharples
from clerestory.panels import Pane
from clerestory.plots.style import COLOURS, blank, degrees, styled


def claim(thorough: bool) -> Claim:
    """R² of the regressions."""
    incidence = np.arange(0.0, 86.0, 5.0)
    ours = Pane(thickness_mm=8.0).angular(elevation_deg=incidence).transmittance.values[:, 0]
    formulas = {
        "Edmonds et al. 2000": (1.0 - edmonds_greenup_compagnon(incidence, 1.52)) ** 2,
        "Tregenza-Sharples": tregenza_sharples(incidence),
    }
    published = {"Edmonds et al. 2000": 0.99, "Tregenza-Sharples": 0.93}
    fine = np.arange(0.0, 90.0, 1.0)
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        curve = Pane(thickness_mm=8.0).angular(elevation_deg=fine).transmittance[:, 0]
        axes.plot(fine, curve, color=COLOURS[0], label="8 mm clear float glass, computed")
        marks = ("s", "o")
        for number, (name, values) in enumerate(formulas.items(), 1):
            axes.plot(incidence, values, marks[number - 1], color=COLOURS[number], markersize=4.5, label=name)
        axes.set(xlabel="Angle of incidence", ylabel="Transmittance", ylim=(0, 1), title="8 mm float glass")
        degrees(axes.xaxis, 15.0)
        axes.legend(loc="lower left")
    measured = [
        Measured(f"R² with {name}", float(np.corrcoef(ours, values)[0, 1] ** 2), published[name], is_floor=True)
        for name, values in formulas.items()
    ]
    return Claim(measured, figure)
