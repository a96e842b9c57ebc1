"""How a design was found: each trial, the best so far, and the front of two figures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from clerestory.plots.style import COLOURS, FAINT, INK, blank, styled

_MARKERS = ("D", "s", "^", "v")


def design_history(
    figures: ArrayLike,
    *,
    labels: Sequence[str],
    signs: Sequence[float],
    screened: int = 0,
    compared: Mapping[str, Sequence[float]] | None = None,
    title: str | None = None,
) -> Figure:
    """Figures of the trials of a design, one after the other.

    Parameters
    ----------
    figures : array_like, shape (trials, objectives)
        NaN for a case that failed.
    labels : sequence of str
        Of the objectives.
    signs : sequence of 1 or -1
        Whether more or less is better.
    screened : int, default 0
        So many of the first trials were the best panels of the screen.
    compared : mapping of label → figures, optional
        Drawn as lines.
    title : str, optional

    Returns
    -------
    Figure
    """
    values = np.asarray(figures, dtype=np.float64)
    with styled():
        figure = blank(6.4, 1.6 + 2.6 * len(labels))
        axes = figure.subplots(len(labels), 1, sharex=True, squeeze=False)[:, 0]
        for column, (label, sign, one) in enumerate(zip(labels, signs, axes, strict=True)):
            _course(one, values[:, column], label, sign, screened)
            for place, (name, found) in enumerate((compared or {}).items()):
                if len(found) > column:
                    colour = COLOURS[(place + 2) % len(COLOURS)]
                    one.axhline(found[column], color=colour, linestyle=(0, (4, 2)), linewidth=1.2, label=name)
        axes[-1].set_xlabel("Trial")
        handles, names = axes[0].get_legend_handles_labels()
        figure.legend(handles, names, loc="outside lower center", ncols=3)
        axes[0].set_title(title or "Search")
    return figure


def pareto_front(
    figures: ArrayLike,
    *,
    labels: Sequence[str],
    front: Sequence[int],
    best: int,
    compared: Mapping[str, Sequence[float]] | None = None,
    title: str | None = None,
) -> Figure:
    """Two figures of all trials against each other, and those that no other beats.

    Parameters
    ----------
    figures : array_like, shape (trials, 2)
    labels : sequence of two str
    front : sequence of int
        Rows of the front, in the order of the first figure.
    best : int
        The row that is marked.
    compared : mapping of label → figures, optional
        Drawn as marks.
    title : str, optional

    Returns
    -------
    Figure
    """
    values = np.asarray(figures, dtype=np.float64)
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        axes.plot(*values.T, "o", color=FAINT, markersize=4, alpha=0.7, label="trials", linestyle="none")
        axes.plot(*values[list(front)].T, "o-", color=COLOURS[0], markersize=5, label="front")
        axes.plot(*values[best], "o", color="none", markeredgecolor=INK, markersize=12, label="nearest to both bests")
        for place, (name, found) in enumerate((compared or {}).items()):
            if len(found) == 2:
                mark, colour = _MARKERS[place % len(_MARKERS)], COLOURS[(place + 1) % len(COLOURS)]
                axes.plot(*found, mark, color=colour, markersize=7, label=name, linestyle="none")
        axes.set(xlabel=labels[0], ylabel=labels[1])
        figure.legend(loc="outside lower center", ncols=3)
        axes.set_title(title or "Front")
    return figure


def _course(axes: Axes, values: npt.NDArray[np.float64], label: str, sign: float, screened: int) -> None:
    number = np.arange(1, len(values) + 1)
    from_screen = number <= screened
    if screened:
        axes.plot(
            number[from_screen], values[from_screen], "s", color=COLOURS[1], markersize=4.5, label="from the screen"
        )
    axes.plot(number[~from_screen], values[~from_screen], "o", color=FAINT, markersize=4, label="trial")
    so_far = sign * np.fmax.accumulate(sign * values)
    axes.plot(number, so_far, color=COLOURS[0], drawstyle="steps-post", label="best so far")
    axes.set_ylabel(label)
