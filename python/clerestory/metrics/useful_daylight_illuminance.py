"""How often daylight is too little, of help, enough, or too much."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.metrics.counted import counted_hours
from clerestory.rules import positive

BANDS = ("fell-short", "supplementary", "autonomous", "exceeded")


def useful_daylight_illuminance(
    illuminance: xr.DataArray,
    *,
    occupied: xr.DataArray,
    limits_lx: Sequence[float] = (100.0, 300.0, 3000.0),
) -> xr.DataArray:
    r"""Shares of the occupied hours in four bands of illuminance.

    Parameters
    ----------
    illuminance : DataArray, dims ("sensor", "time") [lx]
    occupied : DataArray of bool, dims ("time",)
    limits_lx : three floats, rising, default (100, 300, 3000)

    Returns
    -------
    DataArray, dims ("band", "sensor") [percent]
        `band`: ``"fell-short"`` below the first limit, ``"supplementary"`` from it to below the second,
        ``"autonomous"`` from that up to the third, ``"exceeded"`` beyond. The four are 100 % together.

    Raises
    ------
    ClerestoryError
        If the limits do not rise, no hour is occupied, or the times differ.

    Notes
    -----
    theory/metrics.md, eq. 3; A. Nabil, J. Mardaljevic, Lighting Research & Technology 37(1), 2005, with the four bands
    of J. Mardaljevic, M. Andersen, N. Roy, J. Christoffersen, Proc. BS2012, 189–196.
    """
    limits = [positive("limits_lx", limit) for limit in limits_lx]
    if len(limits) != 3 or not limits[0] < limits[1] < limits[2]:
        raise ClerestoryError(f"limits_lx must be three rising illuminances, got {list(limits_lx)}")
    low, target, high = limits
    lit = counted_hours(illuminance, occupied)
    within = [lit < low, (lit >= low) & (lit < target), (lit >= target) & (lit <= high), lit > high]
    share: xr.DataArray = 100.0 * xr.concat([one.mean("time") for one in within], dim="band")
    share = share.assign_coords(band=np.array(BANDS))
    name = f"useful daylight illuminance, {low:g}/{target:g}/{high:g} lx"
    share.attrs = {"units": "percent", "long_name": name, "limits_lx": limits}
    return share.rename("useful_daylight_illuminance")
