"""The hours that count as daylit, by their diffuse daylight."""

from __future__ import annotations

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError


def daylit_hours(diffuse_horizontal: xr.DataArray) -> xr.DataArray:
    """The half of the year with the most diffuse daylight outside.

    Parameters
    ----------
    diffuse_horizontal : DataArray, dims ("time",) [lx or W/m²]
        Of every interval of whole years, nights included.

    Returns
    -------
    DataArray of bool, dims ("time",)
        4380 of 8760 hours. Of equally bright ones the earlier count first; dark ones never do, so that near the poles
        it can be fewer.

    Raises
    ------
    ClerestoryError
        If a value is missing or all is dark.

    Notes
    -----
    EN 17037:2018, annex A, reckons daylight over these 4380 hours (theory/metrics.md, eq. 8).
    """
    values = diffuse_horizontal.values
    if diffuse_horizontal.dims != ("time",) or not np.isfinite(values).all():
        raise ClerestoryError(
            f"diffuse_horizontal must be finite over time alone, got {int((~np.isfinite(values)).sum())} missing "
            f"over {diffuse_horizontal.dims}"
        )
    brightest = np.argsort(-values, kind="stable")[: (len(values) + 1) // 2]
    daylit = np.zeros(len(values), dtype=bool)
    daylit[brightest] = values[brightest] > 0.0
    if not daylit.any():
        raise ClerestoryError("diffuse_horizontal must be more than 0 at some time, got a dark year")
    return xr.DataArray(
        daylit, dims="time", coords=diffuse_horizontal.coords, attrs={"long_name": "the brighter half of the year"}
    )
