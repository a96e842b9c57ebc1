"""A laser-cut panel as a plane and as thirty bars."""

from __future__ import annotations

from tests.validation.claim import Claim
from tests.validation.drawn_in_a_wall import HAIR_M, PANEL, THICKNESS_MM, averaged, bars, compared, drawn, wall_with

from clerestory import _native


class Averaged:
    """The panel with light unpolarised again at every hit."""

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return averaged(PANEL)


def claim(thorough: bool) -> Claim:
    """Whole and redirected illuminance of three sensors."""
    boxes = drawn(bars(-HAIR_M), THICKNESS_MM / 1e3 + 2.0 * HAIR_M)
    return compared(
        {"plane": wall_with(Averaged()), "thirty bars": boxes},
        title="A panel as a plane and drawn bar by bar",
        rounds=4096 if thorough else 1024,
        whole_error=0.01,
        whole_off=0.02,
        part_error=0.06,
    )
