"""The long jobs, by name; each is done in a process of its own and tells what it has so far."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from clerestory.studio.bsdf.klems_work import klems
from clerestory.studio.panel.work import Tell, angular, dispersion, walk
from clerestory.studio.room.work import room, room_sun
from clerestory.studio.year.work import year

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
