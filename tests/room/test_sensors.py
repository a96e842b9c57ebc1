"""Sensors: grids, points, and places where no one would put one."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.room import Material, Mesh, Opening, Room, SensorGrid, Sensors, Surface
from clerestory.room.whereabouts import misplaced_sensors

ROOM = Room.shoebox(width_m=4.0, depth_m=8.0, height_m=3.0, openings=[Opening(width_m=3.6, height_m=1.8)])
WHITE = Material(diffuse_reflectance=0.8)


def box(low, high, name="box"):
    import trimesh

    solid = trimesh.creation.box(bounds=[low, high])
    return Mesh(name=name, vertices_m=solid.vertices, triangles=solid.faces, material=WHITE)


def test_half_metre_grid_of_a_classroom_has_128_sensors():
    (grid,) = ROOM.sensor_points(SensorGrid(spacing_m=0.5))
    assert len(grid) == 128
    np.testing.assert_allclose(grid.points_m[0], [0.25, 0.25, 0.8])
    np.testing.assert_allclose(grid.points_m[-1], [3.75, 7.75, 0.8])
    np.testing.assert_array_equal(grid.normals, np.tile([0.0, 0.0, 1.0], (128, 1)))


def test_grid_on_the_ceiling_faces_down_when_flipped():
    (grid,) = ROOM.sensor_points(SensorGrid(spacing_m=1.0, height_m=0.0, surface="ceiling", flip=True))
    np.testing.assert_allclose(grid.normals[0], [0.0, 0.0, -1.0])
    assert (grid.points_m[:, 2] < 3.0).all()


def test_grid_keeps_off_the_edges_of_an_odd_floor():
    floor = Surface(
        name="floor", outline_m=[[0, 0, 0], [4, 0, 0], [4, 2, 0], [2, 2, 0], [2, 4, 0], [0, 4, 0]], material=WHITE
    )
    (grid,) = Room(surfaces=(floor,)).sensor_points(SensorGrid(spacing_m=0.25, offset_m=0.5))
    x, y = grid.points_m[:, 0], grid.points_m[:, 1]
    assert len(grid) > 40
    assert ((x >= 0.5) & (y >= 0.5) & ((x <= 1.5) | (y <= 1.5))).all()
    # nearest to the inner corner (2, 2), not only to the straight edges
    assert np.hypot(np.minimum(x - 2.0, 0.0), np.minimum(y - 2.0, 0.0)).min() >= 0.5 - 1e-9


def test_normals_become_unit_vectors():
    one = Sensors(points_m=[[0, 0, 1]], normals=[[0, 3, 4]])
    np.testing.assert_allclose(one.normals, [[0.0, 0.6, 0.8]])


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"points_m": []}, r"points_m of 'sensors' must be a list of points|must hold at least one"),
        ({"points_m": [[0, 0]]}, r"points_m of 'sensors' must be a list of points of 3 numbers"),
        ({"points_m": [[0, 0, np.nan]]}, r"points_m of 'sensors' must be finite"),
        ({"points_m": [[0, 0, 0]], "normals": [0, 0, 0]}, r"normals of 'sensors' must have a length"),
        ({"points_m": [[0, 0, 0], [1, 0, 0]], "normals": [[0, 0, 1]]}, r"must be one for each of its 2 points, got 1"),
    ],
)
def test_wrong_points_say_name_rule_and_value(values, message):
    with pytest.raises(ClerestoryError, match=message):
        Sensors(**values)


def test_grid_on_nothing_and_grid_without_room_are_errors():
    with pytest.raises(ClerestoryError, match="surface of a sensor grid must be one of floor"):
        ROOM.sensor_points(SensorGrid(spacing_m=0.5, surface="flor"))
    with pytest.raises(ClerestoryError, match="must leave room for a sensor"):
        ROOM.sensor_points(SensorGrid(spacing_m=9.0))
    with pytest.raises(ClerestoryError, match="groups of sensors must have names of their own, got 'floor' twice"):
        ROOM.sensor_points([SensorGrid(spacing_m=0.5), SensorGrid(spacing_m=1.0)])


def test_sensors_outside_the_room_are_told():
    inside = Sensors(points_m=[[2, 4, 1]], name="in")
    outside = Sensors(points_m=[[2, 4, 1], [2, -9, 5]], name="out")
    assert misplaced_sensors(ROOM, [inside]) == []
    (sentence,) = misplaced_sensors(ROOM, [inside, outside])
    assert sentence == "1 of 2 sensors of 'out' stand outside the room, the first at (2, -9, 5) m"


def test_sensors_inside_a_solid_are_told():
    from dataclasses import replace

    room = replace(ROOM, meshes=(box([1, 1, 0], [2, 2, 1], name="desk"),))
    asked = Sensors(points_m=[[1.5, 1.5, 0.5], [1.5, 1.5, 1.5], [3.0, 1.5, 0.5]])
    (sentence,) = misplaced_sensors(room, [asked])
    assert sentence.startswith(
        "1 of 3 sensors of 'sensors' stand inside the solid 'desk', the first at (1.5, 1.5, 0.5)"
    )


def test_unobstructed_sensors_are_no_mistake():
    plate = Room(surfaces=(Surface(name="plate", outline_m=[[0, 0, -1], [1, 0, -1], [1, 1, -1]], material=WHITE),))
    assert misplaced_sensors(plate, [Sensors(points_m=[[0, 0, 5]])]) == []
