"""Meshes and Radiance scenes from files."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass
from clerestory.room import Material
from clerestory.room.mesh_file import read_meshes
from clerestory.room.radiance_file import read_radiance
from clerestory.room.toml_file import read_room

WHITE, RED = Material(diffuse_reflectance=0.8), Material(diffuse_reflectance=0.3)
RADIANCE = """# a wall with a hole in it, and a pane
void plastic plaster
0
0
5 0.5 0.5 0.5 0.02 0
void glass clear
0
0
3 0.96 0.96 0.96
void mirror silver 0 0 3 0.9 0.9 0.9
plaster polygon wall
0
0
30 0 0 0  4 0 0  4 0 3  0 0 3  0 0 0  1 0 1  1 0 2  3 0 2  3 0 1  1 0 1
clear polygon pane
0 0 12  1 0 1  3 0 1  3 0 2  1 0 2
silver polygon shelf
0 0 9  0 1 2  1 1 2  1 2 2
"""


@pytest.mark.parametrize("ending", ["obj", "stl", "glb"])
def test_box_comes_through_every_format(tmp_path, ending):
    import trimesh

    solid = trimesh.creation.box(bounds=[[0, 0, 0], [1, 2, 3]])
    path = tmp_path / f"box.{ending}"
    solid.export(path)
    (mesh,) = read_meshes(path, material=WHITE, up_axis="z", scale=0.001)
    np.testing.assert_allclose(mesh.vertices_m.min(axis=0), [0, 0, 0], atol=1e-9)
    np.testing.assert_allclose(mesh.vertices_m.max(axis=0), [0.001, 0.002, 0.003], rtol=1e-6)
    assert len(mesh.triangles) == 12


def test_gltf_stands_up_by_itself(tmp_path):
    import trimesh

    path = tmp_path / "pole.glb"
    trimesh.creation.box(bounds=[[0, 0, 0], [1, 5, 1]]).export(path)
    (mesh,) = read_meshes(path, material=WHITE)
    np.testing.assert_allclose(mesh.vertices_m.max(axis=0), [1, 0, 5], atol=1e-6)


def test_materials_go_by_object_or_material_name(tmp_path):
    path = tmp_path / "two.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl wood\nf 1 2 3\nusemtl steel\nf 1 2 4\n")
    meshes = read_meshes(path, materials={"wood": RED, "steel": WHITE})
    assert {mesh.material for mesh in meshes} == {RED, WHITE}
    with pytest.raises(ClerestoryError, match=r"materials must name .*steel.* of two.obj, got wood"):
        read_meshes(path, materials={"wood": RED})


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("noise.stl", b"not a mesh at all", r"noise.stl must"),
        ("empty.obj", b"# nothing\n", r"empty.obj must"),
        ("nan.obj", b"v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", r"vertices_m of .* must be finite"),
        ("noise.glb", b"glTF?", r"noise.glb must be what its name says"),
        ("room.dwg", b"", r"ending of room.dwg must be one of .obj"),
    ],
)
def test_file_that_is_not_what_its_name_says_is_an_error(tmp_path, name, content, message):
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(ClerestoryError, match=message):
        read_meshes(path, material=WHITE)


def test_radiance_polygons_with_seams_glass_and_mirrors(tmp_path):
    path = tmp_path / "wall.rad"
    path.write_text(RADIANCE)
    (wall, shelf), (pane,) = read_radiance(path)
    assert wall.material == Material(diffuse_reflectance=0.5 * 0.98, specular_reflectance=0.02)
    assert len(wall.outline_m) == 4
    assert [len(hole) for hole in wall.holes_m] == [4]
    assert shelf.material.specular_reflectance == pytest.approx(0.9)
    # transmissivity 0.96 is a transmittance of 0.88 (Radiance's own formula for n = 1.52)
    transmittance = pane.glazing.transmittance
    transmissivity = (
        (np.sqrt(0.8402528435 + 0.0072522239 * transmittance**2) - 0.9166530661) / 0.0036261119 / transmittance
    )
    assert isinstance(pane.glazing, Glass)
    assert transmissivity == pytest.approx(0.96, abs=1e-6)


def test_radiance_material_map_comes_first(tmp_path):
    path = tmp_path / "wall.rad"
    path.write_text(RADIANCE)
    surfaces, windows = read_radiance(path, materials={"plaster": RED, "clear": WHITE})
    assert [surface.material for surface in surfaces][:2] == [RED, WHITE]
    assert windows == []


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("clear polygon pane", "claer polygon pane", r"wall.rad, line 15: material 'claer' must be defined"),
        ("polygon wall", "sphere wall", r"wall.rad, line 11: primitives must be polygons"),
        ("0 0 12  1", "0 0 14  1", r"wall.rad, line 15: "),
        ("0 0 9  0 1 2", "0 0 9  0 one 2", r"wall.rad, line 17: a primitive must be"),
        ("# a wall", "!genbox a b 1 2 3\n# a wall", r"wall.rad, line 1: commands are not run"),
    ],
)
def test_mistakes_in_radiance_files_have_a_line(tmp_path, old, new, message):
    assert old in RADIANCE
    path = tmp_path / "wall.rad"
    path.write_text(RADIANCE.replace(old, new))
    with pytest.raises(ClerestoryError, match=message):
        read_radiance(path)


def test_files_join_a_room_through_toml(tmp_path):
    import trimesh

    (tmp_path / "wall.rad").write_text(RADIANCE)
    trimesh.creation.box(bounds=[[0, 3, 0], [1, 4, 1]]).export(tmp_path / "desk.stl")
    (tmp_path / "room.toml").write_text(
        '[[radiance]]\nfile = "wall.rad"\nmaterials = { plaster = 0.3 }\n[[mesh]]\nfile = "desk.stl"\nmaterial = 0.5\n'
    )
    room = read_room(tmp_path / "room.toml")
    assert room.surfaces[0].material == RED
    assert [window.name for window in room.windows] == ["pane"]
    assert len(room.meshes) == 1
