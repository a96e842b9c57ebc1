"""What the page draws of a panel: its section with the beams, its lobes and shares, its tables."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from clerestory.panels.angular import LONG_NAMES
from clerestory.panels.section_beams import section_beams
from clerestory.plots.section_outline import outline

if TYPE_CHECKING:
    import xarray as xr

    from clerestory.panels import Panel

#: Digits behind the point of lengths that are only drawn [mm].
_DIGITS = 4


def section_of(panel: Panel, *, elevation_deg: Any, azimuth_deg: Any, wavelength_nm: Any = None) -> dict[str, Any]:
    """The section and the strips of light in it.

    Returns
    -------
    dict
        ``pitch_mm``, ``front_mm``, ``back_mm``; ``low_mm``, ``high_mm`` between which ``solids``, ``films`` and
        ``surfaces`` are (lists of points z, y); ``strips`` with ``corners``, ``power``, ``total_reflections`` and
        whether each ``leaves`` the panel; the first is the light that arrives.
    """
    beams = section_beams(
        panel, elevation_deg=elevation_deg, azimuth_deg=azimuth_deg, wavelength_nm=wavelength_nm, least_power=0.005
    )
    profile = panel.native_profile
    front, back = profile.depth_range_mm
    pitch, depth = profile.pitch_mm, back - front
    corners, power = beams["corners"].values, beams["power"].values
    # the light wanders up or down within: entry and exits stay in the picture
    inside = corners[power >= 0.05][1:, :2].reshape(-1, 2)
    middle = 0.5 * float(inside[:, 1].min() + inside[:, 1].max()) if len(inside) else 0.5 * pitch
    height = max(2.4 * depth, 3.0 * pitch, 1.5 * float(np.ptp(inside[:, 1])) if len(inside) else 0.0)
    low, high = middle - 0.5 * height, middle + 0.5 * height
    shape = outline(profile, low, high)
    slack = 1e-9 * depth
    ends = corners[:, 2:, 0]
    leaves = ((ends > back + slack) | (ends < front - slack)).all(axis=1) & (np.arange(len(ends)) > 0)
    return {
        "pitch_mm": pitch,
        "front_mm": front,
        "back_mm": back,
        "low_mm": low,
        "high_mm": high,
        "solids": [np.round(one, _DIGITS) for one in shape.solids],
        "films": [np.round(one, _DIGITS) for one in shape.films],
        "surfaces": [np.round(one, _DIGITS) for one in shape.surfaces],
        "strips": [
            {"corners": np.round(c, _DIGITS), "power": p, "total_reflections": n, "leaves": out}
            for c, p, n, out in zip(corners, power, beams["total_reflections"].values, leaves, strict=True)
        ],
    }


def lobes_of(panel: Panel, **incidence: Any) -> dict[str, Any]:
    """The beams that leave and how the light divides.

    Returns
    -------
    dict
        ``lobes``: list of ``power``, ``side``, ``elevation_deg``, ``azimuth_deg``, ``total_reflections`` and
        ``direction``; ``shares``: those of :meth:`Panel.angular`, of the same beams.
    """
    found = panel.lobes(**incidence)
    power, y = found["power"].values, found["direction"].values[:, 1]
    through = found["side"].values == ("back" if found.attrs["side"] == "front" else "front")
    # its vertical sense reversed; light that came in level has none to reverse
    turned = through & (y * -np.sin(np.radians(found.attrs["elevation_deg"])) < -1e-15)
    transmittance, deflected = float(power[through].sum()), float(power[turned].sum())
    names = ("power", "side", "elevation_deg", "azimuth_deg", "total_reflections", "direction")
    columns = [found[name].values.tolist() for name in names]
    return {
        "lobes": [dict(zip(names, row, strict=True)) for row in zip(*columns, strict=True)],
        "shares": {
            "transmittance": transmittance,
            "reflectance": float(power[~through].sum()),
            "absorptance": found.attrs["absorbed"],
            "transmittance_deflected": deflected,
            "transmittance_undeflected": transmittance - deflected,
            "residual": found.attrs["residual"],
        },
    }


def rows_of(table: xr.Dataset) -> dict[str, Any]:
    """A table of :meth:`Panel.angular` over elevation alone, as lists."""
    plain = table.squeeze([name for name in table.dims if name != "elevation"], drop=True)
    names = [name for name in LONG_NAMES if name in plain]
    return {"elevation_deg": plain["elevation"].values, **{name: plain[name].values for name in names}}
