"""Rooms of a HBJSON model, the format of Ladybug Tools: faces, apertures, doors, shades and sensor grids."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.exchange.hbjson_modifiers import Modifiers
from clerestory.glazing import Glazing
from clerestory.room.material import Material
from clerestory.room.scene import Room
from clerestory.room.sensors import Sensors
from clerestory.room.surface import Mesh, Outline, Surface
from clerestory.room.window import Window, normal_of
from clerestory.rules import Points, points

METRES = {"Meters": 1.0, "Millimeters": 1e-3, "Centimeters": 1e-2, "Feet": 0.3048, "Inches": 0.0254}
"""What the model's units are in metres."""

Thing = Mapping[str, Any]


def read_hbjson(
    path: str | os.PathLike[str],
    *,
    room: str | None = None,
    materials: Mapping[str, Material | Glazing] | None = None,
    ground_reflectance: float = 0.2,
) -> Room:
    """The rooms of a HBJSON model as one room.

    Parameters
    ----------
    path : path-like
        A ``Model`` of version 1, whose north is its y axis.
    room : str, optional
        Identifier of the one room to read; default all, with what stands around them.
    materials : mapping of identifier → Material or Glazing, optional
        Instead of the model's modifiers, by their identifiers: a panel in a window, or something for a modifier that is
        not understood.
    ground_reflectance : float, 0..1, default 0.2

    Returns
    -------
    Room
        Faces and opaque doors are surfaces, apertures and glass doors windows, shades surfaces or meshes, sensor grids
        groups of sensors. A face that two rooms share stands once. Air boundaries are left out: they stop no light.

    Raises
    ------
    ClerestoryError
        If the file is no HBJSON model, or holds what has no counterpart: modifiers other than Plastic, Glass, Metal,
        Mirror and Void, dynamic groups of states, a shade that lets light through unless it is glass.

    Notes
    -----
    Things without a modifier have that of their room's set, else the generic ones of the schema: floor 0.2, walls 0.5,
    ceiling 0.8, windows 0.64. Roughness is left out. The corners of faces run anticlockwise as seen from outside.
    """
    file = Path(path)
    model = _model(file)
    try:
        return _Reader(model, file.name, materials or {}).room(room, ground_reflectance)
    except ClerestoryError as cause:
        raise ClerestoryError(f"{file.name}: {cause}") from cause
    except (KeyError, TypeError, IndexError, AttributeError) as cause:
        told = f"{type(cause).__name__} {cause}"
        raise ClerestoryError(f"{file.name} must keep to the schema of Honeybee models, got: {told}") from cause


def _model(file: Path) -> Thing:
    try:
        model = json.loads(file.read_text(encoding="utf-8"))
    except OSError as cause:
        raise ClerestoryError(f"{file} must be a readable file: {cause.strerror}") from None
    except (UnicodeDecodeError, json.JSONDecodeError) as cause:
        raise ClerestoryError(f"{file.name} must be JSON, got: {cause}") from None
    if not isinstance(model, dict) or model.get("type") != "Model":
        kind = model.get("type") if isinstance(model, dict) else type(model).__name__
        raise ClerestoryError(f"{file.name} must be a Honeybee Model, got {kind!r}; export the whole model")
    return model


class _Reader:
    def __init__(self, model: Thing, name: str, instead: Mapping[str, Material | Glazing]) -> None:
        self.model, self.name = model, name
        units = str(model.get("units", "Meters"))
        if units not in METRES:
            raise ClerestoryError(f"units must be one of {', '.join(METRES)}, got {units!r}")
        self.scale = METRES[units]
        self.radiance: Thing = (model.get("properties") or {}).get("radiance") or {}
        self.modifiers = Modifiers(self.radiance, instead)
        self.surfaces: list[Surface] = []
        self.windows: list[Window] = []
        self.meshes: list[Mesh] = []
        self.shared: set[str] = set()

    def room(self, wanted: str | None, ground_reflectance: float) -> Room:
        rooms = self.model.get("rooms") or []
        known = [str(room["identifier"]) for room in rooms]
        if wanted is not None and wanted not in known:
            raise ClerestoryError(f"room must be one of {', '.join(known) or 'none'}, got {wanted!r}")
        for room in rooms:
            if wanted is None or room["identifier"] == wanted:
                for face in room["faces"]:
                    self._face(face, room)
                self._shades(room, room)
        for face in self.model.get("orphaned_faces") or []:
            self._face(face, None)
        for aperture in self.model.get("orphaned_apertures") or []:
            self._opening(aperture, None, None, is_glass=True)
        for door in self.model.get("orphaned_doors") or []:
            self._opening(door, None, None, is_glass=bool(door.get("is_glass")))
        for shade in self.model.get("orphaned_shades") or []:
            self._shade(shade, "Context", None)
        for mesh in self.model.get("shade_meshes") or []:
            self._mesh(mesh)
        return Room(
            surfaces=tuple(self.surfaces),
            windows=tuple(self.windows),
            meshes=tuple(self.meshes),
            sensors=tuple(self._grids(wanted)),
            ground_reflectance=ground_reflectance,
            name=str(wanted or self.model.get("display_name") or self.model.get("identifier") or self.name),
        )

    def _face(self, face: Thing, room: Thing | None) -> None:
        name, kind = str(face["identifier"]), str(face["face_type"])
        boundary = face.get("boundary_condition") or {}
        if boundary.get("type") == "Surface":
            # the other room has the same face: the first that comes stands for both
            if name in self.shared:
                return
            self.shared.add(str(boundary["boundary_condition_objects"][0]))
        if kind != "AirBoundary":
            outline, holes = self._outline(face)
            for door in face.get("doors") or []:
                if not door.get("is_glass"):
                    holes.append(self._outline(door)[0])
            material = self._material(face, kind, room)
            self.surfaces.append(Surface(name=name, outline_m=outline, holes_m=tuple(holes), material=material))
        wall = None if kind == "AirBoundary" else name
        for aperture in face.get("apertures") or []:
            self._opening(aperture, wall, room, is_glass=True)
        for door in face.get("doors") or []:
            self._opening(door, wall, room, is_glass=bool(door.get("is_glass")))
        self._shades(face, room)

    def _opening(self, thing: Thing, wall: str | None, room: Thing | None, *, is_glass: bool) -> None:
        name = str(thing["identifier"])
        outline, holes = self._outline(thing)
        if not is_glass:
            material = self._material(thing, "Door", room)
            self.surfaces.append(Surface(name=name, outline_m=outline, holes_m=tuple(holes), material=material))
        else:
            if holes:
                raise ClerestoryError(f"aperture {name!r} must have no holes, got {len(holes)}; divide it")
            glazing = self.modifiers.glazing(thing, room)
            if isinstance(glazing, Material):
                raise ClerestoryError(f"aperture {name!r} must have a glazing, got {glazing!r}; take Glass")
            # corners of the model run anticlockwise from outside, ours from the room
            self.windows.append(Window(name=name, outline_m=outline[::-1], glazing=glazing, wall=wall))
        self._shades(thing, room)

    def _shades(self, thing: Thing, room: Thing | None) -> None:
        for shade in thing.get("outdoor_shades") or []:
            self._shade(shade, "OutdoorShade", room)
        for shade in thing.get("indoor_shades") or []:
            self._shade(shade, "IndoorShade", room)

    def _shade(self, shade: Thing, kind: str, room: Thing | None) -> None:
        name = str(shade["identifier"])
        outline, holes = self._outline(shade)
        found = self.modifiers.material(shade, kind, room)
        if isinstance(found, Material):
            self.surfaces.append(Surface(name=name, outline_m=outline, holes_m=tuple(holes), material=found))
        elif holes:
            raise ClerestoryError(f"glass shade {name!r} must have no holes, got {len(holes)}; divide it")
        else:
            self.windows.append(Window(name=name, outline_m=outline, glazing=found))

    def _mesh(self, mesh: Thing) -> None:
        name = str(mesh["identifier"])
        geometry = mesh["geometry"]
        triangles = []
        for face in geometry["faces"]:
            triangles += [[face[0], face[k], face[k + 1]] for k in range(1, len(face) - 1)]
        self.meshes.append(
            Mesh(
                name=name,
                vertices_m=self.scale * points(f"vertices of {name!r}", geometry["vertices"]),
                triangles=np.array(triangles, dtype=np.int64),
                material=self._material(mesh, "Context", None),
            )
        )

    def _material(self, thing: Thing, kind: str, room: Thing | None) -> Material:
        found = self.modifiers.material(thing, kind, room)
        if not isinstance(found, Material):
            raise ClerestoryError(
                f"{kind} {thing['identifier']!r} must have an opaque modifier, got {found!r}; make it an aperture"
            )
        return found

    def _outline(self, thing: Thing) -> tuple[Outline, list[Outline]]:
        name, geometry = thing["identifier"], thing["geometry"]
        corners = self.scale * points(f"boundary of {name!r}", geometry["boundary"])
        if len(corners) < 3 or not np.linalg.norm(normal_of(corners)) > 0.0:
            raise ClerestoryError(f"boundary of {name!r} must be a polygon with an area, got {len(corners)} corners")
        holes = [self.scale * points(f"hole of {name!r}", hole) for hole in geometry.get("holes") or []]
        return _tuples(corners), [_tuples(hole) for hole in holes]

    def _grids(self, wanted: str | None) -> Iterator[Sensors]:
        for grid in self.radiance.get("sensor_grids") or []:
            if wanted is not None and grid.get("room_identifier") not in (None, wanted):
                continue
            sensors = grid["sensors"]
            yield Sensors(
                points_m=self.scale * np.array([one["pos"] for one in sensors], dtype=np.float64),
                normals=np.array([one["dir"] for one in sensors], dtype=np.float64),
                name=str(grid.get("display_name") or grid["identifier"]),
            )


def _tuples(corners: Points) -> Outline:
    return tuple((float(x), float(y), float(z)) for x, y, z in corners)
