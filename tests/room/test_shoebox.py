"""Shoebox rooms: their geometry, openings and what stands before them."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass, Open
from clerestory.room import FacingBuilding, LightShelf, Louvres, Material, Opening, Overhang, Part, Room
from clerestory.room.window import normal_of

BOX = {"width_m": 4.0, "depth_m": 8.0, "height_m": 3.0}
GLASS = Glass(transmittance=0.88)


def named(things, name):
    return next(thing for thing in things if thing.name == name)


def test_six_sides_have_the_area_of_a_box():
    room = Room.shoebox(**BOX)
    assert {surface.name for surface in room.surfaces} == {"floor", "ceiling", "facade", "back", "left", "right"}
    assert float(np.sum(room.scene.areas)) == pytest.approx(2 * (4 * 8 + 4 * 3 + 8 * 3))


@pytest.mark.parametrize("wall", ["facade", "back", "left", "right", "ceiling"])
def test_windows_look_into_the_room(wall):
    room = Room.shoebox(**BOX, openings=[Opening(width_m=1.0, height_m=1.0, sill_m=1.0, wall=wall)])
    corners = np.array(room.windows[0].outline_m)
    inwards = np.array([2.0, 4.0, 1.5]) - corners.mean(axis=0)
    assert float(normal_of(corners) @ inwards) > 0.0


@pytest.mark.parametrize(("azimuth", "outside"), [(180, (0, -1)), (0, (0, 1)), (90, (1, 0)), (270, (-1, 0))])
def test_facade_looks_where_it_is_told(azimuth, outside):
    room = Room.shoebox(**BOX, openings=[Opening(width_m=1.0, height_m=1.0)], facade_azimuth_deg=azimuth)
    np.testing.assert_allclose(-normal_of(np.array(room.windows[0].outline_m))[:2], outside, atol=1e-12)


def test_parts_fill_the_window_from_the_top_down():
    opening = Opening(
        width_m=3.6, height_m=1.8, sill_m=0.9, parts=[Part(glazing=Open(), height_m=0.6), Part(glazing=GLASS)]
    )
    upper, lower = Room.shoebox(**BOX, openings=[opening]).windows
    assert (upper.glazing, lower.glazing) == (Open(), GLASS)
    heights = [sorted({corner[2] for corner in window.outline_m}) for window in (upper, lower)]
    np.testing.assert_allclose(heights, [[2.1, 2.7], [0.9, 2.1]])


def test_thick_wall_has_reveals_and_windows_outside():
    room = Room.shoebox(**BOX, openings=[Opening(width_m=1.0, height_m=2.0, sill_m=0.5)], wall_thickness_m=0.3)
    reveals = [surface for surface in room.surfaces if surface.name.endswith("reveal")]
    areas = dict(zip(room.scene.surfaces, np.asarray(room.scene.areas), strict=True))
    assert sum(areas[reveal.name] for reveal in reveals) == pytest.approx(0.3 * (1 + 2 + 1 + 2))
    assert {corner[1] for corner in room.windows[0].outline_m} == {-0.3}


@pytest.mark.parametrize(("tilt", "sign"), [(20.0, 1.0), (-20.0, -1.0)])
def test_tilted_part_swings_its_lower_edge_inwards(tilt, sign):
    opening = Opening(width_m=2.0, height_m=1.0, parts=[Part(glazing=GLASS, tilt_deg=tilt)])
    hanging, behind = Room.shoebox(**BOX, openings=[opening]).windows
    lowest = min(hanging.outline_m, key=lambda corner: corner[2])
    assert lowest[1] == pytest.approx(sign * np.sin(np.radians(20.0)))
    assert lowest[2] == pytest.approx(1.9 - np.cos(np.radians(20.0)))
    assert behind.glazing == Open()
    assert float(normal_of(np.array(hanging.outline_m))[1]) > 0.0


def test_obstructions_stand_outside():
    room = Room.shoebox(
        **BOX,
        facade_azimuth_deg=90.0,
        obstructions=[
            FacingBuilding(distance_m=10.0, height_m=12.0),
            Overhang(depth_m=1.0, height_m=2.8),
            LightShelf(
                height_m=2.0,
                outside_m=0.5,
                inside_m=0.4,
                material=Material(diffuse_reflectance=0, specular_reflectance=0.9),
            ),
            Louvres(bottom_m=1.0, top_m=2.0, count=6, depth_m=0.1, tilt_deg=30.0),
        ],
    )
    reach = {surface.name: [corner[0] for corner in surface.outline_m] for surface in room.surfaces}
    assert set(reach["building"]) == {10.0}
    assert max(reach["overhang"]) == pytest.approx(1.0)
    assert max(reach["light shelf 1"]) == pytest.approx(0.5)
    assert min(reach["light shelf 2"]) == pytest.approx(-0.4)
    slat = named(room.surfaces, "louvres 1").outline_m
    assert max(slat)[2] < min(slat)[2]  # the outer edge is the lower one
    assert sum(name.startswith("louvres") for name in reach) == 6


def test_other_glazings_leave_the_rest_alone():
    room = Room.shoebox(**BOX, openings=[Opening(width_m=1.0, height_m=1.0)])
    other = room.with_glazing({"window": Open()})
    assert other.windows[0].glazing == Open()
    assert other.surfaces == room.surfaces
    with pytest.raises(ClerestoryError, match=r"glazing must name windows of the room \(window\), got 'door'"):
        room.with_glazing({"door": Open()})


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"width_m": 0.0}, r"width_m must be greater than 0, got 0"),
        ({"height_m": float("nan")}, r"height_m must be finite, got nan"),
        ({"floor": 1.2}, r"floor reflectance must lie in 0..1, got 1.2"),
        ({"widht_m": 4.0}, r"a shoebox room must have the parameters of Shoebox"),
        (
            {"openings": [Opening(width_m=5.0, height_m=1.0)]},
            r"window 'window' must lie within its wall \(facade, 4 by 3 m\)",
        ),
        (
            {"openings": [Opening(width_m=1.0, height_m=1.0), Opening(width_m=1.0, height_m=1.0)]},
            r"openings must have names of their own, got 'window' 2 times",
        ),
    ],
)
def test_impossible_room_says_name_rule_and_value(values, message):
    with pytest.raises(ClerestoryError, match=message):
        Room.shoebox(**{**BOX, **values})


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"parts": [Part(glazing=GLASS, height_m=0.4)]}, r"must add up to equal to its height_m \(1\), got 0.4"),
        ({"parts": [Part(glazing=GLASS, height_m=1.4), Part(glazing=GLASS)]}, r"add up to less than its height_m"),
        ({"parts": [Part(glazing=GLASS), Part(glazing=GLASS)]}, r"must all but one have a height_m, got 2 without"),
        ({"parts": []}, r"parts of 'window' must hold at least one"),
        ({"wall": "door"}, r"wall of 'window' must be one of facade, back"),
    ],
)
def test_impossible_opening_says_name_rule_and_value(values, message):
    with pytest.raises(ClerestoryError, match=message):
        Opening(width_m=1.0, height_m=1.0, **values)


@pytest.mark.parametrize("values", [{"transmittance": 0.95}, {"transmittance": -0.1}])
def test_glass_cannot_pass_more_than_its_faces_let(values):
    with pytest.raises(ClerestoryError, match=r"transmittance must lie in 0..0.918"):
        Glass(**values)


def test_glazing_must_be_one():
    with pytest.raises(ClerestoryError, match=r"glazing of a part must be a glazing such as Glass"):
        Part(glazing=0.88)


def test_material_cannot_reflect_more_than_all():
    with pytest.raises(ClerestoryError, match=r"must be at most 1, got 0.8 \+ 0.3"):
        Material(diffuse_reflectance=0.8, specular_reflectance=0.3)


def test_empty_scene_is_an_error():
    with pytest.raises(ClerestoryError, match="a room must hold at least one surface"):
        Room()
