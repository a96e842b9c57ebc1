"""How much of a room has the sun in it for too long."""

from __future__ import annotations

import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.metrics.counted import counted_hours
from clerestory.rules import not_negative, positive

SUNLIT_LX = 1000.0
"""Direct sun at which a sensor counts as sunlit [lx]; IES LM-83-12, 2.2.6 and 3.4."""


def annual_sunlight_exposure(
    sun_direct: xr.DataArray,
    *,
    occupied: xr.DataArray,
    threshold_lx: float = SUNLIT_LX,
    limit_h: float = 250.0,
    interval_h: float = 1.0,
) -> xr.DataArray:
    r"""Share of the sensors that have direct sun for more than so many hours of the year.

    Parameters
    ----------
    sun_direct : DataArray, dims ("sensor", "time") [lx]
        Of the sun's beam alone, with no diffuse reflection, blinds open: `annual_illuminance(…).sun_direct`.
    occupied : DataArray of bool, dims ("time",)
        For IES LM-83 the `ANALYSIS_HOURS` on the clock of the place.
    threshold_lx : float, default 1000
        An hour at exactly the threshold counts.
    limit_h : float, default 250
        A sensor with exactly so many hours is not exposed yet.
    interval_h : float, default 1
        Length of an interval.

    Returns
    -------
    DataArray without dimensions [percent]
        ASE1000/250h by default.

    Raises
    ------
    ClerestoryError
        If no hour is occupied, or the times differ.

    Notes
    -----
    :math:`ASE = N^{-1} \sum_s [\,\Delta t \sum_{h \in H} [E^{sun}_{sh} \ge 1000\,lx] > 250\,h\,]` (theory/metrics.md,
    eq. 5); IES LM-83-12 and LM-83-23.
    """
    hours = sunlit_hours(sun_direct, occupied=occupied, threshold_lx=threshold_lx, interval_h=interval_h)
    limit = not_negative("limit_h", limit_h)
    result: xr.DataArray = 100.0 * (hours > limit + 1e-9).mean("sensor")
    result.attrs = {"units": "percent", "long_name": f"ASE, {threshold_lx:g} lx for more than {limit:g} h"}
    return result.rename("annual_sunlight_exposure")


def sunlit_hours(
    sun_direct: xr.DataArray, *, occupied: xr.DataArray, threshold_lx: float = SUNLIT_LX, interval_h: float = 1.0
) -> xr.DataArray:
    """Hours in which each sensor has direct sun, dims ("sensor",) [h]; as in `annual_sunlight_exposure`."""
    sunlit = positive("threshold_lx", threshold_lx)
    length = positive("interval_h", interval_h)
    if "sensor" not in sun_direct.dims:
        raise ClerestoryError(f"sun_direct must have the dimension sensor, got {sun_direct.dims}")
    hours: xr.DataArray = (counted_hours(sun_direct, occupied, name="sun_direct") >= sunlit).sum("time") * length
    hours.attrs = {"units": "h", "long_name": f"hours with direct sun of {sunlit:g} lx"}
    return hours.rename("sunlit_hours")
