"""Figures of several variants as dots on one line each, told apart by shape and colour."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure

from clerestory.errors import ClerestoryError
from clerestory.plots.style import COLOURS, HAIR, blank, styled

MARKERS = "osD^vPX"


def variant_dots(
    rows: Mapping[str, Mapping[str, tuple[float, float]]],
    *,
    label: str = "Share [%]",
    limits: tuple[float, float] | None = (0.0, 100.0),
    title: str | None = None,
) -> Figure:
    """Dots with their standard errors, a line a figure and a shape a variant.

    Parameters
    ----------
    rows : mapping of what it is → mapping of variant → (value, standard error)
        All of one unit.
    label : str
        Of the axis, with the unit.
    limits : two floats, optional
        Ends of the axis.
    title : str, optional

    Returns
    -------
    Figure

    Raises
    ------
    ClerestoryError
        If there is nothing to draw.
    """
    variants = list(dict.fromkeys(variant for row in rows.values() for variant in row))
    if not variants:
        raise ClerestoryError("rows must hold at least one figure of one variant, got none")
    with styled():
        figure = blank(7.4, 1.2 + 0.42 * len(rows))
        axes = figure.add_subplot()
        for index, variant in enumerate(variants):
            # a little apart, so that equal values stay seen
            shift = 0.22 * (index - (len(variants) - 1) / 2) / max(1, (len(variants) - 1) / 2)
            found = [(place, row[variant]) for place, row in enumerate(rows.values()) if variant in row]
            axes.errorbar(
                [value for _, (value, _) in found],
                [place + shift for place, _ in found],
                xerr=[error for _, (_, error) in found],
                color=COLOURS[index % len(COLOURS)],
                marker=MARKERS[index % len(MARKERS)],
                linestyle="none",
                markersize=7,
                capsize=2,
                label=variant,
            )
        axes.set_yticks(range(len(rows)), list(rows))
        axes.set_ylim(len(rows) - 0.5, -0.5)
        for place in range(len(rows)):
            axes.axhline(place, color=HAIR, linewidth=0.8, zorder=0)
        axes.grid(axis="y", visible=False)
        if limits is not None:
            span = limits[1] - limits[0]
            axes.set_xlim(limits[0] - 0.02 * span, limits[1] + 0.02 * span)
        axes.set_xlabel(label)
        figure.legend(loc="outside upper left", ncols=min(3, len(variants)))
        if title:
            figure.suptitle(title, x=0.02, ha="left")
    return figure
