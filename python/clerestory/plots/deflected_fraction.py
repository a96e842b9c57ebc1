"""Deflected fraction against incidence, for panels of several proportions."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.figure import Figure
from numpy.typing import ArrayLike
from xarray import Dataset

from clerestory.plots.radial import line
from clerestory.plots.style import FAINT, blank, degrees, line_style, styled


def deflected_fraction(
    tables: Mapping[float, Dataset], *, formula: Mapping[float, ArrayLike] | None = None, title: str | None = None
) -> Figure:
    """Share of the transmitted light that leaves with its vertical sense reversed, against elevation.

    Parameters
    ----------
    tables : mapping from D/W (spacing over thickness) to Dataset
        Each of ``panel.angular(...)`` at one azimuth.
    formula : mapping from D/W to array_like, optional
        What to draw dashed beside each, at the elevations of its table: the values of
        :func:`~clerestory.glass.edmonds_deflected_fraction`, say.
    title : str, optional

    Returns
    -------
    Figure

    Raises
    ------
    ClerestoryError
        If a table has several azimuths or wavelengths, or no transmittance.
    """
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        for number, (ratio, table) in enumerate(tables.items()):
            fraction = line(table, "transmittance_deflected")[0] / line(table, "transmittance")[0]
            elevation, colour = table["elevation"].to_numpy(), line_style(number)["color"]
            axes.plot(elevation, fraction.to_numpy(), color=colour, label=f"D/W = {ratio:g}")
            if formula and ratio in formula:
                axes.plot(elevation, formula[ratio], color=colour, linestyle=(0, (3, 2)), linewidth=1.1)
        if formula:
            axes.plot([], [], color=FAINT, linestyle=(0, (3, 2)), linewidth=1.1, label="formula")
        axes.set(
            ylim=(0.0, 1.0), xlabel="Elevation of the incident light", ylabel="Deflected share of the transmitted light"
        )
        axes.margins(x=0.0)
        degrees(axes.xaxis, 15.0)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=4)
        axes.set_title(title or "Deflected fraction")
    return figure
