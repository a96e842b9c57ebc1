"""A window as one plane and as the boxes it is made of, between mirrors: what both give three sensors."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from tests.validation.claim import Claim, Measured

from clerestory import _native
from clerestory.coefficients import daylight_coefficients
from clerestory.glazing import Open
from clerestory.illuminance import illuminance
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel, Panel
from clerestory.panels.optics import ARC_CHORDS, TOLERANCE, exact_optics
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.room import Interface, Material, Room, Sensors, Surface, Window
from clerestory.sky import CieSky

SPACING_MM, THICKNESS_MM, CUT_MM, INDEX = 20.0, 30.0, 1.0, 1.49
WIDTH_M, HEIGHT_M = 2.0, 0.6
PANEL = LaserCutPanel(spacing_mm=SPACING_MM, thickness_mm=THICKNESS_MM, cut_width_mm=CUT_MM, medium=Medium(n=INDEX))
SKY = CieSky(sky_type=5, zenith_luminance_cd_m2=1.0)
BLACK = Material(diffuse_reflectance=0.0)
MIRROR = Material(diffuse_reflectance=0.0, specular_reflectance=1.0)
# a hair between faces that would otherwise lie in one plane
HAIR_M = 1e-3
# corners are numbered 4 x + 2 y + z; each face anticlockwise from outside
_BOX = [
    *([0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5]),
    *([0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6]),
    *([0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]),
]
Box = tuple[str, tuple[float, float], tuple[float, float], float]
"""Name, y from the far to the near face and z from the lower to the upper [m], and refractive index."""


def averaged(panel: Panel) -> _native.Glazing:
    """A panel with light unpolarised again at every hit."""
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


def bars(near_m: float) -> list[Box]:
    """The bars of the panel, whose face to the room lies at y = ``near_m``."""
    rows = [(k * SPACING_MM + CUT_MM / 2.0) / 1e3 for k in range(round(1e3 * HEIGHT_M / SPACING_MM))]
    depth = (near_m - THICKNESS_MM / 1e3, near_m)
    return [(f"bar {k}", depth, (low, low + (SPACING_MM - CUT_MM) / 1e3), INDEX) for k, low in enumerate(rows)]


def drawn(boxes: Sequence[Box], depth_m: float) -> Room:
    """Boxes between mirrors that reach from the wall outwards, in an open window."""
    x = WIDTH_M / 2.0
    frame = [(-x, 0.0), (x, 0.0), (x, HEIGHT_M), (-x, HEIGHT_M)]
    mirrors = []
    for side, (first, second) in enumerate(zip(frame, [*frame[1:], frame[0]], strict=True)):
        outline = [(a, y, b) for (a, b), y in ((first, 0.0), (second, 0.0), (second, -depth_m), (first, -depth_m))]
        mirrors.append(Surface(name=f"mirror {side}", outline_m=outline, material=MIRROR))
    solids = []
    for name, depth, height, index in boxes:
        corners = [(a, y, z) for a in (-x + 1e-6, x - 1e-6) for y in depth for z in height]
        solids.append(Interface(name=name, vertices_m=corners, triangles=_BOX, back_index=index))
    return wall_with(Open(), tuple(mirrors), tuple(solids))


def compared(
    rooms: dict[str, Room], *, title: str, rounds: int, whole_error: float, whole_off: float, part_error: float
) -> Claim:
    """Whole and redirected illuminance of three sensors in two rooms, the second being the drawn one.

    Parameters
    ----------
    rooms : mapping of label → Room
    title : str
        Of the figure.
    rounds : int
    whole_error, whole_off, part_error : float
        Relative limits of the standard error and the difference of the whole, and of the standard error of the
        redirected part at the sensor above.
    """
    lit = []
    for room in rooms.values():
        coefficients = daylight_coefficients(room, basis="tregenza145", sky=SKY, rounds=rounds, seed=16)
        found = illuminance(coefficients, SKY)
        # patches are drawn together: their errors add at most
        error = coefficients.redirected_standard_error.sum("patch")
        lit.append((found.total.values, found.total_standard_error.values, found.redirected.values, error.values))
    plane, boxes = lit
    error, error_of_part = np.hypot(plane[1], boxes[1]), np.hypot(plane[3], boxes[3])
    off, off_of_part = np.abs(plane[0] - boxes[0]), np.abs(plane[2] - boxes[2])
    with styled():
        figure = blank(5.6, 3.4)
        axes = figure.add_subplot()
        for row, (label, found) in enumerate(zip(rooms, lit, strict=True)):
            place = np.arange(3) + 0.36 * (row - 0.5)
            axes.bar(place, found[0], yerr=found[1], width=0.34, color=COLOURS[row], label=label, capsize=3)
        axes.set_xticks(range(3), ["level", "above", "below"])
        axes.set(ylabel="Illuminance [lx per cd/m²]", title=title)
        axes.legend(ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.12))
    return Claim(
        [
            Measured("whole: largest standard error, relative", float((error / boxes[0]).max()), whole_error),
            Measured("whole: largest difference, in standard errors", float((off / error).max()), 4.0),
            Measured("whole: largest difference, relative", float((off / boxes[0]).max()), whole_off),
            Measured("redirected above: standard error, relative", float(error_of_part[1] / boxes[2][1]), part_error),
            Measured("redirected above: difference, in standard errors", float(off_of_part[1] / error_of_part[1]), 4.0),
        ],
        figure,
    )
