"""Sky components of CIE 171 cases 5.9 and 5.11."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
from tests.validation.cie171_openings.rooms import GROUND_REFLECTANCE, Case, facade, roof
from tests.validation.claim import Claim, Measured
from tests.validation.opening import sky_and_ground, through_opening

from clerestory.coefficients import daylight_coefficients
from clerestory.glazing import Open
from clerestory.illuminance import illuminance
from clerestory.plots.style import COLOURS, blank, styled

TABLE = Path(__file__).parents[2] / "data" / "daylight" / "cie171_unglazed_quadrature.csv"
CASES = {
    "5.9_1x1": (roof(1.0), "5.9_1x1"),
    "5.9_4x4": (roof(4.0), "5.9_4x4"),
    "5.11_2x1": (facade(2.0, 1.0, 1.0), "5.11_*_2x1"),
    "5.11_4x3": (facade(4.0, 3.0, 0.0), "5.11_*_4x3"),
}


def published(pattern: str) -> dict[tuple[int, str], float]:
    """(sky type, point) → percent; rows that hold for every sky count for each."""
    parts = {pattern} if "*" not in pattern else {pattern.replace("*", part) for part in ("wall", "floor", "ceiling")}
    found = {}
    with TABLE.open() as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row["test"] in parts:
                kinds = range(1, 17) if row["sky_type"] == "0" else (int(row["sky_type"]),)
                found.update({(kind, row["point"]): float(row["percent"]) for kind in kinds})
    return found


def traced(case: Case, thorough: bool) -> dict[tuple[int, str], float]:
    """The same from daylight coefficients."""
    coefficients = daylight_coefficients(
        case.room(Open()), basis="reinhart5185" if thorough else "reinhart2305", rounds=64 if thorough else 8, seed=1
    )
    found = {}
    for kind in range(1, 17):
        total = illuminance(coefficients, case.sky(kind)).total.values
        found.update({(kind, point): value for point, value in zip(case.points, total, strict=True)})
    return found


def integrated(case: Case) -> dict[tuple[int, str], float]:
    """The same by our own quadrature."""
    sensors, found = case.sensors(), {}
    for kind in range(1, 17):
        light = sky_and_ground(case.sky(kind), GROUND_REFLECTANCE)
        values = through_opening(sensors.points_m, sensors.normals, case.rectangle, light)
        found.update({(kind, point): value for point, value in zip(case.points, values, strict=True)})
    return found


def claim(thorough: bool) -> Claim:
    """Deviations from the published percentages."""
    measured, ratios = [], {}
    for name, (case, pattern) in CASES.items():
        known = published(pattern)
        far = dict(zip(case.points, case.away_from_edges(), strict=True))
        ours, rays = integrated(case), traced(case, thorough)
        judged = [key for key in known if far[key[1]]]
        table = max(abs(ours[key] / known[key] - 1.0) for key in judged)
        measured.append(Measured(f"{name}: our quadrature, off the table by, relative", table, 0.008))
        deviation = np.array([rays[key] / ours[key] - 1.0 for key in judged])
        label = f"{name}: rays, off our quadrature by, relative, {len(judged)} points and skies"
        measured.append(Measured(label, float(np.abs(deviation).max()), 0.01))
        ratios[name] = 100.0 * deviation
    with styled():
        figure = blank(6.4, 3.6)
        axes = figure.add_subplot()
        for row, values in enumerate(ratios.values()):
            spread = np.random.default_rng(0).uniform(-0.25, 0.25, len(values))
            axes.plot(values, row + spread, ".", markersize=3, color=COLOURS[row], alpha=0.6)
        axes.set_yticks(range(len(ratios)), list(ratios))
        axes.axvspan(-1.0, 1.0, color=COLOURS[2], alpha=0.08)
        axes.set(
            xlabel="Deviation of the rays from the quadrature [%]",
            title="CIE 171, unglazed: every point under every sky",
        )
    return Claim(measured, figure)
