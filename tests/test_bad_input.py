"""Every mistake is a ClerestoryError that says name, rule, value and way out, before any work."""

import math

import pytest

from clerestory import (
    ClerestoryError,
    ExtrudedPanel,
    Facet,
    LaserCutPanel,
    Medium,
    Pane,
    PrismaticPanel,
    Profile,
    panel_from_dict,
    read_measured,
    read_panel,
)

LCP = LaserCutPanel(spacing_mm=6, thickness_mm=3)


def laser_cut(**changed):
    return LaserCutPanel(**({"spacing_mm": 6, "thickness_mm": 3} | changed))


def prismatic(**changed):
    return PrismaticPanel(**({"pitch_mm": 2, "lower_deg": 45, "upper_deg": 45, "base_mm": 1} | changed))


PANELS = [
    (lambda: laser_cut(spacing_mm=-1), "spacing_mm must be a positive number, got -1"),
    (lambda: laser_cut(spacing_mm=0), "spacing_mm must be a positive number, got 0"),
    (lambda: laser_cut(spacing_mm=[]), "spacing_mm must have at least one value, got an empty sequence"),
    (lambda: laser_cut(spacing_mm=[3, math.nan]), "spacing_mm[1] must be finite, got nan"),
    (lambda: laser_cut(spacing_mm="6"), "spacing_mm must be a number, got '6'"),
    (lambda: laser_cut(spacing_mm=True), "spacing_mm must be a number, got True"),
    (lambda: laser_cut(thickness_mm=None), "thickness_mm must be a number, got None"),
    (lambda: laser_cut(thickness_mm=0), "thickness_mm must be a positive number, got 0"),
    (lambda: laser_cut(thickness_mm=math.inf), "thickness_mm must be finite, got inf"),
    (lambda: laser_cut(cut_width_mm=-0.1), "cut_width_mm must be 0 or a positive number, got -0.1"),
    (lambda: laser_cut(cut_width_mm=6.5), "cut_width_mm must be smaller than spacing_mm (6), got 6.5"),
    (lambda: laser_cut(cut_tilt_deg=81), "cut_tilt_deg must be between -80 and 80, got 81"),
    (lambda: laser_cut(cut_tilt_deg=[60, -60]), "cut_tilt_deg makes cuts 1 and 2 cross inside the sheet"),
    (lambda: laser_cut(cut_depth_mm=4), "cut_depth_mm must be at most thickness_mm (3), got 4"),
    (lambda: laser_cut(cut_depth_mm=0), "cut_depth_mm must be a positive number, got 0"),
    (lambda: laser_cut(cut_radius_mm=1), "cut_radius_mm must be at least half the length of the cut (1.500)"),
    (lambda: laser_cut(cut_slope_deg=31), "cut_slope_deg must be between 0 and 30, got 31"),
    (lambda: laser_cut(cut_diffuse=1.5), "cut_diffuse must be between 0 and 1, got 1.5"),
    (lambda: laser_cut(medium=1.49), "medium must be a Medium or the name of one, got 1.49"),
    (lambda: laser_cut(medium="pmmma"), "pmma"),
    (lambda: prismatic(pitch_mm=0), "pitch_mm must be a positive number, got 0"),
    (lambda: prismatic(lower_deg=0), "lower_deg must be greater than 0 and at most 90, got 0"),
    (lambda: prismatic(upper_deg=91), "upper_deg must be greater than 0 and at most 90, got 91"),
    (lambda: prismatic(lower_deg=90, upper_deg=90), "upper_deg must be less than 90 when lower_deg is 90"),
    (lambda: prismatic(base_mm=-1), "base_mm must be 0 or a positive number, got -1"),
    (lambda: prismatic(ridges="left"), "ridges must be one of front, back, got 'left'"),
    (lambda: Pane(thickness_mm=-3), "thickness_mm must be a positive number, got -3"),
    (lambda: Medium(n=0.9), "n must be"),
    (lambda: Medium(n=math.inf), "n must be finite, got inf"),
    (lambda: Medium(n=1.5, absorption_per_mm=-1), "absorption_per_mm must be"),
]

FACETS = [
    Facet(start=(0, 0), end=(0, 1), left=0, right=1),
    Facet(start=(1, 0), end=(1, 1), left=1, right=0),
]

PROFILES = [
    (lambda: Profile(pitch_mm=0, facets=FACETS), "pitch_mm must be a positive number, got 0"),
    (lambda: Profile(pitch_mm=1, facets=[]), "a profile needs at least one facet, got none"),
    (
        lambda: Profile(pitch_mm=1, facets=[FACETS[0], Facet(start=(1, 0), end=(1, 0.9), left=1, right=0)]),
        "does not close",
    ),
    (lambda: Profile(pitch_mm=1, facets=[*FACETS, Facet(start=(0.5, 0), end=(2, 0.5), left=1, right=1)]), "crosses"),
    (lambda: Profile(pitch_mm=2, facets=FACETS), "does not close"),
    (lambda: Profile(pitch_mm=1, facets=[1]), "facet 1 must be a Facet, got 1"),
    (lambda: Facet(start=(0, 0), end=(0, math.nan), left=0, right=1), "end y must be finite, got nan"),
    (lambda: Facet(start=(0, 0, 1), end=(0, 1), left=0, right=1), "start must be a point of two numbers (z, y)"),
    (
        lambda: Facet(start=(0, 0), end=(0, 1), left=-1, right=1),
        "left must be the number of a medium, 0 to 255, got -1",
    ),
    (
        lambda: Profile(pitch_mm=1, facets=[Facet(start=(0, 0), end=(0, 1), left=0, right=1, bulge=1.5), FACETS[1]]),
        "facet 1: the bulge of an arc must be between -1 (half circle) and 1, got 1.5",
    ),
    (
        lambda: ExtrudedPanel(profile=Profile(pitch_mm=1, facets=FACETS), media=[]),
        "media must hold the 1 media that profile names, got 0",
    ),
    (lambda: ExtrudedPanel(profile="drawing.svg"), "profile must be a Profile, got 'drawing.svg'"),
]

QUESTIONS = [
    ({"elevation_deg": 90.5}, "elevation_deg must be greater than -90 and less than 90, got 90.5"),
    ({"elevation_deg": -90}, "elevation_deg must be greater than -90 and less than 90, got -90"),
    ({"elevation_deg": math.nan}, "elevation_deg must be finite, got nan"),
    ({"elevation_deg": True}, "elevation_deg must be a number"),
    ({"elevation_deg": None}, "elevation_deg must be a number"),
    ({"elevation_deg": "high"}, "elevation_deg must be a number"),
    ({"elevation_deg": 0, "azimuth_deg": 120}, "azimuth_deg must be greater than -90 and less than 90, got 120"),
    ({"elevation_deg": 0, "side": "left"}, "side must be one of front, back, got 'left'"),
    ({"elevation_deg": 0, "polarisation": "resolve"}, "did you mean 'resolved'?"),
    ({"elevation_deg": 0, "tolerance": 0}, "tolerance must be between 0 and 1, got 0"),
    ({"elevation_deg": 0, "tolerance": True}, "tolerance must be a number, got True"),
    ({"elevation_deg": 0, "arc_chords": 1}, "arc_chords must be a whole number of at least 2, got 1"),
    (
        {"elevation_deg": 0, "wavelength_nm": 380},
        "wavelength_nm must lie in the validity range 420 to 1620 nm of this medium, got 380",
    ),
    ({"elevation_deg": 0, "wavelength_nm": math.nan}, "wavelength_nm must be finite, got nan"),
    ({"elevation_deg": 0, "wavelength_nm": -550}, "wavelength_nm must"),
]

TABLES = [
    ({"elevation_deg": []}, "elevation_deg must be a number or a list of numbers"),
    ({"elevation_deg": [0, math.nan]}, "elevation_deg must be finite, got nan"),
    ({"elevation_deg": 0, "azimuth_deg": [math.inf]}, "azimuth_deg must be finite, got inf"),
    ({"elevation_deg": [[0, 1]]}, "elevation_deg must be a number or a list of numbers"),
    ({"elevation_deg": 0, "method": "montecarlo"}, "did you mean 'monte_carlo'?"),
    ({"elevation_deg": 0, "rays": 1}, "rays must be a whole number of at least 2, got 1"),
    ({"elevation_deg": 0, "rays": 10.5}, "rays must be a whole number of at least 2, got 10.5"),
    ({"elevation_deg": 0, "seed": -1}, "seed must be a whole number of at least 0, got -1"),
    ({"elevation_deg": 0, "wavelength_nm": []}, "wavelength_nm must be a number or a list of numbers"),
    ({"elevation_deg": 0, "wavelength_nm": [550, 380]}, "wavelength_nm must"),
]

VALUES = [
    ({"thickness_mm": 3}, "kind must be given, one of laser-cut, prismatic, pane, extruded"),
    ({"kind": "lasercut"}, "did you mean 'laser-cut'?"),
    ({"kind": "pane", "thicknes_mm": 3}, "did you mean 'thickness_mm'?"),
    ({"kind": "pane"}, "a pane panel must have thickness_mm, got none"),
    ({"kind": "pane", "thickness_mm": 3, "medium": {"n": 0.5}}, "n must be"),
    ({"kind": "extruded", "profile": {"pitch_mm": 1}}, "keys of profile must include 'facets'"),
    (
        {"kind": "extruded", "profile": {"pitch_mm": 1, "facets": [{"start": [0, 0], "end": [0, 1], "left": 0}]}},
        "keys of facet 1 must include 'right'",
    ),
]

FILES = [
    ("kind = laser-cut", "panel.toml must be a TOML file, got:"),
    ('kind = "pane"\nthickness_mm = -3', "panel.toml: thickness_mm must be a positive number, got -3"),
    ('kind = "pane"\nthickness_mm = 3\nthickness_mm = 4', "panel.toml must be a TOML file, got:"),
]

MEASURED = [
    ("", "must hold a line of column names and a row of numbers, got 0 lines"),
    ("elevation_deg,transmitance\n0,0.9\n", "line 1: column must be one of"),
    ("transmittance\n0.9\n", "line 1: columns must include elevation_deg or theta_deg"),
    ("elevation_deg\n0\n", "line 1: columns must include a quantity such as transmittance"),
    ("elevation_deg,transmittance\n0,0.9\n# a note\n10\n", "line 4: a row must have 2 fields, got 1"),
    ("elevation_deg,transmittance\n0,high\n", "line 2: transmittance must be a number, got 'high'"),
    (
        "elevation_deg,transmittance\n0,92\n",
        "line 2: transmittance must be a share of 1, got 92; divide per cent by 100",
    ),
    (
        "elevation_deg,transmittance\n95,0.9\n",
        "line 2: elevation_deg must be greater than -90 and less than 90, got 95",
    ),
    ("elevation_deg,transmittance\n0,nan\n", "line 2: transmittance must be a share of 1, got nan"),
]


def check(raised, said):
    message = str(raised.value)
    assert said in message
    assert "\n" not in message
    assert isinstance(raised.value, ValueError)


@pytest.mark.parametrize(("make", "said"), PANELS + PROFILES)
def test_a_panel_that_cannot_be_is_refused_when_it_is_made(make, said):
    with pytest.raises(ClerestoryError) as raised:
        make()
    check(raised, said)


@pytest.mark.parametrize(("question", "said"), QUESTIONS)
def test_a_question_about_beams_that_has_no_answer_is_refused(question, said):
    with pytest.raises(ClerestoryError) as raised:
        LCP.lobes(**question)
    check(raised, said)


@pytest.mark.parametrize(("question", "said"), QUESTIONS + TABLES)
def test_a_question_about_a_table_that_has_no_answer_is_refused(question, said):
    with pytest.raises(ClerestoryError) as raised:
        LCP.angular(**question)
    check(raised, said)


@pytest.mark.parametrize(("values", "said"), VALUES)
def test_values_that_make_no_panel_are_refused(values, said):
    with pytest.raises(ClerestoryError) as raised:
        panel_from_dict(values)
    check(raised, said)


@pytest.mark.parametrize(("text", "said"), FILES)
def test_a_file_that_holds_no_panel_is_refused(tmp_path, text, said):
    (tmp_path / "panel.toml").write_text(text)
    with pytest.raises(ClerestoryError) as raised:
        read_panel(tmp_path / "panel.toml")
    check(raised, said)


def test_a_file_that_is_not_there_is_refused(tmp_path):
    for read in (read_panel, read_measured):
        with pytest.raises(ClerestoryError, match="must be a readable file, got: No such file"):
            read(tmp_path / "missing")


@pytest.mark.parametrize(("text", "said"), MEASURED)
def test_a_measurement_that_cannot_be_read_is_refused_by_line(tmp_path, text, said):
    (tmp_path / "measured.csv").write_text(text)
    with pytest.raises(ClerestoryError) as raised:
        read_measured(tmp_path / "measured.csv")
    check(raised, said)
    assert str(raised.value).startswith(str(tmp_path / "measured.csv"))
