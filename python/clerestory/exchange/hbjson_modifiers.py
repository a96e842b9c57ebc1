"""Radiance modifiers of an HBJSON model as materials and glazings, and which thing has which."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass, Glazing, Open
from clerestory.room.material import Material

_PHOTOPIC = np.array([0.265, 0.670, 0.065])
"""Weights of red, green and blue in Radiance's luminance."""

GENERIC_REFLECTANCE = {
    "Floor": 0.2,
    "RoofCeiling": 0.8,
    "Wall": 0.5,
    "Door": 0.5,
    "IndoorShade": 0.5,
    "OutdoorShade": 0.35,
    "Context": 0.2,
}
"""Of things without a modifier: the visible reflectances of the schema's generic modifier set."""

GENERIC_TRANSMITTANCE = {"Outdoors": 0.64, "Surface": 0.88}
"""Of apertures without a modifier, by what is on their other side: the same set."""

_SETS = {
    "Wall": "wall_set",
    "Floor": "floor_set",
    "RoofCeiling": "roof_ceiling_set",
    "Aperture": "aperture_set",
    "Door": "door_set",
    "Shade": "shade_set",
}


class Modifiers:
    """The modifiers of a model.

    Parameters
    ----------
    radiance : mapping
        ``properties.radiance`` of the model: ``modifiers``, ``modifier_sets``, ``global_modifier_set``.
    instead : mapping of identifier → Material or Glazing
        Used instead of the model's own; for every modifier that is not understood.
    """

    def __init__(self, radiance: Mapping[str, Any], instead: Mapping[str, Material | Glazing]) -> None:
        self.known = {str(one["identifier"]): one for one in radiance.get("modifiers") or [] if "identifier" in one}
        self.sets = {str(one["identifier"]): one for one in radiance.get("modifier_sets") or [] if "identifier" in one}
        self.instead = instead

    def material(self, thing: Mapping[str, Any], kind: str, room: Mapping[str, Any] | None) -> Material | Glazing:
        """What an opaque thing of a kind such as "Wall", "Door" or "IndoorShade" is made of."""
        found = self._own(thing) or self._of_set(kind, thing, room)
        if found is None:
            return Material(diffuse_reflectance=GENERIC_REFLECTANCE[kind])
        return self.read(found)

    def glazing(self, thing: Mapping[str, Any], room: Mapping[str, Any] | None) -> Material | Glazing:
        """What an aperture or a glass door is made of."""
        found = self._own(thing) or self._of_set("Aperture", thing, room)
        if found is None:
            other_side = "Surface" if _boundary(thing) == "Surface" else "Outdoors"
            return Glass(transmittance=GENERIC_TRANSMITTANCE[other_side])
        return self.read(found)

    def read(self, found: str | Mapping[str, Any]) -> Material | Glazing:
        """A modifier, given in full or by its identifier."""
        name = found if isinstance(found, str) else str(found.get("identifier", ""))
        if name in self.instead:
            return self.instead[name]
        modifier = self.known.get(name) if isinstance(found, str) else found
        if modifier is None:
            raise ClerestoryError(f"modifier {name!r} must be in the model or in materials, got neither")
        kind = str(modifier.get("type"))
        if kind == "Glass":
            return _glass(modifier, name)
        if kind in {"Plastic", "Metal", "Mirror"}:
            return _opaque(modifier, kind, name)
        if kind == "Void":
            return Open()
        raise ClerestoryError(
            f"modifier {name!r} must be Plastic, Glass, Metal, Mirror or Void, got {kind}; name what to use instead: "
            f"materials={{{name!r}: Material(diffuse_reflectance=…)}}, or a glazing"
        )

    def _own(self, thing: Mapping[str, Any]) -> str | Mapping[str, Any] | None:
        radiance = (thing.get("properties") or {}).get("radiance") or {}
        if radiance.get("dynamic_group_identifier"):
            raise ClerestoryError(
                f"{thing.get('identifier')!r} must have one state, got the dynamic group "
                f"{radiance['dynamic_group_identifier']!r}; choose a state and give it as the modifier"
            )
        found: str | Mapping[str, Any] | None = radiance.get("modifier")
        return found

    def _of_set(
        self, kind: str, thing: Mapping[str, Any], room: Mapping[str, Any] | None
    ) -> str | Mapping[str, Any] | None:
        radiance = ((room or {}).get("properties") or {}).get("radiance") or {}
        name = radiance.get("modifier_set")
        if name is None:
            return None
        if str(name) not in self.sets:
            raise ClerestoryError(f"modifier set {name!r} must be in the model, got {', '.join(self.sets) or 'none'}")
        base = "Shade" if kind.endswith("Shade") else kind
        part = self.sets[str(name)].get(_SETS.get(base, "")) or {}
        outdoors = _boundary(thing) == "Outdoors" if base != "Shade" else kind == "OutdoorShade"
        if base == "Aperture":
            first = "window_modifier" if outdoors else "interior_modifier"
        else:
            first = "exterior_modifier" if outdoors else "interior_modifier"
        found: str | Mapping[str, Any] | None = part.get(first)
        return found


def _boundary(thing: Mapping[str, Any]) -> str:
    return str((thing.get("boundary_condition") or {}).get("type", "Outdoors"))


def _colour(modifier: Mapping[str, Any], quantity: str, name: str) -> float:
    try:
        parts = [float(modifier[f"{letter}_{quantity}"]) for letter in "rgb"]
    except (KeyError, TypeError, ValueError):
        raise ClerestoryError(f"modifier {name!r} must give r_, g_ and b_{quantity} as numbers") from None
    return float(_PHOTOPIC @ parts)


def _opaque(modifier: Mapping[str, Any], kind: str, name: str) -> Material:
    """Roughness has no counterpart: what is specular is mirrored."""
    colour = _colour(modifier, "reflectance", name)
    if kind == "Mirror":
        return Material(diffuse_reflectance=0.0, specular_reflectance=colour)
    specular = float(modifier.get("specularity") or 0.0)
    if kind == "Metal":
        return Material(diffuse_reflectance=colour * (1.0 - specular), specular_reflectance=colour * specular)
    return Material(diffuse_reflectance=colour * (1.0 - specular), specular_reflectance=specular)


def _glass(modifier: Mapping[str, Any], name: str) -> Glass:
    """The file gives t, the share that survives one crossing: with all reflections between the faces
    T = (1 − r)² t / (1 − r² t²), r = ((n − 1) / (n + 1))²."""
    through = _colour(modifier, "transmissivity", name)
    n = float(modifier.get("refraction_index") or 1.52)
    r = ((n - 1.0) / (n + 1.0)) ** 2
    return Glass(transmittance=(1.0 - r) ** 2 * through / (1.0 - r * r * through * through))
