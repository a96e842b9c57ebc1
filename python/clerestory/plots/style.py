"""How every figure of Clerestory looks: colours that colour-blind eyes tell apart, few lines, units on the axes."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text

#: Colours for lines, in their order: M. Okabe, K. Ito, *Color Universal Design*, 2008; told apart by dashes as well.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
DASHES: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (1.5, 1.2)), (0, (6, 1.5, 1.2, 1.5)), (0, (3, 1)), (0, (1, 2)), "-")
INK = "#22262b"
FAINT = "#8a929b"
HAIR = "#dfe3e7"

_SETTINGS: dict[Any, Any] = {
    "axes.axisbelow": True,
    "axes.edgecolor": FAINT,
    "axes.grid": True,
    "axes.labelcolor": INK,
    "axes.labelsize": 10,
    "axes.linewidth": 0.8,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.titlepad": 10,
    "figure.dpi": 110,
    "figure.titlesize": 12,
    "figure.titleweight": "bold",
    "font.size": 9.5,
    "grid.color": HAIR,
    "grid.linewidth": 0.8,
    "legend.frameon": False,
    "legend.handlelength": 2.4,
    "lines.linewidth": 1.9,
    "lines.solid_capstyle": "round",
    "savefig.dpi": 200,
    "svg.fonttype": "path",
    "svg.hashsalt": "clerestory",
    "text.color": INK,
    "xtick.color": FAINT,
    "xtick.labelcolor": INK,
    "xtick.major.size": 3,
    "ytick.color": FAINT,
    "ytick.labelcolor": INK,
    "ytick.major.size": 3,
}


@contextmanager
def styled() -> Iterator[None]:
    """The settings of every figure, within a ``with`` block; the user's own come back after it."""
    with mpl.rc_context(_SETTINGS):
        yield


def blank(width_in: float = 6.4, height_in: float = 4.2) -> Figure:
    """An empty figure that makes room for its labels and belongs to no window."""
    return Figure(figsize=(width_in, height_in), layout="constrained")


def line_style(number: int) -> dict[str, Any]:
    """Colour and dashes of the ``number``-th line of a figure."""
    return {"color": COLOURS[number % len(COLOURS)], "linestyle": DASHES[number % len(DASHES)]}


def degrees(axis: Any, step: float) -> None:
    """Ticks every ``step`` degrees, written with their sign."""
    axis.set_major_locator(mpl.ticker.MultipleLocator(step))
    axis.set_major_formatter(lambda value, _: f"{value:g}°".replace("-", "−"))


def heading(figure: Figure, text: str) -> Text:
    """The title of a figure of several axes, where the title of a single one stands."""
    return figure.suptitle(text, x=0.02, ha="left")


def note(axes: Axes, text: str) -> Text:
    """A line of small print under the title."""
    return axes.annotate(
        text, (0.0, 1.0), (0.0, 3.0), xycoords="axes fraction", textcoords="offset points", color=FAINT, fontsize=8.5
    )
