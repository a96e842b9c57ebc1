"""Values on a grid of sensors as a false-colour plan with contour lines and numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from clerestory.errors import ClerestoryError
from clerestory.plots.style import INK, blank, styled
from clerestory.room.scene import Room

Array = npt.NDArray[np.float64]

WIDE = 20.0
"""Values that span more than this to 1 have a logarithmic scale and contour lines at 1, 2, 5, 10 …"""

MOST_NUMBERS = 260
"""A grid of more sensors is drawn without numbers."""


@dataclass(frozen=True)
class GridFrame:
    """A grid's own axes in the world: where it begins and which way its columns and rows run."""

    origin: Array
    across: Array
    along: Array

    def place(self, points: Any) -> Array:
        """Points of the world in the grid's plane, shape (n, 2) [m]."""
        offset = np.asarray(points, dtype=np.float64) - self.origin
        return np.stack([offset @ self.across, offset @ self.along], axis=-1)


def grid_frame(values: xr.DataArray, room: Room | None = None) -> GridFrame:
    """The axes of a grid of sensors, from the corner of the surface it lies on if the room is known.

    Raises
    ------
    ClerestoryError
        If the sensors are no grid, or of several.
    """
    groups = np.unique(values["group"])
    if len(groups) != 1 or (values["row"] < 0).any():
        raise ClerestoryError(
            f"values must be of one grid of sensors, got {', '.join(map(str, groups))}; "
            'choose one with values.where(values.group == "floor", drop=True)'
        )
    points = np.stack([values[f"{axis}_m"].values for axis in "xyz"], axis=1)
    row, column = values["row"].values, values["column"].values
    ones = np.ones(len(points))
    step = np.linalg.lstsq(np.stack([column, row, ones], axis=1), points, rcond=None)[0]
    across, along = _unit(step[0]), _unit(step[1])
    if not across.any() or not along.any():
        raise ClerestoryError("values must be of a grid of at least 2 by 2 sensors, got one row or column")
    origin = step[2] - (step[0] + step[1]) / 2.0
    surfaces = () if room is None else room.surfaces
    named = next((surface for surface in surfaces if surface.name == groups[0]), None)
    if named is not None:
        origin = np.array(named.outline_m[0])
    return GridFrame(origin, across, along)


def room_plan(
    values: xr.DataArray,
    *,
    room: Room | None = None,
    levels: npt.ArrayLike | None = None,
    title: str | None = None,
) -> Figure:
    """False-colour plan of a grid of sensors, with contour lines and the number at each sensor.

    Parameters
    ----------
    values : DataArray, dims ("sensor",)
        Of one grid, such as `daylight_factor(...).total`.
    room : Room, optional
        Draws its windows, and counts lengths from the corner of the floor.
    levels : array_like, optional
        Of the contour lines; default round numbers, marked on the colour bar where the scale is logarithmic.
    title : str, optional

    Returns
    -------
    Figure
        Distances in metres in the grid's own axes: a facade along its columns lies at the bottom.

    Raises
    ------
    ClerestoryError
        If the values are not those of one grid.
    """
    if values.dims != ("sensor",):
        raise ClerestoryError(f"values must have the dimension sensor alone, got {values.dims}; choose of the others")
    frame = grid_frame(values, room)
    place = frame.place(np.stack([values[f"{axis}_m"].values for axis in "xyz"], axis=1))
    width, height = np.ptp(place[:, 0]), np.ptp(place[:, 1])
    with styled():
        figure = blank(min(2.6 + 4.6 * (width + 0.5) / (height + 0.5), 9.0), 6.4 if height >= width else 4.4)
        axes = figure.add_subplot()
        most, positive = float(values.max()), values.values[values.values > 0.0]
        wide = len(positive) > 0 and most / float(positive.min()) > WIDE
        norm = LogNorm(float(positive.min()), most) if wide else Normalize(0.0, most or 1.0)
        lines = _one_two_five(float(positive.min()), most) if wide and levels is None else levels
        mesh = draw_grid(axes, values, frame, levels=lines, norm=norm)
        if room is not None:
            draw_windows(axes, room, frame)
        bar = figure.colorbar(mesh, ax=axes, shrink=0.85, aspect=30)
        if wide:
            bar.set_ticks([float(level) for level in np.asarray(lines)])
            bar.ax.minorticks_off()
        bar.ax.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")
        long_name, units = quantity(values)
        bar.set_label(f"{long_name} [{units}]")
        bar.outline.set_visible(False)
        axes.set(xlabel="Across the room [m]", ylabel="Into the room [m]")
        axes.set_title(title or long_name)
    return figure


def draw_grid(
    axes: Axes,
    values: xr.DataArray,
    frame: GridFrame,
    *,
    levels: npt.ArrayLike | None = None,
    norm: Normalize | None = None,
    numbers: bool = True,
    contours: bool = True,
    digits: int | None = None,
) -> Any:
    """Cells, contour lines and numbers of one grid; returns the cells, for a colour bar."""
    place = frame.place(np.stack([values[f"{axis}_m"].values for axis in "xyz"], axis=1))
    row, column = values["row"].values, values["column"].values
    shape = (int(row.max()) + 1, int(column.max()) + 1)
    across, along, cells = (np.full(shape, np.nan) for _ in range(3))
    across[row, column], along[row, column], cells[row, column] = place[:, 0], place[:, 1], values.values
    x, y = np.nanmean(across, axis=0), np.nanmean(along, axis=1)
    shown = np.ma.masked_invalid(cells)
    mesh = axes.pcolormesh(x, y, shown, shading="nearest", cmap="viridis", norm=norm, rasterized=True)
    numbers = numbers and values.size <= MOST_NUMBERS
    if contours and min(shape) > 1 and float(shown.max()) > float(shown.min()):
        lines = axes.contour(x, y, shown, levels=levels, colors="white", linewidths=0.9, alpha=0.9)
        if not numbers:
            axes.clabel(lines, fmt="%g", fontsize=8)
    if numbers:
        digits = _digits(float(np.nanmax(np.abs(cells)))) if digits is None else digits
        for (u, v), value in zip(place, values.values, strict=True):
            text = axes.text(u, v, f"{value:.{digits}f}", ha="center", va="center", fontsize=6.5, color="white")
            text.set_path_effects([withStroke(linewidth=1.6, foreground=INK)])
    axes.set_aspect("equal")
    axes.grid(False)
    return mesh


def draw_windows(axes: Axes, room: Room, frame: GridFrame) -> None:
    """Where the windows are, as seen from above: a thick line for a wall's, an outline for the roof's."""
    for index, window in enumerate(room.windows):
        corners = frame.place(np.array(window.outline_m))
        closed = np.vstack([corners, corners[:1]])
        axes.plot(
            closed[:, 0],
            closed[:, 1],
            color="#56B4E9",
            linewidth=4.0,
            solid_capstyle="butt",
            clip_on=False,
            label="window" if index == 0 else None,
        )


def quantity(values: xr.DataArray) -> tuple[str, str]:
    """What values are called in a figure, and their unit."""
    units = str(values.attrs.get("units", ""))
    name = str(values.attrs.get("long_name", values.name or "")).removesuffix(", total")
    return name[:1].upper() + name[1:], {"percent": "%", "1": "–"}.get(units, units)


def _one_two_five(low: float, high: float) -> list[float]:
    """Round numbers between two, in the steps 1, 2, 5, 10 …"""
    decades = range(int(np.floor(np.log10(low))), int(np.ceil(np.log10(high))) + 1)
    return [step * 10.0**decade for decade in decades for step in (1, 2, 5) if low <= step * 10.0**decade <= high]


def _digits(largest: float) -> int:
    """Decimals that leave two or three digits of the largest value."""
    return int(np.clip(2 - np.floor(np.log10(largest)), 0, 3)) if largest > 0.0 else 0


def _unit(vector: Array) -> Array:
    length = float(np.linalg.norm(vector))
    return vector / length if length > 1e-9 else np.zeros(3)
