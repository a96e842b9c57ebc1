"""What the page draws of a room: its surfaces, windows and planes."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.glazing import Glazing, Open, Stack
from clerestory.panels import Panel
from clerestory.room.scene import Room, materials_of
from clerestory.room.window import normal_of
from clerestory.studio.room.asked import AskedRoom
from clerestory.studio.room.planes import plane_names, told

#: Digits of what is drawn: a tenth of a millimetre.
_DIGITS = 4


def scene_of(asked: AskedRoom, variant: Any, planes: Any, spacing_m: Any) -> dict[str, Any]:
    """Everything that the 3D view draws, in the world's axes [m].

    Parameters
    ----------
    asked : AskedRoom
    variant : str, optional
    planes : list of str, optional
        Names of planes to lay out; default the room's own.
    spacing_m : float, optional
        Of grids on surfaces.
    """
    room = asked.room(variant)
    vertices, surface_index = (np.asarray(values) for values in room.scene.triangles())
    names = plane_names(room)
    if planes is None:
        planes = names[: max(1, len(room.sensors))]
    if not isinstance(planes, list) or len(planes) > 16:
        raise ClerestoryError(f"planes must be a list of at most 16 names of planes, got {planes!r}")
    site = asked.site
    return {
        "name": room.name if variant is None else str(variant),
        "variants": list(asked.variants),
        "bounds_m": [vertices.reshape(-1, 3).min(axis=0), vertices.reshape(-1, 3).max(axis=0)],
        "inside_m": _inside(room),
        "north": [0.0, 1.0, 0.0],
        "surfaces": _surfaces(room, vertices, surface_index),
        "windows": [
            {
                "name": window.name,
                "outline_m": window.outline_m,
                "normal": normal_of(np.array(window.outline_m)),
                "glazing": words(window.glazing),
                "kind": kind(window.glazing),
            }
            for window in room.windows
        ],
        "planes": [told(room, name, spacing_m) for name in planes],
        "plane_names": names,
        "site": None if site is None else asdict(site),
        "tables": asked.tables,
    }


def words(glazing: Glazing) -> str:
    """A glazing in words, from the outside to the room."""
    if isinstance(glazing, Stack):
        return " + ".join(words(one) for one in glazing.glazings)
    if isinstance(glazing, Panel):
        return {"laser-cut": "laser-cut panel", "prismatic": "prismatic sheet"}.get(glazing.kind, glazing.kind)
    if isinstance(glazing, Open):
        return "open"
    name = getattr(glazing, "name", None)
    return str(name) if name else kind(glazing)


def kind(glazing: Glazing) -> str:
    """The word that stands for a glazing's kind; of a stack, that of the layer that turns light."""
    if isinstance(glazing, Stack):
        inner = [kind(one) for one in glazing.glazings]
        return next((one for one in inner if one not in ("glass", "pane", "slab", "open")), inner[0])
    if isinstance(glazing, Panel):
        return str(glazing.kind)
    return {"Bsdf": "bsdf", "TregenzaSharples": "glass", "PlainTransmittance": "plain"}.get(
        type(glazing).__name__, type(glazing).__name__.lower()
    )


def _surfaces(room: Room, vertices: Any, surface_index: Any) -> list[dict[str, Any]]:
    materials = materials_of(room)
    outlines = {one.name: [one.outline_m, *one.holes_m] for one in room.surfaces}
    outlines |= {one.name: [one.outline_m] for one in room.windows}
    found = []
    for index, (name, of_kind) in enumerate(zip(room.scene.surfaces, room.scene.kinds, strict=True)):
        material = materials.get(name)
        triangles = vertices[surface_index == index].reshape(-1, 9).round(_DIGITS)
        found.append(
            {
                "name": name,
                "kind": of_kind,
                "diffuse": None if material is None else material.diffuse_reflectance,
                "specular": None if material is None else material.specular_reflectance,
                "triangles": triangles,
                "outlines": [np.round(loop, _DIGITS) for loop in outlines.get(name, [])],
            }
        )
    return found


def _inside(room: Room) -> list[Any]:
    """Bounds of what encloses the sensors and windows: where the camera looks, whatever stands far outside."""
    seen = [np.array(window.outline_m) for window in room.windows]
    grids = {one.surface for one in room.sensors if hasattr(one, "surface")} | {"floor", "ceiling"}
    seen += [np.array(one.outline_m) for one in room.surfaces if one.name in grids]
    points = np.concatenate(seen or [np.array(one.outline_m) for one in room.surfaces])
    return [points.min(axis=0), points.max(axis=0)]
