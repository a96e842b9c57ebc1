"""A place and its clock."""

import datetime as dt

import numpy as np
import pandas as pd
import pytest

from clerestory.errors import ClerestoryError
from clerestory.site import Site

MACEIO = Site(latitude_deg=-9.67, longitude_deg=-35.74, elevation_m=10.0, timezone="America/Maceio")


@pytest.mark.parametrize(
    "times",
    [
        "2024-06-21 12:00",
        dt.datetime(2024, 6, 21, 12),
        np.datetime64("2024-06-21T12:00"),
        pd.Timestamp("2024-06-21 15:00", tz="UTC"),
        ["2024-06-21 12:00"],
        pd.Series(pd.to_datetime(["2024-06-21 12:00"])),
        pd.DatetimeIndex(["2024-06-21 16:00"], tz="Europe/London"),
    ],
)
def test_every_kind_of_time_is_the_same_moment(times):
    assert MACEIO.moments(times)[0] == pd.Timestamp("2024-06-21 12:00", tz="America/Maceio")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"latitude_deg": 91.0, "longitude_deg": 0.0}, r"latitude_deg must lie in -90..90, got 91"),
        ({"latitude_deg": 0.0, "longitude_deg": 181.0}, r"longitude_deg must lie in -180..180, got 181"),
        ({"latitude_deg": float("nan"), "longitude_deg": 0.0}, r"latitude_deg must be finite, got nan"),
        ({"latitude_deg": "north", "longitude_deg": 0.0}, r"latitude_deg must be a number, got 'north'"),
        (
            {"latitude_deg": 0.0, "longitude_deg": 0.0, "timezone": "Mars/Base"},
            r"timezone must be a known name .* got 'Mars",
        ),
    ],
)
def test_wrong_site_says_name_rule_and_value(values, message):
    with pytest.raises(ClerestoryError, match=message):
        Site(**values)


def test_time_skipped_by_a_clock_change_is_an_error():
    london = Site(latitude_deg=51.5, longitude_deg=0.0, timezone="Europe/London")
    with pytest.raises(ClerestoryError, match=r"times must exist once on the clock of Europe/London"):
        london.moments("2024-03-31 01:30")


@pytest.mark.parametrize("times", ["noon-ish", ["2024-01-01", "NaT"], [None]])
def test_unreadable_time_is_an_error(times):
    with pytest.raises(ClerestoryError, match="times must"):
        MACEIO.moments(times)
