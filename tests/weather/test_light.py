"""The light of the sun and the sky that weather brings."""

import numpy as np
import pytest

from clerestory import (
    ClerestoryError,
    diffuse_horizontal_illuminance_lx,
    sky_basis,
    sky_matrix,
    sun_normal_illuminance_lx,
)


def test_sky_matrix_is_the_skies_of_its_hours(miami):
    matrix = sky_matrix(miami, "reinhart577", ground_reflectance=0.3)
    assert matrix.dims == ("patch", "time")
    assert matrix.shape == (578, 8760)
    for row in (4000, 5222, 7690):
        sky = miami.sky(miami.times[row])
        np.testing.assert_allclose(matrix[:, row], sky.matrix("reinhart577", ground_reflectance=0.3), rtol=1e-5)
    dark = miami.frame.diffuse_horizontal_irradiance_w_m2.to_numpy() == 0.0
    assert (matrix.values[:-1, dark] == 0.0).all()


def test_sun_is_as_bright_as_radiance_finds_and_the_sky_as_said(miami):
    """The sum over the suns of gendaymtx, each some tenths of a degree off; patches sum to the diffuse light."""
    assert float(sun_normal_illuminance_lx(miami).sum()) == pytest.approx(129_888_255.0, rel=0.005)
    sky = diffuse_horizontal_illuminance_lx(miami).values
    upward = sky_matrix(miami, "tregenza145").values[:-1].T @ _projected("tregenza145")
    np.testing.assert_allclose(upward, sky, rtol=1e-4)


def test_a_sun_below_the_horizon_gives_nothing_and_says_so(miami):
    found = sun_normal_illuminance_lx(miami)
    below = miami.sun.apparent_altitude_deg.values <= 0.0
    assert (found.values[below] == 0.0).all()
    lost = miami.frame.direct_normal_irradiance_w_m2.to_numpy()[below].sum()
    assert found.attrs["left_out_wh_m2"] == pytest.approx(lost)
    assert 0.0 < lost < 0.02 * miami.frame.direct_normal_irradiance_w_m2.sum()


def _projected(basis):
    bounds = np.asarray(sky_basis(basis).bounds)[:-1]
    return np.asarray(sky_basis(basis).solid_angles)[:-1] * 0.5 * np.sin(bounds[:, :2]).sum(axis=1)


def test_wrong_words_are_refused(miami):
    with pytest.raises(ClerestoryError, match="sampling must be one of mean, centre, got 'middle'"):
        sky_matrix(miami, sampling="middle")
    with pytest.raises(ClerestoryError, match=r"ground_reflectance must lie in 0\.\.1"):
        sky_matrix(miami, ground_reflectance=2.0)
    with pytest.raises(ClerestoryError, match="time must be one of the weather"):
        miami.sky("1999-01-01 12:00")
