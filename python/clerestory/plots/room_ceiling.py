"""Where the redirected sun lands on the ceiling."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from clerestory.errors import ClerestoryError
from clerestory.plots.room_plan import draw_grid, draw_windows, grid_frame
from clerestory.plots.style import blank, heading, styled
from clerestory.room.scene import Room

MOST_SUNS = 6


def room_ceiling(
    values: xr.DataArray,
    *,
    room: Room | None = None,
    labels: list[str] | None = None,
    title: str = "Redirected sun on the ceiling",
) -> Figure:
    """Plans of the ceiling side by side, one a sun, to one scale.

    Parameters
    ----------
    values : DataArray, dims ("sensor",) or ("sensor", "sun")
        Of a grid on the ceiling, such as `sun_illuminance(...).redirected`; at most 6 suns.
    room : Room, optional
        Draws its windows.
    labels : list of str, optional
        One a sun; default its altitude and azimuth.
    title : str

    Returns
    -------
    Figure
        Seen from above, as a plan.

    Raises
    ------
    ClerestoryError
        If there are more suns than can be drawn, or the values are not those of one grid.
    """
    several = values if "sun" in values.dims else values.expand_dims("sun", axis=-1)
    if several.sizes["sun"] > MOST_SUNS:
        raise ClerestoryError(f"values must have at most {MOST_SUNS} suns, got {several.sizes['sun']}; choose some")
    frame = grid_frame(several, room)
    most = float(several.max())
    norm = Normalize(0.0, most if most > 0.0 else 1.0)
    with styled():
        figure = blank(1.6 + 2.3 * several.sizes["sun"], 5.6)
        row = figure.subplots(1, several.sizes["sun"], squeeze=False, sharey=True)[0]
        for index, axes in enumerate(row):
            one = several.isel(sun=index)
            mesh = draw_grid(axes, one, frame, norm=norm, numbers=False, contours=False)
            if room is not None:
                draw_windows(axes, room, frame)
            axes.set_xlabel("Across [m]")
            axes.set_title(labels[index] if labels else _label(one), fontsize=9.5)
        row[0].set_ylabel("Into the room [m]")
        bar = figure.colorbar(mesh, ax=list(row), shrink=0.85, aspect=30)
        bar.ax.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")
        bar.set_label(f"Illuminance [{several.attrs.get('units', 'lx')}]")
        bar.outline.set_visible(False)
        heading(figure, title)
    return figure


def _label(one: xr.DataArray) -> str:
    if "sun_altitude_deg" not in one.coords:
        return ""
    altitude, azimuth = float(one["sun_altitude_deg"]), float(one["sun_azimuth_deg"])
    return f"sun {altitude:.0f}° high, {np.mod(azimuth, 360.0):.0f}° azimuth"
