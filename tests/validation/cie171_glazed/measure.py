"""Sky components of CIE 171 cases 5.10 and 5.12."""

from __future__ import annotations

import numpy as np
from tests.validation.cie171_openings.measure import CASES
from tests.validation.cie171_openings.rooms import GROUND_REFLECTANCE, Case
from tests.validation.claim import Claim, Measured
from tests.validation.opening import sky_and_ground, through_opening

from clerestory.coefficients import daylight_coefficients
from clerestory.glass import tregenza_sharples
from clerestory.glazing import TregenzaSharples
from clerestory.illuminance import illuminance
from clerestory.plots.style import COLOURS, blank, styled

SHOWN_SKY = 12


def transmittance(cos_i: np.ndarray) -> np.ndarray:
    """Of the glass, from the cosine of incidence."""
    return np.asarray(tregenza_sharples(np.degrees(np.arccos(np.clip(cos_i, 0.0, 1.0)))))


def compared(case: Case, thorough: bool) -> tuple[np.ndarray, np.ndarray]:
    """Percentages by rays and by quadrature, shape (16, points)."""
    coefficients = daylight_coefficients(
        case.room(TregenzaSharples()),
        basis="reinhart5185",
        rounds=64 if thorough else 12,
        window_samples=2048,
        seed=2,
    )
    sensors, rays, exact = case.sensors(), [], []
    for kind in range(1, 17):
        sky = case.sky(kind)
        rays.append(illuminance(coefficients, sky).total.values)
        light = sky_and_ground(sky, GROUND_REFLECTANCE)
        exact.append(through_opening(sensors.points_m, sensors.normals, case.rectangle, light, transmittance))
    return np.array(rays), np.array(exact)


def claim(thorough: bool) -> Claim:
    """Deviations from the quadrature."""
    measured = []
    with styled():
        figure = blank(7.2, 3.6)
        panels = figure.subplots(1, len(CASES), sharey=False)
        for axes, (name, (case, _)) in zip(panels, CASES.items(), strict=True):
            rays, exact = compared(case, thorough)
            far = case.away_from_edges()
            worst = float(np.abs(rays[:, far] / exact[:, far] - 1.0).max())
            glazed = name.replace("5.9", "5.10").replace("5.11", "5.12")
            measured.append(Measured(f"{glazed}: largest over {16 * int(far.sum())} points and skies", worst, 0.01))
            axes.plot(exact[SHOWN_SKY - 1], color=COLOURS[0], linewidth=1.2)
            axes.plot(rays[SHOWN_SKY - 1], "o", markersize=3, color=COLOURS[1])
            axes.set_xticks(
                range(len(case.points)), [point if index % 3 == 0 else "" for index, point in enumerate(case.points)]
            )
            axes.set_title(glazed)
        panels[0].set_ylabel("Percent of the open sky, CIE sky 12")
    return Claim(measured, figure)
