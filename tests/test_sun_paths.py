"""The sun's way through windows: laws that hold for any room, and places that trigonometry knows."""

import re
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import clerestory
from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass, Open, PlainTransmittance, Stack
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel, PrismaticPanel
from clerestory.room import (
    FacingBuilding,
    Interface,
    LightShelf,
    Louvres,
    Material,
    Mesh,
    Opening,
    Overhang,
    Part,
    Room,
    SensorGrid,
    Sensors,
    Surface,
    Window,
    beams,
)
from clerestory.sun import direction_of
from clerestory.sun_coefficients import SunWarning, sun_coefficients
from clerestory.sun_paths import sun_paths

PANEL = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, medium=Medium(n=1.49))

PRISMS = PrismaticPanel(pitch_mm=2.0, lower_deg=45.0, upper_deg=60.0, base_mm=2.0, medium=Medium(n=1.49))


def room(glazing, *, wall_thickness_m=0.0, obstructions=(), **opening):
    given = {"width_m": 2.0, "height_m": 1.0, "sill_m": 1.5} | opening
    return Room.shoebox(
        width_m=4.0,
        depth_m=6.0,
        height_m=3.0,
        wall_thickness_m=wall_thickness_m,
        openings=[Opening(parts=[Part(glazing=glazing)], name="window", **given)],
        obstructions=obstructions,
    )


def corners(found, row):
    places = found["patch_corner_m"].values[row]
    return places[~np.isnan(places[:, 0])]


def inside(found, row, points):
    """Which points, on a patch's plane, lie in it."""
    ring = corners(found, row)
    normal = np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0)
    edges = np.roll(ring, -1, axis=0) - ring
    sides = np.einsum("pek,ek->pe", points[:, None] - ring, np.cross(normal, edges))
    return (sides > 0.0).all(axis=1)


def lit(found, surface, points):
    """Whether each point of a surface lies in one of its patches."""
    rows = np.flatnonzero(found["patch_surface"].values == surface)
    return np.any([inside(found, row, points) for row in rows] or [np.zeros(len(points), bool)], axis=0)


def test_a_patch_through_an_opening_lies_where_trigonometry_says():
    """Light from the south at 40° falls by tan 40° a metre: window heights become depths, strengths sines."""
    found = clerestory.sun_paths(room(Open()), altitude_deg=40.0, azimuth_deg=180.0)
    floor = found["patch_surface"].values == "floor"
    places = np.concatenate([corners(found, row) for row in np.flatnonzero(floor)])
    tangent = np.tan(np.radians(40.0))
    np.testing.assert_allclose([places[:, 0].min(), places[:, 0].max()], [1.0, 3.0], atol=1e-9)
    np.testing.assert_allclose([places[:, 1].min(), places[:, 1].max()], [1.5 / tangent, 2.5 / tangent], atol=1e-9)
    assert float(found["patch_area_m2"].values[floor].sum()) == pytest.approx(2.0 / tangent)
    np.testing.assert_allclose(found["patch_strength"].values[floor], np.sin(np.radians(40.0)))
    assert set(found["patch_surface"].values) == {"floor"}


def test_a_redirected_patch_lies_on_the_ceiling_where_the_mirrored_beam_goes():
    found = sun_paths(room(PANEL), altitude_deg=50.0, azimuth_deg=180.0)
    turned = np.flatnonzero(found["beam_kind"].values == "redirected")
    strongest = turned[np.argmax(found["beam_power"].values[turned])]
    # the panel's cuts are level: the beam's height turns, its depth stays
    towards = direction_of(50.0, 180.0)
    np.testing.assert_allclose(found["beam_direction"].values[strongest], -towards * [1, 1, -1], atol=1e-9)
    rows = np.flatnonzero((found["patch_beam"].values == strongest) & (found["patch_surface"].values == "ceiling"))
    depths = np.concatenate([corners(found, row)[:, 1] for row in rows])
    tangent = np.tan(np.radians(50.0))
    np.testing.assert_allclose([depths.min(), depths.max()], [0.5 / tangent, 1.5 / tangent], atol=1e-9)
    lobes = PANEL.lobes(elevation_deg=50.0)
    up = (lobes.side == "back") & (lobes.elevation_deg > 0.0)
    assert float(found["beam_power"][strongest]) == pytest.approx(float(lobes.power.where(up, 0.0).max()), abs=1e-4)


ROOMS = {
    "panel": room(PANEL, wall_thickness_m=0.2),
    "prisms": room(PRISMS),
    "stack": room(Stack((Glass(transmittance=0.88), PANEL))),
    "louvres": room(
        Open(),
        wall_thickness_m=0.1,
        obstructions=[Louvres(bottom_m=1.5, top_m=2.5, count=6, depth_m=0.12), Overhang(depth_m=0.5, height_m=2.8)],
    ),
    "mirror": room(
        Open(),
        obstructions=[
            LightShelf(
                height_m=2.0,
                outside_m=0.3,
                inside_m=0.8,
                material=Material(diffuse_reflectance=0.1, specular_reflectance=0.8),
            )
        ],
    ),
    "furnished": replace(
        room(Glass(transmittance=0.88)),
        meshes=(
            Mesh(
                name="table",
                vertices_m=np.array([[1.2, 1.0, 0.7], [2.6, 1.2, 0.7], [2.2, 2.4, 0.7], [1.0, 2.0, 0.9]]),
                triangles=np.array([[0, 1, 2], [0, 2, 3]]),
                material=Material(diffuse_reflectance=0.4),
            ),
        ),
    ),
    "tilted": Room.shoebox(
        width_m=4.0,
        depth_m=6.0,
        height_m=3.0,
        openings=[
            Opening(width_m=2.0, height_m=1.0, sill_m=1.8, name="window", parts=[Part(glazing=PANEL, tilt_deg=15.0)])
        ],
    ),
}


@pytest.mark.parametrize("name", ROOMS)
@pytest.mark.parametrize(("altitude", "azimuth"), [(50.0, 180.0), (31.0, 205.0)])
def test_a_sensor_is_lit_where_the_patches_are(name, altitude, azimuth):
    """Patches are found by cutting polygons, `sun_coefficients` by looking back along rays: they say the same."""
    one = ROOMS[name]
    found = sun_paths(one, altitude_deg=altitude, azimuth_deg=azimuth, least_power=1e-7)
    for surface, flip in (("floor", False), ("ceiling", True), ("right", False)):
        grid = SensorGrid(spacing_m=0.2, height_m=0.0, surface=surface, flip=flip)
        (placed,) = one.sensor_points(grid)
        sun = sun_coefficients(one, grid, altitude_deg=altitude, azimuth_deg=azimuth, rounds=8, max_bounces=0)
        share = (sun.direct + sun.redirected).values[:, 0]
        rows = np.flatnonzero(found["patch_surface"].values == surface)
        own = np.zeros(len(placed))
        for row in rows:
            own += found["patch_strength"].values[row] * inside(found, row, placed.points_m)
        # a sensor near an edge sees part of the disc
        partly = np.abs(share - own) > 0.03 * max(own.max(), 1e-9) + 1e-4
        edge = np.any([_near_edge(found, row, placed.points_m) for row in rows] or [np.zeros(len(own), bool)], axis=0)
        assert not (partly & ~edge).any(), (surface, placed.points_m[partly & ~edge][:3])
        # prisms have beams weaker than least_power
        assert (share[~edge & (own == 0.0)] < 1e-5).all()
        assert (share[~edge & (own > 1e-5)] > 0.0).all()


def _near_edge(found, row, points):
    ring = corners(found, row)
    steps = np.roll(ring, -1, axis=0) - ring
    offset = points[:, None] - ring
    along = np.clip((offset * steps).sum(axis=2) / (steps**2).sum(axis=1), 0.0, 1.0)
    return (np.linalg.norm(offset - along[..., None] * steps, axis=2) < 0.045).any(axis=1)


@pytest.mark.parametrize("name", ROOMS)
def test_the_light_of_a_beam_lands_whole(name):
    """Area times strength of its patches is what its piece of the window lets through; none is lost or doubled."""
    one = ROOMS[name]
    found = sun_paths(one, altitude_deg=47.0, azimuth_deg=190.0, least_power=1e-4)
    towards = direction_of(47.0, 190.0)
    names = [window.name for window in one.windows]
    for beam in range(found.sizes["beam"]):
        rows = found["patch_beam"].values == beam
        flux = float((found["patch_area_m2"].values * found["patch_strength"].values)[rows].sum())
        if str(found["beam_source"].values[beam]) not in names or "reflected" in found["beam_kind"].values[beam]:
            continue
        window = one.windows[names.index(str(found["beam_source"].values[beam]))]
        ring = np.array(window.outline_m)
        area = 0.5 * np.linalg.norm(np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0))
        share = float(found["sunlit_share"].sel(window=found["beam_window"].values[beam]))
        most = float(found["beam_power"][beam]) * area * share * abs(_cos(ring, towards))
        if name in ("tilted", "mirror"):
            assert flux < most + 1e-9
        else:
            assert flux == pytest.approx(most, rel=1e-6)


@pytest.mark.parametrize("name", ROOMS)
def test_a_patch_lies_where_its_corners_on_the_window_are_thrown(name):
    one = ROOMS[name]
    found = sun_paths(one, altitude_deg=47.0, azimuth_deg=190.0, least_power=1e-4)
    rings = {window.name: np.array(window.outline_m) for window in one.windows}
    seen = 0
    for row, beam in enumerate(found["patch_beam"].values):
        ring = rings.get(str(found["beam_source"].values[beam]))
        if ring is None:
            continue
        source, count = found["patch_source_m"].values[row], len(corners(found, row))
        normal = np.cross(ring[1] - ring[0], ring[2] - ring[1])
        np.testing.assert_allclose((source[:count] - ring[0]) @ normal, 0.0, atol=1e-6)
        way, direction = corners(found, row) - source[:count], found["beam_direction"].values[beam]
        np.testing.assert_allclose(np.cross(way, direction), 0.0, atol=1e-6)
        # light may graze the sill or the jamb
        assert (way @ direction > -1e-9).all()
        seen += 1
    assert seen


def _cos(ring, towards):
    normal = np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0)
    return float(normal @ towards / np.linalg.norm(normal))


@pytest.mark.parametrize("name", ROOMS)
def test_power_along_a_path_never_grows_and_begins_with_the_lobes(name):
    found = sun_paths(ROOMS[name], altitude_deg=44.0, azimuth_deg=170.0, bounces=3, least_power=1e-3)
    power, count = found["power"].values, found["vertices"].values
    assert len(count) > 0
    for row, n in enumerate(count):
        assert (np.diff(power[row, :n]) <= 1e-12).all()
        assert np.isnan(power[row, n:]).all()
        assert power[row, 0] == power[row, 1] == 1.0
    assert set(found["event"].values[:, 0]) == {"sun"}
    assert set(found["event"].values[:, 1]) == ({"glazing", "mirror"} if name == "mirror" else {"glazing"})


def test_what_enters_is_the_sum_of_the_lobes():
    found = sun_paths(room(PANEL), altitude_deg=44.0, azimuth_deg=200.0, least_power=1e-6)
    assert float(found["beam_power"].sum()) == pytest.approx(float(found["entering"][0]), abs=1e-5)
    assert float(found["cos_incidence"][0]) == pytest.approx(-direction_of(44.0, 200.0)[1])
    assert 0.5 < float(found["entering"][0]) < 1.0


def test_paths_end_in_patches():
    """Where the ray of a path first meets a diffuse surface, a patch lies."""
    one = ROOMS["furnished"]
    found = sun_paths(one, altitude_deg=50.0, azimuth_deg=190.0, points=200)
    event, place, surface = found["event"].values, found["position_m"].values, found["surface"].values
    assert (event[:, 2] == "diffuse").all()
    for name in np.unique(surface[:, 2]):
        assert lit(found, name, place[surface[:, 2] == name, 2]).all()
    assert "table" in surface[:, 2]


def test_paths_go_on_by_the_cosine():
    """Many directions from one spot: their mean leans along the normal by two thirds, as the cosine law has it."""
    found = sun_paths(room(Open()), altitude_deg=50.0, azimuth_deg=180.0, points=1000)
    place = found["position_m"].values
    way = place[:, 3] - place[:, 2]
    mean = (way / np.linalg.norm(way, axis=1, keepdims=True)).mean(axis=0)
    np.testing.assert_allclose(mean, [0.0, 0.0, 2.0 / 3.0], atol=0.01)


def test_an_obstruction_blocks_the_sun_and_is_named():
    building = FacingBuilding(distance_m=5.0, height_m=9.0)
    free, hidden = (
        sun_paths(room(Open(), obstructions=these), altitude_deg=30.0, azimuth_deg=180.0) for these in ((), [building])
    )
    assert float(free["sunlit_share"][0]) == 1.0
    assert free["blocked_by"].values.tolist() == [""]
    assert float(hidden["sunlit_share"][0]) == 0.0
    assert hidden["blocked_by"].values.tolist() == ["building"]
    assert hidden.sizes["path"] == hidden.sizes["beam"] == hidden.sizes["patch"] == 0
    # an overhang 0.5 m deep, 0.5 m above the head, shades the window below a line that drops by tan 60°
    shaded = sun_paths(
        room(Open(), obstructions=[Overhang(depth_m=0.5, height_m=3.0)]), altitude_deg=60.0, azimuth_deg=180.0
    )
    assert float(shaded["sunlit_share"][0]) == pytest.approx(1.0 - (0.5 * np.tan(np.radians(60.0)) - 0.5), abs=1e-9)
    assert shaded["blocked_by"].values.tolist() == ["overhang"]


@pytest.mark.parametrize(("altitude", "azimuth"), [(40.0, 0.0), (-5.0, 180.0), (0.0, 180.0)])
def test_a_sun_behind_the_facade_or_below_the_horizon_lights_nothing(altitude, azimuth):
    found = sun_paths(room(Open()), altitude_deg=altitude, azimuth_deg=azimuth)
    assert found.sizes["path"] == found.sizes["beam"] == found.sizes["patch"] == 0
    assert float(found["sunlit_share"][0]) == 0.0


def test_a_light_shelf_that_is_a_mirror_throws_a_patch_on_the_ceiling():
    shelf = LightShelf(height_m=2.0, inside_m=0.8, material=Material(diffuse_reflectance=0.1, specular_reflectance=0.8))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = sun_paths(room(Open(), obstructions=[shelf]), altitude_deg=45.0, azimuth_deg=180.0)
    mirrored = np.flatnonzero(found["beam_kind"].values == "reflected")
    assert len(mirrored) == 1
    np.testing.assert_allclose(found["beam_direction"].values[mirrored[0]], [0.0, 0.5**0.5, 0.5**0.5], atol=1e-12)
    assert float(found["beam_power"][mirrored[0]]) == pytest.approx(0.8)
    rows = np.flatnonzero(found["patch_beam"].values == mirrored[0])
    assert set(found["patch_surface"].values[rows]) == {"ceiling"}
    # light that comes through at height z meets the shelf z - 2 behind the window and the ceiling 1 m beyond
    depths = np.concatenate([corners(found, row)[:, 1] for row in rows])
    np.testing.assert_allclose([depths.min(), depths.max()], [1.0, 1.5], atol=1e-9)
    assert "mirror" in found["event"].values
    assert "reflected" in found["path_kind"].values


def test_beams_go_by_a_second_window():
    """A partition of plain glass behind the window takes its share, and its frame the rest."""
    behind = Window(
        name="partition",
        outline_m=[(0.0, 1.0, 0.0), (4.0, 1.0, 0.0), (4.0, 1.0, 3.0), (0.0, 1.0, 3.0)][::-1],
        glazing=PlainTransmittance(transmittance=0.6),
    )
    plain = room(PlainTransmittance(transmittance=0.5))
    both = replace(plain, windows=(*plain.windows, behind))
    alone, found = (sun_paths(one, altitude_deg=40.0, azimuth_deg=180.0) for one in (plain, both))
    assert found["beam_source"].values.tolist() == ["window", "partition"]
    np.testing.assert_allclose(found["beam_power"].values, [0.5, 0.3])
    for one, strength in ((alone, 0.5), (found, 0.3)):
        floor = one["patch_surface"].values == "floor"
        np.testing.assert_allclose(one["patch_strength"].values[floor], strength * np.sin(np.radians(40.0)))
    np.testing.assert_allclose(found["patch_area_m2"].sum(), alone["patch_area_m2"].sum())


def test_a_bsdf_has_paths_in_its_own_directions_and_no_patches():
    spread = PANEL.bsdf("klems_quarter").blurred()
    found = sun_paths(room(spread), altitude_deg=50.0, azimuth_deg=180.0, points=100)
    assert found.sizes["patch"] == found.sizes["beam"] == 0
    assert found.sizes["path"] > 20
    first = found["position_m"].values[:, 2] - found["position_m"].values[:, 1]
    assert len(np.unique(first.round(6), axis=0)) > 20
    assert float(found["entering"][0]) == pytest.approx(
        float(sun_paths(room(PANEL), altitude_deg=50.0, azimuth_deg=180.0)["entering"][0]), abs=0.08
    )


def test_an_interface_is_told_of_and_ends_the_light():
    block = Interface(
        name="block",
        vertices_m=np.array([[0.5, 1.0, 0.1], [3.5, 1.0, 0.1], [3.5, 1.0, 2.9], [0.5, 1.0, 2.9]]),
        triangles=np.array([[0, 1, 2], [0, 2, 3]]),
        back_index=1.0,
    )
    with pytest.warns(SunWarning, match="interface 'block' is not followed"):
        found = sun_paths(replace(room(Open()), interfaces=(block,)), altitude_deg=40.0, azimuth_deg=180.0)
    assert set(found["event"].values[:, 2]) == {"interface"}
    assert found.sizes["patch"] == 0


def test_a_window_that_is_not_convex():
    """An L of two squares: the patch has its area and its notch."""
    ring = [(1.0, 0.0, 1.0), (3.0, 0.0, 1.0), (3.0, 0.0, 2.0), (2.0, 0.0, 2.0), (2.0, 0.0, 2.5), (1.0, 0.0, 2.5)][::-1]
    plain = room(Open())
    walls = tuple(one for one in plain.surfaces if one.name != "facade")
    facade = Surface(
        name="facade",
        outline_m=[(4, 0, 0), (0, 0, 0), (0, 0, 3), (4, 0, 3)],
        material=Material(diffuse_reflectance=0.5),
    )
    one = replace(
        plain,
        surfaces=(*walls, facade),
        windows=(Window(name="window", outline_m=ring, glazing=Open(), wall="facade"),),
    )
    found = sun_paths(one, altitude_deg=45.0, azimuth_deg=180.0)
    assert float(found["patch_area_m2"].sum()) == pytest.approx(2.5)
    points = np.array([[1.5, 2.25, 0.0], [2.5, 2.25, 0.0], [2.5, 1.5, 0.0]])
    assert lit(found, "floor", points).tolist() == [True, False, True]


@pytest.mark.parametrize("name", ["panel", "furnished"])
def test_cells_say_what_polygons_say(name, monkeypatch):
    """Where there is too much for polygons a grid of rays gives the same light to within a cell."""
    exact = sun_paths(ROOMS[name], altitude_deg=47.0, azimuth_deg=190.0)
    monkeypatch.setattr(beams, "_MOST_SHADES", 0)
    cells = sun_paths(ROOMS[name], altitude_deg=47.0, azimuth_deg=190.0)
    for surface in np.unique(exact["patch_surface"].values):
        flux = [
            float((one["patch_area_m2"] * one["patch_strength"]).values[one["patch_surface"].values == surface].sum())
            for one in (exact, cells)
        ]
        assert flux[0] == pytest.approx(flux[1], abs=0.03)
    totals = [float((one["patch_area_m2"] * one["patch_strength"]).sum()) for one in (exact, cells)]
    assert totals[0] == pytest.approx(totals[1], rel=1e-6)


def test_thousands_of_slats_are_looked_at_cell_by_cell():
    slats = Louvres(bottom_m=1.5, top_m=2.5, count=1000, depth_m=0.0005)
    found = sun_paths(room(Open(), obstructions=[slats]), altitude_deg=45.0, azimuth_deg=180.0)
    # slats of half their spacing, seen at 45°, hide half
    assert float(found["sunlit_share"][0]) == pytest.approx(0.5, abs=0.1)
    assert found.sizes["path"] > 0
    assert found["blocked_by"].values[0].startswith("louvres")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"points": 0}, r"points must be a whole number of 1\.\.10000, got 0"),
        ({"bounces": 1.5}, r"bounces must be a whole number of 0\.\.8, got 1.5"),
        ({"least_power": 0.0}, r"least_power must be greater than 0"),
        ({"altitude_deg": 91.0}, r"altitude_deg must lie in -90\.\.90"),
        ({"azimuth_deg": float("nan")}, r"azimuth_deg must be"),
    ],
)
def test_wrong_values_are_told(values, message):
    with pytest.raises(ClerestoryError, match=message):
        sun_paths(room(Open()), **{"altitude_deg": 40.0, "azimuth_deg": 180.0, **values})


def test_the_example_of_the_how_to_runs(capsys):
    """The room of docs/how-to/room.md and what it says of its sunlight."""
    text = (Path(__file__).parents[1] / "docs" / "how-to" / "room.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    names = {}
    for block in (blocks[0], next(one for one in blocks if "import sun_paths" in one)):
        exec(compile(block, "room.md", "exec"), names)
    said = capsys.readouterr().out
    assert "ceiling: " in said
    assert "redirected" in said
    assert names["first"].sizes["vertex"] >= 3


def test_the_same_room_gives_the_same_paths():
    one, two = (sun_paths(ROOMS["panel"], altitude_deg=40.0, azimuth_deg=170.0, bounces=2) for _ in range(2))
    one.attrs.clear()
    two.attrs.clear()
    assert one.identical(two)


def test_sensors_name_is_no_matter():
    """Sensors play no part in where the sun goes."""
    bare = replace(ROOMS["panel"], sensors=(Sensors(points_m=[[1.0, 1.0, 1.0]]),))
    one, two = (sun_paths(each, altitude_deg=40.0, azimuth_deg=170.0) for each in (ROOMS["panel"], bare))
    np.testing.assert_array_equal(one["patch_corner_m"], two["patch_corner_m"])
