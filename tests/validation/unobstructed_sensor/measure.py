"""A horizontal sensor in the open."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured

from clerestory.coefficients import daylight_coefficients
from clerestory.illuminance import illuminance
from clerestory.plots.style import blank, line_style, styled
from clerestory.room import Material, Room, Sensors, Surface
from clerestory.sky import CieSky

LIMITS = {"tregenza145": 0.015, "reinhart2305": 0.001, "troplux5221": 0.001}


def open_field() -> Room:
    """A sensor far above a small black plate."""
    plate = Surface(
        name="plate", outline_m=[[0, 0, -9], [1, 0, -9], [0, 1, -9]], material=Material(diffuse_reflectance=0)
    )
    return Room(surfaces=(plate,), sensors=(Sensors(points_m=[[0, 0, 0]]),))


def claim(thorough: bool) -> Claim:
    """All skies in three bases."""
    measured, drawn = [], {}
    for basis, limit in LIMITS.items():
        coefficients = daylight_coefficients(open_field(), basis=basis, rounds=1024 if thorough else 256, seed=8)
        off = []
        for kind in range(1, 17):
            sky = CieSky(sky_type=kind, sun_altitude_deg=40.0, diffuse_horizontal_illuminance_lx=100.0)
            off.append(float(illuminance(coefficients, sky).total[0]) / 100.0 - 1.0)
        measured.append(
            Measured(f"{basis}: sum of the coefficients, off π by", abs(float(coefficients.direct.sum()) - np.pi), 1e-9)
        )
        measured.append(Measured(f"{basis}: largest of 16 skies, off by, relative", float(np.abs(off).max()), limit))
        drawn[basis] = 100.0 * np.array(off)
    with styled():
        figure = blank(6.0, 3.4)
        axes = figure.add_subplot()
        for row, (basis, off) in enumerate(drawn.items()):
            axes.plot(range(1, 17), off, marker="o", markersize=3, label=basis, **line_style(row))
        axes.set(xlabel="Sky type", ylabel="Off by [%]", title="Open field: horizontal illuminance by patches")
        axes.legend()
    return Claim(measured, figure)
