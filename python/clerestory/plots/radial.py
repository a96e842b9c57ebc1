"""Radial diagram: how much goes through and how much comes back, drawn in the direction the light comes from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import cast

import numpy as np
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from xarray import DataArray, Dataset

from clerestory.errors import ClerestoryError
from clerestory.plots.style import FAINT, HAIR, blank, heading, line_style, styled

#: Names of the quantities in a legend.
_WORDS = {
    "transmittance": "goes through",
    "reflectance": "comes back",
    "absorptance": "is absorbed",
    "transmittance_deflected": "goes through, deflected",
    "transmittance_undeflected": "goes through, undeflected",
}


def radial(
    *tables: Dataset, quantities: Sequence[str] = ("transmittance", "reflectance"), title: str | None = None
) -> Figure:
    """Polar diagram of shares of the light against its incidence.

    Parameters
    ----------
    *tables : Dataset
        One or two of ``panel.angular(...)``, each at one azimuth. Light on the front comes from the left and light on
        the back from the right, as in a section of the panel: one table a side makes one whole diagram.
    quantities : sequence of str, default transmittance and reflectance
        Variables of the tables.
    title : str, optional

    Returns
    -------
    Figure
        The distance from the centre is the share, the direction is where the light comes from. A Monte Carlo table
        has a band of two standard errors on either side.

    Raises
    ------
    ClerestoryError
        If a table has several azimuths or wavelengths, or not that quantity; or two tables are of one side.
    """
    sides = {_side(table): table for table in tables}
    if not tables or len(sides) < len(tables):
        raise ClerestoryError(
            f"radial takes one table a side, got {len(tables)} of {len(sides)} sides; draw two figures"
        )
    lowest = min(float(table["elevation"].min()) for table in sides.values())
    with styled():
        figure = blank(6.4 if len(sides) > 1 else 4.8, 5.4 if lowest < 0.0 else 4.4 if len(sides) == 1 else 3.9)
        axes = cast(PolarAxes, figure.add_subplot(projection="polar"))
        for number, quantity in enumerate(quantities):
            label: str | None = _WORDS.get(quantity, quantity.replace("_", " "))
            for side, table in sides.items():
                share, error = line(table, quantity)
                angle = np.radians(share["elevation"].to_numpy())
                angle = np.pi - angle if side == "front" else angle
                axes.plot(angle, share.to_numpy(), label=label, **line_style(number))
                label = None
                if error is not None:
                    low, high = share - 2.0 * error, share + 2.0 * error
                    axes.fill_between(angle, low, high, color=line_style(number)["color"], alpha=0.2, linewidth=0)
        _frame(axes, sides, -90.0 if lowest < 0.0 else 0.0)
        figure.legend(loc="outside lower center", ncols=2)
        heading(figure, title or "Shares of the light against its incidence")
    return figure


def line(table: Dataset, quantity: str) -> tuple[DataArray, DataArray | None]:
    """One quantity along the elevation, and its standard error if it has one."""
    if quantity not in table:
        known = ", ".join(map(str, table.data_vars))
        raise ClerestoryError(f"quantity must be a variable of the table ({known}), got {quantity!r}")
    for dimension in set(table[quantity].dims) - {"elevation"}:
        if table.sizes[dimension] > 1:
            raise ClerestoryError(
                f"the table must have one {dimension}, got {table.sizes[dimension]}; choose one with .sel or .isel"
            )
    flat = table.squeeze([d for d in table[quantity].dims if d != "elevation"])
    error = f"{quantity}_standard_error"
    return flat[quantity], flat.get(error)


def _side(table: Dataset) -> str:
    return str(table.attrs.get("side", "front"))


def _frame(axes: PolarAxes, sides: Mapping[str, Dataset], least: float) -> None:
    """The arc that the tables cover, labelled in degrees of elevation."""
    if len(sides) == 2:
        first, last = (0.0, 360.0) if least < 0.0 else (0.0, 180.0)
    elif "front" in sides:
        first, last = 90.0, 180.0 - least
    else:
        first, last = least, 90.0
    axes.set_thetamin(first)
    axes.set_thetamax(last)
    ticks = np.arange(first, last + (1.0 if last - first < 360.0 else 0.0), 15.0)
    elevations = np.where(
        (ticks > 90.0) & (ticks < 270.0), 180.0 - ticks, np.where(ticks >= 270.0, ticks - 360.0, ticks)
    )
    axes.set_thetagrids(ticks, [f"{e:g}°".replace("-", "−") for e in elevations])
    axes.set_ylim(0.0, 1.0)
    axes.set_rticks([0.2, 0.4, 0.6, 0.8, 1.0])
    axes.set_rlabel_position(90.0)
    axes.tick_params(axis="y", labelsize=8, labelcolor=FAINT)
    axes.tick_params(axis="x", pad=4)
    for spine in axes.spines.values():
        spine.set_color(FAINT)
    axes.grid(color=HAIR)
    words = {"front": (180.0, "from outside"), "back": (0.0, "from the room")}
    for side in sides:
        angle, word = words[side]
        axes.annotate(
            word,
            (np.radians(angle), 1.0),
            (-6.0 if side == "front" else 6.0, -18.0),
            textcoords="offset points",
            ha="right" if side == "front" else "left",
            va="center",
            color=FAINT,
            fontsize=8.5,
            annotation_clip=False,
        )
