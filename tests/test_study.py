"""A room file as a study, from the API and from the command line."""

import json

import numpy as np
import pytest
import xarray as xr
from typer.testing import CliRunner

from clerestory.cli import app
from clerestory.coefficients import daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.illuminance import illuminance, sun_illuminance
from clerestory.panels import LaserCutPanel
from clerestory.study import read_study, run_study, summary
from clerestory.sun_coefficients import sun_coefficients

STUDY = """
name = "open"
[site]
latitude_deg = -9.67
longitude_deg = -35.74
timezone = "America/Maceio"
[glazings.none]
kind = "open"
[glazings.panel]
kind = "laser-cut"
spacing_mm = 4.0
thickness_mm = 6.0
[shoebox]
width_m = 4
depth_m = 6
height_m = 3
facade_azimuth_deg = 0
[[shoebox.opening]]
width_m = 3
height_m = 1.5
glazing = "none"
[[sensors]]
spacing_m = 1.0
[[variant]]
name = "panel"
glazing = { window = "panel" }
[calculation]
basis = "tregenza145"
target_relative_error = 0.2
[[sky]]
name = "overcast"
sky_type = 16
diffuse_horizontal_illuminance_lx = 10000
[[sky]]
name = "sunny"
sky_type = 12
time = "2024-06-21 11:00"
luminous_turbidity = 4
diffuse_horizontal_illuminance_lx = 14000
"""


def written(tmp_path, text=STUDY):
    path = tmp_path / "room.toml"
    path.write_text(text)
    return path


def test_study_reads_rooms_skies_and_how_well(tmp_path):
    study = read_study(written(tmp_path))
    assert list(study.rooms) == ["open", "panel"]
    assert isinstance(study.rooms["panel"].windows[0].glazing, LaserCutPanel)
    assert study.calculation.basis == "tregenza145"
    sunny = study.skies["sunny"]
    assert sunny.sun_altitude_deg == pytest.approx(55.5, abs=1.5)
    assert 60_000.0 < sunny.direct_normal_illuminance_lx < 100_000.0


def test_illuminance_is_that_of_sky_and_sun_together(tmp_path):
    study = read_study(written(tmp_path))
    found = run_study(study)["open"]
    room, sky = study.rooms["open"], study.skies["sunny"]
    coefficients = daylight_coefficients(room, basis="tregenza145", target_relative_error=0.2)
    sun = sun_coefficients(room, altitude_deg=sky.sun_altitude_deg, azimuth_deg=sky.sun_azimuth_deg)
    beam = sun_illuminance(sun, sky.direct_normal_illuminance_lx).total.isel(sun=0)
    np.testing.assert_allclose(
        found.illuminance.total.sel(sky="sunny"), illuminance(coefficients, sky).total + beam, rtol=1e-12
    )
    numbers = summary({"open": found})["open"]
    assert numbers["illuminance_lx"]["overcast"]["mean"] == pytest.approx(
        100.0 * numbers["daylight_factor_percent"]["mean"]
    )


def test_command_leaves_files_and_prints_a_table(tmp_path):
    result = CliRunner().invoke(app, ["room", str(written(tmp_path)), "--out", str(tmp_path / "out")])
    assert result.exit_code == 0, result.output
    assert "Daylight factor" in result.output
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert {"summary.json", "open-coefficients.nc", "panel-illuminance.nc", "open-daylight-factor.csv"} <= names
    assert {"open-plan.png", "section.png", "section-sunny.png", "sky-sunny.png", "panel-ceiling.png"} <= names
    with xr.open_dataset(tmp_path / "out" / "panel-coefficients.nc") as coefficients:
        assert coefficients.attrs["basis"] == "tregenza145"


def test_command_prints_json_and_nothing_else(tmp_path):
    words = ["room", str(written(tmp_path)), "--out", str(tmp_path / "out"), "--json", "--seed", "3"]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.output
    found = json.loads(result.stdout)
    assert set(found["rooms"]) == {"open", "panel"}
    assert found["rooms"]["open"]["converged"] is True


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('"2024-06-21 11:00"', '"2024-06-21 23:00"', "must be by day, got 2024-06-21 23:00"),
        ("sky_type = 12", "sky_type = 21", r"[[sky]] 2 of room.toml: sky_type must be 1..15"),
        ("{ window =", "{ door =", "glazing must name windows of the room (window), got 'door'"),
        ('basis = "tregenza145"', 'bases = "tregenza145"', "got bases; did you mean basis?"),
        ("luminous_turbidity = 4", "luminous_turbidity = 0.4", "luminous_turbidity must be at least 1"),
        ('name = "panel"', 'name = "open"', "must have a name of its own, got 'open'"),
    ],
)
def test_mistakes_are_one_line_and_exit_code_2(tmp_path, old, new, message):
    assert old in STUDY
    path = written(tmp_path, STUDY.replace(old, new))
    with pytest.raises(ClerestoryError) as told:
        read_study(path)
    assert message in str(told.value)
    result = CliRunner().invoke(app, ["room", str(path), "--out", str(tmp_path / "out")])
    assert result.exit_code == 2
    assert message in result.stderr
    assert result.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()
