"""How much light falls on a thing in a year."""

from __future__ import annotations

import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.rules import positive

LIMITS_LX_H = {"high": 15_000.0, "medium": 150_000.0, "low": 600_000.0}
"""Most annual exposure of museum objects by how they respond to light [lx h]: high such as silk and water colours,
medium such as most textiles and prints, low such as oil and tempera; stone and metal have no limit. CIE 157:2004."""


def annual_light_exposure(illuminance: xr.DataArray, *, interval_h: float = 1.0) -> xr.DataArray:
    r"""Illuminance added up over the year, all hours counting.

    Parameters
    ----------
    illuminance : DataArray, dims (…, "time") [lx]
        On the object's surface.
    interval_h : float, default 1
        Length of an interval.

    Returns
    -------
    DataArray without "time" [lx h]

    Raises
    ------
    ClerestoryError
        If a value is missing.

    Notes
    -----
    :math:`\sum_h E_h \Delta t` (theory/metrics.md, eq. 11); limits for museums in `LIMITS_LX_H` (CIE 157:2004).
    """
    if "time" not in illuminance.dims or bool(illuminance.isnull().any()):
        raise ClerestoryError("illuminance must have the dimension time and no value missing")
    exposure: xr.DataArray = illuminance.sum("time") * positive("interval_h", interval_h)
    exposure.attrs = {"units": "lx h", "long_name": "annual light exposure"}
    return exposure.rename("annual_light_exposure")
