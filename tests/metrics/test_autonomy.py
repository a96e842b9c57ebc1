"""Daylight autonomy in its kinds, counted by hand."""

import numpy as np
import pytest
import xarray as xr
from tests.metrics.years import hours, year

from clerestory.errors import ClerestoryError
from clerestory.metrics import (
    annual_sunlight_exposure,
    continuous_daylight_autonomy,
    daylight_autonomy,
    spatial_daylight_autonomy,
    sunlit_hours,
    useful_daylight_illuminance,
)

# hour 4 is out of use
LIT = year([[300.0, 299.0, 0.0, 600.0, 9999.0], [30.0, 150.0, 3000.0, 3001.0, 0.0]])
USED = hours(LIT, 0, 1, 2, 3)


def test_autonomy_counts_the_hours_at_the_target_or_above():
    # 300 and 600; 3000 and 3001
    assert daylight_autonomy(LIT, occupied=USED).values.tolist() == [50.0, 50.0]
    assert daylight_autonomy(LIT, occupied=USED, threshold_lx=299.0).values.tolist() == [75.0, 50.0]


def test_continuous_autonomy_gives_an_hour_its_share():
    found = continuous_daylight_autonomy(LIT, occupied=USED)
    np.testing.assert_allclose(found, [100 * (1 + 299 / 300 + 0 + 1) / 4, 100 * (0.1 + 0.5 + 1 + 1) / 4], rtol=1e-14)


def test_four_bands_hold_each_hour_once():
    found = useful_daylight_illuminance(LIT, occupied=USED)
    assert found.sel(band="fell-short").values.tolist() == [25.0, 25.0]  # 0; 30
    assert found.sel(band="supplementary").values.tolist() == [25.0, 25.0]  # 299; 150
    assert found.sel(band="autonomous").values.tolist() == [50.0, 25.0]  # 300 and 600; 3000
    assert found.sel(band="exceeded").values.tolist() == [0.0, 25.0]  # 3001
    with pytest.raises(ClerestoryError, match="three rising"):
        useful_daylight_illuminance(LIT, occupied=USED, limits_lx=(300, 100, 3000))


def test_spatial_autonomy_is_the_share_of_sensors_with_enough():
    lit = year([[300, 300, 0, 0], [300, 0, 0, 0], [300, 300, 300, 0]])
    # two of three sensors have it in half of the hours
    assert float(spatial_daylight_autonomy(lit, occupied=hours(lit))) == pytest.approx(200 / 3)
    assert float(spatial_daylight_autonomy(lit, occupied=hours(lit), hours_percent=75.0)) == pytest.approx(100 / 3)


def test_autonomy_of_a_seventh_is_reached_by_a_seventh():
    lit = year([[300.0, 300.0, 300.0, 0, 0, 0, 0]])
    assert float(spatial_daylight_autonomy(lit, occupied=hours(lit), hours_percent=100.0 * 3 / 7)) == 100.0


def test_sunlight_exposure_is_the_share_of_sensors_with_more_than_250_hours():
    sun = np.zeros((3, 300))
    sun[0, :251], sun[1, :250], sun[2, :] = 1000.0, 5000.0, 999.0
    sunny = year(sun)
    assert sunlit_hours(sunny, occupied=hours(sunny)).values.tolist() == [251.0, 250.0, 0.0]
    assert float(annual_sunlight_exposure(sunny, occupied=hours(sunny))) == pytest.approx(100 / 3)
    # half-hour steps make half the hours
    assert float(annual_sunlight_exposure(sunny, occupied=hours(sunny), interval_h=0.5)) == 0.0


def test_hours_that_cannot_be_counted_are_refused():
    with pytest.raises(ClerestoryError, match="at least one hour that counts, got none"):
        daylight_autonomy(LIT, occupied=hours(LIT, 99))
    with pytest.raises(ClerestoryError, match="must have the 5 times"):
        daylight_autonomy(LIT, occupied=USED.isel(time=slice(3)))
    with pytest.raises(ClerestoryError, match="must have the times of illuminance"):
        daylight_autonomy(LIT, occupied=USED.assign_coords(time=LIT["time"] + np.timedelta64(1, "h")))
    with pytest.raises(ClerestoryError, match="bool over time alone"):
        daylight_autonomy(LIT, occupied=USED.astype(float))
    with pytest.raises(ClerestoryError, match="a missing value"):
        daylight_autonomy(xr.where(LIT == 600.0, np.nan, LIT), occupied=USED)
    # night and holidays may hold anything
    daylight_autonomy(xr.where(LIT == 9999.0, np.nan, LIT), occupied=USED)
