"""How even the daylight of a room is through the year."""

from __future__ import annotations

import xarray as xr

from clerestory.illuminance import uniformity
from clerestory.metrics.counted import counted_hours


def annual_uniformity(illuminance: xr.DataArray, *, occupied: xr.DataArray) -> xr.DataArray:
    r"""Median over the occupied hours of the least illuminance over the mean.

    Parameters
    ----------
    illuminance : DataArray, dims ("sensor", "time") [lx]
    occupied : DataArray of bool, dims ("time",)

    Returns
    -------
    DataArray without dimensions, 0..1
        Of the hours with light; NaN if all are dark.

    Raises
    ------
    ClerestoryError
        If no hour is occupied, or the times differ.

    Notes
    -----
    :math:`\operatorname{median}_{h \in H} \min_s E_{sh} / \overline{E_h}` (theory/metrics.md, eq. 12; the ratio is
    theory/illuminance.md, eq. 5).
    """
    middle: xr.DataArray = uniformity(counted_hours(illuminance, occupied)).median("time")
    middle.attrs = {"units": "1", "long_name": "median uniformity, least over mean"}
    return middle.rename("annual_uniformity")
