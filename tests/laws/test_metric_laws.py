"""What holds of the metrics of any year."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as some
from tests.metrics.years import hours, year

from clerestory.metrics import (
    ElectricLighting,
    annual_light_exposure,
    annual_sunlight_exposure,
    annual_uniformity,
    continuous_daylight_autonomy,
    daylight_autonomy,
    daylight_provision,
    lighting_energy,
    spatial_daylight_autonomy,
    useful_daylight_illuminance,
)
from clerestory.metrics.useful_daylight_illuminance import BANDS

LUX = some.one_of(some.sampled_from([0.0, 100.0, 299.0, 300.0, 1000.0, 3000.0]), some.floats(0.0, 2e4))
YEARS = some.integers(1, 12).flatmap(
    lambda n: some.lists(some.lists(LUX, min_size=n, max_size=n), min_size=1, max_size=5)
)


@given(YEARS, some.data())
@settings(max_examples=60)
def test_counts_are_those_of_plain_loops(rows, data):
    lit = year(rows)
    chosen = data.draw(some.sets(some.integers(0, len(rows[0]) - 1), min_size=1))
    used = hours(lit, *chosen)
    n = len(chosen)
    enough = [sum(row[h] >= 300.0 for h in chosen) for row in rows]
    np.testing.assert_allclose(daylight_autonomy(lit, occupied=used), [100.0 * count / n for count in enough])
    np.testing.assert_allclose(
        continuous_daylight_autonomy(lit, occupied=used),
        [100.0 * sum(min(row[h] / 300.0, 1.0) for h in chosen) / n for row in rows],
    )
    np.testing.assert_allclose(
        spatial_daylight_autonomy(lit, occupied=used), 100.0 * sum(2 * count >= n for count in enough) / len(rows)
    )
    np.testing.assert_allclose(
        annual_sunlight_exposure(lit, occupied=used, limit_h=2.0),
        100.0 * sum(sum(row[h] >= 1000.0 for h in chosen) > 2 for row in rows) / len(rows),
    )

    def band(lux):
        return BANDS[0] if lux < 100 else BANDS[1] if lux < 300 else BANDS[2] if lux <= 3000 else BANDS[3]

    found = useful_daylight_illuminance(lit, occupied=used)
    for name in BANDS:
        counted = [100.0 * sum(band(row[h]) == name for h in chosen) / n for row in rows]
        np.testing.assert_allclose(found.sel(band=name), counted)
    np.testing.assert_allclose(found.sel(band=list(BANDS[2:])).sum("band"), daylight_autonomy(lit, occupied=used))
    np.testing.assert_allclose(annual_light_exposure(lit), [sum(row) for row in rows])


@given(YEARS, some.floats(1.0, 3.0))
@settings(max_examples=60)
def test_more_light_is_never_less_of_it(rows, more):
    lit = year(rows)
    used, brighter = hours(lit), lit * more
    for metric in (daylight_autonomy, continuous_daylight_autonomy, spatial_daylight_autonomy):
        assert (metric(brighter, occupied=used) >= metric(lit, occupied=used) - 1e-9).all()
    before, after = daylight_provision(lit, daylit=used), daylight_provision(brighter, daylit=used)
    assert int(after.level) >= int(before.level)
    assert (after.minimum_illuminance <= after.target_illuminance).all()
    lamps = ElectricLighting(zone="room")
    saved = [float(lighting_energy(one, occupied=used, lighting=lamps).saved) for one in (lit, brighter)]
    assert saved[1] >= saved[0] - 1e-12
    # nothing is saved beyond all that dimming can save
    assert 0.0 <= saved[1] <= 0.7 * float(lighting_energy(lit, occupied=used, lighting=lamps).without_daylight) + 1e-12


@given(LUX.filter(lambda lux: lux > 0.0), some.integers(1, 5), some.integers(1, 30))
@settings(max_examples=60)
def test_a_constant_year_is_all_or_nothing(lux, sensors, times):
    lit = year([[lux] * times] * sensors)
    used = hours(lit)
    all_of_it = 100.0 if lux >= 300.0 else 0.0
    assert (daylight_autonomy(lit, occupied=used) == all_of_it).all()
    assert float(spatial_daylight_autonomy(lit, occupied=used)) == all_of_it
    np.testing.assert_allclose(continuous_daylight_autonomy(lit, occupied=used), 100.0 * min(lux / 300.0, 1.0))
    assert sorted(useful_daylight_illuminance(lit, occupied=used).isel(sensor=0).values) == [0.0, 0.0, 0.0, 100.0]
    np.testing.assert_allclose(annual_uniformity(lit, occupied=used), 1.0)
    assert float(daylight_provision(lit, daylit=used).target_illuminance) == lux
    assert float(annual_sunlight_exposure(lit, occupied=used, limit_h=0.0)) == (100.0 if lux >= 1000.0 else 0.0)
