"""How long the sun's own light, straight or redirected, falls on people's eyes or desks."""

from __future__ import annotations

import xarray as xr

from clerestory.metrics.annual_sunlight_exposure import SUNLIT_LX
from clerestory.metrics.counted import counted_hours
from clerestory.rules import positive


def glare_prone_hours(
    sun_direct: xr.DataArray,
    sun_redirected: xr.DataArray,
    *,
    occupied: xr.DataArray,
    threshold_lx: float = SUNLIT_LX,
    interval_h: float = 1.0,
) -> xr.Dataset:
    r"""Hours of use in which the patch of the sun reaches the sensors, by a straight beam or a redirected one.

    Parameters
    ----------
    sun_direct, sun_redirected : DataArray, dims ("sensor", "time") [lx]
        Of the sun's specular paths alone, without and with a total reflection in the panel: parts of
        `annual_illuminance`. Sensors at the eyes (1.2 m, upright) judge glare; those of the work plane say where desks
        are sunlit.
    occupied : DataArray of bool, dims ("time",)
    threshold_lx : float, default 1000
        Both beams together at a sensor; exactly this counts.
    interval_h : float, default 1
        Length of an interval.

    Returns
    -------
    Dataset
        `glare_prone_hours`, dims ("sensor",) [h]; `by_direct` and `by_redirected`, those in which that beam alone is
        enough; `anywhere` and `anywhere_by_redirected`, without dimensions: hours in which it is so at one sensor or
        more.

    Raises
    ------
    ClerestoryError
        If no hour is occupied, or the times differ.

    Notes
    -----
    :math:`\Delta t \sum_{h \in H} [E^{direct}_{sh} + E^{redirected}_{sh} \ge E_{limit}]` (theory/metrics.md, eq. 13). A
    criterion of exposure, not of sensation: an eye in the patch of the sun sees the sun or its image, at 10⁶ cd/m² and
    more, in the panel. 1000 lx is that of direct sun in IES LM-83.
    """
    sunlit, length = positive("threshold_lx", threshold_lx), positive("interval_h", interval_h)
    straight = counted_hours(sun_direct, occupied, name="sun_direct")
    turned = counted_hours(sun_redirected, occupied, name="sun_redirected")
    both = straight + turned >= sunlit
    found = xr.Dataset(
        {
            "glare_prone_hours": both.sum("time") * length,
            "by_direct": (straight >= sunlit).sum("time") * length,
            "by_redirected": (turned >= sunlit).sum("time") * length,
            "anywhere": both.any("sensor").sum("time") * length,
            "anywhere_by_redirected": (turned >= sunlit).any("sensor").sum("time") * length,
        }
    )
    words = {
        "glare_prone_hours": "hours in the sun's patch",
        "by_direct": "hours in the direct sun's patch",
        "by_redirected": "hours in the redirected sun's patch",
        "anywhere": "hours with a sensor in the sun's patch",
        "anywhere_by_redirected": "hours with a sensor in the redirected sun's patch",
    }
    for name, long_name in words.items():
        found[name].attrs = {"units": "h", "long_name": f"{long_name}, {sunlit:g} lx"}
    return found
