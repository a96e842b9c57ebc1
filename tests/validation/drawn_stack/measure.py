"""A laser-cut panel between two panes, as a stack and as boxes."""

from __future__ import annotations

from tests.validation.claim import Claim
from tests.validation.drawn_in_a_wall import (
    HAIR_M,
    HEIGHT_M,
    PANEL,
    THICKNESS_MM,
    Box,
    averaged,
    bars,
    compared,
    drawn,
    wall_with,
)

from clerestory import _native
from clerestory.medium import Medium
from clerestory.panels import Pane

PANE_MM, PANE_INDEX, GAP_MM = 6.0, 1.52, 4.0


class AveragedStack:
    """Pane, panel and pane with light unpolarised again at every face."""

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        pane = Pane(thickness_mm=PANE_MM, medium=Medium(n=PANE_INDEX))
        layers = [averaged(pane), averaged(PANEL), averaged(pane)]
        return _native.Stack([layers], weights=[1.0], is_resolved=False).glazing()


def layers_drawn() -> list[Box]:
    """Pane, bars and pane from the room outwards."""
    height = (1e-6, HEIGHT_M - 1e-6)
    inner = -HAIR_M
    panel = inner - (PANE_MM + GAP_MM) / 1e3
    outer = panel - (THICKNESS_MM + GAP_MM) / 1e3
    panes = [
        (name, (near - PANE_MM / 1e3, near), height, PANE_INDEX)
        for name, near in (("inner pane", inner), ("outer pane", outer))
    ]
    return [panes[0], *bars(panel), panes[1]]


def claim(thorough: bool) -> Claim:
    """Whole and redirected illuminance of three sensors."""
    depth = (THICKNESS_MM + 2.0 * (PANE_MM + GAP_MM)) / 1e3 + 2.0 * HAIR_M
    return compared(
        {"stack": wall_with(AveragedStack()), "boxes": drawn(layers_drawn(), depth)},
        title="A panel between panes, as a stack and drawn",
        rounds=4096 if thorough else 768,
        whole_error=0.015,
        whole_off=0.03,
        part_error=0.1,
    )
