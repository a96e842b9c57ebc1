"""Sky and externally reflected components before a long wall."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured

from clerestory.coefficients import daylight_coefficients
from clerestory.illuminance import daylight_factor
from clerestory.plots.style import blank, line_style, styled
from clerestory.room import Material, Room, Sensors, Surface
from clerestory.sky import CieSky

UNIFORM = CieSky(sky_type=5, zenith_luminance_cd_m2=1.0)
HALF_LENGTH_M = 1000.0
DISTANCE_M = 10.0
GROUND = 0.25


def street(elevation_deg: float, reflectance: float) -> Room:
    """One sensor before a wall whose edge it sees at an elevation."""
    height = DISTANCE_M * float(np.tan(np.radians(elevation_deg)))
    x = HALF_LENGTH_M
    wall = [(-x, 0.0, 0.0), (x, 0.0, 0.0), (x, 0.0, height), (-x, 0.0, height)]
    return Room(
        surfaces=(Surface(name="wall", outline_m=wall, material=Material(diffuse_reflectance=reflectance)),),
        sensors=(Sensors(points_m=[[0.0, DISTANCE_M, 0.0]]),),
        ground_reflectance=GROUND,
    )


def closed_form(elevation_deg: float, reflectance: float) -> tuple[float, float]:
    """Sky and externally reflected component in percent."""
    factor = (1.0 - np.cos(np.radians(elevation_deg))) / 2.0
    return 100.0 * (1.0 - factor), 100.0 * factor * reflectance * (1.0 + GROUND) / 2.0


def claim(thorough: bool) -> Claim:
    """Both components for three elevations and three reflectances."""
    measured, drawn = [], []
    for reflectance in (0.0, 0.3, 0.7):
        for elevation in (20.0, 45.0, 70.0):
            coefficients = daylight_coefficients(
                street(elevation, reflectance),
                basis="tregenza145",
                sky=UNIFORM,
                rounds=4096 if thorough else 1024,
                seed=6,
            )
            factor = daylight_factor(coefficients, UNIFORM)
            sky, outside = closed_form(elevation, reflectance)
            value, error = float(factor.total[0]), float(factor.total_standard_error[0])
            label = f"reflectance {reflectance:g}, edge at {elevation:g}°"
            measured.append(Measured(f"{label}: standard error, relative", error / value, 0.003))
            measured.append(
                Measured(f"{label}: off by, relative", abs(value / (sky + outside) - 1.0), 4.0 * error / value + 1e-4)
            )
            if reflectance > 0.0:
                back = float(factor.interreflected[0])
                measured.append(Measured(f"{label}: standard error of the reflected share", error / outside, 0.03))
                allowed = 4.0 * error / outside + 1e-4
                measured.append(
                    Measured(f"{label}: reflected share off by, relative", abs(back / outside - 1.0), allowed)
                )
            drawn.append((reflectance, elevation, value))
    with styled():
        figure = blank(6.0, 3.8)
        axes = figure.add_subplot()
        angles = np.linspace(0.0, 85.0, 60)
        for row, reflectance in enumerate((0.0, 0.3, 0.7)):
            style = line_style(row)
            axes.plot(angles, [sum(closed_form(a, reflectance)) for a in angles], label=f"ρ = {reflectance:g}", **style)
            at = [(elevation, value) for r, elevation, value in drawn if r == reflectance]
            axes.plot(*zip(*at, strict=True), "o", color=style["color"])
        axes.set(xlabel="Elevation of the wall's edge [°]", ylabel="Percent of the open sky")
        axes.set_title("A long wall: lines closed form, dots traced")
        axes.legend()
    return Claim(measured, figure)
