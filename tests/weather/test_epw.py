"""EPW files: whole ones are read as they are, broken ones understood with a note or refused in one line."""

import re

import numpy as np
import pandas as pd
import pytest
from pvlib import iotools

from clerestory import ClerestoryError, Site, read_epw

from .conftest import HEADER_LINES, MIAMI, row, with_field

DIRECT, DIFFUSE = "direct_normal_irradiance_w_m2", "diffuse_horizontal_irradiance_w_m2"


def changed(index, field, value):
    def change(lines):
        lines[index] = with_field(lines[index], field, value)
        return lines

    return change


def test_values_are_those_that_pvlib_reads(miami):
    table, place = iotools.read_epw(MIAMI)
    for column, name in ((DIRECT, "dni"), (DIFFUSE, "dhi"), ("dew_point_c", "temp_dew"), ("dry_bulb_c", "temp_air")):
        np.testing.assert_array_equal(miami.frame[column], table[name])
    assert miami.site.latitude_deg == place["latitude"]
    assert miami.site.longitude_deg == place["longitude"]


def test_hours_end_when_they_say(miami):
    """Hour 1 is the first of the day: its middle is half past midnight."""
    assert miami.times[0].strftime("%m-%d %H:%M %z") == "01-01 00:30 -0500"
    assert miami.times[-1].strftime("%m-%d %H:%M") == "12-31 23:30"
    assert miami.frame[DIRECT].iloc[12] == 324.0  # 1 January, hour 13: 12 to 13 o'clock


def test_first_weekday_is_that_of_the_header(miami):
    assert miami.times[0].day_name() == "Sunday"
    assert any("begins on a Sunday" in note for note in miami.notes)


def test_light_comes_while_the_sun_is_up(miami):
    lit = miami.frame[DIFFUSE].to_numpy() > 5.0
    assert miami.sun.altitude_deg.values[lit].min() > -8.5


def test_wall_clock_of_the_site_keeps_the_moments(miami):
    here = read_epw(MIAMI, timezone="America/New_York")
    assert (here.times == miami.times).all()
    assert here.times[4344].strftime("%H:%M") == "01:30"  # summer time in July
    assert here.site.timezone == "America/New_York"


def test_wall_clock_of_another_place_is_refused():
    with pytest.raises(
        ClerestoryError, match=r"epw:1: timezone must keep the file's standard time, UTC-5 h, got 'Asia"
    ):
        read_epw(MIAMI, timezone="Asia/Tokyo")


def test_place_given_goes_before_that_of_the_file():
    site = Site(latitude_deg=25.8, longitude_deg=-80.2, timezone="America/New_York")
    assert read_epw(MIAMI, site=site).site == site


def test_missing_codes_by_night_are_zero(spoiled):
    found = read_epw(spoiled(changed(row(6, 21, 2), 14, 9999)))
    assert found.frame[DIRECT].iloc[row(6, 21, 2) - HEADER_LINES] == 0.0
    assert "direct normal irradiance: 1 missing values by night are 0" in found.notes


def test_short_gap_is_filled_between_its_ends(spoiled, miami):
    def change(lines):
        for hour in (12, 13):
            for field in (13, 14, 15):
                lines[row(4, 2, hour)] = with_field(lines[row(4, 2, hour)], field, 9999)
        return lines

    found = read_epw(spoiled(change))
    at = row(4, 2, 12) - HEADER_LINES
    ends = miami.frame[DIFFUSE].iloc[[at - 1, at + 2]]
    filled = found.frame[DIFFUSE].iloc[at : at + 2]
    assert (filled > 0.8 * ends.min()).all()
    assert (filled < 1.2 * ends.max()).all()
    assert "diffuse horizontal irradiance: 2 missing values by day are filled, longest gap 2 h" in found.notes


def test_missing_direct_follows_from_the_global(spoiled, miami):
    at = row(4, 2, 12)
    found = read_epw(spoiled(changed(at, 14, 9999)))
    assert "1 missing values follow from the global" in " ".join(found.notes)
    assert found.frame[DIRECT].iloc[at - HEADER_LINES] == pytest.approx(
        miami.frame[DIRECT].iloc[at - HEADER_LINES], rel=0.05
    )


def test_missing_rows_are_put_in(spoiled, miami):
    found = read_epw(spoiled(lambda lines: [x for k, x in enumerate(lines) if k not in (row(3, 1, 3), row(3, 1, 12))]))
    assert len(found) == 8760
    assert "2 rows were missing" in found.notes
    np.testing.assert_allclose(found.frame[DIFFUSE].sum(), miami.frame[DIFFUSE].sum(), rtol=1e-3)


def test_last_night_hours_are_put_in(spoiled):
    assert len(read_epw(spoiled(lambda lines: lines[:-2]))) == 8760


def test_long_gap_is_refused_with_its_line(spoiled):
    path = spoiled(lambda lines: lines[: row(3, 1, 8)] + lines[row(3, 1, 16) :])
    with pytest.raises(
        ClerestoryError,
        match=rf"spoiled.epw:{row(3, 1, 8)}: .*longer than at most 3 hours of daylight, got 8 from 01 Mar",
    ):
        read_epw(path)
    assert len(read_epw(path, max_gap_hours=8.0)) == 8760


def test_leap_day_is_kept(spoiled):
    def change(lines):
        day = [with_field(line, 2, 29) for line in lines[row(2, 28, 1) : row(3, 1, 1)]]
        return lines[: row(3, 1, 1)] + day + lines[row(3, 1, 1) :]

    found = read_epw(spoiled(change))
    assert len(found) == 8784
    assert found.times[0].day_name() == "Sunday"
    assert any("29 February" in note for note in found.notes)


def test_years_of_one_stretch_are_kept(spoiled):
    def change(lines):
        return lines[:HEADER_LINES] + [with_field(line, 0, 2019) for line in lines[HEADER_LINES:]]

    assert set(read_epw(spoiled(change)).times.year) == {2019}


def test_longitude_of_the_wrong_sign_is_mirrored(spoiled):
    """Far from Greenwich the clock and the light contradict it."""
    found = read_epw(spoiled(changed(0, 7, "80.30")))
    assert found.site.longitude_deg == -80.30
    assert any("wrong sign" in note for note in found.notes)


def test_longitude_of_the_wrong_sign_is_found_near_greenwich():
    """Where the clock does not tell, the hours in which light comes do."""
    from clerestory.weather.daylight import checked_site

    true = Site(latitude_deg=40.45, longitude_deg=-3.55, timezone="+01:00")
    frame = _clear_year(true)
    wrong = Site(latitude_deg=40.45, longitude_deg=3.55, timezone="+01:00")
    for given in (true, wrong):
        found, notes = checked_site(frame, given, interval_minutes=60.0, wrong=ClerestoryError)
        assert found.longitude_deg == -3.55
        assert len(notes) == (given is wrong)


def _clear_year(site):
    from clerestory import sun_position
    from clerestory.weather.course import course

    index = pd.date_range("2023-01-01 00:05", periods=8760 * 6, freq="10min", tz=site.timezone)
    altitude = sun_position(site, index).apparent_altitude_deg.values
    table = pd.DataFrame({DIRECT: 900 * course(DIRECT, altitude), DIFFUSE: 150 * course(DIFFUSE, altitude)}, index)
    return table.resample("h").mean().shift(30, freq="min")


def test_light_at_night_is_refused(spoiled):
    with pytest.raises(
        ClerestoryError, match=r"epw:1: light and sun must agree, .* they would fit a sun 7\.\d h later"
    ):
        read_epw(spoiled(changed(0, 7, "25.0")))


def test_light_an_hour_off_is_told(spoiled):
    found = read_epw(spoiled(changed(0, 7, "-68.0")))
    assert any(re.search(r"day begins and ends about (45|50|55) min later than the sun", note) for note in found.notes)


def test_latin_1_names_are_read(spoiled):
    path = spoiled(changed(0, 1, "Maceió Zumbi dos Palmares"), encoding="latin-1")
    found = read_epw(path)
    assert "Maceió Zumbi" in found.source
    assert "text is Latin-1, not UTF-8" in found.notes


def test_comma_in_the_name_is_understood(spoiled):
    found = read_epw(spoiled(changed(0, 1, "Miami, Intl Ap")))
    assert found.site.latitude_deg == 25.82
    assert any("commas too many" in note for note in found.notes)


def test_header_without_its_other_lines_is_enough(spoiled, miami):
    found = read_epw(spoiled(lambda lines: lines[:1] + lines[HEADER_LINES:]))
    assert found.frame[DIRECT].sum() == miami.frame[DIRECT].sum()
    assert any("DATA PERIODS" in note for note in found.notes)


@pytest.mark.parametrize("minutes", [("15", "30", "45", "60"), ("15", "30", "45", "0"), ("0", "15", "30", "45")])
def test_quarters_of_hours_are_read_however_minutes_are_written(spoiled, minutes, miami):
    def change(lines):
        lines[7] = lines[7].replace("DATA PERIODS,1,1", "DATA PERIODS,1,4")
        rows = [with_field(line, 4, minute) for line in lines[HEADER_LINES : row(2, 1, 1)] for minute in minutes]
        return lines[:HEADER_LINES] + rows

    found = read_epw(spoiled(change))
    assert found.interval_minutes == 15.0
    assert found.times[0].strftime("%H:%M:%S") == "00:07:30"
    assert found.frame[DIRECT].sum() == pytest.approx(4.0 * miami.frame[DIRECT].iloc[: 31 * 24].sum())


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda x: x[1:], r"spoiled.epw:1: an EPW file must have a line LOCATION,city,…, got 'DESIGN CONDITIONS"),
        (lambda x: x[:8], r"spoiled.epw:8: there must be rows of weather after the header, got none"),
        (changed(0, 6, "north"), r"spoiled.epw:1: latitude must be a number, got 'north'"),
        (changed(0, 6, "91"), r"spoiled.epw:1: latitude_deg must lie in -90..90, got 91"),
        (changed(0, 8, "33"), r"spoiled.epw:1: time zone must lie in -12..14 hours, got 33"),
        (
            lambda x: [",".join(x[0].split(",")[:7]), *x[1:]],
            r"spoiled.epw:1: LOCATION must have 9 fields after it, got 6",
        ),
        (changed(7, 2, "7"), r"spoiled.epw:8: rows an hour must divide 60, got 7"),
        (changed(7, 1, "2"), r"spoiled.epw:8: DATA PERIODS must be one period, got 2; split the file"),
        (changed(20, 14, "much"), r"spoiled.epw:21: direct normal irradiance must be a number, got 'much'"),
        (changed(20, 14, "4000"), r"spoiled.epw:21: direct normal irradiance must lie in 0..1500 W/m2, got 4000"),
        (changed(20, 15, "-300"), r"spoiled.epw:21: diffuse horizontal irradiance must lie in 0..1500 W/m2, got -300"),
        (changed(20, 1, "13"), r"spoiled.epw:21: month and day must be a date, got month 13, day 1"),
        (changed(8, 3, "0"), r"spoiled.epw:9: hour must be 1..24, .* if hours count from 0, add 1 to each"),
        (lambda x: x[:20] + x[19:], r"spoiled.epw:21: times must go forward, got 01 January 11:30, which repeats"),
        (lambda x: x[:30] + x[10:], r"spoiled.epw:31: times must go forward, got 01 January 02:30, which comes after"),
        (lambda x: [*x[:40], "1995,1,2,9,0,?9", *x[41:]], r"spoiled.epw:41: a row must have at least 16 fields, got 6"),
    ],
)
def test_broken_file_is_refused_in_one_line(spoiled, change, message):
    with pytest.raises(ClerestoryError, match=message) as told:
        read_epw(spoiled(change))
    assert "\n" not in str(told.value)


def test_file_that_is_not_there_or_no_text(tmp_path):
    with pytest.raises(ClerestoryError, match=r"none.epw must be a file to read, got: No such file"):
        read_epw(tmp_path / "none.epw")
    (tmp_path / "a.epw").write_bytes(b"PK\0\0\0")
    with pytest.raises(ClerestoryError, match=r"must be a text file, got binary data"):
        read_epw(tmp_path / "a.epw")
    (tmp_path / "b.epw").write_bytes(b"\n")
    with pytest.raises(ClerestoryError, match=r"got an empty file"):
        read_epw(tmp_path / "b.epw")
