"""The command line: the API's names, files in a folder, one line and exit code 2 for a mistake."""

import json
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

import pytest
import xarray as xr
from typer.testing import CliRunner

from clerestory import LaserCutPanel, Medium, Pane, PrismaticPanel, read_panel
from clerestory.cli import app
from clerestory.cli.angle_list import number_list

LASER_CUT = ["panel", "laser-cut", "--spacing-mm", "6", "--thickness-mm", "3", "--medium", "1.49"]
LCP = LaserCutPanel(spacing_mm=6, thickness_mm=3, medium=Medium(n=1.49))


def run(*words):
    return CliRunner().invoke(app, list(map(str, words)))


def answer(*words):
    result = run(*words, "--json")
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


def test_the_command_line_finds_what_the_api_finds():
    found = answer(*LASER_CUT, "--elevation", "-60:60:30", "--azimuth", "0,20", "--side", "back")
    table = LCP.angular(elevation_deg=range(-60, 61, 30), azimuth_deg=[0, 20], side="back")
    assert found["variables"]["transmittance_deflected"] == table.transmittance_deflected.values.tolist()
    assert found["coordinates"]["elevation"] == [-60, -30, 0, 30, 60]
    assert found["panel"] == LCP.to_dict()


@pytest.mark.parametrize(
    ("words", "panel"),
    [
        (
            "laser-cut --spacing-mm 3,4 --thickness-mm 6 --cut-width-mm 0.2 --cut-tilt-deg 0,1 --cut-depth-mm 5",
            LaserCutPanel(spacing_mm=[3, 4], thickness_mm=6, cut_width_mm=0.2, cut_tilt_deg=[0, 1], cut_depth_mm=5),
        ),
        (
            "prismatic --pitch-mm 2 --lower-deg 45 --upper-deg 45 --base-mm 3 --ridges back",
            PrismaticPanel(pitch_mm=2, lower_deg=45, upper_deg=45, base_mm=3, ridges="back"),
        ),
        (
            "pane --thickness-mm 8 --medium 1.52 --absorption-per-mm 0.01",
            Pane(thickness_mm=8, medium=Medium(n=1.52, absorption_per_mm=0.01)),
        ),
    ],
)
def test_every_kind_has_the_names_of_the_api(words, panel):
    found = answer("panel", *words.split(), "--elevation", "30", "--wavelength-nm", "550", "--tolerance", "1e-3")
    assert found["panel"] == panel.to_dict()


def test_every_argument_of_a_panel_is_an_option():
    for kind in (LaserCutPanel, PrismaticPanel, Pane):
        # wide enough that no name is broken
        shown = CliRunner(env={"COLUMNS": "200", "TERM": "dumb"}).invoke(app, ["panel", kind.kind, "--help"]).output
        for field in fields(kind):
            assert not field.init or f"--{field.name.replace('_', '-')}" in shown


def test_results_are_files_that_are_named(tmp_path: Path):
    result = run(*LASER_CUT, "--elevation", "0:80:20", "--out", tmp_path / "out")
    assert result.exit_code == 0, result.output
    files = {path.name for path in (tmp_path / "out").iterdir()}
    assert files >= {
        "panel.toml",
        "angular.nc",
        "angular.csv",
        "radial.png",
        "radial.svg",
        "section.png",
        "section.svg",
    }
    assert all(str(tmp_path / "out" / name) in result.output for name in files)
    assert read_panel(tmp_path / "out" / "panel.toml") == LCP
    with xr.open_dataset(tmp_path / "out" / "angular.nc") as table:
        assert table.sizes["elevation"] == 5


def test_a_panel_is_read_from_its_file(tmp_path: Path):
    path = LCP.to_toml(tmp_path / "mine.toml")
    assert answer("panel", path, "--elevation", "60")["panel"] == LCP.to_dict()


def test_a_measured_file_is_compared_in_one_command(tmp_path: Path):
    measured = tmp_path / "measured.csv"
    measured.write_text("elevation_deg,transmittance\n0,0.92\n30,0.91\n72.5,0.7\n")
    found = answer(*LASER_CUT, "--measured", measured, "--out", tmp_path)["comparison"]["transmittance"]
    assert found["n"] == 3
    # computed at 72.5 degrees itself, not between 70 and 75
    worst = LCP.angular(elevation_deg=72.5).transmittance.item() - 0.7
    assert found["largest_difference"] == pytest.approx(worst, abs=1e-12)
    assert {"comparison.json", "regression_transmittance.png"} <= {path.name for path in tmp_path.iterdir()}


def test_rays_tell_their_standard_errors():
    words = ["--method", "monte_carlo", "--rays", "500", "--seed", "4", "--elevation", "30"]
    assert "transmittance_standard_error" in answer(*LASER_CUT, *words)["variables"]
    assert "±" in run(*LASER_CUT, *words).output


def test_doctor_says_what_is_there():
    found = json.loads(run("doctor", "--json").stdout)
    assert found["threads"] >= 1
    assert found["packages"]["numpy"]
    assert set(found["extras"]) >= {"mitsuba", "pyradiance"}
    assert "clerestory" in run("doctor").output


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("0:10:5", [0, 5, 10]),
        ("0:9:5", [0, 5]),
        ("-10,3.5", [-10, 3.5]),
        ("0:0.3:0.1", [0, 0.1, 0.2, 0.3]),
        ("5:0:-5", [5, 0]),
    ],
)
def test_lists_of_numbers(text, numbers):
    assert number_list("--elevation", text) == pytest.approx(numbers)


def test_a_mistake_is_one_line_and_exit_code_2(tmp_path: Path):
    """In a process of its own: what a shell sees."""
    bad = tmp_path / "bad.toml"
    bad.write_text('kind = "pane"\nthicknes_mm = 3\n')
    command = [sys.executable, "-c", "from clerestory.cli import app; app()", "panel", str(bad)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("\n") == 1
    assert "did you mean 'thickness_mm'?" in done.stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--cut-width-mm", "7"], "cut_width_mm must be smaller than spacing_mm (6), got 7"),
        (["--elevation", "0:95:5"], "elevation_deg must be greater than -90 and less than 90, got 90"),
        (["--elevation", "0:85"], "--elevation must be numbers or start:stop:step"),
        (["--elevation", "0:85:-5"], "the step of --elevation must lead from 0 to 85"),
        (["--medium", "pmmma"], "pmma"),
        (["--rays", "0"], "rays must be a whole number of at least 2, got 0"),
        (["--measured", "no such.csv"], "no such.csv must be a readable file"),
    ],
)
def test_mistakes_are_told_in_the_words_of_the_api(words, said):
    result = run(*LASER_CUT, *words)
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stderr.count("\n") == 1


def test_a_word_that_is_neither_kind_nor_file_is_told_the_nearest():
    result = run("panel", "prismatik")
    assert result.exit_code == 2
    assert "did you mean 'prismatic'?" in result.stderr


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["panel", "pane", "--thickness-mm", "thick"], "--thickness-mm"),
        (["panel", "pane"], "--thickness-mm"),
        (["panel", "pane", "--thickness-mm", "3", "--colour", "red"], "--colour"),
        (["panel", "pane", "--thickness-mm", "3", "--side", "left"], "--side"),
        (["pannel"], "pannel"),
    ],
)
def test_words_that_are_no_command_are_one_line_too(words, said):
    result = run(*words)
    assert result.exit_code == 2
    assert said in result.stderr
    assert "--help" in result.stderr
    assert result.stderr.count("\n") == 1


def test_without_words_there_is_help():
    for words in ([], ["panel"], ["--help"], ["panel", "pane", "--help"]):
        assert "Usage" in run(*words).output
