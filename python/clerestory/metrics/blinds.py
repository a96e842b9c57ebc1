"""Blinds that people close against the sun, group of windows by group."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.metrics.annual_sunlight_exposure import SUNLIT_LX
from clerestory.rules import positive, within

WHITE_LOUVRES = 0.2
"""Diffuse transmittance of closed white louvres (reflectance above 80 %) where no better is known; IES LM-83-12, 2.2.7.
It gives 0.05 for a fabric of which nothing is known."""


def blinds_closed(
    sun_direct: xr.DataArray, *, threshold_lx: float = SUNLIT_LX, sensors_percent: float = 2.0
) -> xr.DataArray:
    r"""When the blinds of a group of windows are closed: as long as the sun would reach too much of the room.

    Parameters
    ----------
    sun_direct : DataArray, dims ("sensor", "time") [lx]
        Of the sun's beam through the windows of this group alone, blinds open, no diffuse reflection.
    threshold_lx : float, default 1000
        A sensor with this much of the sun or more is sunlit.
    sensors_percent : float, 0..100, default 2
        More sunlit sensors than this close the blinds.

    Returns
    -------
    DataArray of bool, dims ("time",)

    Notes
    -----
    :math:`B_h = [\,N^{-1} \sum_s [E^{sun}_{sh} \ge 1000\,lx] > 2\,\%\,]` (theory/metrics.md, eq. 6); IES LM-83-12,
    2.2.6, where each group of windows is judged and closed by itself, hour by hour, at any time of the day.
    """
    sunlit = positive("threshold_lx", threshold_lx)
    limit = within("sensors_percent", sensors_percent, 0.0, 100.0)
    share = 100.0 * (sun_direct >= sunlit).mean("sensor")
    closed: xr.DataArray = share > limit + 1e-9
    closed.attrs = {"long_name": "blinds closed", "threshold_lx": sunlit, "sensors_percent": limit}
    return closed.rename("blinds_closed")


def with_blinds(
    groups: Mapping[str, xr.Dataset],
    *,
    transmittance: Mapping[str, float | None] | float = WHITE_LOUVRES,
    threshold_lx: float = SUNLIT_LX,
    sensors_percent: float = 2.0,
) -> xr.Dataset:
    r"""Illuminance with each group of windows behind blinds while its sun is in the room.

    Parameters
    ----------
    groups : mapping of group → Dataset of `annual_illuminance`
        What enters through the windows of that group alone.
    transmittance : float or mapping of group → float, 0..1, default 0.2
        Of the closed blinds, for diffuse light. None for a group without blinds.
    threshold_lx, sensors_percent
        As in `blinds_closed`.

    Returns
    -------
    Dataset
        `total` and `sun_direct`, dims ("sensor", "time") [lx], all groups together; `blinds_closed`, dims
        ("window_group", "time"), only of the groups that have blinds.

    Raises
    ------
    ClerestoryError
        If there is no group, one is unknown, or a transmittance is out of range.

    Notes
    -----
    Closed blinds let no beam of the sun through, and this share of the light from sky, ground and reflections
    (theory/metrics.md, eq. 7): the simple blind, with which the sun that the slats scatter into the room is left out.
    """
    if not groups:
        raise ClerestoryError("groups must hold at least one group of windows, got none")
    through: dict[str, float | None]
    through = dict(transmittance) if isinstance(transmittance, Mapping) else dict.fromkeys(groups, transmittance)
    for name in through:
        if name not in groups:
            raise ClerestoryError(f"transmittance must name groups ({', '.join(groups)}), got {name!r}")
    total, beam, closed = [], [], {}
    for name, lit in groups.items():
        share = through.get(name)
        if share is None:
            total.append(lit["total"])
            beam.append(lit["sun_direct"])
            continue
        within(f"transmittance of the blinds of {name!r}", share, 0.0, 1.0)
        shut = blinds_closed(lit["sun_direct"], threshold_lx=threshold_lx, sensors_percent=sensors_percent)
        closed[name] = shut
        diffuse = lit["total"] - lit["sun_direct"] - lit["sun_redirected"]
        total.append(lit["total"].where(~shut, share * diffuse))
        beam.append(lit["sun_direct"].where(~shut, 0.0))
    result = xr.Dataset({"total": sum(total), "sun_direct": sum(beam)}).transpose("sensor", "time")
    for name, what in (("total", "with blinds"), ("sun_direct", "direct sun, with blinds")):
        result[name].attrs = {"units": "lx", "long_name": f"illuminance, {what}"}
    states = [state.reset_coords(drop=True) for state in closed.values()]
    if states:
        result["blinds_closed"] = xr.concat(states, dim=xr.Variable("window_group", np.array(list(closed))))
        result["blinds_closed"].attrs = {"long_name": "blinds closed"}
    return result
