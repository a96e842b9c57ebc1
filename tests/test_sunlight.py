"""How bright the sun is through the air."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.site import Site
from clerestory.sunlight import (
    LUMINOUS_SOLAR_CONSTANT_LX,
    direct_normal_illuminance_lx,
    extraterrestrial_illuminance_lx,
    relative_air_mass,
)

MACEIO = Site(latitude_deg=-9.67, longitude_deg=-35.74, elevation_m=0.0, timezone="America/Maceio")


def test_air_mass_of_kasten_and_young():
    """Their Table: 1 at the zenith, 1.994 at 30°, 5.586 at 10°, 37.92 at the horizon."""
    mass = relative_air_mass(np.array([90.0, 30.0, 10.0, 0.0, -1.0]))
    np.testing.assert_allclose(mass[:4], [1.0, 1.994, 5.586, 37.92], rtol=1e-3)
    assert np.isnan(mass[4])


def test_earth_is_nearest_in_january():
    """Perihelion 0.98331 and aphelion 1.01671 astronomical units away in 2024."""
    near, far = extraterrestrial_illuminance_lx(MACEIO, ["2024-01-03 00:00", "2024-07-05 00:00"]).values
    assert near == pytest.approx(LUMINOUS_SOLAR_CONSTANT_LX / 0.98331**2, rel=1e-4)
    assert far == pytest.approx(LUMINOUS_SOLAR_CONSTANT_LX / 1.01671**2, rel=1e-4)


def test_clean_air_passes_nine_tenths_of_a_zenith_sun():
    """Rayleigh scattering alone, weighted by V(λ), has an optical thickness near 0.0986 (Clear 1982)."""
    times = "2024-02-25 11:36"  # the sun stands within 2° of Maceió's zenith
    through = direct_normal_illuminance_lx(MACEIO, times, luminous_turbidity=1.0)
    outside = extraterrestrial_illuminance_lx(MACEIO, times)
    assert float(-np.log(through / outside)[0]) == pytest.approx(1.0 / 10.145, rel=5e-3)


def test_turbidity_counts_atmospheres():
    times = ["2024-06-21 09:00", "2024-06-21 12:00"]
    outside = extraterrestrial_illuminance_lx(MACEIO, times)
    one, three = (
        -np.log(direct_normal_illuminance_lx(MACEIO, times, luminous_turbidity=turbidity) / outside).values
        for turbidity in (1.0, 3.0)
    )
    np.testing.assert_allclose(three, 3.0 * one, rtol=1e-12)


def test_no_sun_at_night_and_more_of_it_on_a_mountain():
    assert float(direct_normal_illuminance_lx(MACEIO, "2024-06-21 00:00", luminous_turbidity=2.5)[0]) == 0.0
    high = Site(latitude_deg=-9.67, longitude_deg=-35.74, elevation_m=3000.0, timezone="America/Maceio")
    below, above = (
        float(direct_normal_illuminance_lx(site, "2024-06-21 09:00", luminous_turbidity=2.5)[0])
        for site in (MACEIO, high)
    )
    assert above > 1.05 * below


@pytest.mark.parametrize("turbidity", [0.5, -1.0, float("nan")])
def test_air_cleaner_than_clean_is_an_error(turbidity):
    with pytest.raises(ClerestoryError, match="luminous_turbidity must"):
        direct_normal_illuminance_lx(MACEIO, "2024-06-21 12:00", luminous_turbidity=turbidity)
