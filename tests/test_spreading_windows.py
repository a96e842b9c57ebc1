"""Windows known by a BSDF, or too rough for beams, in a room."""

import numpy as np
import pytest

from clerestory import (
    ClerestoryError,
    Glass,
    LaserCutPanel,
    Medium,
    Opening,
    Part,
    Room,
    Sensors,
    bsdf_of,
    daylight_coefficients,
    sun_coefficients,
)

SUNS = {"altitude_deg": [25.0, 50.0], "azimuth_deg": [170.0, 205.0]}


def room(glazing, *, width_m=3.6):
    opening = Opening(width_m=width_m, height_m=1.8, sill_m=0.9, parts=(Part(glazing=glazing),))
    return Room.shoebox(width_m=4, depth_m=8, height_m=3, openings=[opening], floor=0.2, walls=0.5, ceiling=0.8)


def by_parts(found, parts):
    """Sum of the parts and its standard error, the parts taken as independent."""
    value = sum(found[part].values for part in parts)
    return value, np.sqrt(sum(found[f"{part}_standard_error"].values ** 2 for part in parts))


def test_pane_as_a_klems_matrix_is_the_pane_within_its_blur():
    """Patches of 10 to 15 degrees move light about in the room but neither make nor lose it."""
    glass = Glass(transmittance=0.88)
    sensors = Sensors(name="table", points_m=[[x, 2.5, 0.8] for x in (1.0, 2.0, 3.0)], normals=[[0, 0, 1]] * 3)
    clear, blurred = (
        daylight_coefficients(room(filling), sensors, basis="tregenza145", rounds=8, nodes=2048)
        for filling in (glass, bsdf_of(glass).blurred())
    )
    ratio = (blurred.sky_illuminance / clear.sky_illuminance).values
    assert (blurred.sky_illuminance_standard_error / blurred.sky_illuminance).values.max() < 0.01
    assert np.abs(ratio - 1.0).max() < 0.06
    # the sun's patch becomes a blot wider than its beam: all the floor gets the same, as none of it meets a wall
    floor = [[x, y, 0.01] for x in np.arange(0.1, 4, 0.2) for y in np.arange(0.05, 5, 0.1)]
    whole = Sensors(name="floor", points_m=floor, normals=[[0, 0, 1]] * len(floor))
    direct = [
        sun_coefficients(room(filling, width_m=1.8), whole, altitude_deg=[50.0], azimuth_deg=[180.0], rounds=2)
        for filling in (glass, bsdf_of(glass).blurred())
    ]
    means = [float(found.direct.mean()) for found in direct]
    assert means[1] == pytest.approx(means[0], rel=0.03)
    assert (direct[1].direct.values > 0).mean() > 1.3 * (direct[0].direct.values > 0).mean()


def test_rough_panel_needs_its_bsdf_for_the_sun_and_has_it():
    rough = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, cut_slope_deg=2.0, cut_diffuse=0.1, medium=Medium(n=1.49))
    sensors = Sensors(name="ceiling", points_m=[[2.0, 2.0, 2.9]], normals=[[0, 0, -1]])
    with pytest.raises(ClerestoryError, match=r"panel\.bsdf\(\)\.blurred\(\)"):
        sun_coefficients(room(rough), sensors, **SUNS)
    found = sun_coefficients(room(rough.bsdf().blurred()), sensors, rounds=8, **SUNS)
    value, error = by_parts(found, ("direct", "interreflected"))
    # some of its light goes up to the ceiling at once
    assert (found.direct.values > 4 * found.direct_standard_error.values).all()
    assert (error < 0.2 * value).all()
    assert (found.redirected.values == 0.0).all()
