"""The way of the sun as the page draws it."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import xarray as xr

from clerestory.room.scene import Room
from clerestory.studio.room_numbers import whole
from clerestory.sun import direction_of
from clerestory.sun_coefficients import SunWarning
from clerestory.sun_paths import sun_paths

#: Digits of places: a tenth of a millimetre; and of shares.
_DIGITS, _SHARE_DIGITS = 4, 5
#: Points of a window from which paths begin.
_POINTS, _MOST_POINTS = 12, 400


def paths_of(room: Room, *, altitude_deg: float, azimuth_deg: float, density: Any) -> dict[str, Any]:
    """Paths, beams and sunlit patches of one sun; none while it is below the horizon."""
    points = _POINTS if density is None else whole("density", density, 1, _MOST_POINTS)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always", SunWarning)
        found = sun_paths(room, altitude_deg=altitude_deg, azimuth_deg=azimuth_deg, points=points)
    names = [str(name) for name in found["window"].values]
    return {
        "altitude_deg": altitude_deg,
        "azimuth_deg": azimuth_deg,
        "direction": direction_of(altitude_deg, azimuth_deg),
        "is_up": altitude_deg > 0.0,
        "windows": [
            {
                "name": name,
                "cos_incidence": float(found["cos_incidence"][k]),
                "sunlit_share": float(found["sunlit_share"][k]),
                "blocked_by": found["blocked_by"].values[k] or None,
                "entering": float(found["entering"][k]),
            }
            for k, name in enumerate(names)
        ],
        "paths": _paths(found),
        "beams": _beams(found),
        "patches": _patches(found),
        "warnings": [str(one.message) for one in told if issubclass(one.category, SunWarning)],
    }


def _paths(found: xr.Dataset) -> list[dict[str, Any]]:
    position, power = found["position_m"].values.round(_DIGITS), found["power"].values.round(_SHARE_DIGITS)
    window, kind = found["path_window"].values, found["path_kind"].values
    event, surface = found["event"].values, found["surface"].values
    return [
        {
            "window": window[k],
            "kind": kind[k],
            "power": float(power[k, count - 1]),
            "points": position[k, :count],
            "stages": event[k, :count].tolist(),
            "surfaces": surface[k, :count].tolist(),
            "segment_power": power[k, 1:count],
        }
        for k, count in enumerate(found["vertices"].values)
    ]


def _beams(found: xr.Dataset) -> list[dict[str, Any]]:
    source, window, kind = (found[f"beam_{name}"].values for name in ("source", "window", "kind"))
    power, strength = found["beam_power"].values, found["beam_strength"].values
    direction, turned = found["beam_direction"].values, found["beam_total_reflections"].values
    return [
        {
            "source": source[k],
            "window": window[k],
            "kind": kind[k],
            "power": float(power[k]),
            "illuminance_per_normal": float(strength[k]),
            "direction": direction[k].round(6),
            "total_reflections": int(turned[k]),
        }
        for k in range(len(power))
    ]


def _patches(found: xr.Dataset) -> list[dict[str, Any]]:
    corner, source = found["patch_corner_m"].values, found["patch_source_m"].values
    surface, beam = found["patch_surface"].values, found["patch_beam"].values
    area, strength = found["patch_area_m2"].values, found["patch_strength"].values
    counts = (~np.isnan(corner[..., 0])).sum(axis=1)
    return [
        {
            "surface": surface[k],
            "beam": int(beam[k]),
            "polygon": corner[k, :count].round(_DIGITS),
            "source": source[k, :count].round(_DIGITS),
            "area_m2": float(area[k]),
            "illuminance_per_normal": float(strength[k]),
        }
        for k, count in enumerate(counts)
    ]
