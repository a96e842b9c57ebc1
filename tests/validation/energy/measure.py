"""Energy over random panels and directions."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured
from tests.validation.random_panels import random_incidence, random_panel

from clerestory.plots.style import COLOURS, blank, styled

_TOLERANCE = 1e-5


def claim(thorough: bool) -> Claim:
    """Sums of the powers of all lobes, and what is left over."""
    rng = np.random.default_rng(20)
    off, residual = [], []
    for i in range(120 if thorough else 30):
        lobes = random_panel(rng).lobes(
            **random_incidence(rng), polarisation="resolved" if i % 2 else "averaged", tolerance=_TOLERANCE
        )
        off.append(float(lobes.power.sum()) + lobes.attrs["absorbed"] + lobes.attrs["residual"] - 1.0)
        residual.append(lobes.attrs["residual"])
    within = float(np.mean(np.array(residual) <= _TOLERANCE))
    with styled():
        figure = blank(6.4, 3.4)
        axes = figure.add_subplot()
        axes.hist(np.log10(np.maximum(np.abs(off), 1e-17)), bins=24, color=COLOURS[0])
        axes.axvline(-12.0, color=COLOURS[1], linewidth=1.5)
        axes.set(xlabel="log₁₀ of |sum − 1|", ylabel="Panels and directions", title="Energy: what is missing from 1")
    return Claim(
        [
            Measured(f"largest difference from 1 over {len(off)} panels", float(np.abs(off).max()), 1e-12),
            Measured("share of the panels with a residual within the tolerance", within, 0.85, is_floor=True),
        ],
        figure,
    )
