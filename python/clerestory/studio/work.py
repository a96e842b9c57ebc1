"""The long jobs, by name; each is done in a process of its own and tells what it has so far."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from clerestory.studio.klems_work import klems
from clerestory.studio.panel_work import Tell, angular, dispersion, walk
from clerestory.studio.room_work import room, room_sun
from clerestory.studio.year_work import year

__all__ = ["JOBS", "Tell"]

JOBS: dict[str, Callable[..., Any]] = {
    "angular": angular,
    "walk": walk,
    "dispersion": dispersion,
    "klems": klems,
    "year": year,
    "room": room,
    "room_sun": room_sun,
}
