"""The laser-cut panel: a sheet with fine cuts that mirror light inside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from clerestory import _native
from clerestory.medium import PMMA, Medium
from clerestory.panels.arguments import medium, repeating, sequence
from clerestory.panels.panel import Panel
from clerestory.rules import number


@dataclass(frozen=True, slots=True, kw_only=True)
class LaserCutPanel(Panel):
    """A clear sheet with parallel horizontal cuts: light is mirrored by total reflection at their faces.

    Parameters
    ----------
    spacing_mm : float or sequence of float, greater than 0 [mm]
        From each cut to the next, D in the literature. A sequence repeats, as do those of tilts and depths; sequences
        of different lengths repeat until all end together.
    thickness_mm : float, greater than 0 [mm]
        Of the sheet, W in the literature.
    cut_width_mm : float, at least 0 and smaller than spacing_mm, default 0 [mm]
        Of the kerf; each bar is spacing - cut width high. 0: an air gap that takes no room, the ideal cut.
    cut_tilt_deg : float or sequence of float, -80..80, default 0 [degrees]
        Above 0 if the cut rises from the outside to the room. Cuts must not cross inside the sheet.
    cut_depth_mm : float or sequence of float, greater than 0, at most thickness_mm, optional [mm]
        From the front. None: right through.
    cut_radius_mm : float, optional [mm]
        Of curved cuts, above 0 if they bulge upwards, below 0 downwards; at least half the length of the cut.
    cut_slope_deg : float, 0..30, default 0 [degrees]
        Root-mean-square tilt of a rippled cut surface, along and across the cut. Needs ``method="monte_carlo"``.
    cut_diffuse : float, 0..1, default 0
        Share of the light on a cut that is reflected diffusely. Needs ``method="monte_carlo"``.
    medium : Medium or the name of one, default PMMA

    Raises
    ------
    ClerestoryError
        If a value breaks its rule.

    Notes
    -----
    I. R. Edmonds, Solar Energy Materials 29, 1-26, 1993. The cross-section: theory/panels.md.

    Examples
    --------
    >>> panel = LaserCutPanel(spacing_mm=6.0, thickness_mm=3.0, medium=Medium(n=1.49))
    >>> round(panel.angular(elevation_deg=60).transmittance_deflected.item(), 4)
    0.3096
    """

    kind: ClassVar[str] = "laser-cut"

    spacing_mm: float | Sequence[float]
    thickness_mm: float
    cut_width_mm: float = 0.0
    cut_tilt_deg: float | Sequence[float] = 0.0
    cut_depth_mm: float | Sequence[float] | None = None
    cut_radius_mm: float | None = None
    cut_slope_deg: float = 0.0
    cut_diffuse: float = 0.0
    medium: Medium = PMMA

    @property
    def media(self) -> tuple[Medium, ...]:
        """The sheet's."""
        return (self.medium,)

    def _checked(self) -> dict[str, Any]:
        depth, radius = self.cut_depth_mm, self.cut_radius_mm
        numbers = ("thickness_mm", "cut_width_mm", "cut_slope_deg", "cut_diffuse")
        return {name: number(name, getattr(self, name)) for name in numbers} | {
            "spacing_mm": repeating("spacing_mm", self.spacing_mm),
            "cut_tilt_deg": repeating("cut_tilt_deg", self.cut_tilt_deg),
            "cut_depth_mm": None if depth is None else repeating("cut_depth_mm", depth),
            "cut_radius_mm": None if radius is None else number("cut_radius_mm", radius),
            "medium": medium("medium", self.medium),
        }

    def _drawn(self) -> _native.Profile:
        return _native.Profile.laser_cut(
            spacing_mm=sequence(self.spacing_mm),
            thickness_mm=self.thickness_mm,
            cut_width_mm=self.cut_width_mm,
            cut_tilt_deg=sequence(self.cut_tilt_deg),
            cut_depth_mm=None if self.cut_depth_mm is None else sequence(self.cut_depth_mm),
            cut_radius_mm=self.cut_radius_mm,
            cut_slope_deg=self.cut_slope_deg,
            cut_diffuse=self.cut_diffuse,
        )
