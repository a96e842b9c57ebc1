"""The way of the sun as the page draws it."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from clerestory.room.beams import Array, sun_way
from clerestory.room.scene import Room
from clerestory.studio.room.numbers import whole
from clerestory.sun import direction_of
from clerestory.sun_coefficients import SunWarning

#: Digits of places: a tenth of a millimetre; and of shares.
_DIGITS, _SHARE_DIGITS = 4, 5
#: Points of a window from which paths begin.
_POINTS, _MOST_POINTS = 12, 400


def paths_of(room: Room, *, altitude_deg: float, azimuth_deg: float, density: Any) -> dict[str, Any]:
    """Paths, beams and sunlit patches of one sun; none while it is below the horizon."""
    points = _POINTS if density is None else whole("density", density, 1, _MOST_POINTS)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always", SunWarning)
        way = sun_way(room, altitude_deg=altitude_deg, azimuth_deg=azimuth_deg, points=points)
    return {
        "altitude_deg": altitude_deg,
        "azimuth_deg": azimuth_deg,
        "direction": direction_of(altitude_deg, azimuth_deg),
        "is_up": altitude_deg > 0.0,
        "windows": _windows(way.windows),
        "paths": _paths(way.paths),
        "beams": _beams(way.beams),
        "patches": _patches(way.patches),
        "warnings": [str(one.message) for one in told if issubclass(one.category, SunWarning)],
    }


def _windows(windows: dict[str, Array]) -> list[dict[str, Any]]:
    blocked = [name or None for name in windows["blocked_by"].tolist()]
    numbers = (windows[name].tolist() for name in ("cos_incidence", "sunlit_share", "entering"))
    return [
        {"name": name, "cos_incidence": cos, "sunlit_share": share, "blocked_by": by, "entering": entering}
        for name, by, cos, share, entering in zip(windows["name"].tolist(), blocked, *numbers, strict=True)
    ]


def _paths(paths: dict[str, Array]) -> list[dict[str, Any]]:
    points, power = paths["position"].round(_DIGITS).tolist(), paths["power"].round(_SHARE_DIGITS).tolist()
    stages, surfaces = paths["event"].tolist(), paths["surface"].tolist()
    return [
        {
            "window": window,
            "kind": kind,
            "power": power[end - 1],
            "points": points[first:end],
            "stages": stages[first:end],
            "surfaces": surfaces[first:end],
            "segment_power": power[first + 1 : end],
        }
        for window, kind, (first, end) in zip(
            paths["window"].tolist(), paths["kind"].tolist(), _ranges(paths["vertices"]), strict=True
        )
    ]


def _beams(beams: dict[str, Array]) -> list[dict[str, Any]]:
    columns = {
        "source": beams["source"],
        "window": beams["window"],
        "kind": beams["kind"],
        "power": beams["power"],
        "illuminance_per_normal": beams["strength"],
        "direction": beams["direction"].round(6),
        "total_reflections": beams["total_reflections"],
    }
    return _records(columns)


def _patches(patches: dict[str, Array]) -> list[dict[str, Any]]:
    corner, source = patches["corner"].round(_DIGITS).tolist(), patches["source"].round(_DIGITS).tolist()
    columns = {
        "surface": patches["surface"],
        "beam": patches["beam"],
        "area_m2": patches["area"],
        "illuminance_per_normal": patches["strength"],
    }
    return [
        {**one, "polygon": corner[first:end], "source": source[first:end]}
        for one, (first, end) in zip(_records(columns), _ranges(patches["corners"]), strict=True)
    ]


def _records(columns: dict[str, Array]) -> list[dict[str, Any]]:
    """A mapping for each row of some columns."""
    return [
        dict(zip(columns, row, strict=True)) for row in zip(*(one.tolist() for one in columns.values()), strict=True)
    ]


def _ranges(counts: Array) -> list[tuple[int, int]]:
    """Where each of some runs of values begins and ends."""
    ends = np.cumsum(counts)
    return list(zip((ends - counts).tolist(), ends.tolist(), strict=True))
