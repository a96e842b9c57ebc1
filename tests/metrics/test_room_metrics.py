"""What stands for a whole room, counted by hand."""

import numpy as np
import pytest
from tests.metrics.years import hours, year

from clerestory.errors import ClerestoryError
from clerestory.glazing import Open
from clerestory.metrics import (
    ElectricLighting,
    annual_light_exposure,
    annual_uniformity,
    daylight_provision,
    distance_from_window_wall,
    glare_prone_hours,
    lighting_energy,
    useful_depth,
)
from clerestory.room import Opening, Part, Room


def test_provision_is_the_level_that_target_and_minimum_both_reach():
    # medians of the hours: half of them have at least 800, 600, 600, 450, …
    lit = year([[900, 800, 1, 1], [700, 600, 1, 1], [600, 600, 600, 600], [450, 450, 1, 1]])
    found = daylight_provision(lit, daylit=hours(lit))
    # half of four sensors have 600, all but 5 % (that is all four) have 450
    assert float(found.target_illuminance) == 600.0
    assert float(found.minimum_illuminance) == 450.0
    assert (int(found.target_level), int(found.minimum_level), int(found.level)) == (2, 2, 2)
    assert int(daylight_provision(lit * 2.0, daylit=hours(lit)).level) == 3
    assert int(daylight_provision(lit / 2.0, daylit=hours(lit)).level) == 1
    # 299 lx in place of 300 is no level
    assert int(daylight_provision(lit * (299 / 600), daylit=hours(lit)).level) == 0


def test_ninety_five_percent_of_twenty_sensors_are_nineteen():
    lit = year([[0.0]] + [[120.0]] * 10 + [[320.0]] * 9)
    assert float(daylight_provision(lit, daylit=hours(lit)).minimum_illuminance) == 120.0
    lit = year([[0.0]] * 2 + [[120.0]] * 9 + [[320.0]] * 9)
    assert float(daylight_provision(lit, daylit=hours(lit)).minimum_illuminance) == 0.0


def test_exposure_adds_up_all_hours():
    lit = year([[100.0, 0.0, 50.0, 300.0]])
    assert annual_light_exposure(lit).values.tolist() == [450.0]
    assert annual_light_exposure(lit, interval_h=0.25).values.tolist() == [112.5]


def test_uniformity_of_the_year_is_the_median_of_its_lit_hours():
    lit = year([[100.0, 10.0, 0.0, 40.0], [300.0, 30.0, 0.0, 40.0]])
    # 0.5, 0.5, dark, 1 (out of use)
    assert float(annual_uniformity(lit, occupied=hours(lit, 0, 1, 2))) == 0.5
    assert np.isnan(float(annual_uniformity(lit * 0.0, occupied=hours(lit))))


def test_patch_of_the_sun_counts_both_beams_and_each():
    direct = year([[1000.0, 600.0, 0.0, 9000.0], [0.0, 0.0, 0.0, 0.0]])
    turned = year([[0.0, 600.0, 0.0, 0.0], [0.0, 1500.0, 999.0, 0.0]])
    found = glare_prone_hours(direct, turned, occupied=hours(direct, 0, 1, 2))
    assert found.glare_prone_hours.values.tolist() == [2.0, 1.0]
    assert found.by_direct.values.tolist() == [1.0, 0.0]
    assert found.by_redirected.values.tolist() == [0.0, 1.0]
    assert (float(found.anywhere), float(found.anywhere_by_redirected)) == (2.0, 1.0)


def test_lamps_give_what_daylight_leaves():
    lit = year([[0.0, 150.0, 240.0, 270.0, 300.0, 900.0]])
    lamps = ElectricLighting(
        power_density_w_m2=10.0, setpoint_lx=300.0, minimum_power_share=0.3, minimum_light_share=0.2, zone="sensor"
    )
    found = lighting_energy(lit, occupied=hours(lit), lighting=lamps)
    # light still needed: 1, 0.5, 0.2, 0.1, 0, 0; power: 1, 0.3 + 0.7 × 0.3/0.8, then the minimum
    assert float(found.used) == pytest.approx(10 * (1 + 0.5625 + 4 * 0.3) / 1000)
    assert float(found.without_daylight) == pytest.approx(10 * 6 / 1000)
    assert float(found.saved) == pytest.approx(float(found.without_daylight) - float(found.used))
    off = ElectricLighting(power_density_w_m2=10.0, switched_off=True, zone="sensor")
    assert float(lighting_energy(lit, occupied=hours(lit), lighting=off).used) == pytest.approx(
        10 * (1 + 0.5625 + 2 * 0.3) / 1000
    )


def test_a_zone_dims_by_its_darkest_sensor():
    lit = year([[300.0], [0.0], [300.0], [300.0]], row=("sensor", [0, 0, 1, 1]))
    exact = {"power_density_w_m2": 1000.0, "minimum_power_share": 0.0, "minimum_light_share": 0.0}

    def used(zone):
        return float(lighting_energy(lit, occupied=hours(lit), lighting=ElectricLighting(zone=zone, **exact)).used)

    assert (used("sensor"), used("row"), used("room")) == (0.25, 0.5, 1.0)
    loose = year([[300.0], [0.0]], row=("sensor", [-1, -1]))
    with pytest.raises(ClerestoryError, match="in rows of a grid"):
        lighting_energy(loose, occupied=hours(loose))
    with pytest.raises(ClerestoryError, match="zone must be one of sensor, row, room"):
        ElectricLighting(zone="rows")


def test_depth_is_where_the_rows_fall_below_the_level():
    values = year([[90.0], [70.0], [80.0], [60.0], [20.0]]).isel(time=0)
    distance = [1.0, 1.0, 2.0, 3.0, 4.0]
    # rows: 80, 80, 60, 20; from 60 to 20 the level of 50 lies a quarter on
    assert float(useful_depth(values, distance)) == pytest.approx(3.25)
    assert float(useful_depth(values, distance, threshold=81.0)) == 0.0
    last = useful_depth(values, distance, threshold=10.0)
    assert (float(last), last.attrs["at_least"]) == (4.0, 1)


def test_depth_begins_at_the_brightest_row():
    # dark under the sill, bright behind it
    values = year([[40.0], [90.0], [10.0]]).isel(time=0)
    assert float(useful_depth(values, [0.5, 1.5, 2.5])) == pytest.approx(2.0)


@pytest.mark.parametrize("azimuth", [0.0, 37.0, 180.0])
def test_distance_is_from_the_inner_face_of_the_wall(azimuth):
    window = Opening(width_m=2.0, height_m=1.5, sill_m=0.9, parts=[Part(glazing=Open())])
    room = Room.shoebox(
        width_m=4.0, depth_m=6.0, height_m=3.0, wall_thickness_m=0.3, facade_azimuth_deg=azimuth, openings=[window]
    )
    (placed,) = room.sensor_points()
    sensors = year(np.ones((len(placed), 1))).isel(time=0)
    sensors = sensors.assign_coords({f"{a}_m": ("sensor", placed.points_m[:, k]) for k, a in enumerate("xyz")})
    found = distance_from_window_wall(sensors, room)
    np.testing.assert_allclose(np.unique(np.round(found, 9)), np.arange(0.25, 6.0, 0.5))
