"""Panels: what they keep, how they are written and read, and their own shapes."""

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from clerestory import (
    ClerestoryError,
    ExtrudedPanel,
    LaserCutPanel,
    Medium,
    Pane,
    Panel,
    PrismaticPanel,
    panel_from_dict,
    read_panel,
)

PANELS = [
    LaserCutPanel(spacing_mm=6, thickness_mm=3),
    LaserCutPanel(spacing_mm=(3, 4), thickness_mm=6, cut_width_mm=0.2, cut_tilt_deg=[0, 2], cut_depth_mm=5),
    LaserCutPanel(spacing_mm=4, thickness_mm=6, cut_radius_mm=-20, cut_slope_deg=1, cut_diffuse=0.02),
    PrismaticPanel(pitch_mm=2, lower_deg=45, upper_deg=45, base_mm=3),
    PrismaticPanel(pitch_mm=2, lower_deg=90, upper_deg=30, base_mm=0, ridges="back", medium="polycarbonate"),
    Pane(thickness_mm=8, medium=Medium(n=1.52, absorption_per_mm=0.01, name="float")),
    ExtrudedPanel(profile=LaserCutPanel(spacing_mm=4, thickness_mm=6, cut_radius_mm=20).profile, media=["pmma"]),
]


@pytest.mark.parametrize("panel", PANELS, ids=lambda panel: panel.kind)
def test_a_panel_is_itself_in_every_form(panel: Panel, tmp_path: Path):
    path = panel.to_toml(tmp_path / "new folder" / "panel.toml")
    for twin in (
        read_panel(path),
        type(panel).from_toml(path),
        panel_from_dict(panel.to_dict()),
        pickle.loads(pickle.dumps(panel)),
        copy.deepcopy(panel),
    ):
        assert twin == panel
        assert hash(twin) == hash(panel)
        assert type(twin) is type(panel)
    assert [entry.name for entry in path.parent.iterdir()] == ["panel.toml"]


sizes = st.floats(1.0, 20.0)


@given(
    spacing=st.one_of(sizes, st.lists(sizes, min_size=1, max_size=3)),
    thickness=sizes,
    width=st.one_of(st.just(0.0), st.floats(0.01, 0.5)),
    depth=st.one_of(st.none(), st.floats(0.05, 1.0)),
    medium=st.one_of(
        st.sampled_from(["pmma", "polycarbonate", "bk7"]), st.builds(Medium, st.floats(1.0, 2.0), st.floats(0.0, 0.1))
    ),
)
@settings(max_examples=50)
def test_every_laser_cut_panel_survives_a_file(tmp_path_factory, spacing, thickness, width, depth, medium):
    panel = LaserCutPanel(
        spacing_mm=spacing,
        thickness_mm=thickness,
        cut_width_mm=width,
        cut_depth_mm=None if depth is None else depth * thickness,
        medium=medium,
    )
    assert read_panel(panel.to_toml(tmp_path_factory.mktemp("panels") / "panel.toml")) == panel


def test_panels_are_frozen():
    with pytest.raises(AttributeError):
        PANELS[0].thickness_mm = 4.0


def test_sequences_are_kept_as_tuples_and_numbers_as_floats():
    panel = LaserCutPanel(spacing_mm=np.array([3, 4]), thickness_mm=np.int64(6), cut_tilt_deg=[0])
    assert panel.spacing_mm == (3.0, 4.0)
    assert panel.cut_tilt_deg == (0.0,)
    assert type(panel.thickness_mm) is float


def test_a_medium_may_be_named():
    assert Pane(thickness_mm=4, medium="bk7").medium == Medium.named("bk7")


def test_uneven_spacings_add_to_the_pitch():
    profile = LaserCutPanel(spacing_mm=[2, 3, 5], thickness_mm=4).profile
    assert profile.pitch_mm == 10.0
    assert profile.depth_range_mm == (0.0, 4.0)


def test_prisms_are_as_high_as_their_angles_say():
    """pitch / (cot 30 + cot 60) over a base of 1."""
    profile = PrismaticPanel(pitch_mm=2, lower_deg=30, upper_deg=60, base_mm=1).profile
    relief = 2 / (1 / np.tan(np.radians(30)) + 1 / np.tan(np.radians(60)))
    assert profile.depth_range_mm == pytest.approx((0.0, 1.0 + relief))


def test_a_drawn_copy_of_a_panel_has_its_light():
    panel = PrismaticPanel(pitch_mm=2, lower_deg=45, upper_deg=45, base_mm=1, medium=Medium(n=1.5))
    drawn = ExtrudedPanel(profile=panel.profile, media=panel.media)
    at = {"elevation_deg": [-40, 70], "azimuth_deg": [0, 30], "tolerance": 1e-4}
    for name, values in panel.angular(**at).items():
        np.testing.assert_allclose(drawn.angular(**at)[name], values, atol=1e-12)


def test_a_file_of_another_kind_is_refused(tmp_path: Path):
    path = PANELS[0].to_toml(tmp_path / "panel.toml")
    with pytest.raises(ClerestoryError, match=r"panel\.toml: kind must be 'pane', got 'laser-cut'"):
        Pane.from_toml(path)


def test_a_panel_is_written_whole_or_not_at_all(tmp_path: Path):
    (tmp_path / "file").write_text("not a folder")
    with pytest.raises(ClerestoryError, match="must be a place to write to"):
        PANELS[0].to_toml(tmp_path / "file" / "panel.toml")
