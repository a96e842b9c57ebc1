"""A year of illuminance from coefficients, skies and suns."""

import tracemalloc

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from clerestory import (
    ClerestoryError,
    PlainTransmittance,
    Room,
    Site,
    Weather,
    annual_illuminance,
    annual_sun_coefficients,
    daylight_coefficients,
    diffuse_horizontal_illuminance_lx,
    illuminance,
    sky_basis,
    sky_matrix,
    sun_coefficients,
    sun_illuminance,
    sun_normal_illuminance_lx,
    sun_placement_difference,
)
from clerestory.room import Opening, Part, Sensors

SITE = Site(latitude_deg=25.8, longitude_deg=-80.3, timezone="-05:00")
PARTS = ("direct", "redirected", "interreflected")


def days(count=3):
    """Some days of made-up weather, hour by hour."""
    index = pd.date_range("2023-03-20 00:30", periods=24 * count, freq="h", tz="-05:00")
    height = np.maximum(np.sin((index.hour.to_numpy() - 6) * np.pi / 12.0), 0.0)
    cloud = np.repeat(np.linspace(1.0, 0.0, count), 24)
    frame = pd.DataFrame({"dni": 850.0 * height * cloud, "dhi": height * (300.0 - 200.0 * cloud)}, index=index)
    return Weather.from_frame(frame, SITE)


def room(transmittance=0.8):
    glazing = PlainTransmittance(transmittance=transmittance)
    return Room.shoebox(
        width_m=3.0,
        depth_m=4.0,
        height_m=2.7,
        facade_azimuth_deg=180.0,
        openings=[Opening(width_m=2.4, height_m=1.5, parts=(Part(glazing=glazing),))],
        sensors=[Sensors(points_m=[[1.0, 1.0, 0.8], [2.0, 2.0, 0.8], [1.5, 3.0, 0.8]])],
    )


@pytest.fixture(scope="module")
def weather():
    return days()


@pytest.fixture(scope="module")
def coefficients():
    return daylight_coefficients(room(), basis="reinhart577", rounds=4)


@pytest.fixture(scope="module")
def suns(weather):
    return annual_sun_coefficients(room(), None, weather, rounds=8)


@pytest.fixture(scope="module")
def year(coefficients, suns, weather):
    return annual_illuminance(coefficients, suns, weather, standard_errors=True)


def open_field(basis="tregenza145"):
    """Coefficients of one unobstructed horizontal sensor, exactly."""
    bounds = np.asarray(sky_basis(basis).bounds)
    direct = np.asarray(sky_basis(basis).solid_angles) * 0.5 * np.sin(bounds[:, :2]).sum(axis=1)
    direct[-1] = 0.0
    nothing = np.zeros((1, len(direct)))
    return xr.Dataset(
        {
            **dict.fromkeys(PARTS, (("sensor", "patch"), nothing)),
            **{f"{part}_standard_error": (("sensor", "patch"), nothing) for part in PARTS},
            "direct": (("sensor", "patch"), direct[None]),
        },
        coords={name: ("sensor", [0.0]) for name in ("x_m", "y_m", "z_m")},
        attrs={"basis": basis, "ground_reflectance": 0.2, "room": "field"},
    )


def field_suns(altitude, azimuth):
    nothing = np.zeros((1, len(altitude)))
    return xr.Dataset(
        {
            **dict.fromkeys(PARTS, (("sensor", "sun"), nothing)),
            **{f"{part}_standard_error": (("sensor", "sun"), nothing) for part in PARTS},
            "direct": (("sensor", "sun"), np.sin(np.radians(altitude))[None]),
        },
        coords={
            **{name: ("sensor", [0.0]) for name in ("x_m", "y_m", "z_m")},
            "sun_altitude_deg": ("sun", altitude),
            "sun_azimuth_deg": ("sun", azimuth),
        },
    )


def test_open_field_has_the_light_of_sky_and_sun(weather):
    """E = E_diffuse + E_sun sin h."""
    sunny = sun_normal_illuminance_lx(weather).values > 0.0
    altitude = weather.sun.apparent_altitude_deg.values
    suns = field_suns(altitude[sunny], weather.sun.azimuth_deg.values[sunny])
    found = annual_illuminance(open_field(), suns, weather)
    diffuse = diffuse_horizontal_illuminance_lx(weather).values
    direct = sun_normal_illuminance_lx(weather).values * np.sin(np.radians(np.maximum(altitude, 0.0)))
    np.testing.assert_allclose(found.sky[0], diffuse, rtol=1e-4)
    np.testing.assert_allclose(found.sun_direct[0], direct, rtol=1e-5)
    np.testing.assert_allclose(found.total[0], diffuse + direct, rtol=1e-4)
    assert (found.total.values[:, ~sunny & (diffuse == 0.0)] == 0.0).all()


def test_each_time_is_that_of_its_own_sky_and_sun(year, coefficients, suns, weather):
    """Hour by hour through the plain functions; what Monte Carlo finds anew within its standard errors."""
    sunny = np.flatnonzero(sun_normal_illuminance_lx(weather).values > 0.0)
    error = np.zeros(year.total.shape)
    error[:, sunny] = suns.interreflected_standard_error * sun_normal_illuminance_lx(weather).values[sunny]
    for row in (8, 12, 16, 36, 62):
        time = weather.times[row]
        sky = illuminance(coefficients, weather.sky(time).matrix("reinhart577")).total
        here = year.isel(time=row)
        np.testing.assert_allclose(here.sky, sky, rtol=2e-5)
        normal = float(sun_normal_illuminance_lx(weather)[row])
        if normal > 0.0:
            sun = sun_coefficients(
                room(),
                altitude_deg=float(weather.sun.apparent_altitude_deg[row]),
                azimuth_deg=float(weather.sun.azimuth_deg[row]),
                rounds=32,
                seed=5,
            )
            one = sun_illuminance(sun, normal)
            np.testing.assert_allclose(here.sun_direct, one.direct[:, 0], rtol=1e-4, atol=1e-3)
            both = np.hypot(error[:, row], 0.5 * error[:, row])
            assert (np.abs(here.sun_interreflected.values - one.interreflected.values[:, 0]) <= 5.0 * both).all()


def test_parts_sum_to_the_total_and_the_error_bounds_it(year):
    parts = year.sky + year.sun_direct + year.sun_redirected + year.sun_interreflected
    np.testing.assert_allclose(year.total, parts, rtol=1e-6)
    lit = year.total.values > 0.0
    assert (year.total_standard_error.values[lit] > 0.0).all()
    assert year.total.dtype == np.float32
    assert year.total.dims == ("sensor", "time")
    assert list(year.coords)[:1] == ["sensor"]
    assert "local_time" in year.coords


def test_true_suns_are_where_the_sun_is(year, weather):
    sunny = sun_normal_illuminance_lx(weather).values > 0.0
    assert year.sun_offset_deg.values[sunny].max() < 1e-6
    assert np.isnan(year.sun_offset_deg.values[~sunny]).all()


def test_single_precision_loses_less_than_a_millionth(year, coefficients, weather):
    exact = sum(coefficients[part].values for part in PARTS) @ sky_matrix(weather, "reinhart577").values.astype(float)
    np.testing.assert_allclose(year.sky, exact, rtol=1e-6)


def test_little_memory_gives_the_same(year, coefficients, suns, weather, tmp_path):
    tight = annual_illuminance(coefficients, suns, weather, max_memory_mb=0.02)
    for name in ("sky", "total"):
        np.testing.assert_allclose(tight[name], year[name], rtol=1e-6)
    stored = annual_illuminance(coefficients, suns, weather, max_memory_mb=0.007, store=tmp_path / "year.zarr")
    np.testing.assert_allclose(stored.total, year.total, rtol=1e-6)
    np.testing.assert_array_equal(stored.x_m, year.x_m)
    np.testing.assert_array_equal(stored.local_time, year.local_time)
    assert [path.name for path in tmp_path.iterdir()] == ["year.zarr"]


def test_nothing_half_written_is_left(coefficients, suns, weather, tmp_path, monkeypatch):
    def stop(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr(xr.Dataset, "drop_vars", stop)
    with pytest.raises(KeyboardInterrupt):
        annual_illuminance(coefficients, suns, weather, max_memory_mb=0.007, store=tmp_path / "year.zarr")
    assert list(tmp_path.iterdir()) == []


def test_a_sky_of_ones_own_serves(coefficients, weather):
    sky = sky_matrix(weather, "reinhart577")
    np.testing.assert_allclose(
        annual_illuminance(coefficients, None, weather, sky=2.0 * sky).sky,
        2.0 * annual_illuminance(coefficients, None, weather).sky,
        rtol=1e-6,
    )


def test_sectors_of_the_sky_stand_in_for_the_sun_within_a_degree_or_two(coefficients, weather, year):
    fewer = annual_sun_coefficients(room(), None, weather, suns="troplux5221", rounds=2)
    found = annual_illuminance(coefficients, fewer, weather)
    offset = found.sun_offset_deg.values
    assert 0.0 < np.nanmax(offset) < 1.6
    assert found.attrs["suns"] == "troplux5221"
    assert float(found.total.sum()) == pytest.approx(float(year.total.sum()), rel=0.05)


def test_difference_of_the_nearest_suns_is_told(weather):
    told = sun_placement_difference(room(), None, weather, hours=6, rounds=2)
    assert told.exact.shape == told.nearest.shape == (3, 6)
    assert 0.0 < float(told.offset_deg.max()) < 1.6
    assert abs(told.attrs["mean_relative_difference"]) < 0.3
    assert 0.0 <= told.attrs["share_of_flips"] <= 1.0
    assert told.attrs["rms_relative_noise"] > 0.0
    near = sun_placement_difference(room(), None, weather, hours=6, rounds=2, suns="reinhart82945")
    assert float(near.offset_deg.max()) < 0.5
    # what is left is no more than the noise of the two allows
    assert near.attrs["rms_relative_difference"] < 4.0 * near.attrs["rms_relative_noise"] + 0.02


def test_more_transmittance_never_means_less_light(coefficients, suns, weather, year):
    """Half the transmittance gives half the sky's direct light and never more of anything."""
    darker = room(transmittance=0.4)
    found = annual_illuminance(
        daylight_coefficients(darker, basis="reinhart577", rounds=4),
        annual_sun_coefficients(darker, None, weather, rounds=8),
        weather,
    )
    assert (found.total.values <= year.total.values * (1.0 + 1e-6)).all()
    np.testing.assert_allclose(found.sun_direct, 0.5 * year.sun_direct, rtol=1e-5, atol=1e-3)


def test_wrong_pairs_are_refused(coefficients, suns, weather, tmp_path):
    def refused(message, **changed):
        given = {"coefficients": coefficients, "sun_coefficients": suns, "weather": weather} | changed
        with pytest.raises(ClerestoryError, match=message):
            annual_illuminance(**given)

    refused("coefficients must be those of daylight_coefficients", coefficients=suns)
    refused("sun_coefficients must have suns", sun_coefficients=coefficients)
    refused("sun_coefficients must be of the 3 sensors", sun_coefficients=suns.isel(sensor=[0]))
    refused("sun_coefficients must be of the 3 sensors", sun_coefficients=suns.isel(sensor=[1, 0, 2]))
    refused(
        r"must have a sun within 5° of every sun of the weather, got \d+\.\d° at", sun_coefficients=suns.isel(sun=[0])
    )
    refused("sky must have dims", sky=sky_matrix(weather, "tregenza145"))
    refused("max_memory_mb must be greater than 0", max_memory_mb=0.0)
    refused("max_memory_mb must hold twice the result", max_memory_mb=0.001)
    refused(r"store must be a folder ending in \.zarr", store=tmp_path / "year.nc")
    (tmp_path / "there.zarr").mkdir()
    refused("store must not exist yet", store=tmp_path / "there.zarr")
    night = Weather.from_frame(weather.frame * 0.0, SITE)
    with pytest.raises(ClerestoryError, match="weather must have direct irradiance while the sun is up"):
        annual_sun_coefficients(room(), None, night)


def test_memory_stays_below_what_is_allowed(miami_year, tmp_path):
    """Coefficients of 200 sensors and 2305 patches, results of 3.5 MB and a sky of 20 MB, within 10 MB."""
    coefficients = field_of(200, "reinhart2305")
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    annual_illuminance(coefficients, None, miami_year, max_memory_mb=10.0, store=tmp_path / "year.zarr")
    peak = tracemalloc.get_traced_memory()[1] - before
    tracemalloc.stop()
    assert peak < 10e6


def field_of(count, basis):
    one = open_field(basis)
    return xr.concat([one] * count, dim="sensor", data_vars="all", coords="all")


@pytest.fixture(scope="module")
def miami_year():
    return days(90)
