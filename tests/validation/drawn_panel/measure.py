"""A laser-cut panel as a plane and as thirty bars."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured

from clerestory import _native
from clerestory.coefficients import daylight_coefficients
from clerestory.glazing import Open
from clerestory.illuminance import illuminance
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel
from clerestory.panels.optics import ARC_CHORDS, TOLERANCE, exact_optics
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.room import Interface, Material, Room, Sensors, Surface, Window
from clerestory.sky import CieSky

SPACING_MM, THICKNESS_MM, CUT_MM, INDEX = 20.0, 30.0, 1.0, 1.49
WIDTH_M, HEIGHT_M = 2.0, 0.6
SKY = CieSky(sky_type=5, zenith_luminance_cd_m2=1.0)
BLACK = Material(diffuse_reflectance=0.0)
MIRROR = Material(diffuse_reflectance=0.0, specular_reflectance=1.0)
# a hair between faces that would otherwise lie in one plane
HAIR_M = 1e-3


class Averaged:
    """The panel with light unpolarised again at every hit."""

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        panel = LaserCutPanel(
            spacing_mm=SPACING_MM, thickness_mm=THICKNESS_MM, cut_width_mm=CUT_MM, medium=Medium(n=INDEX)
        )
        optics, _ = exact_optics(
            panel, wavelength_nm=None, polarisation="averaged", tolerance=TOLERANCE, arc_chords=ARC_CHORDS
        )
        return optics.glazing()


def wall_with(glazing: object, surfaces: tuple[Surface, ...] = (), interfaces: tuple[Interface, ...] = ()) -> Room:
    """A black wall with the window, and what stands behind it outside."""
    x = WIDTH_M / 2.0
    outline = [(x, 0.0, 0.0), (-x, 0.0, 0.0), (-x, 0.0, HEIGHT_M), (x, 0.0, HEIGHT_M)]
    around = [(9.0, 0.0, -9.0), (-9.0, 0.0, -9.0), (-9.0, 0.0, 9.0), (9.0, 0.0, 9.0)]
    wall = Surface(name="wall", outline_m=around, holes_m=[outline], material=BLACK)
    return Room(
        surfaces=(wall, *surfaces),
        interfaces=interfaces,
        windows=(Window(name="window", outline_m=outline, glazing=glazing),),
        sensors=(Sensors(points_m=[[0.0, 4.0, 0.3], [0.0, 4.0, 2.3], [1.5, 4.0, -1.5]], normals=[0.0, -1.0, 0.0]),),
    )


def drawn() -> Room:
    """The panel as boxes between mirrors."""
    x, depth = WIDTH_M / 2.0, THICKNESS_MM / 1e3 + 2.0 * HAIR_M
    frame = [(-x, 0.0), (x, 0.0), (x, HEIGHT_M), (-x, HEIGHT_M)]
    mirrors = []
    for side, (first, second) in enumerate(zip(frame, [*frame[1:], frame[0]], strict=True)):
        outline = [(a, y, b) for (a, b), y in ((first, 0.0), (second, 0.0), (second, -depth), (first, -depth))]
        mirrors.append(Surface(name=f"mirror {side}", outline_m=outline, material=MIRROR))
    bars = []
    for k in range(round(1e3 * HEIGHT_M / SPACING_MM)):
        low = (k * SPACING_MM + CUT_MM / 2.0) / 1e3
        corners = [
            (a, y, z)
            for a in (-x + 1e-6, x - 1e-6)
            for y in (HAIR_M - depth, -HAIR_M)
            for z in (low, low + (SPACING_MM - CUT_MM) / 1e3)
        ]
        bars.append(Interface(name=f"bar {k}", vertices_m=corners, triangles=BOX, back_index=INDEX))
    return wall_with(Open(), tuple(mirrors), tuple(bars))


# corners are numbered 4 x + 2 y + z; each face anticlockwise from outside
BOX = [
    *([0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5]),
    *([0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6]),
    *([0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]),
]


def claim(thorough: bool) -> Claim:
    """Whole and redirected illuminance of three sensors."""
    rounds = 4096 if thorough else 1024
    lit = []
    for room in (wall_with(Averaged()), drawn()):
        coefficients = daylight_coefficients(room, basis="tregenza145", sky=SKY, rounds=rounds, seed=16)
        found = illuminance(coefficients, SKY)
        # patches are drawn together: their errors add at most
        error = coefficients.redirected_standard_error.sum("patch")
        lit.append((found.total.values, found.total_standard_error.values, found.redirected.values, error.values))
    plane, bars = lit
    whole_error, part_error = np.hypot(plane[1], bars[1]), np.hypot(plane[3], bars[3])
    with styled():
        figure = blank(5.6, 3.4)
        axes = figure.add_subplot()
        for row, (label, found) in enumerate((("plane", plane), ("thirty bars", bars))):
            place = np.arange(3) + 0.36 * (row - 0.5)
            axes.bar(place, found[0], yerr=found[1], width=0.34, color=COLOURS[row], label=label, capsize=3)
        axes.set_xticks(range(3), ["level", "above", "below"])
        axes.set(ylabel="Illuminance [lx per cd/m²]", title="A panel as a plane and drawn bar by bar")
        axes.legend(ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.12))
    return Claim(
        [
            Measured("whole: largest standard error, relative", float((whole_error / bars[0]).max()), 0.01),
            Measured(
                "whole: largest difference, in standard errors",
                float(np.abs((plane[0] - bars[0]) / whole_error).max()),
                4.0,
            ),
            Measured("whole: largest difference, relative", float(np.abs(plane[0] / bars[0] - 1.0).max()), 0.02),
            Measured("redirected above: standard error, relative", float(part_error[1] / bars[2][1]), 0.06),
            Measured(
                "redirected above: difference, in standard errors",
                float(abs(plane[2][1] - bars[2][1]) / part_error[1]),
                4.0,
            ),
        ],
        figure,
    )
