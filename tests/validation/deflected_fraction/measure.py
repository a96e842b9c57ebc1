"""Deflected fraction for three proportions beside Edmonds' formula."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured
from tests.validation.laser_cut_series.measure import ideal

from clerestory.glass import edmonds_deflected_fraction
from clerestory.plots import deflected_fraction


def claim(thorough: bool) -> Claim:
    """Largest difference up to 70 degrees."""
    elevation = np.arange(0.5, 89.6, 0.5)
    tables, formula, measured = {}, {}, []
    for ratio in (0.3, 0.5, 0.7):
        tables[ratio] = ideal(ratio, 1.49).angular(elevation_deg=elevation)
        formula[ratio] = edmonds_deflected_fraction(elevation, 1.49, spacing_mm=ratio, thickness_mm=1.0)
        fraction = (tables[ratio].transmittance_deflected / tables[ratio].transmittance).values[:, 0]
        off = float(np.abs(fraction - formula[ratio])[elevation <= 70.0].max())
        measured.append(Measured(f"D/W = {ratio}: largest difference up to 70°", off, 0.034))
    return Claim(measured, deflected_fraction(tables, formula=formula, title="Deflected fraction and Edmonds' formula"))
