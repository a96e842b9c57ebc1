"""How much of a room has enough daylight often enough."""

from __future__ import annotations

import xarray as xr

from clerestory.metrics.daylight_autonomy import daylight_autonomy
from clerestory.rules import within


def spatial_daylight_autonomy(
    illuminance: xr.DataArray,
    *,
    occupied: xr.DataArray,
    threshold_lx: float = 300.0,
    hours_percent: float = 50.0,
) -> xr.DataArray:
    r"""Share of the sensors that daylight alone lights to a target in so many of the hours.

    Parameters
    ----------
    illuminance : DataArray, dims ("sensor", "time") [lx]
        With the blinds as people would have them: `with_blinds`. Each sensor stands for the same area.
    occupied : DataArray of bool, dims ("time",)
        For IES LM-83 the `ANALYSIS_HOURS` on the clock of the place.
    threshold_lx : float, default 300
    hours_percent : float, 0..100, default 50
        A sensor with exactly this daylight autonomy counts.

    Returns
    -------
    DataArray without dimensions [percent]
        sDA300/50 % by default.

    Raises
    ------
    ClerestoryError
        If no hour is occupied, or the times differ.

    Notes
    -----
    :math:`sDA = N^{-1} \sum_s [DA_s \ge p]` (theory/metrics.md, eq. 4); IES LM-83-12 and LM-83-23.
    """
    share = within("hours_percent", hours_percent, 0.0, 100.0)
    # a hair for the rounding of a share such as 3/7
    enough = daylight_autonomy(illuminance, occupied=occupied, threshold_lx=threshold_lx) >= share - 1e-9
    result: xr.DataArray = 100.0 * enough.mean("sensor")
    result.attrs = {"units": "percent", "long_name": f"sDA, {threshold_lx:g} lx in {share:g} % of the hours"}
    return result.rename("spatial_daylight_autonomy")
