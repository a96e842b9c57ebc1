"""What a plan needs of a room beside its sensors, kept with results so that they can be drawn without the room."""

from __future__ import annotations

import json
from typing import Any

from clerestory.room.scene import Room

MOST_CHARACTERS = 60_000
"""An attribute of a NetCDF file holds 64 KiB."""


def plan_attributes(room: Room, text: str = "") -> dict[str, str]:
    """Attributes of a result that draw its plans, and find the file of the study that it came from.

    Parameters
    ----------
    room : Room
    text : str
        Of the file.

    Returns
    -------
    dict
        ``room_outlines``, the JSON of `plan_outlines`, and ``study_toml``; without what is too long for a file.
    """
    found = {"room_outlines": json.dumps(plan_outlines(room)), "study_toml": text}
    return {name: value for name, value in found.items() if 0 < len(value.encode()) <= MOST_CHARACTERS}


def plan_outlines(room: Room) -> dict[str, dict[str, Any]]:
    """Outlines of the surfaces that sensors lie over, and of the windows.

    Parameters
    ----------
    room : Room

    Returns
    -------
    dict
        ``surfaces`` and ``windows``: name → outline [m], a list of (x, y, z). Surfaces are those that a group of
        sensors is named after.
    """
    groups = {one.name for one in room.sensor_points()}
    surfaces = {one.name: one.outline_m for one in room.surfaces if one.name in groups}
    windows = {one.name: one.outline_m for one in room.windows}
    return {
        "surfaces": {name: _listed(outline) for name, outline in surfaces.items()},
        "windows": {name: _listed(outline) for name, outline in windows.items()},
    }


def _listed(outline: Any) -> list[list[float]]:
    return [[float(value) for value in corner] for corner in outline]
