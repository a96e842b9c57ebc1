"""A year of weather as carpets: a column a day, a row an hour."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pandas as pd
from matplotlib.figure import Figure

from clerestory.errors import ClerestoryError
from clerestory.plots.style import FAINT, blank, heading, styled
from clerestory.weather.columns import DIFFUSE, DIRECT, LONG_NAMES
from clerestory.weather.weather import Weather

Array = npt.NDArray[np.float64]


def weather_carpet(weather: Weather, *, columns: tuple[str, ...] = (DIRECT, DIFFUSE)) -> Figure:
    """Irradiances through the days and hours of a year, with sunrise and sunset.

    Parameters
    ----------
    weather : Weather
    columns : tuple of str
        Columns of its table, one carpet each; default direct normal and diffuse horizontal irradiance.

    Returns
    -------
    Figure
        The hours are those of the site's clock; intervals that it does not have stay white.

    Raises
    ------
    ClerestoryError
        If the weather has no such column.
    """
    for column in columns:
        if column not in weather.frame:
            raise ClerestoryError(f"columns must be among {sorted(weather.frame.columns)}, got {column!r}")
    local = weather.times.tz_localize(None)
    days = pd.date_range(local[0].normalize(), local[-1].normalize(), freq="D")
    rows = round(24.0 * 60.0 / weather.interval_minutes)
    day = (local.normalize() - days[0]).days.to_numpy()
    row = ((local - local.normalize()) / pd.Timedelta(minutes=weather.interval_minutes)).to_numpy().astype(int)

    def carpet(values: Array) -> Array:
        table = np.full((rows, len(days)), np.nan)
        table[np.minimum(row, rows - 1), day] = values
        return table

    hours = (np.arange(rows) + 0.5) * weather.interval_minutes / 60.0
    altitude = carpet(weather.sun.apparent_altitude_deg.values)
    whole = np.isfinite(altitude).all(axis=0).all() and len(days) > 2
    with styled():
        figure = blank(9.0, 0.8 + 2.6 * len(columns))
        heading(figure, weather.source)
        for axes, column in zip(np.atleast_1d(figure.subplots(len(columns), sharex=True)), columns, strict=True):
            values = carpet(weather.frame[column].to_numpy(dtype=np.float64))
            mesh = axes.pcolormesh(
                np.arange(len(days) + 1), np.linspace(0.0, 24.0, rows + 1), values, cmap="inferno", rasterized=True
            )
            if whole:
                axes.contour(np.arange(len(days)) + 0.5, hours, altitude, [0.0], colors="white", linewidths=0.8)
            axes.set(ylim=(0, 24), yticks=[0, 6, 12, 18, 24], ylabel="Hour")
            axes.grid(visible=False)
            name = LONG_NAMES.get(column, column)
            axes.set_title(name[0].upper() + name[1:])
            bar = figure.colorbar(mesh, ax=axes, pad=0.01, aspect=14)
            bar.set_label("°C" if column.endswith("_c") else "W/m²")
            bar.outline.set_visible(False)
        starts = days[days.day == 1] if len(days) > 45 else days
        axes.set_xticks([(start - days[0]).days for start in starts])
        axes.set_xticklabels([f"{start:%b}" if len(days) > 45 else f"{start.day} {start:%b}" for start in starts])
        axes.set_xlabel(
            f"{len(days)} days, clock of {weather.site.timezone}; white line: the sun on the horizon", color=FAINT
        )
    return figure
