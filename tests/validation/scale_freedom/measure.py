"""The same panels in nanometres and in kilometres."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
from tests.validation.accounts import accounts, disagreement
from tests.validation.claim import Claim, Measured
from tests.validation.random_panels import random_incidence, random_panel

from clerestory.medium import Medium
from clerestory.plots.style import COLOURS, blank, styled

FACTORS = (1e-6, 1e-3, 0.1, 25.4, 1e3, 1e6)


def scaled(panel, factor):
    """All lengths of a panel times a factor, absorption per length over it."""
    lengths = {f.name: getattr(panel, f.name) for f in fields(panel) if f.init and f.name.endswith("_mm")}
    medium = Medium(n=panel.medium.n, absorption_per_mm=panel.medium.absorption_per_mm / factor)
    return replace(panel, medium=medium, **{k: None if v is None else v * factor for k, v in lengths.items()})


def claim(thorough: bool) -> Claim:
    """Largest change of any share, by factor."""
    rng = np.random.default_rng(23)
    worst, largest = dict.fromkeys(FACTORS, 0.0), dict.fromkeys(FACTORS, 0.0)
    count = 10 if thorough else 3
    for _ in range(count):
        panel, incidence = random_panel(rng), random_incidence(rng)
        here = accounts(panel, incidence, tolerance=1e-5)
        for factor in FACTORS:
            there = accounts(scaled(panel, factor), incidence, tolerance=1e-5)
            worst[factor] = max(worst[factor], disagreement(here, there))
            largest[factor] = max(largest[factor], float(np.abs(there.shares - here.shares).max()))
    with styled():
        figure = blank(6.4, 3.4)
        axes = figure.add_subplot()
        axes.loglog(list(FACTORS), np.maximum(list(largest.values()), 1e-17), "o-", color=COLOURS[0])
        axes.set(xlabel="Factor on all lengths", ylabel="Largest change of a share", title="Scale freedom")
    return Claim(
        [Measured(f"largest change over what is not known, {count} panels × 6 factors", max(worst.values()), 1.0)],
        figure,
    )
