"""Scenes that cannot be are refused before any ray, by name and rule."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.glazing import Open
from clerestory.room import Interface, Material, Mesh, Room, Surface, Window

GREY = Material(diffuse_reflectance=0.5)
WALL = Surface(name="wall", outline_m=[[0, 0, 0], [4, 0, 0], [4, 0, 3], [0, 0, 3]], material=GREY)


def window(left, right, wall="wall"):
    outline = [[right, 0, 1], [left, 0, 1], [left, 0, 2], [right, 0, 2]]
    return Window(name="pane", outline_m=outline, glazing=Open(), wall=wall)


def block(name, outside, inside, low, high):
    import trimesh

    solid = trimesh.creation.box(bounds=[[low] * 3, [high] * 3])
    return Interface(
        name=name, vertices_m=solid.vertices, triangles=solid.faces, front_index=outside, back_index=inside
    )


def test_a_window_within_its_wall_cuts_its_own_hole():
    scene = Room(surfaces=(WALL,), windows=(window(1.0, 2.0),)).scene
    assert dict(zip(scene.surfaces, np.asarray(scene.areas), strict=True)) == pytest.approx({"wall": 11.0, "pane": 1.0})


@pytest.mark.parametrize(
    ("things", "message"),
    [
        ({"windows": (window(3.0, 5.0),)}, r"wall: pane must lie wholly inside the outline"),
        ({"windows": (window(1.0, 2.0, wall="wal"),)}, r"pane: its wall must be a polygon of the scene, got \"wal\""),
        ({"windows": (window(1.0, 2.0), window(2.0, 3.0))}, r"name of its own, got 'pane' twice"),
        ({"interfaces": (block("glass", 1.0, 1.5, 1.0, 3.0), block("core", 1.3, 1.6, 1.5, 2.0))}, r"media must nest"),
    ],
)
def test_what_does_not_fit_together_is_named(things, message):
    with pytest.raises(ClerestoryError, match=message):
        _ = Room(surfaces=(WALL,), **things).scene


def test_media_that_nest_are_a_scene():
    nested = (block("glass", 1.0, 1.5, 1.0, 3.0), block("core", 1.5, 1.6, 1.5, 2.0))
    assert Room(surfaces=(WALL,), interfaces=nested).scene.kinds == ["opaque", "interface", "interface"]


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (
            {"vertices_m": [[0, 0, np.nan], [1, 0, 0], [0, 1, 0]]},
            r"vertices_m of 'sail' must be finite, got \[0.0, 0.0, nan\]",
        ),
        ({"triangles": [[0, 1, 3]]}, r"triangles of 'sail' must count from 0 to 2, got 0..3"),
        ({"triangles": []}, r"triangles of 'sail' must"),
        ({"triangles": [[0.5, 1, 2]]}, r"triangles of 'sail' must be rows of 3 whole numbers"),
        ({"material": 0.5}, r"material of 'sail' must be a Material"),
        ({"name": " "}, r"name must be a word or more on one line"),
    ],
)
def test_broken_meshes_are_named(values, message):
    whole = {"name": "sail", "vertices_m": np.eye(3), "triangles": [[0, 1, 2]], "material": GREY}
    with pytest.raises(ClerestoryError, match=message):
        Mesh(**{**whole, **values})


def test_no_index_below_that_of_nothing():
    with pytest.raises(ClerestoryError, match=r"back_index of 'prism' must lie in 1..5, got 0.9"):
        Interface(name="prism", vertices_m=np.eye(3), triangles=[[0, 1, 2]], back_index=0.9)
