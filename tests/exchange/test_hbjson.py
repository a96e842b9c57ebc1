"""A HBJSON model becomes the room that it describes, or one clear line."""

import json

import numpy as np
import pytest
from tests.exchange.model import model, thing

from clerestory import Glass, LaserCutPanel, Material, Overhang, Room, Sensors, daylight_coefficients, daylight_factor
from clerestory.errors import ClerestoryError
from clerestory.exchange import read_hbjson
from clerestory.room.opening import Opening, Part
from clerestory.room.window import normal_of


def written(tmp_path, whole):
    path = tmp_path / "small.hbjson"
    path.write_text(json.dumps(whole))
    return path


def test_faces_windows_doors_shades_and_grids_are_there(tmp_path):
    room = read_hbjson(written(tmp_path, model()))
    assert [surface.name for surface in room.surfaces] == [
        *("floor", "ceiling", "south", "overhang", "north", "door", "east", "west")
    ]
    reflectance = {surface.name: surface.material for surface in room.surfaces}
    assert reflectance["floor"].diffuse_reflectance == 0.2
    assert reflectance["ceiling"].diffuse_reflectance == 0.8
    # the set of the room says what walls to other rooms are; those to the outside have the generic 0.5
    assert [reflectance[name].diffuse_reflectance for name in ("east", "south")] == [0.7, 0.5]
    assert reflectance["overhang"].diffuse_reflectance == 0.35
    assert reflectance["door"].specular_reflectance == 0.1
    assert reflectance["door"].diffuse_reflectance == pytest.approx(0.27)
    (window,) = room.windows
    assert window.wall == "south"
    np.testing.assert_allclose(normal_of(np.array(window.outline_m)), [0.0, 1.0, 0.0])
    # a t of 0.96 lets (1 − r)² t / (1 − r² t²) through
    r = (0.52 / 2.52) ** 2
    assert window.glazing.transmittance == pytest.approx((1 - r) ** 2 * 0.96 / (1 - (r * 0.96) ** 2), rel=1e-12)
    assert len(room.sensors[0]) == 9
    assert len(room.surfaces[4].holes_m) == 1, "the door is cut out of its wall"


def test_its_daylight_is_that_of_the_same_room_drawn_here(tmp_path):
    plain = Material(diffuse_reflectance=0.5)
    window = Opening(width_m=2.0, height_m=1.5, sill_m=1.0, parts=(Part(glazing=Glass(transmittance=0.88)),))
    points = Sensors(points_m=[[x, y, 0.8] for y in (1.0, 3.0, 5.0) for x in (1.0, 2.0, 3.0)], name="desk")
    drawn = Room.shoebox(
        width_m=4.0,
        depth_m=6.0,
        height_m=3.0,
        facade_azimuth_deg=180.0,
        floor=plain,
        walls=plain,
        ceiling=plain,
        openings=[window],
        obstructions=[Overhang(depth_m=0.5, width_m=2.0, height_m=2.6, material=plain)],
    )
    # where the shoebox lies is its own affair
    corner = np.array([surface.outline_m for surface in drawn.surfaces if surface.name == "floor"])[0].min(axis=0)
    placed = Sensors(points_m=points.points_m + corner, name="desk")
    whole = model()
    whole["rooms"][0]["properties"] = {}
    whole["properties"]["radiance"]["modifiers"] = []
    even = dict.fromkeys(("grey",), plain)
    for one in whole["rooms"][0]["faces"]:
        one["properties"]["radiance"]["modifier"] = "grey"
        for other in [*one.get("outdoor_shades", []), *one.get("doors", [])]:
            other["properties"]["radiance"]["modifier"] = "grey"
    read = read_hbjson(written(tmp_path, whole), materials=even | {"clear": Glass(transmittance=0.88)})
    how = {"basis": "tregenza145", "target_relative_error": 0.02}
    here = daylight_factor(daylight_coefficients(drawn, placed, **how))
    there = daylight_factor(daylight_coefficients(read, **how, seed=1))
    error = np.hypot(here.total_standard_error, there.total_standard_error)
    assert float((error / here.total).max()) < 0.05
    assert float((abs(here.total - there.total) / error).max()) < 4.0


def test_feet_are_turned_into_metres(tmp_path):
    room = read_hbjson(written(tmp_path, model(units="Feet")))
    assert np.max([surface.outline_m for surface in room.surfaces if surface.name == "floor"]) == pytest.approx(1.8288)
    assert room.sensors[0].points_m.max() == pytest.approx(1.524)


def test_a_panel_can_fill_a_window_of_the_model(tmp_path):
    panel = LaserCutPanel(spacing_mm=4, thickness_mm=6)
    room = read_hbjson(written(tmp_path, model()), materials={"clear": panel})
    assert room.windows[0].glazing == panel


def test_a_wall_between_two_rooms_stands_once_and_air_stops_nothing(tmp_path):
    whole = model()
    first = whole["rooms"][0]
    second = json.loads(json.dumps(first).replace('"office"', '"store"'))
    for one in second["faces"]:
        one["identifier"] += "2"
        for key in ("apertures", "outdoor_shades", "doors"):
            one.pop(key, None)
        for corner in one["geometry"]["boundary"]:
            corner[0] += 4.0
    for faces, name, other in ((first["faces"][4], "east", "west2"), (second["faces"][5], "west2", "east")):
        assert faces["identifier"] == name
        faces["boundary_condition"] = {"type": "Surface", "boundary_condition_objects": [other, "x"]}
    whole["rooms"].append(second)
    names = [surface.name for surface in read_hbjson(written(tmp_path, whole)).surfaces]
    assert "east" in names
    assert "west2" not in names
    for faces in (first["faces"][4], second["faces"][5]):
        faces["face_type"] = "AirBoundary"
    names = [surface.name for surface in read_hbjson(written(tmp_path, whole)).surfaces]
    assert not {"east", "west2"} & set(names)
    assert "west2" not in [one.name for one in read_hbjson(written(tmp_path, whole), room="office").surfaces]


def test_orphans_and_meshes_stand_around(tmp_path):
    triangle = [[10.0, 0.0, 0.0], [12.0, 0.0, 0.0], [12.0, 0.0, 5.0]]
    mesh = thing("ShadeMesh", "hill", [])
    mesh["geometry"] = {"type": "Mesh3D", "vertices": [*triangle, [10.0, 0.0, 5.0]], "faces": [[0, 1, 2, 3]]}
    room = read_hbjson(
        written(tmp_path, model(orphaned_shades=[thing("Shade", "tree", triangle)], shade_meshes=[mesh]))
    )
    assert room.surfaces[-1].material.diffuse_reflectance == 0.2
    assert room.meshes[0].triangles.tolist() == [[0, 1, 2], [0, 2, 3]]


def changed(path, value):
    whole = model()
    here = whole
    for step in path[:-1]:
        here = here[step]
    here[path[-1]] = value
    return whole


SOUTH = ("rooms", 0, "faces", 2)


@pytest.mark.parametrize(
    ("whole", "message"),
    [
        (changed(("type",), "Room"), "must be a Honeybee Model, got 'Room'"),
        (changed(("units",), "Yards"), "units must be one of Meters, Millimeters"),
        (
            changed((*SOUTH, "properties", "radiance", "modifier"), "cloth"),
            "must be Plastic, Glass, Metal, Mirror or Void",
        ),
        (changed((*SOUTH, "properties", "radiance", "modifier"), "clear"), "must have an opaque modifier"),
        (changed((*SOUTH, "properties", "radiance", "modifier"), "none"), "must be in the model or in materials"),
        (changed((*SOUTH, "geometry"), {}), "must keep to the schema of Honeybee models, got: KeyError 'boundary'"),
        (changed((*SOUTH, "geometry", "boundary"), [[0, 0, 0], [1, 0, 0]]), "must be a polygon with an area"),
        (changed(("rooms", 0, "properties", "radiance", "modifier_set"), "dark"), "must be in the model, got light"),
        (
            changed((*SOUTH, "apertures", 0, "properties", "radiance", "dynamic_group_identifier"), "blinds"),
            "must have one state, got the dynamic group 'blinds'",
        ),
    ],
)
def test_what_has_no_counterpart_is_refused_plainly(tmp_path, whole, message):
    with pytest.raises(ClerestoryError) as told:
        read_hbjson(written(tmp_path, whole))
    assert message in str(told.value)
    assert "small.hbjson" in str(told.value)
    assert "\n" not in str(told.value)


def test_other_files_are_no_models(tmp_path):
    with pytest.raises(ClerestoryError, match="must be a readable file"):
        read_hbjson(tmp_path / "none.hbjson")
    (tmp_path / "x.hbjson").write_text("{")
    with pytest.raises(ClerestoryError, match="must be JSON"):
        read_hbjson(tmp_path / "x.hbjson")
    with pytest.raises(ClerestoryError, match="room must be one of office, got 'ofice'"):
        read_hbjson(written(tmp_path, model()), room="ofice")
