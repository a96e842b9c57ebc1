"""A curve from the facade to the back of the room, several glazings compared."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from clerestory.errors import ClerestoryError
from clerestory.plots.room_plan import grid_frame, quantity
from clerestory.plots.style import FAINT, blank, line_style, note, styled
from clerestory.room.scene import Room

WIDE = 50.0


def room_section(
    curves: Mapping[str, xr.DataArray],
    *,
    room: Room | None = None,
    standard_errors: Mapping[str, xr.DataArray] | None = None,
    threshold: float | None = None,
    title: str | None = None,
) -> Figure:
    """Mean of each row of sensors against its distance into the room, with the range over the row.

    Parameters
    ----------
    curves : mapping of label → DataArray, dims ("sensor",)
        Of one grid each, such as `daylight_factor(...).total` for two glazings of one room.
    room : Room, optional
        Counts lengths from the corner of the floor.
    standard_errors : mapping of label → DataArray, optional
        Drawn as bars: those of a row's mean, as if the row's errors went the same way.
    threshold : float, optional
        A level to reach, drawn as a line.
    title : str, optional

    Returns
    -------
    Figure
        The scale is logarithmic where the values span over 50 to 1.

    Raises
    ------
    ClerestoryError
        If there is no curve, or one is not of a single grid.
    """
    if not curves:
        raise ClerestoryError("curves must hold at least one, got none")
    first = next(iter(curves.values()))
    long_name, units = quantity(first)
    with styled():
        figure = blank(6.8, 4.2)
        axes = figure.add_subplot()
        for index, (label, values) in enumerate(curves.items()):
            frame = grid_frame(values, room)
            points = np.stack([values[f"{axis}_m"].values for axis in "xyz"], axis=1)
            along = frame.place(points)[:, 1]
            rows = np.unique(values["row"].values)
            of_row = [values["row"].values == row for row in rows]
            distance = np.array([along[row].mean() for row in of_row])
            mean, least, most = (np.array([f(values.values[row]) for row in of_row]) for f in (np.mean, np.min, np.max))
            style = line_style(index)
            axes.fill_between(distance, least, most, color=style["color"], alpha=0.14, linewidth=0)
            error = (standard_errors or {}).get(label)
            bars = None if error is None else np.array([error.values[row].mean() for row in of_row])
            axes.errorbar(distance, mean, yerr=bars, label=label, capsize=2, elinewidth=1.0, **style)
        if threshold is not None:
            axes.axhline(threshold, color=FAINT, linewidth=1.0, linestyle=(0, (2, 2)))
            axes.annotate(
                f"{threshold:g} {units}", (1.0, threshold), xycoords=("axes fraction", "data"), ha="right", va="bottom"
            )
        lowest, highest = (float(f([f(values) for values in curves.values()])) for f in (np.min, np.max))
        if lowest > 0.0 and highest / lowest > WIDE:
            axes.set_yscale("log")
            axes.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")
        else:
            axes.set_ylim(bottom=0.0)
        axes.set_xlim(left=0.0)
        axes.set(xlabel="Distance into the room [m]", ylabel=f"{long_name} [{units}]")
        axes.legend(title=None)
        axes.set_title(title or f"{long_name} through the room", pad=18)
        note(axes, "line: mean of each row of sensors; band: least to most in the row")
    return figure
