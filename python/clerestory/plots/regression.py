"""Regression cloud: computed against reference, with the line, R² and what is left."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from clerestory.plots.style import COLOURS, FAINT, INK, blank, styled


class Comparison(Protocol):
    """What a comparison of two tables tells: the pairs, and the regression of values on reference."""

    @property
    def reference(self) -> NDArray[np.float64]:
        """The values to meet, shape (k,)."""

    @property
    def values(self) -> NDArray[np.float64]:
        """The values found, shape (k,)."""

    @property
    def r_squared(self) -> float:
        """Share of the variance that the line explains."""

    @property
    def slope(self) -> float:
        """Of the line."""

    @property
    def intercept(self) -> float:
        """Of the line."""

    @property
    def rms(self) -> float:
        """Root mean square of the differences."""


def regression(
    comparison: Comparison, *, quantity: str = "Transmittance", reference: str = "reference", title: str | None = None
) -> Figure:
    """Each pair a dot, the regression line through them, equality dashed.

    Parameters
    ----------
    comparison : Comparison
        Of :func:`clerestory.compare.compare`.
    quantity : str, default "Transmittance"
        What was compared, with its unit if it has one.
    reference : str, default "reference"
        Where the reference comes from.
    title : str, optional

    Returns
    -------
    Figure
        With R², slope and root mean square difference in a corner.
    """
    low = float(min(comparison.reference.min(), comparison.values.min(), 0.0))
    high = float(max(comparison.reference.max(), comparison.values.max()))
    ends = np.array([low, high + 0.04 * (high - low)])
    with styled():
        figure = blank(4.8, 4.6)
        axes = figure.add_subplot()
        axes.plot(ends, ends, color=FAINT, linestyle=(0, (3, 3)), linewidth=1.0, label="equal")
        line = comparison.intercept + comparison.slope * ends
        axes.plot(ends, line, color=COLOURS[1], linewidth=1.6, label="regression")
        axes.plot(comparison.reference, comparison.values, "o", color=COLOURS[0], markersize=5, markeredgecolor="white")
        axes.set(
            aspect="equal", xlim=ends, ylim=ends, xlabel=f"{quantity}, {reference}", ylabel=f"{quantity}, computed"
        )
        numbers = f"R² = {comparison.r_squared:.4f}\nslope = {comparison.slope:.4f}\nrms = {comparison.rms:.4f}"
        axes.text(0.04, 0.96, numbers, transform=axes.transAxes, va="top", color=INK, linespacing=1.5)
        axes.legend(loc="lower right")
        axes.set_title(title or "Computed against reference")
    return figure
