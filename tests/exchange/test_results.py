"""Results as files of other programs: what they read is what was written."""

import json

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from clerestory import Opening, Room, SensorGrid, daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.exchange import (
    read_ill,
    read_matrix,
    read_pts,
    write_coefficients,
    write_ill,
    write_ladybug_results,
    write_matrix,
    write_pts,
)
from clerestory.exchange.radiance_matrix import matrix_of
from clerestory.sky import sky_basis


def annual():
    """Three sensors in two groups, two days hour by hour, the middle of each hour on the clock; sun from 8 to 16 h."""
    local = pd.date_range("2023-01-01 00:30", periods=48, freq="h")
    daytime = (local.hour >= 8) & (local.hour < 16)
    total = np.where(daytime, 1.0, 0.0) * np.array([[100.0], [250.5], [1234.25]]) + np.where(
        daytime, np.arange(48), 0.0
    )
    return xr.Dataset(
        {"total": (("sensor", "time"), total), "sun_direct": (("sensor", "time"), total / 2.0)},
        coords={
            "time": local - pd.Timedelta(hours=3),
            "local_time": ("time", local),
            "group": ("sensor", ["desk", "desk", "wall / north"]),
            **{f"{axis}_m": ("sensor", [1.0, 2.0, 3.0]) for axis in "xyz"},
            **{f"normal_{axis}": ("sensor", [0.0, 0.0, float(axis == "z")]) for axis in "xyz"},
        },
    )


def test_a_year_as_text_has_month_day_hour_and_a_column_a_sensor(tmp_path):
    path = write_ill(annual(), tmp_path / "room.ill", decimals=2)
    lines = path.read_text().splitlines()
    assert len(lines) == 48
    assert lines[0] == "1 1 0.500 0.00 0.00 0.00"
    assert lines[32] == "1 2 8.500 132.00 282.50 1266.25"
    read = read_ill(path)
    np.testing.assert_allclose(read.values, annual().total.values, atol=5e-3)
    assert read.time.values[32] == np.datetime64("2023-01-02T08:30")
    (tmp_path / "bad.ill").write_text("1 1 0.5 3 4\n1 1 1.5 3\n")
    with pytest.raises(ClerestoryError, match=r"bad.ill, line 2: must have 2 illuminances, got 1"):
        read_ill(tmp_path / "bad.ill")


def test_points_come_back(tmp_path):
    room = Room.shoebox(width_m=3, depth_m=4, height_m=3, sensors=[SensorGrid(spacing_m=1.0)])
    (sensors,) = room.sensor_points()
    read = read_pts(write_pts(sensors, tmp_path / "desk.pts"))
    np.testing.assert_allclose(read.points_m, sensors.points_m, atol=1e-8)
    np.testing.assert_allclose(read.normals, sensors.normals, atol=1e-8)
    assert read.name == "desk"
    (tmp_path / "bad.pts").write_text("0 0 0 0 0\n")
    with pytest.raises(ClerestoryError, match=r"bad.pts, line 1: must be six numbers"):
        read_pts(tmp_path / "bad.pts")


@pytest.mark.parametrize("form", ["ascii", "float", "double"])
def test_a_matrix_comes_back(tmp_path, form):
    values = np.random.default_rng(1).random((4, 7, 3))
    read = read_matrix(write_matrix(values, tmp_path / "a.mtx", form=form, note="a\nb"))
    np.testing.assert_allclose(read, values, rtol=1e-6 if form != "double" else 0.0)
    with pytest.raises(ClerestoryError, match="must hold"):
        matrix_of((tmp_path / "a.mtx").read_bytes()[:-60])


def test_radiance_finds_our_illuminance_from_our_matrix(tmp_path):
    """dctimestep with the matrix written here and gendaymtx's sky gives what coefficients times sky gives."""
    radiance = pytest.importorskip("pyradiance")
    room = Room.shoebox(
        width_m=3,
        depth_m=4,
        height_m=3,
        facade_azimuth_deg=150,
        openings=[Opening(width_m=2, height_m=1.5)],
        sensors=[SensorGrid(spacing_m=1.5)],
    )
    coefficients = daylight_coefficients(room, basis="reinhart577", rounds=2, seed=1)
    weather = tmp_path / "noon.wea"
    weather.write_text(
        "place test\nlatitude 40\nlongitude 105\ntime_zone 105\nsite_elevation 1600\nweather_data_file_units 1\n"
        "3 21 12.0 700 120\n6 21 8.0 300 200\n12 21 15.0 0 80\n"
    )
    sky = radiance.gendaymtx(weather, mfactor=2, outform="d")
    (tmp_path / "sky.smx").write_bytes(sky)
    luminance = 179.0 * matrix_of(sky) @ [0.265, 0.670, 0.065]
    # patch k of Radiance is patch order[k] here
    ours = np.empty_like(luminance)
    ours[np.asarray(sky_basis("reinhart577").order("radiance"))] = luminance
    expected = sum(coefficients[part].values for part in ("direct", "redirected", "interreflected")) @ ours
    for form in ("float", "ascii"):
        path = write_coefficients(coefficients, tmp_path / f"{form}.mtx", form=form)
        # one thread of columns, rows of sensors; the answer is a matrix with its own header
        found = matrix_of(radiance.dctimestep(path, tmp_path / "sky.smx", outform="d"))
        np.testing.assert_allclose(179.0 * found @ [0.265, 0.670, 0.065], expected, rtol=2e-6)
    assert expected.max() > 1000.0


def test_sectors_that_radiance_has_not_are_refused(tmp_path):
    with pytest.raises(ClerestoryError, match="must be over tregenza145 or a reinhart basis"):
        write_coefficients(xr.Dataset(attrs={"basis": "troplux5221"}), tmp_path / "a.mtx")


def test_the_folder_is_laid_out_as_ladybug_tools_reads_it(tmp_path):
    written = write_ladybug_results(annual(), tmp_path / "results")
    assert {str(path.relative_to(tmp_path / "results")) for path in written} == {
        "grids_info.json",
        "grid_states.json",
        "study_info.json",
        "sun-up-hours.txt",
        *(f"__static_apertures__/default/{part}/{grid}.npy" for part in ("total", "direct") for grid in GRIDS),
        *(f"grid/{grid}.pts" for grid in GRIDS),
    }
    info = json.loads((tmp_path / "results" / "grids_info.json").read_text())
    assert [(one["full_id"], one["count"], one["name"]) for one in info] == [
        ("desk", 2, "desk"),
        ("wall_north", 1, "wall / north"),
    ]
    hours = [float(line) for line in (tmp_path / "results" / "sun-up-hours.txt").read_text().split()]
    # the interval from 8 to 9 on the clock is hour 8
    assert hours == [*range(8, 16), *range(32, 40)]
    desk = np.load(tmp_path / "results" / "__static_apertures__/default/total/desk.npy")
    assert desk.dtype == np.float32
    np.testing.assert_allclose(desk, annual().total.values[:2][:, [*range(8, 16), *range(32, 40)]], rtol=1e-6)
    study = json.loads((tmp_path / "results" / "study_info.json").read_text())
    assert study["timestep"] == 1
    assert study["study_hours"] == list(range(48))


GRIDS = ("desk", "wall_north")


def test_hours_are_those_of_standard_time(tmp_path):
    """Where the clock is put forward and back, these formats go on."""
    utc = pd.date_range("2023-01-01 05:30", periods=8760, freq="h")
    local = utc.tz_localize("UTC").tz_convert("America/New_York").tz_localize(None)
    year = xr.Dataset(
        {"total": (("sensor", "time"), np.ones((1, 8760)))}, coords={"time": utc, "local_time": ("time", local)}
    )
    assert len(set(local)) < 8760
    write_ladybug_results(year, tmp_path)
    assert [float(line) for line in (tmp_path / "sun-up-hours.txt").read_text().split()] == list(range(8760))
    assert write_ill(year, tmp_path / "a.ill").read_text().splitlines()[-1] == "12 31 23.500 1.0"


def test_older_recipes_have_text(tmp_path):
    write_ladybug_results(annual(), tmp_path, form="ill")
    rows = [line.split("\t") for line in (tmp_path / "desk.ill").read_text().splitlines()]
    assert [len(row) for row in rows] == [16, 16]
    assert float(rows[1][0]) == pytest.approx(258.5)


def test_what_cannot_be_written_is_told(tmp_path):
    year = annual()
    with pytest.raises(ClerestoryError, match="quantity must be one of total, sun_direct, got 'totl'; did you mean"):
        write_ill(year, tmp_path / "a.ill", quantity="totl")
    broken = year.assign(total=year.total.where(year.sensor != 1) if "sensor" in year.coords else year.total * np.nan)
    with pytest.raises(ClerestoryError, match="must be finite to be written"):
        write_ill(broken, tmp_path / "a.ill")
    leap = year.drop_vars("local_time").assign_coords(time=pd.date_range("2024-02-29 00:30", periods=48, freq="h"))
    with pytest.raises(ClerestoryError, match="must not fall on 29 February"):
        write_ladybug_results(leap, tmp_path)
    with pytest.raises(ClerestoryError, match="a year without light"):
        write_ladybug_results(year * 0.0, tmp_path)
    assert not list(tmp_path.iterdir())
