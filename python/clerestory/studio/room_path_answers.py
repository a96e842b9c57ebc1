"""The way of the sun as the page draws it."""

from __future__ import annotations

import warnings
from typing import Any

from clerestory.room.scene import Room
from clerestory.studio.room_numbers import whole
from clerestory.sun_coefficients import SunWarning
from clerestory.sun_paths import sun_paths

_DIGITS = 4
#: Points of a window from which paths begin.
_POINTS, _MOST_POINTS = 12, 400


def paths_of(room: Room, *, altitude_deg: float, azimuth_deg: float, density: Any) -> dict[str, Any]:
    """Paths, beams and sunlit patches of one sun; none while it is below the horizon."""
    points = _POINTS if density is None else whole("density", density, 1, _MOST_POINTS)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always", SunWarning)
        found = sun_paths(room, altitude_deg=altitude_deg, azimuth_deg=azimuth_deg, points=points)
    position, power = found["position_m"].values.round(_DIGITS), found["power"].values.round(5)
    paths = []
    for k, count in enumerate(found["vertices"].values):
        paths.append(
            {
                "window": str(found["path_window"].values[k]),
                "kind": str(found["kind"].values[k]),
                "power": float(power[k, count - 1]),
                "points": position[k, :count],
                "stages": found["event"].values[k, :count].tolist(),
                "surfaces": found["surface"].values[k, :count].tolist(),
                "segment_power": power[k, 1:count],
            }
        )
    return {
        "altitude_deg": altitude_deg,
        "azimuth_deg": azimuth_deg,
        "is_up": altitude_deg > 0.0,
        "windows": [
            {
                "name": str(name),
                "cos_incidence": float(found["cos_incidence"][k]),
                "sunlit_share": float(found["sunlit_share"][k]),
                "blocked_by": str(found["blocked_by"].values[k]) or None,
            }
            for k, name in enumerate(found["window"].values)
        ],
        "paths": paths,
        "beams": [],
        "patches": [],
        "warnings": [str(one.message) for one in told if issubclass(one.category, SunWarning)],
    }
