"""The hours that a metric counts, checked once for all metrics."""

from __future__ import annotations

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError


def counted_hours(illuminance: xr.DataArray, occupied: xr.DataArray, *, name: str = "illuminance") -> xr.DataArray:
    """The illuminance in those hours that count.

    Parameters
    ----------
    illuminance : DataArray with the dimension "time" [lx]
    occupied : DataArray of bool, dims ("time",)
        Hours that count; the same times as ``illuminance``.
    name : str
        What the illuminance is called in messages.

    Returns
    -------
    DataArray, fewer times

    Raises
    ------
    ClerestoryError
        If no hour counts, the times differ, ``occupied`` is no yes or no, or a value is missing or negative.
    """
    if "time" not in illuminance.dims:
        raise ClerestoryError(f"{name} must have the dimension time, got {illuminance.dims}")
    if occupied.dims != ("time",) or occupied.dtype != np.bool_:
        raise ClerestoryError(f"occupied must be bool over time alone, got {occupied.dtype} over {occupied.dims}")
    if occupied.sizes["time"] != illuminance.sizes["time"]:
        raise ClerestoryError(
            f"occupied must have the {illuminance.sizes['time']} times of {name}, got {occupied.sizes['time']}"
        )
    if "time" in occupied.coords and "time" in illuminance.coords:
        differ = occupied["time"].values != illuminance["time"].values
        if differ.any():
            first = int(np.argmax(differ))
            raise ClerestoryError(
                f"occupied must have the times of {name}, got {occupied['time'].values[first]} for "
                f"{illuminance['time'].values[first]}"
            )
    if not bool(occupied.any()):
        raise ClerestoryError("occupied must hold at least one hour that counts, got none; widen the schedule")
    counted: xr.DataArray = illuminance.isel(time=np.flatnonzero(occupied.values))
    least = float(counted.min(skipna=False))
    if not least >= 0.0:
        problem = "a missing value" if np.isnan(least) else f"{least:g} lx"
        raise ClerestoryError(f"{name} must not be missing or negative in an hour that counts, got {problem}")
    return counted
