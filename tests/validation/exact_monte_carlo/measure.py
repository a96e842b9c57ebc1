"""z-scores of the exact solver against the walk."""

from __future__ import annotations

import numpy as np
from tests.validation.accounts import unknown
from tests.validation.claim import Claim, Measured
from tests.validation.random_panels import random_incidence, random_panel

from clerestory.plots.style import COLOURS, blank, styled

NAMES = ("transmittance", "reflectance", "absorptance", "transmittance_deflected", "transmittance_undeflected")


def claim(thorough: bool) -> Claim:
    """z of every share that both find to be neither none nor all of the light."""
    rng = np.random.default_rng(26)
    scores, count = [], 120 if thorough else 40
    for i in range(count):
        panel, incidence = random_panel(rng), random_incidence(rng)
        polarisation = "resolved" if i % 2 else "averaged"
        lobes = panel.lobes(**incidence, polarisation=polarisation, tolerance=1e-6)
        not_known = unknown(lobes) + 1e-6
        how = {**incidence, "polarisation": polarisation}
        exact = panel.angular(**how)
        walk = panel.angular(**how, method="monte_carlo", rays=100_000 if thorough else 20_000, seed=i)
        for name in NAMES:
            error = walk[f"{name}_standard_error"].item()
            off = walk[name].item() - exact[name].item()
            if error > 0.0 or abs(off) > not_known:
                score = np.sign(off) * max(abs(off) - not_known, 0.0) / max(error, 1e-12)
                scores.append(score)
    z = np.array(scores)
    with styled():
        figure = blank(6.4, 3.6)
        axes = figure.add_subplot()
        bins = np.linspace(-5.0, 5.0, 41)
        axes.hist(np.clip(z, -5, 5), bins=bins, density=True, color=COLOURS[0], alpha=0.8, label="found")
        fine = np.linspace(-5.0, 5.0, 201)
        axes.plot(fine, np.exp(-0.5 * fine**2) / np.sqrt(2 * np.pi), color=COLOURS[1], label="normal")
        axes.set(
            xlabel="(Monte Carlo − exact) / standard error", ylabel="Density", title="Exact solver against the walk"
        )
        axes.legend()
    return Claim(
        [
            Measured(f"largest |z| of {z.size} shares of {count} panels", float(np.abs(z).max()), 4.5),
            Measured("root mean square of z", float(np.sqrt(np.mean(z**2))), 1.15),
        ],
        figure,
    )
