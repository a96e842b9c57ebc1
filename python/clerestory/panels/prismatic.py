"""The prismatic panel: a sheet with ridges on one side."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Literal

from clerestory import _native
from clerestory.medium import PMMA, Medium
from clerestory.panels.arguments import medium
from clerestory.panels.panel import Panel
from clerestory.rules import number, one_of


@dataclass(frozen=True, slots=True, kw_only=True)
class PrismaticPanel(Panel):
    """A clear sheet with horizontal ridges on one side, flat on the other.

    Parameters
    ----------
    pitch_mm : float, greater than 0 [mm]
        From each ridge to the next.
    lower_deg, upper_deg : float, greater than 0, at most 90 [degrees]
        Between the sheet and the facet below and above the ridge; not both 90.
    base_mm : float, at least 0 [mm]
        Of the solid sheet under the ridges.
    ridges : {"front", "back"}, default "front"
        The side that carries them; front is the outside.
    medium : Medium or the name of one, default PMMA

    Raises
    ------
    ClerestoryError
        If a value breaks its rule.

    Notes
    -----
    The ridges are pitch / (cot lower + cot upper) high (theory/panels.md, eq. 3).

    Examples
    --------
    >>> PrismaticPanel(pitch_mm=2.0, lower_deg=45, upper_deg=45, base_mm=3.0).profile.depth_range_mm
    (0.0, 4.0)
    """

    kind: ClassVar[str] = "prismatic"

    pitch_mm: float
    lower_deg: float
    upper_deg: float
    base_mm: float
    ridges: Literal["front", "back"] = "front"
    medium: Medium = PMMA

    @property
    def media(self) -> tuple[Medium, ...]:
        """The sheet's."""
        return (self.medium,)

    def _checked(self) -> dict[str, Any]:
        numbers = ("pitch_mm", "lower_deg", "upper_deg", "base_mm")
        return {name: number(name, getattr(self, name)) for name in numbers} | {
            "ridges": one_of("ridges", self.ridges, ("front", "back")),
            "medium": medium("medium", self.medium),
        }

    def _drawn(self) -> _native.Profile:
        return _native.Profile.prismatic(
            pitch_mm=self.pitch_mm,
            lower_deg=self.lower_deg,
            upper_deg=self.upper_deg,
            base_mm=self.base_mm,
            ridges=self.ridges,
        )
