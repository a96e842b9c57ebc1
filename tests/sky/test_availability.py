"""How much light a sky of which only its type is known sends down."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.sky.availability import shows_sun, usual_diffuse_horizontal_lx

#: Of each condition: a CIE type, and what the half of the sky beside the sun gives a horizontal plane, factor [lx] and
#: exponent of the sine, fitted apart from the whole sky's (IES 1984; its third term is 0 beside the sun).
HALF_SKIES = {"clear": (12, 8200.0, 0.5), "partly cloudy": (8, 22_700.0, 1.0), "cloudy": (1, 10_700.0, 1.0)}


@pytest.mark.parametrize(
    ("sky_type", "low", "at_30"), [(11, 800.0, 11_760.155), (7, 300.0, 22_800.0), (6, 300.0, 10_800.0)]
)
def test_it_rises_with_the_sun_and_ends_with_it(sky_type, low, at_30):
    assert usual_diffuse_horizontal_lx(sky_type, 30.0) == pytest.approx(at_30, abs=1e-3)
    assert usual_diffuse_horizontal_lx(sky_type, 1e-9) == pytest.approx(low, abs=1.0)
    assert usual_diffuse_horizontal_lx(sky_type, [-1e-9, -30.0, 0.0]).tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("sky", HALF_SKIES)
def test_two_halves_of_a_sky_beside_the_sun_are_the_whole(sky):
    sky_type, factor, power = HALF_SKIES[sky]
    altitude = np.arange(10.0, 91.0, 10.0)
    halves = 2.0 * factor * np.sin(np.radians(altitude)) ** power
    np.testing.assert_allclose(usual_diffuse_horizontal_lx(sky_type, altitude), halves, rtol=1.0 / 12.0)


def test_every_type_belongs_to_one_condition_and_the_bright_ones_show_the_sun():
    noon = {sky_type: float(usual_diffuse_horizontal_lx(sky_type, 90.0)) for sky_type in range(1, 17)}
    assert set(noon.values()) == {16_300.0, 45_300.0, 21_300.0}
    cloudy = [sky_type for sky_type, light in noon.items() if light == 21_300.0]
    assert cloudy == [sky_type for sky_type in range(1, 17) if not shows_sun(sky_type)] == [1, 2, 3, 4, 5, 6, 16]
    with pytest.raises(ClerestoryError, match="sky_type"):
        usual_diffuse_horizontal_lx(17, 30.0)
