"""From coefficients and skies to illuminance."""

import numpy as np
import pytest
import xarray as xr

from clerestory.coefficients import PARTS, daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.illuminance import average_by_group, daylight_factor, illuminance, uniformity
from clerestory.room import Opening, Room, SensorGrid
from clerestory.sky import CieSky

ROOM = Room.shoebox(
    width_m=4.0,
    depth_m=6.0,
    height_m=3.0,
    openings=[Opening(width_m=3.0, height_m=1.6)],
    sensors=[SensorGrid(spacing_m=1.0), SensorGrid(spacing_m=1.0, height_m=0.0, surface="ceiling", flip=True)],
)


@pytest.fixture(scope="module")
def coefficients():
    return daylight_coefficients(ROOM, basis="tregenza145", rounds=8)


def test_parts_add_up_to_the_total(coefficients):
    lit = illuminance(coefficients, CieSky(sky_type=12, sun_altitude_deg=50.0, zenith_luminance_cd_m2=3000.0))
    np.testing.assert_allclose(sum(lit[part] for part in PARTS), lit.total, rtol=1e-12)
    assert lit.total.attrs["units"] == "lx"


def test_skies_add(coefficients):
    """Superposition: the light of two skies together is the sum of their lights."""
    one = CieSky(sky_type=1, diffuse_horizontal_illuminance_lx=8000.0).matrix("tregenza145")
    two = CieSky(sky_type=13, sun_altitude_deg=25.0, zenith_luminance_cd_m2=2500.0).matrix("tregenza145")
    apart = illuminance(coefficients, one).total + illuminance(coefficients, two).total
    np.testing.assert_allclose(illuminance(coefficients, one + two).total, apart, rtol=1e-12)


def test_further_dimensions_of_a_sky_are_kept(coefficients):
    hours = xr.concat(
        [CieSky(sky_type=5, zenith_luminance_cd_m2=level).matrix("tregenza145") for level in (1000.0, 3000.0)],
        dim="time",
    )
    lit = illuminance(coefficients, hours)
    assert set(lit.total.dims) == {"sensor", "time"}
    np.testing.assert_allclose(lit.total.isel(time=1), 3.0 * lit.total.isel(time=0), rtol=1e-12)


def test_daylight_factor_does_not_depend_on_how_bright_the_sky_is(coefficients):
    dim, bright = (
        daylight_factor(coefficients, CieSky(sky_type=16, diffuse_horizontal_illuminance_lx=level)).total
        for level in (5000.0, 20_000.0)
    )
    np.testing.assert_allclose(dim, bright, rtol=1e-12)
    np.testing.assert_allclose(dim, daylight_factor(coefficients).total, rtol=1e-12)
    assert dim.attrs["units"] == "percent"


def test_daylight_factor_takes_no_sun(coefficients):
    sunny = CieSky(
        sky_type=12, sun_altitude_deg=30.0, zenith_luminance_cd_m2=1.0, direct_normal_illuminance_lx=50_000.0
    )
    with pytest.raises(ClerestoryError, match="sky of a daylight factor must have no sun"):
        daylight_factor(coefficients, sunny)


def test_error_says_whether_it_is_one_or_a_bound(coefficients):
    judged = illuminance(coefficients, CieSky(sky_type=16, zenith_luminance_cd_m2=700.0)).total_standard_error
    other = illuminance(coefficients, CieSky(sky_type=5, zenith_luminance_cd_m2=700.0)).total_standard_error
    assert judged.attrs["kind"] == "standard error"
    assert other.attrs["kind"] == "upper bound"
    scale = 700.0
    np.testing.assert_allclose(judged, scale * coefficients.sky_illuminance_standard_error, rtol=1e-9)


def test_uniformity_and_averages_by_hand():
    values = xr.DataArray([1.0, 2.0, 3.0, 10.0], dims="sensor", coords={"group": ("sensor", ["a", "a", "a", "b"])})
    assert float(uniformity(values)) == pytest.approx(1.0 / 4.0)
    averages = average_by_group(values)
    assert dict(zip(averages["group"].values, averages.values, strict=True)) == {"a": 2.0, "b": 10.0}
    assert np.isnan(float(uniformity(0.0 * values)))


def test_sky_of_another_basis_is_an_error(coefficients):
    with pytest.raises(ClerestoryError, match="sky must have the 146 patches of the coefficients"):
        illuminance(coefficients, CieSky(sky_type=5, zenith_luminance_cd_m2=1.0).matrix("reinhart577"))
