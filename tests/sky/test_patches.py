"""Patches of the sky and their mean luminance."""

import csv
from pathlib import Path

import numpy as np
import pytest
from numpy.polynomial.legendre import leggauss

from clerestory.errors import ClerestoryError
from clerestory.sky import BASES, CieSky, patch_means, sky_basis
from clerestory.sun import direction_of

DATA = Path(__file__).parents[1] / "data" / "sky"


def reference_centres(name):
    with (DATA / name).open() as file:
        table = list(csv.DictReader(line for line in file if not line.startswith("#")))
    azimuth = next(key for key in table[0] if key.startswith("azim"))
    return np.array([[float(row["alt_deg"]), float(row[azimuth])] for row in table])


@pytest.mark.parametrize("name", BASES)
def test_patches_tile_the_sky(name):
    basis = sky_basis(name)
    solid_angles = np.asarray(basis.solid_angles)
    assert len(solid_angles) == len(basis) == int(name.lstrip("abcdefghijklmnopqrstuvwxyz")) + 1
    assert solid_angles[:-1].sum() == pytest.approx(2.0 * np.pi, rel=1e-12)
    assert solid_angles[-1] == pytest.approx(2.0 * np.pi, rel=1e-12)


@pytest.mark.parametrize(
    ("order", "file"), [("cie", "tregenza145_cie_order.csv"), ("radiance", "tregenza145_radiance_order.csv")]
)
def test_both_numberings_match_the_reference_tables(order, file):
    basis = sky_basis("tregenza145")
    index = np.asarray(basis.order(order))
    patches = index[1:] if order == "radiance" else index[:-1]
    altitude, azimuth = reference_centres(file).T
    ours, theirs = np.asarray(basis.centres)[patches], direction_of(altitude, azimuth)
    np.testing.assert_allclose(ours, theirs, atol=2e-3)


@pytest.mark.parametrize("name", BASES)
def test_means_times_solid_angles_are_the_integral_of_the_sky(name):
    sky = CieSky(sky_type=12, sun_altitude_deg=40.0, sun_azimuth_deg=135.0, zenith_luminance_cd_m2=1.0)
    nodes, weights = leggauss(400)
    azimuth = (np.arange(800) + 0.5) * 2.0 * np.pi / 800
    sine = np.repeat((1.0 + nodes) / 2.0, 800)
    cosine, around = np.sqrt(1.0 - sine**2), np.tile(azimuth, 400)
    directions = np.stack([cosine * np.sin(around), cosine * np.cos(around), sine], axis=-1)
    whole = np.sum(np.repeat(weights / 2.0, 800) * sky.luminance_cd_m2(directions)) * 2.0 * np.pi / 800
    solid_angles = np.asarray(sky_basis(name).solid_angles)[:-1]
    means = patch_means(sky.luminance_cd_m2, basis=name)
    assert float(means @ solid_angles) == pytest.approx(whole, rel=2e-5)


def test_mean_of_the_sine_over_a_patch_has_a_closed_form():
    """∫ sin γ dω over a ring sector is Δα (sin² γ₂ − sin² γ₁) / 2."""
    bounds = np.asarray(sky_basis("tregenza145").bounds)[:-1]
    exact = (np.sin(bounds[:, 0]) + np.sin(bounds[:, 1])) / 2.0
    np.testing.assert_allclose(patch_means(lambda d: d[:, 2], basis="tregenza145"), exact, rtol=1e-13)


def test_the_patch_with_the_sun_is_not_its_centre():
    """A clear sky's corona is steep: the mean over a Tregenza patch is over 1 % off the value at its centre."""
    sky = CieSky(sky_type=13, sun_altitude_deg=30.0, sun_azimuth_deg=0.0, zenith_luminance_cd_m2=1.0)
    means = patch_means(sky.luminance_cd_m2, basis="tregenza145")
    centre = sky.luminance_cd_m2(np.asarray(sky_basis("tregenza145").centres)[:-1])
    brightest = int(np.argmax(means))
    assert abs(centre[brightest] / means[brightest] - 1.0) > 0.01


def test_ground_is_lit_by_sky_and_sun():
    sky = CieSky(
        sky_type=12,
        sun_altitude_deg=30.0,
        diffuse_horizontal_illuminance_lx=8000.0,
        direct_normal_illuminance_lx=60_000.0,
    )
    matrix = sky.matrix("tregenza145", ground_reflectance=0.25)
    assert matrix.dims == ("patch",)
    assert matrix.sizes["patch"] == 146
    assert float(matrix[-1]) == pytest.approx(0.25 * (8000.0 + 30_000.0) / np.pi, rel=1e-12)


@pytest.mark.parametrize("name", ["reinhart578", "klems", 145])
def test_unknown_basis_is_an_error(name):
    with pytest.raises(ClerestoryError, match="basis"):
        sky_basis(name)
