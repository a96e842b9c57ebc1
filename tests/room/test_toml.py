"""A room as one TOML file."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass, Open, Slab, Stack
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel
from clerestory.room import (
    FacingBuilding,
    Interface,
    Material,
    Mesh,
    Opening,
    Overhang,
    Part,
    Room,
    SensorGrid,
    Sensors,
)
from clerestory.room.toml_file import read_room
from clerestory.room.toml_text import room_to_toml, write_room
from clerestory.site import Site

CLASSROOM = """
name = "Classroom"
ground_reflectance = 0.25
[site]
latitude_deg = -9.67
longitude_deg = -35.74
timezone = "America/Maceio"
[materials.plaster]
diffuse_reflectance = 0.7
[glazings.glass]
kind = "glass"
transmittance = 0.88
[glazings.double]
kind = "slab"
refractive_index = 1.52
thickness_mm = 6.0
[shoebox]
width_m = 4
depth_m = 8
height_m = 3
walls = "plaster"
wall_thickness_m = 0.2
[[shoebox.opening]]
width_m = 3.6
height_m = 1.8
[[shoebox.opening.part]]
glazing = "double"
height_m = 0.6
[[shoebox.opening.part]]
glazing = "glass"
[[obstruction]]
kind = "overhang"
depth_m = 1.0
height_m = 2.8
[[sensors]]
spacing_m = 0.5
[calculation]
basis = "tregenza145"
"""


def written(tmp_path, text, name="room.toml"):
    path = tmp_path / name
    path.write_text(text)
    return path


def test_file_is_the_room_it_describes(tmp_path):
    glass = Glass(transmittance=0.88)
    double = Slab(refractive_index=1.52, thickness_mm=6.0)
    assert read_room(written(tmp_path, CLASSROOM)) == Room.shoebox(
        name="Classroom",
        ground_reflectance=0.25,
        site=Site(latitude_deg=-9.67, longitude_deg=-35.74, timezone="America/Maceio"),
        width_m=4,
        depth_m=8,
        height_m=3,
        walls=Material(diffuse_reflectance=0.7),
        wall_thickness_m=0.2,
        openings=[Opening(width_m=3.6, height_m=1.8, parts=[Part(glazing=double, height_m=0.6), Part(glazing=glass)])],
        obstructions=[Overhang(depth_m=1.0, height_m=2.8)],
        sensors=[SensorGrid(spacing_m=0.5)],
    )


def test_round_trip_keeps_everything(tmp_path):
    triangle = {"vertices_m": np.array([[0, 1, 0], [1, 1, 0], [0, 2, 1 / 3]]), "triangles": np.array([[0, 1, 2]])}
    shoebox = Room.shoebox(
        width_m=3.7,
        depth_m=5.3,
        height_m=2.9,
        facade_azimuth_deg=33.0,
        openings=[
            Opening(
                width_m=2.0,
                height_m=1.5,
                parts=[Part(glazing=Slab(refractive_index=1.49, thickness_mm=6.0), tilt_deg=10.0, behind=Open())],
            )
        ],
        obstructions=[FacingBuilding(distance_m=8.0, height_m=9.0)],
        site=Site(latitude_deg=1.5, longitude_deg=2.5, elevation_m=3.5, timezone="-03:00"),
    )
    room = Room(
        surfaces=shoebox.surfaces,
        windows=shoebox.windows,
        meshes=(Mesh(name="sail", material=Material(diffuse_reflectance=0.1, specular_reflectance=0.6), **triangle),),
        interfaces=(Interface(name="prism", back_index=1.49, back_absorption_per_m=0.3, **triangle),),
        sensors=(
            SensorGrid(spacing_m=0.3, offset_m=0.4),
            Sensors(points_m=[[1, 1, 1]], normals=[[0, 1, 1]], name="eye"),
        ),
        site=shoebox.site,
        name="all of it",
    )
    path = tmp_path / "room.toml"
    write_room(room, path)
    assert read_room(path) == room
    assert room_to_toml(read_room(path)) == room_to_toml(room)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("width_m = 4\n", "widht_m = 4\n", r"\[shoebox\] of room.toml must .* got widht_m; did you mean width_m\?"),
        ("width_m = 4\n", "", r"\[shoebox\] of room.toml must have width_m"),
        ("width_m = 4\n", 'width_m = "four"\n', r"\[shoebox\] of room.toml: width_m must be a number, got 'four'"),
        (
            'glazing = "double"',
            'glazing = "dubble"',
            r"must be one of glass, double, got 'dubble'; did you mean 'double'",
        ),
        ('walls = "plaster"', 'walls = "brick"', r"material in room.toml must be one of plaster, got 'brick'"),
        (
            'kind = "glass"',
            'kind = "glas"',
            r"kind of \[glass\] in .* must be one of open, .* did you mean 'glass'",
        ),
        ("transmittance = 0.88", "transmittance = 1.2", r"\[glass\] in .* transmittance must lie in 0..0.918"),
        ("[[sensors]]", "[[sensor]]", r"room.toml must hold only .* got sensor; did you mean sensors\?"),
        ("[site]", "[site", r"room.toml must be TOML: .*line 4"),
        ("height_m = 3\n", "height_m = 2\n", r"window 'window' must lie within its wall"),
        (
            "diffuse_reflectance = 0.7",
            "diffuse_reflectance = 1.7",
            r"\[materials.plaster\] .* must lie in 0..1, got 1.7",
        ),
    ],
)
def test_mistakes_name_table_key_and_rule(tmp_path, old, new, message):
    assert old in CLASSROOM
    with pytest.raises(ClerestoryError, match=message):
        read_room(written(tmp_path, CLASSROOM.replace(old, new, 1)))


def test_file_that_is_not_there_or_no_text_is_an_error(tmp_path):
    with pytest.raises(ClerestoryError, match=r"nowhere.toml must be a readable file"):
        read_room(tmp_path / "nowhere.toml")
    (tmp_path / "noise.toml").write_bytes(bytes(range(128, 256)))
    with pytest.raises(ClerestoryError, match=r"noise.toml must be TOML"):
        read_room(tmp_path / "noise.toml")


def test_panels_fill_windows_from_tables_and_files(tmp_path):
    panel = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, medium=Medium.named("pmma"))
    panel.to_toml(tmp_path / "panel.toml")
    here = CLASSROOM.replace(
        'kind = "slab"\nrefractive_index = 1.52', 'kind = "laser-cut"\nspacing_mm = 4.0\nmedium = "pmma"'
    )
    beside = CLASSROOM.replace('kind = "slab"\nrefractive_index = 1.52\nthickness_mm = 6.0', 'file = "panel.toml"')
    rooms = [read_room(written(tmp_path, text, name)) for text, name in ((here, "a.toml"), (beside, "b.toml"))]
    for room in rooms:
        assert room.windows[0].glazing == panel
        assert read_room(written(tmp_path, room_to_toml(room))) == room
    assert len(rooms[0].scene.surfaces) == len(rooms[0].surfaces) + 2


def test_mistakes_in_a_panel_name_its_table(tmp_path):
    text = CLASSROOM.replace('kind = "slab"\nrefractive_index = 1.52', 'kind = "laser-cut"\nspacing_mm = -4.0')
    with pytest.raises(ClerestoryError, match=r"\[double\] in \[glazings\] of room.toml: spacing_mm"):
        read_room(written(tmp_path, text))


def test_a_panel_stands_between_panes(tmp_path):
    slab = 'kind = "slab"\nrefractive_index = 1.52\nthickness_mm = 6.0'
    panel = '[glazings.panel]\nkind = "laser-cut"\nspacing_mm = 4.0\nthickness_mm = 6.0'
    stacked = f'kind = "stack"\nlayers = ["glass", "panel"]\n{panel}'
    room = read_room(written(tmp_path, CLASSROOM.replace(slab, stacked)))
    layers = (Glass(transmittance=0.88), LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0))
    assert room.windows[0].glazing == Stack(layers)
    assert read_room(written(tmp_path, room_to_toml(room))) == room
    assert "window 1" in room.scene.surfaces


@pytest.mark.parametrize("layers", [(), (0.88,)])
def test_a_stack_of_nothing_is_an_error(layers):
    with pytest.raises(ClerestoryError, match="layers"):
        Stack(layers)
