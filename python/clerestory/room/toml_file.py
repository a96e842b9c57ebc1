"""A room as one TOML file."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.glazing_table import build, glazing_tables
from clerestory.room.material import Material
from clerestory.room.mesh_file import read_meshes
from clerestory.room.obstruction import FacingBuilding, LightShelf, Louvres, Obstruction, Overhang, obstruction_surfaces
from clerestory.room.opening import Opening, Part
from clerestory.room.radiance_file import read_radiance
from clerestory.room.scene import Room
from clerestory.room.sensors import SensorGrid, Sensors
from clerestory.room.shoebox import Shoebox
from clerestory.room.surface import Interface, Mesh, Surface
from clerestory.room.toml_table import Table
from clerestory.room.window import Window
from clerestory.rules import number, one_of
from clerestory.site import Site

OBSTRUCTIONS: dict[str, type[Any]] = {
    "facing-building": FacingBuilding,
    "overhang": Overhang,
    "light-shelf": LightShelf,
    "louvres": Louvres,
}
"""The word after ``kind =`` of an obstruction and what it makes."""

NOT_THE_ROOM = ("calculation", "sky", "variant")
"""Tables that say what to compute in the room: see `read_study`."""


def read_toml(path: str | os.PathLike[str]) -> dict[str, Any]:
    """The tables of a TOML file.

    Raises
    ------
    ClerestoryError
        If it cannot be read or is no TOML; the message says where.
    """
    try:
        tables: dict[str, Any] = tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as cause:
        raise ClerestoryError(f"{path} must be a readable file: {cause.strerror}") from cause
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as cause:
        raise ClerestoryError(f"{path} must be TOML: {cause}") from cause
    return tables


def read_room(path: str | os.PathLike[str]) -> Room:
    """The room that a TOML file describes.

    Parameters
    ----------
    path : path-like
        Files that it names are looked for beside it.

    Raises
    ------
    ClerestoryError
        If the file cannot be read, holds an unknown key, lacks one, or a value is wrong; the message names the table.
    """
    return room_of(read_toml(path), where=Path(path).name, folder=Path(path).parent)


def room_of(tables: dict[str, Any], *, where: str = "the room", folder: Path = Path()) -> Room:
    """The room that the tables of a TOML file describe."""
    top = Table(tables, where)
    materials: dict[str, Material] = {
        name: build(Material, Table(values, f"[materials.{name}] of {where}"))
        for name, values in top.table("materials").values.items()
    }
    glazing = glazing_tables(top.table("glazings"), folder)

    def material(name: Any) -> Material:
        if isinstance(name, (int, float)) and not isinstance(name, bool):
            return Material(diffuse_reflectance=number("reflectance", name))
        return materials[one_of(f"material in {where}", name, materials)]

    surfaces: list[Surface] = []
    windows: list[Window] = []
    meshes: list[Mesh] = []
    shape = top.take("shoebox", None)
    obstructions = top.tables("obstruction")
    if shape is not None:
        box = _shoebox(Table(shape, f"[shoebox] of {where}"), material, glazing)
        made, glazed = box.build()
        surfaces += made
        windows += glazed
        for table in obstructions:
            surfaces += obstruction_surfaces(_obstruction(table, material), box)
    elif obstructions:
        raise ClerestoryError(f"[[obstruction]] of {where} must stand before a [shoebox], got none")
    for table in top.tables("surface"):
        table.values["material"] = material(table.values.get("material"))
        surfaces.append(build(Surface, table))
    for table in top.tables("window"):
        table.values["glazing"] = glazing(table.values.get("glazing"))
        windows.append(build(Window, table))
    for table in top.tables("mesh"):
        if "file" in table.values:
            path = folder / str(table.take("file"))
            chosen = {name: material(value) for name, value in table.table("materials").values.items()}
            default = table.take("material", None)
            meshes += read_meshes(
                path,
                materials=chosen,
                material=None if default is None else material(default),
                **table.rest("scale", "up_axis"),
            )
        else:
            table.values["material"] = material(table.values.get("material"))
            meshes.append(build(Mesh, table))
    for table in top.tables("radiance"):
        path = folder / str(table.take("file"))
        chosen = {name: material(value) for name, value in table.table("materials").values.items()}
        table.finish()
        found, glazed = read_radiance(path, materials=chosen)
        surfaces += found
        windows += glazed
    interfaces = [build(Interface, table) for table in top.tables("interface")]
    sensors = [build(Sensors if "points_m" in table.values else SensorGrid, table) for table in top.tables("sensors")]
    site = top.take("site", None)
    name = top.take("name", "room")
    reflectance = top.take("ground_reflectance", 0.2)
    for other in NOT_THE_ROOM:
        top.take(other, None)
    top.finish()
    return Room(
        surfaces=tuple(surfaces),
        windows=tuple(windows),
        meshes=tuple(meshes),
        interfaces=tuple(interfaces),
        sensors=tuple(sensors),
        ground_reflectance=reflectance,
        site=None if site is None else build(Site, Table(site, f"[site] of {where}")),
        name=name,
    )


def _shoebox(table: Table, material: Any, glazing: Any) -> Shoebox:
    openings = []
    for row in table.tables("opening"):
        parts = []
        for part in row.tables("part"):
            for key in {"glazing", "behind"} & set(part.values):
                part.values[key] = glazing(part.values[key])
            parts.append(build(Part, part))
        if "glazing" in row.values:
            if parts:
                raise ClerestoryError(f"{row.where} must have a glazing or parts, got both")
            parts = [Part(glazing=glazing(row.take("glazing")))]
        if parts:
            row.values["parts"] = tuple(parts)
        openings.append(build(Opening, row))
    table.values["openings"] = tuple(openings)
    for key in {"floor", "walls", "ceiling"} & set(table.values):
        table.values[key] = material(table.values[key])
    box: Shoebox = build(Shoebox, table)
    return box


def _obstruction(table: Table, material: Any) -> Obstruction:
    kind = OBSTRUCTIONS[one_of(f"kind of {table.where}", table.take("kind"), OBSTRUCTIONS)]
    if "material" in table.values:
        table.values["material"] = material(table.values["material"])
    made: Obstruction = build(kind, table)
    return made
