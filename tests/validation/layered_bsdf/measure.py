"""Four matrices of a pane and a prism against pywincalc."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from tests.bsdf.panels_as_matrices import BASIS, prism
from tests.bsdf.test_layers import pane_band
from tests.validation.claim import Claim, Measured
from tests.validation.layered_glazing.wincalc import wincalc

from clerestory.bsdf import Bsdf, layered_band
from clerestory.plots.style import COLOURS, blank, styled


def claim(thorough: bool) -> Claim:
    """Largest difference of each matrix."""
    pane = Bsdf(name="pane", visible=pane_band(), solar=pane_band(), thickness_mm=4.0)
    with tempfile.TemporaryDirectory() as folder:
        paths = [str(bsdf.to_xml(Path(folder) / f"{bsdf.name}.xml")) for bsdf in (pane, prism())]
        request = {"layers": paths, "theta_deg": [0.0], "methods": ["PHOTOPIC"], "basis": "FULL", "matrices": True}
        (theirs,) = wincalc(request)["PHOTOPIC"]
    ours = layered_band([pane_band(), prism().visible])
    measured, turned, sums = [], [], []
    for name, block in ours.band:
        kind, side = name.split("_")
        values = np.array(theirs[side][f"{kind} matrix"])
        most = block.values.max()
        off = float(np.abs(values - block.values).max() / most)
        measured.append(Measured(f"{name.replace('_', ' ')}: largest difference over largest value", off, 1e-6))
        turned.append(float(np.abs(values.T - block.values).max() / most))
        sums.append(abs(theirs[side][f"{kind} diffuse_diffuse"] - block.mean()))
    measured.append(Measured("diffuse values: largest difference", float(max(sums)), 1e-6))
    kept = np.abs(np.array(theirs["absorptance"]) - ours.absorptance_front[:, 0])
    measured.append(Measured("absorptance of each layer at normal incidence", float(kept.max()), 1e-6))
    measured.append(Measured("a matrix turned on its side, least difference", min(turned), 0.2, is_floor=True))
    share = BASIS.projected_solid_angle @ np.array(theirs["front"]["transmission matrix"])
    with styled():
        figure = blank(6.0, 3.6)
        axes = figure.add_subplot()
        axes.plot(ours.band.transmission_front.hemispherical(), color=COLOURS[0], label="Clerestory")
        axes.plot(share, "o", color=COLOURS[1], markersize=3, markerfacecolor="white", label="pywincalc")
        axes.set(xlabel="Incident patch", ylabel="Visible transmittance", ylim=(0.0, 1.0))
        axes.set_title("A prismatic panel behind a pane")
        axes.legend()
    return Claim(measured, figure)
