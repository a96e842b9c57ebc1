"""Which hours count, by the calendar and by the clock."""

import numpy as np
import pandas as pd
import pytest
from tests.metrics.years import year

from clerestory.errors import ClerestoryError
from clerestory.metrics import ANALYSIS_HOURS, Schedule, daylit_hours, occupied_hours
from clerestory.metrics.schedule import DAYS

# the middles of the hours of 2023 on the standard time of New York
YEAR = pd.date_range("2023-01-01 00:30", periods=8760, freq="h", tz="-05:00")


def test_analysis_hours_are_3650():
    assert int(occupied_hours(YEAR, ANALYSIS_HOURS).sum()) == 3650
    # and they are 8 to 18 h
    local = pd.DatetimeIndex(occupied_hours(YEAR).local_time.values[occupied_hours(YEAR).values])
    assert (local.hour.min(), local.hour.max()) == (8, 17)


def test_working_days_of_2023_are_260():
    assert int(occupied_hours(YEAR, Schedule()).sum()) == 260 * 10
    assert int(occupied_hours(YEAR, Schedule(days=("saturday", "sunday"))).sum()) == 105 * 10


def test_summer_time_moves_the_hours_of_the_clock():
    found = occupied_hours(YEAR, Schedule(days=DAYS, clock="America/New_York"))
    by_day = pd.Series(found.values, index=YEAR)
    winter, summer = by_day.loc["2023-02-01"], by_day.loc["2023-07-01"]
    assert winter[winter].index.hour.tolist() == list(range(8, 18))
    assert summer[summer].index.hour.tolist() == list(range(7, 17))
    # from 12 March to 4 November: on every day of the year ten hours count all the same
    assert int(found.sum()) == 3650
    moved = by_day[by_day].groupby(by_day[by_day].index.date).apply(lambda day: day.index[0].hour == 7)
    assert int(moved.sum()) == (pd.Timestamp("2023-11-05") - pd.Timestamp("2023-03-12")).days


def test_holidays_and_spans():
    term = Schedule(hours=("08:00-12:00", "13:30-17:00"), holidays=("07-01/07-31", "12-20/01-10", "2023-04-07"))
    found = occupied_hours(YEAR, term)
    used = pd.Series(found.values, index=YEAR)
    assert not used.loc["2023-07"].any()
    assert not used.loc["2023-12-20":].any()
    assert not used.loc[:"2023-01-10"].any()
    assert not used.loc["2023-04-07"].any()
    assert used.loc["2023-04-06"].sum() == 4 + 4  # 13:30 counts: it is the middle of its hour
    assert used.loc["2023-01-11"].sum() == 8


def test_the_end_of_a_span_does_not_count():
    day = occupied_hours(YEAR[24:48], Schedule(hours=("08:30-16:30",)))
    assert np.flatnonzero(day).tolist() == list(range(8, 16))


def test_a_typical_year_has_the_calendar_it_is_given():
    # 1 January 2023 is a Sunday, that of 2024 a Monday
    january = YEAR[:24]
    assert not occupied_hours(january, Schedule()).any()
    assert int(occupied_hours(january, Schedule(year=2024)).sum()) == 10
    leap_day = pd.DatetimeIndex(["2020-02-29 12:30"]).tz_localize("UTC")
    with pytest.raises(ClerestoryError, match="29th of February"):
        occupied_hours(leap_day, Schedule(year=2023))


def test_times_are_kept_as_utc():
    found = occupied_hours(YEAR[:2])
    assert str(found["time"].values[0]) == "2023-01-01T05:30:00.000000000"


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"hours": ("8-18",)}, "spans such as \"08:00-18:00\", got '8-18'"),
        ({"hours": ("22:00-06:00",)}, "must begin before they end on one day"),
        ({"hours": "08:00-18:00"}, "must be a list of texts"),
        ({"days": ("mondays",)}, "did you mean 'monday'"),
        ({"holidays": ("25 December",)}, "must be days such as"),
        ({"holidays": ("02-30",)}, "must be days such as"),
        ({"holidays": ("2023-12-20/01-05",)}, "must be days such as"),
        ({"clock": "Miami"}, "a time zone such as \"America/New_York\", got 'Miami'"),
        ({"year": 23}, "1583..9999"),
    ],
)
def test_a_wrong_schedule_is_told(wrong, message):
    with pytest.raises(ClerestoryError) as told:
        Schedule(**wrong)
    assert message in str(told.value)


def test_times_without_a_zone_are_refused():
    with pytest.raises(ClerestoryError, match="must have a time zone"):
        occupied_hours(YEAR.tz_localize(None))


def test_daylit_is_the_brighter_half():
    outside = year([[0.0, 0.0, 5.0, 9.0, 7.0, 5.0, 1.0, 0.0]]).isel(sensor=0, drop=True)
    # four of eight; 5 stands twice, both in
    assert np.flatnonzero(daylit_hours(outside)).tolist() == [2, 3, 4, 5]
    # the earlier of equals
    assert np.flatnonzero(daylit_hours(outside.isel(time=slice(0, 6)))).tolist() == [2, 3, 4]
    # dark hours never count
    assert np.flatnonzero(daylit_hours(outside.where(outside > 6.0, 0.0))).tolist() == [3, 4]
    with pytest.raises(ClerestoryError, match="dark year"):
        daylit_hours(outside * 0.0)
