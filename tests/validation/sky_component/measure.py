"""Sky components before an unglazed window."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
from tests.validation.claim import Claim, Measured

from clerestory.coefficients import daylight_coefficients
from clerestory.glazing import Open
from clerestory.illuminance import daylight_factor
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.room import Material, Room, Sensors, Surface, Window
from clerestory.sky import CieSky

TABLE = Path(__file__).parents[2] / "data" / "daylight" / "sky_component_window_analytic.csv"
FAR = 50.0


def windows() -> list[dict[str, float]]:
    """The windows of the table of a size that can be built, with their closed forms."""
    with TABLE.open() as file:
        table = list(csv.DictReader(line for line in file if not line.startswith("#")))
    rows = [{name: float(value) for name, value in row.items()} for row in table]
    return [row for row in rows if row["w"] < FAR and row["h"] < FAR]


def before(width: float, height: float, distance: float) -> Room:
    """A black wall y = 0 with a window on one side of the point before it; nothing else."""
    opening = [(width, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, height), (width, 0.0, height)]
    around = [(FAR, 0.0, -FAR), (-FAR, 0.0, -FAR), (-FAR, 0.0, FAR), (FAR, 0.0, FAR)]
    black = Material(diffuse_reflectance=0.0)
    hall = [(-FAR, 0.0, -FAR), (-FAR, FAR, -FAR), (-FAR, FAR, FAR), (-FAR, 0.0, FAR)]
    walls = {
        "wall": (around, [opening]),
        "west": (hall, []),
        "east": ([(-x, y, z) for x, y, z in hall], []),
        "back": ([(x, FAR, z) for x, _, z in around], []),
        "roof": ([(-FAR, 0, FAR), (FAR, 0, FAR), (FAR, FAR, FAR), (-FAR, FAR, FAR)], []),
        "floor": ([(-FAR, 0, -FAR), (FAR, 0, -FAR), (FAR, FAR, -FAR), (-FAR, FAR, -FAR)], []),
    }
    return Room(
        surfaces=tuple(
            Surface(name=name, outline_m=outline, holes_m=holes, material=black)
            for name, (outline, holes) in walls.items()
        ),
        windows=(Window(name="window", outline_m=opening, glazing=Open()),),
        sensors=(Sensors(points_m=[[0.0, distance, 0.0]]),),
    )


def claim(thorough: bool) -> Claim:
    """Traced against closed forms."""
    measured, found, exact = [], [], []
    skies = {"uniform": (5, "SC_uniform_closed", 0.0), "overcast": (16, "SC_cie_overcast_closed", 0.003)}
    rows = windows()
    for row in rows:
        room = before(row["w"], row["h"], row["d"])
        for name, (kind, column, patches) in skies.items():
            sky = CieSky(sky_type=kind, zenith_luminance_cd_m2=1.0)
            coefficients = daylight_coefficients(
                room, basis="reinhart2305", sky=sky, rounds=64 if thorough else 16, window_samples=2048, seed=4
            )
            factor = daylight_factor(coefficients, sky)
            value, error = float(factor.total[0]) / 100.0, float(factor.total_standard_error[0]) / 100.0
            found.append(value)
            exact.append(row[column])
            label = f"{name}, w {row['w']:g}, h {row['h']:g}, d {row['d']:g} m"
            allowed = 4.0 * error / row[column] + patches
            measured.append(Measured(f"{label}: standard error, relative", error / row[column], 0.002))
            measured.append(Measured(f"{label}: off by, relative", abs(value / row[column] - 1.0), allowed))
    with styled():
        figure = blank(4.6, 4.2)
        axes = figure.add_subplot()
        axes.plot([0.0, max(exact)], [0.0, max(exact)], color=COLOURS[0], linewidth=1.0)
        axes.plot(exact, found, "o", color=COLOURS[1], markersize=5)
        axes.set(xlabel="Closed form", ylabel="Traced", title="Sky component before a window")
    assert np.isfinite(found).all()
    return Claim(measured, figure)
