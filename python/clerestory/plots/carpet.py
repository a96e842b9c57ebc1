"""A year hour by hour: days across, hours of the day up, several glazings one below the other."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import numpy.typing as npt
import pandas as pd
import xarray as xr
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure

from clerestory.errors import ClerestoryError
from clerestory.plots.room_plan import quantity
from clerestory.plots.style import blank, styled

DARK = "#15171a"
"""Of night, and of whatever is 0 on a logarithmic scale."""

LUX_RANGE = (30.0, 10_000.0)
"""Of the logarithmic scale for illuminances [lx]."""

LUX_TICKS = (30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0)


def carpet(
    series: Mapping[str, xr.DataArray], *, limits: tuple[float, float] | None = None, title: str | None = None
) -> Figure:
    """Values of a year by day and hour, one carpet a label, all on one scale.

    Parameters
    ----------
    series : mapping of label → DataArray, dims ("time",)
        With the coordinate `local_time`, the clock that the hours are drawn by; `time` without it. Illuminances have a
        logarithmic scale.
    limits : two floats, optional
        Ends of the scale; default 30 to 10 000 for illuminances, else those of the values.
    title : str, optional

    Returns
    -------
    Figure

    Raises
    ------
    ClerestoryError
        If there is no series, or one has other dimensions.
    """
    if not series:
        raise ClerestoryError("series must hold at least one, got none")
    grids = {label: by_day_and_hour(values) for label, values in series.items()}
    first = next(iter(series.values()))
    name, units = quantity(first)
    is_light = units == "lx"
    least = min(float(np.nanmin(grid[0])) for grid in grids.values())
    most = max(float(np.nanmax(grid[0])) for grid in grids.values())
    low, high = limits or (LUX_RANGE if is_light else (least, most if most > least else least + 1.0))
    norm = LogNorm(low, high) if is_light else Normalize(low, high)
    with styled():
        figure = blank(8.4, 0.7 + 1.75 * len(grids))
        every = figure.subplots(len(grids), 1, sharex=True, squeeze=False)[:, 0]
        for axes, (label, (cells, days, hours)) in zip(every, grids.items(), strict=True):
            shown = np.ma.masked_invalid(np.where(cells > 0.0, cells, np.nan) if is_light else cells)
            axes.set_facecolor(DARK)
            mesh = axes.pcolormesh(days, hours, shown, norm=norm, cmap="viridis", rasterized=True)
            axes.set_ylim(0, 24)
            axes.set_yticks([0, 6, 12, 18, 24])
            axes.grid(False)
            axes.set_title(label, fontsize=9.5, pad=4)
            axes.set_ylabel("Hour")
        months = pd.date_range(pd.Timestamp(days[0]).normalize(), pd.Timestamp(days[-1]), freq="MS")
        if len(months) > 1:
            every[-1].set_xticks(months.to_numpy(), [month.strftime("%b") for month in months], ha="left")
        bar = figure.colorbar(mesh, ax=every.tolist(), shrink=0.9, aspect=12 * len(grids), extend="both")
        bar.outline.set_visible(False)
        bar.set_label(f"{name} [{units}]")
        if is_light:
            bar.set_ticks([tick for tick in LUX_TICKS if low <= tick <= high])
            bar.ax.minorticks_off()
            bar.ax.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")
        if title:
            figure.suptitle(title, x=0.02, ha="left")
    return figure


def by_day_and_hour(
    values: xr.DataArray,
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.datetime64], npt.NDArray[np.float64]]:
    """A series as cells (hour, day), with the edges of days and of hours; what a clock change leaves out is missing."""
    if values.dims != ("time",):
        raise ClerestoryError(f"a carpet must be of a series over time alone, got {values.dims}")
    clock = pd.DatetimeIndex(values["local_time" if "local_time" in values.coords else "time"].values)
    # the wall clock skips and repeats an hour, time itself does not
    steps = np.diff(values["time"].values).astype("timedelta64[s]").astype(np.float64) / 60.0
    step = float(min(60.0, *steps)) if len(steps) else 60.0
    row = ((clock.hour * 60 + clock.minute) // step).astype(int).to_numpy()
    days = pd.date_range(clock.min().normalize(), clock.max().normalize(), freq="D")
    column = (clock.normalize() - days[0]).days.to_numpy()
    rows = int(np.ceil(24 * 60 / step))
    total, count = np.zeros((rows, len(days))), np.zeros((rows, len(days)))
    np.add.at(total, (row, column), values.values)
    np.add.at(count, (row, column), 1.0)
    cells = np.divide(total, count, out=np.full_like(total, np.nan), where=count > 0)
    edges = days.append(pd.DatetimeIndex([days[-1] + pd.Timedelta(days=1)]))
    return cells, np.asarray(edges.to_numpy()), np.asarray(np.arange(rows + 1) * step / 60.0)
