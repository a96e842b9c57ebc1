"""Plans of one metric for several glazings side by side, on one scale."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from clerestory.errors import ClerestoryError
from clerestory.plots.room_plan import draw_grid, draw_windows, grid_frame, quantity
from clerestory.plots.style import blank, styled
from clerestory.room.scene import Room


def metric_plans(
    plans: Mapping[str, xr.DataArray],
    *,
    room: Room | None = None,
    limits: tuple[float, float] | None = None,
    level: float | None = None,
    title: str | None = None,
) -> Figure:
    """Plans of one metric side by side, with the number at each sensor where they fit.

    Parameters
    ----------
    plans : mapping of label → DataArray, dims ("sensor",)
        Of one grid each.
    room : Room, optional
        Draws its windows.
    limits : two floats, optional
        Ends of the scale; default 0 to 100 for percentages, 0 to the most otherwise.
    level : float, optional
        Of a contour line.
    title : str, optional

    Returns
    -------
    Figure

    Raises
    ------
    ClerestoryError
        If there is no plan, or the values are not those of one grid.
    """
    if not plans:
        raise ClerestoryError("plans must hold at least one, got none")
    name, units = quantity(next(iter(plans.values())))
    most = max(float(values.max()) for values in plans.values())
    low, high = limits or (0.0, 100.0 if units == "%" else most or 1.0)
    frames = {label: grid_frame(values, room) for label, values in plans.items()}
    first = next(iter(plans.values()))
    place = frames[next(iter(plans))].place(np.stack([first[f"{axis}_m"].values for axis in "xyz"], axis=1))
    width, height = np.ptp(place, axis=0) + 0.5
    with styled():
        each = float(np.clip(4.4 * width / height, 1.7, 5.5))
        figure = blank(min(each * len(plans) + 1.3, 12.0), float(np.clip(each * height / width, 2.2, 4.8)) + 0.8)
        every = figure.subplots(1, len(plans), sharey=True, squeeze=False)[0]
        for axes, (label, values) in zip(every, plans.items(), strict=True):
            drawn = float(values.min()) < (level or 0.0) < float(values.max())
            mesh = draw_grid(
                axes,
                values,
                frames[label],
                levels=None if level is None else [level],
                norm=Normalize(low, high),
                numbers=len(plans) <= 3,
                digits=0 if high >= 30.0 else None,
                contours=level is not None and drawn,
            )
            if room is not None:
                draw_windows(axes, room, frames[label])
            axes.set_title(label, fontsize=9.5)
            axes.set_xlabel("Across the room [m]")
        every[0].set_ylabel("Into the room [m]")
        bar = figure.colorbar(mesh, ax=every.tolist(), shrink=0.85, aspect=30)
        bar.outline.set_visible(False)
        bar.set_label(f"{name} [{units}]")
        if title:
            figure.suptitle(title, x=0.02, ha="left")
    return figure
