"""A laser-cut panel between two panes, as a stack and as boxes."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured
from tests.validation.drawn_panel.measure import (
    BOX,
    CUT_MM,
    HAIR_M,
    HEIGHT_M,
    MIRROR,
    SKY,
    SPACING_MM,
    THICKNESS_MM,
    WIDTH_M,
    Averaged,
    wall_with,
)

from clerestory import _native
from clerestory.coefficients import daylight_coefficients
from clerestory.glazing import Open
from clerestory.illuminance import illuminance
from clerestory.medium import Medium
from clerestory.panels import Pane
from clerestory.panels.optics import ARC_CHORDS, TOLERANCE, exact_optics
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.room import Interface, Room, Surface

PANE_MM, PANE_INDEX, GAP_MM, BAR_INDEX = 6.0, 1.52, 4.0, 1.49


class AveragedStack:
    """Pane, panel and pane with light unpolarised again at every face."""

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        pane = Pane(thickness_mm=PANE_MM, medium=Medium(n=PANE_INDEX))
        optics, _ = exact_optics(
            pane, wavelength_nm=None, polarisation="averaged", tolerance=TOLERANCE, arc_chords=ARC_CHORDS
        )
        layers = [optics.glazing(), Averaged().glazing(), optics.glazing()]
        return _native.Stack([layers], weights=[1.0], is_resolved=False).glazing()


def drawn() -> Room:
    """The same as boxes between mirrors, the room's side at y = 0."""
    x = WIDTH_M / 2.0
    depth = (THICKNESS_MM + 2.0 * (PANE_MM + GAP_MM)) / 1e3 + 2.0 * HAIR_M
    frame = [(-x, 0.0), (x, 0.0), (x, HEIGHT_M), (-x, HEIGHT_M)]
    mirrors = []
    for side, (first, second) in enumerate(zip(frame, [*frame[1:], frame[0]], strict=True)):
        outline = [(a, y, b) for (a, b), y in ((first, 0.0), (second, 0.0), (second, -depth), (first, -depth))]
        mirrors.append(Surface(name=f"mirror {side}", outline_m=outline, material=MIRROR))
    boxes, near = [], -HAIR_M
    for name, thickness in (("inner pane", PANE_MM), ("bars", THICKNESS_MM), ("outer pane", PANE_MM)):
        far = near - thickness / 1e3
        if name == "bars":
            rows = [(k * SPACING_MM + CUT_MM / 2.0) / 1e3 for k in range(round(1e3 * HEIGHT_M / SPACING_MM))]
            heights = [(low, low + (SPACING_MM - CUT_MM) / 1e3) for low in rows]
        else:
            heights = [(1e-6, HEIGHT_M - 1e-6)]
        for number, height in enumerate(heights):
            corners = [(a, y, z) for a in (-x + 1e-6, x - 1e-6) for y in (far, near) for z in height]
            index = BAR_INDEX if name == "bars" else PANE_INDEX
            boxes.append(Interface(name=f"{name} {number}", vertices_m=corners, triangles=BOX, back_index=index))
        near = far - GAP_MM / 1e3
    return wall_with(Open(), tuple(mirrors), tuple(boxes))


def claim(thorough: bool) -> Claim:
    """Whole and redirected illuminance of three sensors."""
    rounds = 4096 if thorough else 768
    lit = []
    for room in (wall_with(AveragedStack()), drawn()):
        coefficients = daylight_coefficients(room, basis="tregenza145", sky=SKY, rounds=rounds, seed=16)
        found = illuminance(coefficients, SKY)
        # patches are drawn together: their errors add at most
        error = coefficients.redirected_standard_error.sum("patch")
        lit.append((found.total.values, found.total_standard_error.values, found.redirected.values, error.values))
    plane, boxes = lit
    whole_error, part_error = np.hypot(plane[1], boxes[1]), np.hypot(plane[3], boxes[3])
    with styled():
        figure = blank(5.6, 3.4)
        axes = figure.add_subplot()
        for row, (label, found) in enumerate((("stack", plane), ("boxes", boxes))):
            place = np.arange(3) + 0.36 * (row - 0.5)
            axes.bar(place, found[0], yerr=found[1], width=0.34, color=COLOURS[row], label=label, capsize=3)
        axes.set_xticks(range(3), ["level", "above", "below"])
        axes.set(ylabel="Illuminance [lx per cd/m²]", title="A panel between panes, as a stack and drawn")
        axes.legend(ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.12))
    off = np.abs(plane[0] - boxes[0])
    return Claim(
        [
            Measured("whole: largest standard error, relative", float((whole_error / boxes[0]).max()), 0.015),
            Measured("whole: largest difference, in standard errors", float((off / whole_error).max()), 4.0),
            Measured("whole: largest difference, relative", float((off / boxes[0]).max()), 0.03),
            Measured("redirected above: standard error, relative", float(part_error[1] / boxes[2][1]), 0.1),
            Measured(
                "redirected above: difference, in standard errors",
                float(abs(plane[2][1] - boxes[2][1]) / part_error[1]),
                4.0,
            ),
        ],
        figure,
    )
