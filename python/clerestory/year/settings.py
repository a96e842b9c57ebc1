"""What a study of a year is asked, and how well to compute it."""

from __future__ import annotations

from dataclasses import dataclass

from clerestory.errors import ClerestoryError
from clerestory.metrics.blinds import WHITE_LOUVRES
from clerestory.rules import not_negative, positive, within


@dataclass(frozen=True, kw_only=True)
class Blinds:
    """Blinds before a group of windows that people close together, against the sun through this group.

    Parameters
    ----------
    windows : sequence of str
        Names of windows of the room.
    transmittance : float, 0..1, default 0.2
        Of the closed blinds for diffuse light: 0.2 white louvres, 0.05 a fabric of which nothing is known.
    """

    windows: tuple[str, ...]
    transmittance: float = WHITE_LOUVRES

    def __post_init__(self) -> None:
        given: object = self.windows
        if isinstance(given, str) or not self.windows:
            raise ClerestoryError(f"windows of blinds must be a list of names, got {self.windows!r}")
        object.__setattr__(self, "windows", tuple(self.windows))
        within("transmittance of blinds", self.transmittance, 0.0, 1.0)

    @property
    def name(self) -> str:
        """What the group is called."""
        return " + ".join(self.windows)


@dataclass(frozen=True, kw_only=True)
class Measures:
    """Thresholds of the metrics, and the sensors that they are taken at.

    Parameters
    ----------
    threshold_lx : float, default 300
        Enough light: for daylight autonomy in its kinds and for the useful depth.
    useful_limits_lx : three floats, default (100, 300, 3000)
        Between the four bands of useful daylight.
    sunlit_lx : float, default 1000
        Of the sun's own light: for blinds, sunlight exposure and the hours in the sun's patch.
    exposure_limit_h : float, default 250
        Of annual sunlight exposure.
    depth_percent : float, default 50
        Daylight autonomy that the useful depth asks for.
    work_plane : str, optional
        Name of the sensors at desks; default the first of the room.
    eyes : str, optional
        Name of the sensors at eyes, for the hours in the sun's patch; default those of the work plane.
    """

    threshold_lx: float = 300.0
    useful_limits_lx: tuple[float, float, float] = (100.0, 300.0, 3000.0)
    sunlit_lx: float = 1000.0
    exposure_limit_h: float = 250.0
    depth_percent: float = 50.0
    work_plane: str | None = None
    eyes: str | None = None

    def __post_init__(self) -> None:
        positive("threshold_lx", self.threshold_lx)
        positive("sunlit_lx", self.sunlit_lx)
        not_negative("exposure_limit_h", self.exposure_limit_h)
        within("depth_percent", self.depth_percent, 0.0, 100.0)
        limits = tuple(positive("useful_limits_lx", limit) for limit in self.useful_limits_lx)
        if len(limits) != 3 or not limits[0] < limits[1] < limits[2]:
            raise ClerestoryError(f"useful_limits_lx must be three rising illuminances, got {list(limits)}")
        object.__setattr__(self, "useful_limits_lx", limits)
