"""A year from its file to its numbers, and what is refused."""

import json
import tomllib

import numpy as np
import pytest
import xarray as xr
from tests.year.small import YEAR, write_small
from typer.testing import CliRunner

from clerestory.cli import app
from clerestory.coefficients import PARTS, daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.metrics import daylight_autonomy, occupied_hours, spatial_daylight_autonomy
from clerestory.year import evaluate, read_year, run_year, write_year, year_of
from clerestory.year.window_groups import groups_of, lit_through


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    folder = tmp_path_factory.mktemp("year")
    study = read_year(write_small(folder))
    return study, run_year(study, folder / "out"), folder


def test_metrics_are_those_of_the_light_that_is_kept(small):
    study, results, _ = small
    for found in results.values():
        occupied = occupied_hours(study.weather.times, study.schedule)
        light = found["illuminance"].drop_vars("local_time")
        np.testing.assert_allclose(found["daylight_autonomy"], daylight_autonomy(light, occupied=occupied))
        analysis = occupied_hours(study.weather.times)
        assert float(found["spatial_daylight_autonomy"]) == float(spatial_daylight_autonomy(light, occupied=analysis))
        assert int(found["in_use"].sum()) == 3 * 8


def test_less_transmittance_is_less_light(small):
    """The same seed draws the same paths: panes of half the transmittance give less at every sensor and hour."""
    _, results, _ = small
    light = {label: found["illuminance"] for label, found in results.items()}
    lit = light["glass"] > 0.0
    # closed blinds may open where less sun comes in
    open_in_both = ~(results["glass"]["blinds_closed"].any("window_group"))
    assert bool((light["dark"] < light["glass"]).where(lit & open_in_both, True).all())
    assert float(results["dark"]["mean_daylight_factor"]) < float(results["glass"]["mean_daylight_factor"])
    for name in ("mean_daylight_autonomy", "lighting_saved", "spatial_daylight_autonomy_without_blinds"):
        assert float(results["dark"][name]) <= float(results["glass"][name])


def test_light_through_groups_of_windows_adds_up(small):
    """Light through each group with the others black is the light of the room, but for what panes mirror inside."""
    study, _, _ = small
    room = study.variants["glass"]
    groups = groups_of(room, study.blinds)
    assert list(groups) == ["window 2", "without blinds"]
    how = {"basis": "tregenza145", "rounds": 8, "nodes": 1024, "window_samples": 128}
    whole = daylight_coefficients(room, seed=1, **how)
    parts = [daylight_coefficients(lit_through(room, one), seed=2, **how) for one in groups.values()]
    for part in PARTS[:1]:
        total = sum(float(one[part].sum()) for one in parts)
        error = np.sqrt(sum(float((one[f"{part}_standard_error"] ** 2).sum()) for one in (whole, *parts)))
        assert abs(total - float(whole[part].sum())) < 4.0 * error * np.sqrt(whole.sizes["patch"])
    sums = float(sum(one["sky_illuminance"].sum() for one in parts) / whole["sky_illuminance"].sum())
    assert sums == pytest.approx(1.0, abs=0.04)


def test_one_variant_by_itself_is_the_same(small):
    _, results, folder = small
    tables = tomllib.loads(YEAR)
    del tables["variant"]
    alone = evaluate(tables, where=folder)
    for name in ("daylight_autonomy", "illuminance", "lighting_saved", "sun_patch_hours"):
        np.testing.assert_array_equal(alone[name], results["glass"][name])
    tables["variant"] = tomllib.loads(YEAR)["variant"][:1]
    assert evaluate(tables, where=folder).attrs["variant"] == "panel above"
    with pytest.raises(ClerestoryError, match="one \\[\\[variant\\]\\] at most, got 2"):
        evaluate(tomllib.loads(YEAR), where=folder)


def test_the_panel_alone_redirects(small):
    _, results, _ = small
    assert float(results["glass"]["redirected_sun_patch_hours"]) == 0.0
    # where the glass has its beam the panel has less of it
    assert float(results["panel above"]["sunlit_hours"].sum()) <= float(results["glass"]["sunlit_hours"].sum())


def test_files_hold_the_same_numbers(small):
    _, results, folder = small
    tmp_path = folder / "written"
    written = write_year(small[0], results, tmp_path)
    assert [path.name for path in written] == ["year.nc", "metrics.csv", "report.html"]
    with xr.open_dataset(tmp_path / "year.nc") as kept:
        assert kept["variant"].values.tolist() == ["glass", "panel above", "dark"]
        for label, found in results.items():
            np.testing.assert_allclose(kept["daylight_autonomy"].sel(variant=label), found["daylight_autonomy"])
            value = float(kept["lighting_saved"].sel(variant=label))
            line = next(
                row
                for row in (tmp_path / "metrics.csv").read_text().splitlines()
                if row.startswith("lighting_saved,") and f",{label}," in row
            )
            assert float(line.split(",")[-2]) == pytest.approx(value, rel=1e-12)


def test_the_room_may_stand_in_a_file_of_its_own(tmp_path):
    path = write_small(tmp_path)
    room = YEAR.split("[glazings.glass]")[1].split("[[variant]]")[0]
    (tmp_path / "rooms").mkdir()
    (tmp_path / "rooms" / "room.toml").write_text('name = "glass"\n[glazings.glass]' + room)
    rest = "[[variant]]" + YEAR.split("[[variant]]", 1)[1]
    path.write_text('room = "rooms/room.toml"\n[weather]\nfile = "clear.wea"\n' + rest)
    assert list(read_year(path).variants) == ["glass", "panel above", "dark"]


def test_hours_go_by_the_clock_of_the_weather_unless_told(tmp_path):
    path = write_small(tmp_path, YEAR.replace('["08:00-16:00"]', '["08:00-16:00"]\nclock = "America/New_York"'))
    assert read_year(path).schedule.clock == "America/New_York"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            'windows = ["window 2"]',
            'windows = ["window 9"]',
            "must be of the room (window 1, window 2), got 'window 9'",
        ),
        ('hours = ["08:00-16:00"]', 'hours = ["8-16"]', 'spans such as "08:00-18:00"'),
        ("power_density_w_m2 = 8", "power_density = 8", "did you mean power_density_w_m2?"),
        ('file = "clear.wea"', 'file = "cloudy.wea"', "cloudy.wea"),
        ('file = "clear.wea"', "", "must have file"),
        ('suns = "reinhart577"', "sun = 3", "did you mean suns?"),
        ('name = "dark"', 'name = "glass"', "must have a name of its own"),
        ("[lighting]", '[metrics]\neyes = "face"\n[lighting]', "must be one of floor, got 'face'"),
    ],
)
def test_mistakes_are_one_line_and_exit_code_2(tmp_path, old, new, message):
    assert old in YEAR
    path = write_small(tmp_path, YEAR.replace(old, new, 1))
    with pytest.raises(ClerestoryError) as told:
        read_year(path)
    assert message in str(told.value)
    result = CliRunner().invoke(app, ["year", str(path), "--out", str(tmp_path / "out")])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()


def test_a_site_far_from_its_weather_is_refused():
    with pytest.raises(ClerestoryError, match="must be a table"):
        year_of({"shoebox": {"width_m": 3, "depth_m": 5, "height_m": 3}})


def test_command_goes_on_from_what_is_kept_and_prints_json(small):
    _, results, folder = small
    pieces = sorted((folder / "out" / "pieces").rglob("*.nc"))
    before = {path: path.stat().st_mtime_ns for path in pieces}
    words = ["year", str(folder / "year.toml"), "--out", str(folder / "out"), "--json"]
    shown = CliRunner().invoke(app, words)
    assert shown.exit_code == 0, shown.output
    figures = json.loads(shown.stdout)["figures"]
    assert {row["variant"] for row in figures} == set(results)
    # nothing was traced again
    assert before == {path: path.stat().st_mtime_ns for path in sorted((folder / "out" / "pieces").rglob("*.nc"))}
    # window 2 is glass in two of three variants, window 1 is another in each
    assert len(pieces) == 5
