"""The electricity that daylight saves where lamps dim with it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.metrics.counted import counted_hours
from clerestory.rules import not_negative, one_of, positive, within

ZONES = ("sensor", "row", "room")


@dataclass(frozen=True, kw_only=True)
class ElectricLighting:
    """Lamps that dim by what daylight leaves to be done.

    Parameters
    ----------
    power_density_w_m2 : float, default 6
        At full output, ballasts included.
    setpoint_lx : float, default 300
        That lamps and daylight keep together, and the lamps alone at full output.
    minimum_power_share, minimum_light_share : float, 0..1, default 0.3 and 0.2
        Where dimming ends: this share of the power gives this share of the light.
    switched_off : bool, default False
        Whether lamps go out when daylight is enough; otherwise they stay at the minimum.
    zone : "sensor", "row" or "room", default "row"
        What dims as one, by its darkest sensor: each sensor's own lamp, the rows of the grid, all of the room.

    Raises
    ------
    ClerestoryError
        If a value is out of range.
    """

    power_density_w_m2: float = 6.0
    setpoint_lx: float = 300.0
    minimum_power_share: float = 0.3
    minimum_light_share: float = 0.2
    switched_off: bool = False
    zone: str = "row"

    def __post_init__(self) -> None:
        not_negative("power_density_w_m2", self.power_density_w_m2)
        positive("setpoint_lx", self.setpoint_lx)
        within("minimum_power_share", self.minimum_power_share, 0.0, 1.0)
        if within("minimum_light_share", self.minimum_light_share, 0.0, 1.0) == 1.0:
            raise ClerestoryError("minimum_light_share must be less than 1, got 1")
        one_of("zone", self.zone, ZONES)


def lighting_energy(
    illuminance: xr.DataArray,
    *,
    occupied: xr.DataArray,
    lighting: ElectricLighting | None = None,
    interval_h: float = 1.0,
) -> xr.Dataset:
    r"""Electricity of dimmed lamps in a year, and what daylight saves of it.

    Parameters
    ----------
    illuminance : DataArray, dims ("sensor", "time") [lx]
        Of daylight on the work plane. Each sensor stands for the same area.
    occupied : DataArray of bool, dims ("time",)
        When the lamps are on.
    lighting : ElectricLighting, optional
    interval_h : float, default 1
        Length of an interval.

    Returns
    -------
    Dataset without dimensions
        `used`, `without_daylight` and `saved` [kWh/m²] of the times given, `saved_percent` [percent].

    Raises
    ------
    ClerestoryError
        If no hour is occupied, the times differ, or zones are rows of sensors that stand in none.

    Notes
    -----
    The light still needed is :math:`f_L = \max(0, 1 - E / E_{set})`, and its power (theory/metrics.md, eqs. 14-15)

    .. math:: f_P = f_{P,min} + (1 - f_{P,min}) \frac{f_L - f_{L,min}}{1 - f_{L,min}}, \quad f_L \ge f_{L,min}

    as continuous dimming is described in the EnergyPlus Engineering Reference, *Daylighting and Window Calculations*.
    """
    lamps = lighting or ElectricLighting()
    lit = _by_zone(counted_hours(illuminance, occupied), lamps.zone)
    needed = (1.0 - lit / lamps.setpoint_lx).clip(min=0.0)
    least_light, least_power = lamps.minimum_light_share, lamps.minimum_power_share
    share = least_power + (1.0 - least_power) * (needed - least_light).clip(min=0.0) / (1.0 - least_light)
    if lamps.switched_off:
        share = share.where(needed > 0.0, 0.0)
    full = lamps.power_density_w_m2 * positive("interval_h", interval_h) * lit.sizes["time"] / 1000.0
    used = full * float(share.mean())
    saved = {"used": used, "without_daylight": full, "saved": full - used}
    result = xr.Dataset({name: ((), value, {"units": "kWh/m2"}) for name, value in saved.items()})
    result["saved_percent"] = ((), 100.0 * (1.0 - float(share.mean())), {"units": "percent"})
    words = {
        "used": "electricity of dimmed lamps",
        "without_daylight": "electricity of lamps without daylight",
        "saved": "electricity saved by daylight",
        "saved_percent": "share of the lamps' electricity saved by daylight",
    }
    for name, long_name in words.items():
        result[name].attrs["long_name"] = long_name
    return result


def _by_zone(lit: xr.DataArray, zone: str) -> xr.DataArray:
    """The illuminance that each sensor's lamps dim by: of the darkest sensor of its zone."""
    if zone == "sensor":
        return lit
    if zone == "room":
        return lit.min("sensor").expand_dims("sensor")
    row = lit["row"].values if "row" in lit.coords else np.full(lit.sizes["sensor"], -1)
    if (row < 0).any():
        raise ClerestoryError('zone "row" must have sensors in rows of a grid, got some without; choose sensor or room')
    values = lit.transpose("sensor", "time").values
    darkest = {number: values[row == number].min(axis=0) for number in np.unique(row)}
    return lit.transpose("sensor", "time").copy(data=np.stack([darkest[number] for number in row]))
