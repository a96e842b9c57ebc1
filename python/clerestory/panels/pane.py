"""The plain pane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from clerestory import _native
from clerestory.medium import SODA_LIME_CLEAR, Medium
from clerestory.panels.arguments import medium
from clerestory.panels.panel import Panel
from clerestory.rules import number


@dataclass(frozen=True, slots=True, kw_only=True)
class Pane(Panel):
    """A plane-parallel sheet.

    Parameters
    ----------
    thickness_mm : float, greater than 0 [mm]
    medium : Medium or the name of one, default clear soda-lime glass

    Raises
    ------
    ClerestoryError
        If a value breaks its rule.

    Examples
    --------
    >>> round(Pane(thickness_mm=4.0, medium=Medium(n=1.52)).angular(elevation_deg=0).transmittance.item(), 4)
    0.9183
    """

    kind: ClassVar[str] = "pane"

    thickness_mm: float
    medium: Medium = SODA_LIME_CLEAR

    @property
    def media(self) -> tuple[Medium, ...]:
        """The sheet's."""
        return (self.medium,)

    def _checked(self) -> dict[str, Any]:
        return {
            "thickness_mm": number("thickness_mm", self.thickness_mm),
            "medium": medium("medium", self.medium),
        }

    def _drawn(self) -> _native.Profile:
        return _native.Profile.pane(thickness_mm=self.thickness_mm)
