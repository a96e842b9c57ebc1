"""Shorter intervals with the same light."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pandas as pd

from clerestory.site import Site
from clerestory.sun import sun_position
from clerestory.weather.course import FOLLOWS_THE_SUN, course

Array = npt.NDArray[np.float64]

_MOST_W_M2 = 1415.0
"""Of the sun outside the atmosphere, on 3 January."""


def resampled_frame(frame: pd.DataFrame, site: Site, interval_minutes: float, parts: int) -> pd.DataFrame:
    """Each interval in so many equal parts.

    An irradiance over its course through a cloudless day (theory/weather.md, eq. 1) changes evenly between the
    middles of intervals (eq. 2) and is scaled so that each interval keeps its mean (eq. 3). Other columns change
    evenly.
    """
    offsets = ((np.arange(parts) + 0.5) / parts - 0.5) * interval_minutes
    seconds = np.round(offsets * 60.0).astype("timedelta64[s]")
    utc = frame.index.tz_convert("UTC").tz_localize(None).to_numpy().astype("datetime64[s]")
    index = (
        pd.DatetimeIndex((utc[:, None] + seconds).ravel()).as_unit("ns").tz_localize("UTC").tz_convert(frame.index.tz)
    )
    altitude = sun_position(site, index).apparent_altitude_deg.values.reshape(-1, parts)
    known = utc.astype(np.float64)
    wanted = (utc[:, None] + seconds).astype(np.float64)
    table = {}
    for column in frame.columns:
        values = frame[column].to_numpy(dtype=np.float64)
        if column in FOLLOWS_THE_SUN:
            table[column] = _follow(values, course(column, altitude), known, wanted).ravel()
        else:
            table[column] = np.interp(wanted, known, values).ravel()
    return pd.DataFrame(table, index=index)


def _follow(values: Array, shape: Array, known: Array, wanted: Array) -> Array:
    """Values of each part; ``shape`` and ``wanted`` are (interval, part)."""
    mean = shape.mean(axis=1)
    lit = mean > 0.0
    if not lit.any():
        return np.repeat(values[:, None], shape.shape[1], axis=1)
    share = np.interp(wanted, known[lit], values[lit] / mean[lit])
    found = share * shape
    middle = found.mean(axis=1)
    # light before the sun is up, or next to nothing on either side: evenly
    even = middle <= 1e-9 * np.maximum(values, 1e-9)
    scaled = found * np.divide(values, middle, out=np.zeros_like(values), where=~even)[:, None]
    # more than the sun can give: the record's sunrise is not the sun's
    even |= scaled.max(axis=1) > _MOST_W_M2
    return np.where(even[:, None], values[:, None], scaled)
