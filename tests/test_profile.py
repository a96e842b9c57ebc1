"""Profiles: drawn as points, SVG and DXF they are the panels whose shapes they have."""

import math
import pickle
from pathlib import Path

import ezdxf
import numpy as np
import pytest

from clerestory import (
    ClerestoryError,
    ExtrudedPanel,
    Face,
    Facet,
    LaserCutPanel,
    Medium,
    Outline,
    Pane,
    PrismaticPanel,
    Profile,
    read_profile,
)

CLEAR = Medium(n=1.49)
BAR = [(0, 0), (6, 0), (6, 3), (0, 3)]
AT = {"elevation_deg": [-50, 20, 65], "azimuth_deg": [0, 25], "tolerance": 1e-5}


def assert_same_light(profile, panel):
    drawn = ExtrudedPanel(profile=profile, media=panel.media).angular(**AT)
    for name, values in panel.angular(**AT).items():
        np.testing.assert_allclose(drawn[name], values, rtol=0, atol=3e-5, err_msg=str(name))


def test_stacked_bars_are_a_pane():
    """Where an outline touches its own copy nothing is left."""
    profile = Profile.from_outlines([BAR], pitch_mm=3)
    assert len(profile.facets) == 2
    assert_same_light(profile, Pane(thickness_mm=6, medium=CLEAR))


def test_stacked_bars_with_films_are_a_laser_cut_panel():
    profile = Profile.from_outlines([BAR], pitch_mm=3, joins="film")
    assert [facet.film for facet in profile.facets].count(0) == 1
    assert_same_light(profile, LaserCutPanel(spacing_mm=3, thickness_mm=6, medium=CLEAR))


def test_bars_apart_are_a_panel_with_kerfs():
    bar = [(0, 0.1), (6, 0.1), (6, 2.9), (0, 2.9)]
    panel = LaserCutPanel(spacing_mm=3, thickness_mm=6, cut_width_mm=0.2, medium=CLEAR)
    drawn = ExtrudedPanel(profile=Profile.from_outlines([bar], pitch_mm=3), media=[CLEAR])
    at = {"elevation_deg": 20, "azimuth_deg": 25, "tolerance": 1e-4}
    np.testing.assert_allclose(drawn.angular(**at).to_array(), panel.angular(**at).to_array(), rtol=0, atol=3e-4)


def test_the_sense_and_the_beginning_of_an_outline_do_not_matter():
    one, turned, shifted = (
        Profile.from_outlines([points], pitch_mm=3, joins="film")
        for points in (BAR, BAR[::-1], [(z, y + 7.5) for z, y in BAR[2:] + BAR[:2]])
    )
    for other in (turned, shifted):
        assert_same_light(other, ExtrudedPanel(profile=one, media=[CLEAR]))


def test_two_faces_are_a_prismatic_sheet():
    panel = PrismaticPanel(pitch_mm=2, lower_deg=45, upper_deg=45, base_mm=1, medium=CLEAR)
    ridges = [(1, 0), (0, 1), (1, 2)]
    profile = Profile.from_faces([[(2, 0), (2, 2)], ridges], pitch_mm=2)
    assert_same_light(profile, panel)
    # the flat side may be drawn downwards, anywhere
    assert_same_light(Profile.from_faces([ridges, [(2, 5.3), (2, 3.3)]], pitch_mm=2), panel)


def test_layers_lie_between_faces():
    lines = [[(z, 0), (z, 1)] for z in (0, 1, 2)]
    profile = Profile.from_faces(lines, pitch_mm=1, between=[0, 1, 2, 0])
    assert {(facet.start[0], facet.left, facet.right) for facet in profile.facets} == {(0, 0, 1), (1, 1, 2), (2, 2, 0)}
    assert profile.media_count == 2


def test_an_outline_of_air_is_a_hole():
    hole = Outline([(2, 1), (4, 1), (4, 2), (2, 2)], medium=0)
    profile = Profile.from_outlines([BAR, hole], pitch_mm=3)
    assert len(profile.facets) == 6
    around = [facet for facet in profile.facets if 1.5 < facet.start[0] < 4.5]
    assert {frozenset((facet.left, facet.right)) for facet in around} == {frozenset((0, 1))}


def test_a_long_edge_is_cut_where_a_shorter_one_meets_it():
    """Two bars of glass on one of acrylic: the shared face is two interfaces."""
    upper = [Outline([(z, 2), (z + 3, 2), (z + 3, 3), (z, 3)], medium=2) for z in (0, 3)]
    lower = Outline([(0, 0), (6, 0), (6, 2), (0, 2)])
    profile = Profile.from_outlines([lower, *upper], pitch_mm=3)
    shared = [f for f in profile.facets if f.start[1] == f.end[1] == 2.0]
    assert sorted(sorted((f.start[0], f.end[0])) for f in shared) == [[0.0, 3.0], [3.0, 6.0]]
    assert all({f.left, f.right} == {1, 2} for f in shared)


@pytest.mark.parametrize("bulge", [-0.2, 0.2])
def test_arcs_know_their_sides(bulge):
    """A front that bows out (bulge < 0 on the way up) or in."""
    front = Face([(0, 0), (0, 2)], bulges=[bulge])
    profile = Profile.from_faces([front, [(3, 0), (3, 2)]], pitch_mm=2)
    (arc,) = [facet for facet in profile.facets if facet.bulge]
    assert (arc.left, arc.right) == (0, 1)
    # an arc bulges by half its chord times the bulge; anticlockwise on the way up is towards the room
    assert profile.depth_range_mm == pytest.approx((min(0.0, bulge), 3.0))
    assert not profile.is_straight
    assert profile.flattened(8).is_straight
    assert len(profile.flattened(8).facets) == 9


def test_svg_path_data_is_the_outline_it_draws():
    assert_same_light(
        Profile.from_svg_path("M0,0 h6 v-3 h-6 z", pitch_mm=3, joins="film"),
        LaserCutPanel(spacing_mm=3, thickness_mm=6, medium=CLEAR),
    )


def test_svg_arcs_stay_arcs():
    # a half circle of radius 1 towards the room on the back
    profile = Profile.from_svg_path("M0,0 H3 A1,1 0 0 0 3,-2 H0 Z", pitch_mm=2)
    assert profile.depth_range_mm == pytest.approx((0.0, 4.0))
    arcs = [facet for facet in profile.facets if facet.bulge]
    assert len(arcs) == 2
    assert sum(4 * math.atan(abs(facet.bulge)) for facet in arcs) == pytest.approx(math.pi)


def test_svg_curves_become_chords():
    profile = Profile.from_svg_path("M0,0 V-2 M3,0 C4,-0.5 4,-1.5 3,-2", pitch_mm=2, curve_chords=10)
    assert len(profile.facets) == 11
    assert profile.is_straight


def test_an_svg_file_has_units_transforms_and_media(tmp_path: Path):
    path = tmp_path / "panel.svg"
    path.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="1cm" height="1cm" viewBox="0 0 100 100">'
        '<g transform="translate(10 0)"><rect width="60" height="20"/>'
        '<rect data-medium="2" y="20" width="60" height="10"/></g></svg>'
    )
    profile = read_profile(path, pitch_mm=3)
    assert profile.depth_range_mm == pytest.approx((1.0, 7.0))
    assert profile.media_count == 2
    assert len(profile.facets) == 6


def dxf(path: Path, draw, units: int = 4) -> Path:
    document = ezdxf.new()
    document.units = units
    draw(document.modelspace())
    document.saveas(path)
    return path


def test_dxf_polylines_have_bulges_and_units(tmp_path: Path):
    """In cm, the upper and the lower face of a bar bow: a panel with curved cuts."""
    bulge = -math.tan(0.5 * math.asin(0.5 * 6 / 20))
    panel = LaserCutPanel(spacing_mm=3, thickness_mm=6, cut_radius_mm=20, medium=CLEAR)
    points = [(0, 0, bulge), (0.6, 0, 0), (0.6, 0.3, -bulge), (0, 0.3, 0)]
    path = dxf(
        tmp_path / "bar.dxf",
        lambda space: (space.add_lwpolyline(points, format="xyb", close=True), space.add_text("a bar")),
        units=5,
    )
    profile = read_profile(path, pitch_mm=3, joins="film")
    assert sum(facet.bulge != 0 for facet in profile.facets) == 1
    drawn, made = (
        p.angular(elevation_deg=[20, 50], arc_chords=4, tolerance=1e-3)
        for p in (ExtrudedPanel(profile=profile, media=[CLEAR]), panel)
    )
    np.testing.assert_allclose(drawn.transmittance_deflected, made.transmittance_deflected, atol=2e-3)


def test_dxf_lines_and_arcs_are_strung_together(tmp_path: Path):
    def draw(space):
        space.add_line((3, 2), (0, 2))
        space.add_line((0, 0), (0, 2))
        space.add_line((0, 0), (3, 0))
        space.add_arc((3, 1), radius=1, start_angle=-90, end_angle=90)

    profile = read_profile(dxf(tmp_path / "d.dxf", draw), pitch_mm=2)
    assert profile.depth_range_mm == pytest.approx((0.0, 4.0))
    assert len(profile.facets) == 3


def test_dxf_layers_name_media(tmp_path: Path):
    def draw(space):
        space.add_lwpolyline([(0, 0), (6, 0), (6, 2), (0, 2)], close=True, dxfattribs={"layer": "PMMA"})
        space.add_lwpolyline([(0, 2), (6, 2), (6, 3), (0, 3)], close=True, dxfattribs={"layer": "GLASS"})
        space.add_lwpolyline([(-5, 0), (9, 1)], dxfattribs={"layer": "FRAME"})

    path = dxf(tmp_path / "d.dxf", draw)
    assert read_profile(path, pitch_mm=3, layers={"PMMA": 1, "GLASS": 2}).media_count == 2
    with pytest.raises(ClerestoryError, match="did you mean 'GLASS'"):
        read_profile(path, pitch_mm=3, layers={"PMMA": 1, "GLAS": 2})


def test_a_circle_is_a_rod(tmp_path: Path):
    path = dxf(tmp_path / "rods.dxf", lambda space: space.add_circle((1, 1), radius=0.8))
    profile = read_profile(path, pitch_mm=2)
    assert len(profile.facets) == 4
    assert all((facet.left, facet.right) == (1, 0) for facet in profile.facets)


def test_a_profile_is_itself_in_every_form():
    profile = LaserCutPanel(spacing_mm=3, thickness_mm=6, cut_radius_mm=20).profile
    for twin in (pickle.loads(pickle.dumps(profile)), Profile.from_dict(profile.to_dict())):
        assert twin == profile
        assert hash(twin) == hash(profile)
    assert Facet(start=[0, 0], end=[0, 1], left=0, right=1) == Facet(start=(0.0, 0.0), end=(0.0, 1.0), left=0, right=1)


DRAWINGS = [
    (lambda: Profile.from_outlines([[(0, 0), (1, 1)]], pitch_mm=3), "an outline must have 3 points or more, got 2"),
    (lambda: Profile.from_outlines([BAR], pitch_mm=2.5), "outline 1 must not overlap its copy one pitch higher"),
    (lambda: Profile.from_outlines([BAR], pitch_mm=-3), "pitch_mm must be greater than 0, got -3"),
    (lambda: Profile.from_outlines([BAR], pitch_mm=3, joins="glue"), "joins must be one of vanish, film, got 'glue'"),
    (lambda: Profile.from_outlines([], pitch_mm=3), "a profile needs at least one facet, got none"),
    (lambda: Profile.from_faces([[(0, 0), (0, 2)]], pitch_mm=3), "face 1 must close or rise by pitch_mm (3)"),
    (lambda: Profile.from_faces([[(0, 0), (0, 3)]], pitch_mm=3, between=[0]), "between must name 2 media"),
    (lambda: Profile.from_svg_path("M0,0 L1,1", pitch_mm=3), "must close or rise by pitch_mm (3), got ends (0, 0) and"),
    (lambda: Profile.from_svg_path("M0,0 L1,x", pitch_mm=3), "data must be SVG path data, got 'x' at character 9"),
    (lambda: Profile.from_svg_path("L1,1", pitch_mm=3), "data must be SVG path data that begins with M, got 'L1,1'"),
    (lambda: Profile.from_svg_path("M0,0 L1", pitch_mm=3), "data must be SVG path data, got"),
    (lambda: Profile.from_svg_path(3, pitch_mm=3), "data must be SVG path data, got 3"),
    (lambda: read_profile("panel.dwg", pitch_mm=3), "path must end in .svg or .dxf, got 'panel.dwg'"),
    (lambda: read_profile("missing.svg", pitch_mm=3), "missing.svg must be a readable file, got: No such file"),
    (lambda: read_profile("missing.dxf", pitch_mm=3), "missing.dxf must be a readable DXF file, got: No such file"),
]


@pytest.mark.parametrize(("draw", "said"), DRAWINGS)
def test_a_drawing_that_is_no_profile_is_refused(draw, said):
    with pytest.raises(ClerestoryError) as raised:
        draw()
    assert said in str(raised.value)
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.svg", "<svg><path", "a.svg must be an SVG file, got:"),
        ("a.svg", "not a drawing", "a.svg must be an SVG file, got:"),
        ("a.svg", '<svg xmlns="http://www.w3.org/2000/svg"/>', "a.svg must hold a shape, got none"),
        (
            "a.svg",
            '<svg xmlns="http://www.w3.org/2000/svg"><rect width="6" height="3" data-medium="glass"/></svg>',
            "a.svg, shape 1: data-medium must be the number of a medium, got 'glass'",
        ),
        (
            "a.svg",
            '<svg xmlns="http://www.w3.org/2000/svg"><polyline points="0,0 6,0 6,3"/></svg>',
            "a.svg: face 1 must close or rise by pitch_mm (3)",
        ),
        ("a.dxf", "not a drawing", "a.dxf must be a"),
    ],
)
def test_a_file_that_cannot_be_drawn_is_refused(tmp_path, name, text, said):
    (tmp_path / name).write_text(text)
    with pytest.raises(ClerestoryError) as raised:
        read_profile(tmp_path / name, pitch_mm=3)
    assert said in str(raised.value)
    assert str(raised.value).startswith(str(tmp_path))
    assert "\n" not in str(raised.value)


def test_a_dxf_entity_that_cannot_be_followed_is_named(tmp_path: Path):
    path = dxf(tmp_path / "d.dxf", lambda space: space.add_ellipse((0, 0), (2, 0), 0.5))
    with pytest.raises(ClerestoryError, match=r"d\.dxf, ELLIPSE [0-9A-F]+: a drawing must be of LWPOLYLINE"):
        read_profile(path, pitch_mm=3)
