"""A small HBJSON model, written by hand: a room of 4 by 6 by 3 m with a window, a door, an overhang and a grid."""

import copy
from typing import Any

Json = dict[str, Any]


def thing(kind: str, name: str, boundary: list[list[float]], *, modifier: str | None = None, **more: Any) -> Json:
    radiance = {"type": f"{kind}RadiancePropertiesAbridged"} | ({"modifier": modifier} if modifier else {})
    return {
        "type": kind,
        "identifier": name,
        "display_name": name.title(),
        "properties": {"type": f"{kind}PropertiesAbridged", "radiance": radiance},
        "geometry": {"type": "Face3D", "boundary": boundary},
    } | more


def face(name: str, kind: str, boundary: list[list[float]], beyond: str = "Outdoors", **more: Any) -> Json:
    return thing("Face", name, boundary, face_type=kind, boundary_condition={"type": beyond}, **more)


def model(**changes: Any) -> Json:
    """The room: facade at y = 0, looking south; corners of faces anticlockwise from outside."""
    window = thing(
        "Aperture",
        "window",
        [[1, 0, 1], [3, 0, 1], [3, 0, 2.5], [1, 0, 2.5]],
        modifier="clear",
        boundary_condition={"type": "Outdoors"},
    )
    door = thing("Door", "door", [[3, 6, 0.1], [2, 6, 0.1], [2, 6, 2.1], [3, 6, 2.1]], modifier="brown", is_glass=False)
    overhang = thing("Shade", "overhang", [[1, 0, 2.6], [3, 0, 2.6], [3, -0.5, 2.6], [1, -0.5, 2.6]])
    whole = {
        "type": "Model",
        "identifier": "small",
        "units": "Meters",
        "rooms": [
            {
                "type": "Room",
                "identifier": "office",
                "properties": {"radiance": {"modifier_set": "light"}},
                "faces": [
                    face("floor", "Floor", [[0, 6, 0], [4, 6, 0], [4, 0, 0], [0, 0, 0]], "Ground"),
                    face("ceiling", "RoofCeiling", [[0, 0, 3], [4, 0, 3], [4, 6, 3], [0, 6, 3]]),
                    face(
                        "south",
                        "Wall",
                        [[0, 0, 0], [4, 0, 0], [4, 0, 3], [0, 0, 3]],
                        apertures=[window],
                        outdoor_shades=[overhang],
                    ),
                    face("north", "Wall", [[4, 6, 0], [0, 6, 0], [0, 6, 3], [4, 6, 3]], doors=[door]),
                    face("east", "Wall", [[4, 0, 0], [4, 6, 0], [4, 6, 3], [4, 0, 3]], "Adiabatic"),
                    face("west", "Wall", [[0, 6, 0], [0, 0, 0], [0, 0, 3], [0, 6, 3]], "Adiabatic"),
                ],
            }
        ],
        "properties": {
            "type": "ModelProperties",
            "radiance": {
                "type": "ModelRadianceProperties",
                "modifiers": [
                    colour("Glass", "clear", "transmissivity", 0.96),
                    colour("Plastic", "brown", "reflectance", 0.3, specularity=0.1, roughness=0.1),
                    colour("Plastic", "white", "reflectance", 0.7),
                    colour("Trans", "cloth", "reflectance", 0.5),
                ],
                "modifier_sets": [{"identifier": "light", "wall_set": {"interior_modifier": "white"}}],
                "sensor_grids": [
                    {
                        "type": "SensorGrid",
                        "identifier": "desk",
                        "room_identifier": "office",
                        "sensors": [
                            {"pos": [x, y, 0.8], "dir": [0, 0, 1]} for y in (1.0, 3.0, 5.0) for x in (1.0, 2.0, 3.0)
                        ],
                    }
                ],
            },
        },
    }
    return copy.deepcopy(whole | changes)


def colour(kind: str, name: str, quantity: str, value: float, **more: float) -> Json:
    return {"type": kind, "identifier": name, **{f"{letter}_{quantity}": value for letter in "rgb"}} | more
