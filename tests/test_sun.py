"""Where the sun stands."""

import numpy as np
import pandas as pd
import pytest

from clerestory.errors import ClerestoryError
from clerestory.site import Site
from clerestory.sun import direction_of, sun_position

GOLDEN = Site(latitude_deg=39.742476, longitude_deg=-105.1786, elevation_m=1830.14, timezone="-07:00")


def test_worked_example_of_the_algorithms_report():
    """Reda and Andreas, NREL/TP-560-34302, Table A5.1: zenith 50.11162° with refraction, azimuth 194.34024°."""
    sun = sun_position(GOLDEN, "2003-10-17 12:30:30", pressure_pa=82_000.0, temperature_c=11.0)
    assert float(sun.apparent_altitude_deg[0]) == pytest.approx(90.0 - 50.11162, abs=2e-4)
    assert float(sun.azimuth_deg[0]) == pytest.approx(194.34024, abs=2e-4)


def almanac(moment: pd.Timestamp) -> tuple[float, float]:
    """Declination and equation of time [deg], low-precision formulas of the Astronomical Almanac (page C5), good to
    0.01° from 1950 to 2050: another way to the same sky."""
    n = moment.to_julian_date() - 2_451_545.0
    mean_longitude = (280.460 + 0.9856474 * n) % 360.0
    anomaly = np.radians((357.528 + 0.9856003 * n) % 360.0)
    longitude = np.radians(mean_longitude + 1.915 * np.sin(anomaly) + 0.020 * np.sin(2 * anomaly))
    obliquity = np.radians(23.439 - 4e-7 * n)
    ascension = np.degrees(np.arctan2(np.cos(obliquity) * np.sin(longitude), np.cos(longitude)))
    declination = np.degrees(np.arcsin(np.sin(obliquity) * np.sin(longitude)))
    return declination, (mean_longitude - ascension + 180.0) % 360.0 - 180.0


@pytest.mark.parametrize("latitude_deg", [-67.0, -9.67, 0.0, 45.0])
def test_agrees_with_the_almanac_from_1950_to_2050(latitude_deg):
    """Direction within 0.03°: 0.01° each in the almanac's longitude and equation of time, 0.0024° of parallax."""
    site = Site(latitude_deg=latitude_deg, longitude_deg=-35.74)
    rng = np.random.default_rng(1)
    moments = pd.DatetimeIndex(
        pd.Timestamp("1950-01-01", tz="UTC") + pd.to_timedelta(rng.uniform(0.0, 100.0 * 365.25, 400), unit="D")
    )
    sun = sun_position(site, moments)
    ours = direction_of(sun.altitude_deg, sun.azimuth_deg)
    for row, moment in enumerate(moments):
        declination, equation = almanac(moment.tz_localize(None))
        hours = (moment - moment.normalize()) / pd.Timedelta(hours=1)
        hour_angle = np.radians(15.0 * (hours - 12.0) + site.longitude_deg + equation)
        delta, phi = np.radians(declination), np.radians(latitude_deg)
        east = -np.cos(delta) * np.sin(hour_angle)
        north = np.sin(delta) * np.cos(phi) - np.cos(delta) * np.cos(hour_angle) * np.sin(phi)
        up = np.sin(delta) * np.sin(phi) + np.cos(delta) * np.cos(hour_angle) * np.cos(phi)
        assert np.degrees(np.linalg.norm(ours[row] - [east, north, up])) < 0.03


def test_sun_rises_in_the_east_and_stands_north_of_a_southern_city_in_june():
    maceio = Site(latitude_deg=-9.67, longitude_deg=-35.74, timezone="America/Maceio")
    sun = sun_position(maceio, ["2024-06-21 06:30", "2024-06-21 11:25", "2024-06-21 16:30"])
    morning, noon, evening = sun.azimuth_deg.values
    assert 45.0 < morning < 90.0
    assert min(noon, 360.0 - noon) < 2.0
    assert 270.0 < evening < 315.0
    assert float(sun.altitude_deg[1]) == pytest.approx(90.0 - 23.44 - 9.67, abs=0.05)
    assert pd.Timestamp(sun.local_time.values[1]) == pd.Timestamp("2024-06-21 11:25")
    assert pd.Timestamp(sun.time.values[1]) == pd.Timestamp("2024-06-21 14:25")


def test_refraction_lifts_the_horizon_by_half_a_degree_and_vanishes_at_the_zenith():
    site = Site(latitude_deg=0.0, longitude_deg=0.0)
    sun = sun_position(site, pd.date_range("2024-03-20", "2024-03-21", freq="min", tz="UTC"))
    lift = (sun.apparent_altitude_deg - sun.altitude_deg).values
    altitude = sun.altitude_deg.values
    assert lift[np.argmin(np.abs(altitude))] == pytest.approx(0.48, abs=0.03)
    assert abs(lift[np.argmax(altitude)]) < 1e-3
    assert (lift >= -1e-4).all()


def test_directions_point_north_east_and_up():
    np.testing.assert_allclose(direction_of([0, 0, 90], [0, 90, 0]), [[0, 1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-15)


@pytest.mark.parametrize(("altitude", "azimuth"), [(91.0, 0.0), (np.nan, 0.0), (0.0, np.inf)])
def test_impossible_direction_is_an_error(altitude, azimuth):
    with pytest.raises(ClerestoryError, match="altitude_deg"):
        direction_of(altitude, azimuth)


def test_air_that_is_none_is_an_error():
    with pytest.raises(ClerestoryError, match=r"pressure_pa must lie in 30000..110000, got 10"):
        sun_position(GOLDEN, "2024-01-01", pressure_pa=10.0)
