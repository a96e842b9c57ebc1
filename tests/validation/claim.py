"""What a validation case hands over: numbers with their limits, and a figure."""

from __future__ import annotations

from dataclasses import dataclass

from matplotlib.figure import Figure


@dataclass(frozen=True)
class Measured:
    """One number and the limit that the claim stands or falls with."""

    what: str
    value: float
    limit: float
    #: The value must be at least the limit, not at most.
    is_floor: bool = False

    @property
    def holds(self) -> bool:
        """Whether the claim stands; a value that is no number never does."""
        return self.value >= self.limit if self.is_floor else self.value <= self.limit

    @property
    def row(self) -> str:
        """Its row in the table of a page."""
        sign = "≥" if self.is_floor else "≤"
        verdict = "holds" if self.holds else "**fails**"
        return f"| {self.what} | {self.value:.4g} | {sign} {self.limit:g} | {verdict} |"


@dataclass(frozen=True)
class Claim:
    """The outcome of one case."""

    measured: list[Measured]
    figure: Figure
