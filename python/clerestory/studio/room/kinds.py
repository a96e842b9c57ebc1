"""The room as the page offers it: sizes with units and limits, glazings and skies to choose from, and where it begins.

The limits are those of drawing boards, not of physics: a file or a link may hold any value that the room takes.
"""

from __future__ import annotations

from typing import Any

from clerestory.sky.cie import GENERAL_SKIES

_SHOEBOX: tuple[tuple[str, float, float, float, str], ...] = (
    ("width_m", 2.0, 20.0, 0.1, "m"),
    ("depth_m", 2.0, 20.0, 0.1, "m"),
    ("height_m", 2.2, 8.0, 0.05, "m"),
    ("facade_azimuth_deg", 0.0, 359.0, 1.0, "°"),
    ("wall_thickness_m", 0.0, 0.6, 0.01, "m"),
    ("floor", 0.0, 0.95, 0.01, ""),
    ("walls", 0.0, 0.95, 0.01, ""),
    ("ceiling", 0.0, 0.95, 0.01, ""),
)
_OPENING: tuple[tuple[str, float, float, float, str], ...] = (
    ("width_m", 0.3, 20.0, 0.05, "m"),
    ("height_m", 0.3, 8.0, 0.05, "m"),
    ("sill_m", 0.0, 6.0, 0.05, "m"),
)
_SENSORS: tuple[tuple[str, float, float, float, str], ...] = (
    ("spacing_m", 0.2, 2.0, 0.05, "m"),
    ("height_m", 0.0, 2.0, 0.05, "m"),
)
_SITE: tuple[tuple[str, float, float, float, str], ...] = (
    ("latitude_deg", -66.0, 66.0, 0.01, "°"),
    ("longitude_deg", -180.0, 180.0, 0.01, "°"),
    ("elevation_m", 0.0, 4000.0, 1.0, "m"),
)


def start_tables() -> dict[str, Any]:
    """The room shown first: a classroom whose window is glass below and a laser-cut panel behind glass above."""
    return {
        "name": "laser-cut panel above",
        "ground_reflectance": 0.2,
        "site": {"latitude_deg": -9.67, "longitude_deg": -35.74, "elevation_m": 10.0, "timezone": "America/Maceio"},
        "glazings": {one["name"]: one["table"] for one in glazings()},
        "shoebox": {
            "width_m": 4.0,
            "depth_m": 8.0,
            "height_m": 3.0,
            "facade_azimuth_deg": 0.0,
            "wall_thickness_m": 0.15,
            "floor": 0.2,
            "walls": 0.5,
            "ceiling": 0.8,
            "opening": [
                {
                    "name": "window",
                    "width_m": 3.6,
                    "height_m": 1.8,
                    "sill_m": 0.9,
                    "part": [{"glazing": "panel-behind-glass", "height_m": 0.6}, {"glazing": "glass"}],
                }
            ],
        },
        "sensors": [{"surface": "floor", "spacing_m": 0.5, "height_m": 0.8, "name": "work plane"}],
        "variant": [{"name": "glass only", "glazing": {"window 1": "glass"}}],
    }


def glazings() -> list[dict[str, Any]]:
    """Ready-made glazings: ``name`` and ``table`` of [glazings], and a ``label``."""
    laser_cut = {"kind": "laser-cut", "spacing_mm": 4.0, "thickness_mm": 6.0, "medium": "pmma"}
    prisms = {
        "kind": "prismatic",
        "pitch_mm": 4.0,
        "lower_deg": 45.0,
        "upper_deg": 80.0,
        "base_mm": 3.0,
        "medium": "pmma",
    }
    return [
        {"name": "glass", "label": "Single glass", "table": {"kind": "glass", "transmittance": 0.88}},
        {"name": "double-glass", "label": "Double glass", "table": {"kind": "stack", "layers": ["glass", "glass"]}},
        {"name": "tinted-glass", "label": "Tinted glass", "table": {"kind": "glass", "transmittance": 0.5}},
        {"name": "laser-cut-panel", "label": "Laser-cut panel", "table": laser_cut},
        {
            "name": "panel-behind-glass",
            "label": "Laser-cut panel behind glass",
            "table": {"kind": "stack", "layers": ["glass", "laser-cut-panel"]},
        },
        {"name": "prismatic-sheet", "label": "Prismatic sheet", "table": prisms},
        {"name": "open", "label": "Open", "table": {"kind": "open"}},
    ]


def skies() -> list[dict[str, Any]]:
    """Skies to choose from: ``name``, ``label`` and the ``sky`` of a request."""
    found: list[dict[str, Any]] = [
        {"name": "overcast", "label": "Overcast (daylight factor)", "sky": {"kind": "overcast"}}
    ]
    for number, sky in GENERAL_SKIES.items():
        asked = {"kind": "cie", "sky_type": number, "luminous_turbidity": 4.0}
        found.append({"name": f"cie-{number}", "label": f"CIE {number}: {sky.description}", "sky": asked})
    return found


def room_kinds() -> dict[str, Any]:
    """Sliders with the ``path`` of their value in the tables, glazings, skies, and where it begins."""
    start = start_tables()
    opening: list[Any] = ["shoebox", "opening", 0]
    groups: list[tuple[list[Any], str, tuple[tuple[str, float, float, float, str], ...]]] = [
        (["shoebox"], "room", _SHOEBOX),
        (opening, "window", _OPENING),
        ([*opening, "part", 0], "upper part", (("height_m", 0.1, 4.0, 0.05, "m"),)),
        (["sensors", 0], "sensors", _SENSORS),
        (["site"], "site", _SITE),
    ]
    sliders = []
    for path, group, rows in groups:
        for name, low, high, step, unit in rows:
            value: Any = start
            for part in [*path, name]:
                value = value[part]
            sliders.append(
                {
                    "name": name,
                    "group": group,
                    "path": [*path, name],
                    "low": low,
                    "high": high,
                    "step": step,
                    "unit": unit,
                    "start": value,
                }
            )
    return {
        "sliders": sliders,
        "glazings": glazings(),
        "skies": skies(),
        "surfaces": ["work plane", "on floor", "on ceiling", "on back", "on left", "on right"],
        "start": start,
    }
