"""How often daylight alone is enough."""

from __future__ import annotations

import xarray as xr

from clerestory.metrics.counted import counted_hours
from clerestory.rules import positive


def daylight_autonomy(
    illuminance: xr.DataArray, *, occupied: xr.DataArray, threshold_lx: float = 300.0
) -> xr.DataArray:
    r"""Share of occupied hours in which daylight alone reaches a target illuminance.

    Parameters
    ----------
    illuminance : DataArray, dims ("sensor", "time") [lx]
        Every hour of the year, nights included.
    occupied : DataArray of bool, dims ("time",)
        Hours that count; the same times as ``illuminance``.
    threshold_lx : float, default 300
        An hour at exactly the target counts.

    Returns
    -------
    DataArray, dims ("sensor",) [percent]

    Raises
    ------
    ClerestoryError
        If no hour is occupied, or the times differ.

    Notes
    -----
    :math:`DA = |H|^{-1} \sum_{h \in H} [E_h \ge E_{target}]` (theory/metrics.md, eq. 1).
    C. F. Reinhart, J. Mardaljevic, Z. Rogers, LEUKOS 3(1), 2006.
    """
    target = positive("threshold_lx", threshold_lx)
    share: xr.DataArray = 100.0 * (counted_hours(illuminance, occupied) >= target).mean("time")
    share.attrs = {"units": "percent", "long_name": f"daylight autonomy, {target:g} lx", "threshold_lx": target}
    return share.rename("daylight_autonomy")
