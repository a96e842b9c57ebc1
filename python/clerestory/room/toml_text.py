"""A room written as TOML."""

from __future__ import annotations

import os
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

import tomli_w

from clerestory.glazing import Glazing
from clerestory.glazing_table import write_glazing
from clerestory.room.material import Material
from clerestory.room.scene import Room
from clerestory.room.sensors import SensorGrid, Sensors


def room_to_toml(room: Room) -> str:
    """The room as the text of a TOML file, which `read_room` makes into the same room.

    Notes
    -----
    Everything stands there explicitly: a shoebox has become its six polygons, a mesh file its triangles. Materials and
    glazings used more than once stand once.
    """
    materials: dict[Material, str] = {}
    glazings: dict[Glazing, str] = {}

    def material_name(material: Material) -> str:
        return materials.setdefault(material, f"material {len(materials) + 1}")

    def glazing_name(glazing: Glazing) -> str:
        if glazing not in glazings:
            written.append((glazing, write_glazing(glazing, glazing_name)))
            glazings[glazing] = f"glazing {len(glazings) + 1}"
        return glazings[glazing]

    written: list[tuple[Glazing, dict[str, Any]]] = []
    tables: dict[str, Any] = {"name": room.name, "ground_reflectance": room.ground_reflectance}
    if room.site is not None:
        tables["site"] = asdict(room.site)
    things = {
        "surface": [_plain(surface, material=material_name(surface.material)) for surface in room.surfaces],
        "window": [_plain(window, glazing=glazing_name(window.glazing)) for window in room.windows],
        "mesh": [_plain(mesh, material=material_name(mesh.material)) for mesh in room.meshes],
        "interface": [_plain(interface) for interface in room.interfaces],
        "sensors": [_sensors(one) for one in room.sensors],
    }
    tables["materials"] = {name: asdict(material) for material, name in materials.items()}
    tables["glazings"] = {glazings[glazing]: table for glazing, table in written}
    tables.update({name: rows for name, rows in things.items() if rows})
    return tomli_w.dumps({name: value for name, value in tables.items() if value not in ({}, [])})


def write_room(room: Room, path: str | os.PathLike[str]) -> None:
    """Writes the room as a TOML file, whole or not at all."""
    target = Path(path)
    beside = target.with_name(target.name + ".part")
    beside.write_text(room_to_toml(room), encoding="utf-8")
    beside.replace(target)


def _plain(thing: Any, **replaced: Any) -> dict[str, Any]:
    values = {field.name: getattr(thing, field.name) for field in fields(thing)} | replaced
    return {
        name: _listed(value)
        for name, value in values.items()
        if value is not None and not (isinstance(value, tuple) and not value)
    }


def _sensors(one: SensorGrid | Sensors) -> dict[str, Any]:
    return _plain(one)


def _listed(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_listed(item) for item in value]
    return value.tolist() if hasattr(value, "tolist") else value
