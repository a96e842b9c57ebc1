"""How much of what is needed daylight gives, hour by hour."""

from __future__ import annotations

import xarray as xr

from clerestory.metrics.counted import counted_hours
from clerestory.rules import positive


def continuous_daylight_autonomy(
    illuminance: xr.DataArray, *, occupied: xr.DataArray, threshold_lx: float = 300.0
) -> xr.DataArray:
    r"""Mean share of a target illuminance that daylight gives in the occupied hours.

    Parameters
    ----------
    illuminance : DataArray, dims ("sensor", "time") [lx]
    occupied : DataArray of bool, dims ("time",)
    threshold_lx : float, default 300

    Returns
    -------
    DataArray, dims ("sensor",) [percent]
        An hour with half of the target counts for a half, one above it for 1.

    Raises
    ------
    ClerestoryError
        If no hour is occupied, or the times differ.

    Notes
    -----
    :math:`cDA = |H|^{-1} \sum_{h \in H} \min(E_h / E_{target}, 1)` (theory/metrics.md, eq. 2); Z. Rogers,
    *Daylighting Metric Development Using Daylight Autonomy Calculations*, Architectural Energy Corporation, 2006.
    """
    target = positive("threshold_lx", threshold_lx)
    share: xr.DataArray = 100.0 * (counted_hours(illuminance, occupied) / target).clip(max=1.0).mean("time")
    name = f"continuous daylight autonomy, {target:g} lx"
    share.attrs = {"units": "percent", "long_name": name, "threshold_lx": target}
    return share.rename("continuous_daylight_autonomy")
