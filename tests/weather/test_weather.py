"""Weather from tables and WEA files, and in shorter intervals."""

import numpy as np
import pandas as pd
import pytest

from clerestory import ClerestoryError, Site, Weather, read_wea

DIRECT, DIFFUSE = "direct_normal_irradiance_w_m2", "diffuse_horizontal_irradiance_w_m2"
SITE = Site(latitude_deg=39.74, longitude_deg=-105.18, elevation_m=1829.0, timezone="-07:00")


def table(times, direct=500.0, diffuse=100.0):
    return pd.DataFrame({"dni": direct, "dhi": diffuse}, index=pd.DatetimeIndex(times))


@pytest.mark.parametrize("minutes", [30, 15, 5])
def test_shorter_intervals_keep_the_energy(miami, minutes):
    parts = round(60 / minutes)
    fine = miami.resampled(minutes)
    assert len(fine) == 8760 * parts
    for column in (DIRECT, DIFFUSE):
        means = fine.frame[column].to_numpy().reshape(-1, parts).mean(axis=1)
        np.testing.assert_allclose(means, miami.frame[column], atol=1e-9)


def test_shorter_intervals_have_their_own_sun(miami):
    fine = miami.resampled(15)
    assert fine.times[2] - fine.times[1] == pd.Timedelta(minutes=15)
    assert fine.times[:4].mean() == miami.times[0]
    dark = fine.sun.apparent_altitude_deg.values <= 0.0
    lit = fine.frame[DIRECT].to_numpy() > 0.0
    assert (lit & dark).sum() < 0.01 * lit.sum()
    assert (miami.resampled(60)) is miami


def test_shorter_intervals_follow_a_cloudless_day():
    """A day that follows the course of the sun exactly is found again to 2 % of its noon."""
    fine = pd.date_range("2023-06-21 00:02:30", periods=288, freq="5min", tz=SITE.timezone)
    from clerestory import sun_position
    from clerestory.weather.course import course

    altitude = sun_position(SITE, fine).apparent_altitude_deg.values
    true = pd.DataFrame({"dni": 1100 * course(DIRECT, altitude), "dhi": 120 * course(DIFFUSE, altitude)}, fine)
    hours = true.resample("h").mean()
    again = Weather.from_frame(hours, SITE, times="start").resampled(5).frame
    assert np.abs(again[DIRECT].to_numpy() - true["dni"].to_numpy()).max() < 0.02 * true["dni"].max()
    assert np.abs(again[DIFFUSE].to_numpy() - true["dhi"].to_numpy()).max() < 0.02 * true["dhi"].max()


def test_shorter_intervals_follow_clouds_that_come_evenly():
    """Clouds that thicken through the day do so within each hour, not in steps."""
    from clerestory import sun_position
    from clerestory.weather.course import course

    fine = pd.date_range("2023-06-21 00:02:30", periods=288, freq="5min", tz=SITE.timezone)
    altitude = sun_position(SITE, fine).apparent_altitude_deg.values
    clearing = np.linspace(1.0, 0.0, 288)
    true = pd.DataFrame({"dni": 1100 * clearing * course(DIRECT, altitude), "dhi": 0.0 * altitude}, fine)
    again = Weather.from_frame(true.resample("h").mean(), SITE, times="start").resampled(5).frame[DIRECT].to_numpy()
    high = altitude > 15.0
    assert np.abs(again - true["dni"].to_numpy())[high].max() < 0.005 * true["dni"].max()


@pytest.mark.parametrize("minutes", [25, 90, 0, -15])
def test_intervals_that_do_not_fit_are_refused(miami, minutes):
    with pytest.raises(ClerestoryError, match="minutes must"):
        miami.resampled(minutes)


def test_wea_comes_back_as_it_was(miami, tmp_path):
    path = miami.to_wea(tmp_path / "miami.wea")
    again = read_wea(path)
    assert again.site == miami.site
    assert (again.times == miami.times).all()
    np.testing.assert_allclose(again.frame[DIRECT], miami.frame[DIRECT], rtol=1e-5)
    assert path.read_text().splitlines()[1:4] == ["latitude 25.82", "longitude 80.3", "time_zone 75"]


def test_wea_of_chosen_hours_is_kept_as_it_is(tmp_path):
    path = tmp_path / "hours.wea"
    path.write_text(
        "place Golden\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\nsite_elevation 1829\n"
        "weather_data_file_units 1\n"
        "3 21 12.500 850 90\n6 21 8.500 700 100\n"
    )
    found = read_wea(path, max_gap_hours=None)
    assert len(found) == 2
    assert found.sun.altitude_deg.values.round() == pytest.approx([51, 42], abs=1)
    with pytest.raises(ClerestoryError, match=r"hours.wea:\d: .* must"):
        read_wea(path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("latitude 39\n3 21 12.5 850 90\n", r"a.wea:2: a WEA file must say longitude before its rows"),
        ("latitude north\n", r"a.wea:1: latitude must be a number, got 'north'"),
        (
            "latitude 3\nlongitude 3\ntime_zone 0\nweather_data_file_units 2\n1 1 12 3 4",
            r"a.wea:4: weather_data_file_units",
        ),
        ("latitude 3\nlongitude 3\ntime_zone 0\n1 1 12.5 3\n", r"a.wea:4: a row must be month day hour direct diffuse"),
        ("latitude 3\nlongitude 3\ntime_zone 0\n1 1 12.5 3 x\n", r"a.wea:4: .* must be a number, got 'x'"),
        ("latitude 3\nlongitude 3\ntime_zone 0\n1 1 25 3 3\n", r"a.wea:4: hour must lie in 0..24, got 25"),
        ("latitude 3\nlongitude 3\ntime_zone 0\n1 1 12.5 3000 3\n", r"a.wea:4: direct normal irradiance must lie in"),
        ("latitude 3\nlongitude 3\ntime_zone 0\n", r"a.wea:3: there must be rows of weather"),
        ("latitude 93\nlongitude 3\ntime_zone 0\n1 1 12 3 3\n", r"a.wea:1: latitude_deg must lie in"),
    ],
)
def test_broken_wea_is_refused_in_one_line(tmp_path, text, message):
    path = tmp_path / "a.wea"
    path.write_text(text)
    with pytest.raises(ClerestoryError, match=message):
        read_wea(path)


@pytest.mark.parametrize(("marks", "middle"), [("start", "10:30"), ("middle", "10:00"), ("end", "09:30")])
def test_times_mark_what_they_are_said_to(marks, middle):
    found = Weather.from_frame(table(["2023-06-21 10:00", "2023-06-21 11:00"]), SITE, times=marks)
    assert found.times[0].strftime("%H:%M") == middle


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        (
            table(["2023-06-21 10:00"]).drop(columns="dhi"),
            r"frame must have the column diffuse_.* \(or dhi\), got \['dni",
        ),
        (
            table(["2023-06-21 10:00"], direct=-5.0),
            r"direct_normal_irradiance_w_m2 must lie in 0..1500, got -5 at 2023",
        ),
        (table(["2023-06-21 10:00"], direct=float("nan")), r"direct normal irradiance must not be missing for longer"),
        (table(["2023-06-21 11:00", "2023-06-21 10:00"]), r"frame must have increasing times"),
        (
            table(["2023-06-21 10:00", "2023-06-21 18:00", "2023-06-21 19:00"]),
            r"frame: direct .* longer than at most 3 h",
        ),
        (pd.DataFrame({"dni": ["a"], "dhi": [1.0]}, pd.DatetimeIndex(["2023-06-21 10:00"])), r"must hold numbers"),
        (pd.DataFrame({"dni": [1.0], "dhi": [1.0]}, ["noon"]), r"times must be dates and times"),
        ([1, 2], r"frame must be a pandas DataFrame, got list"),
    ],
)
def test_tables_that_cannot_be_weather_are_refused(frame, message):
    with pytest.raises(ClerestoryError, match=message):
        Weather.from_frame(frame, SITE)
