"""Perez' all-weather sky and luminous efficacies against their tables, Radiance and their own integrals."""

import csv
from pathlib import Path

import numpy as np
import pytest
from pvlib import irradiance

from clerestory import ClerestoryError, PerezSky, Room, daylight_coefficients, illuminance, sky_basis
from clerestory.room import Opening, Sensors
from clerestory.sky import patch_means
from clerestory.sky.perez import (
    diffuse_efficacy_lm_w,
    direct_efficacy_lm_w,
    luminance_parameters,
    relative_luminance,
    sky_conditions,
)
from clerestory.sky.perez_sky import quadrature_order
from clerestory.sky.perez_tables import CLEARNESS_BINS, DIFFUSE_EFFICACY, DIRECT_EFFICACY, LUMINANCE

DATA = Path(__file__).parents[1] / "data" / "sky"

#: Direct normal and diffuse horizontal irradiance of the columns of gendaymtx_m1_O1_visible.csv, and days of the year.
IRRADIANCES = [(0, 120), (850, 90), (400, 350), (700, 100), (900, 60), (150, 260), (20, 180)]
DAYS = [80, 80, 172, 172, 355, 264, 172]
#: Towards the sun of each, as gendaymtx -D writes it.
SUNS = [
    (0.636474, -0.498491, 0.588563),
    (-0.095312, -0.641796, 0.760929),
    (-0.111317, -0.276150, 0.954646),
    (0.732964, -0.046698, 0.678663),
    (-0.127668, -0.886808, 0.444154),
    (-0.809101, -0.378402, 0.449630),
    (-0.111317, -0.276150, 0.954646),
]


def table(name):
    with (DATA / name).open() as file:
        rows = [line for line in file if not line.startswith("#")]
    return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(rows)]


def conditions(direct, diffuse, altitude, outside=1367.0):
    return sky_conditions(
        direct_normal_irradiance_w_m2=direct,
        diffuse_horizontal_irradiance_w_m2=diffuse,
        sun_altitude_deg=altitude,
        extraterrestrial_irradiance_w_m2=outside,
    )


def moment(case):
    """Towards the sun of a column of the table, and the parameters of its sky."""
    sun = np.array(SUNS[case]) / np.linalg.norm(SUNS[case])
    direct, diffuse = IRRADIANCES[case]
    outside = irradiance.get_extra_radiation(DAYS[case], solar_constant=1367.0)
    return sun, luminance_parameters(conditions([direct], [diffuse], [np.degrees(np.arcsin(sun[2]))], outside))


def test_tables_are_the_published_ones():
    luminance = table("perez1993_allweather_coeffs.csv")
    efficacy = table("perez1990_luminous_efficacy.csv")
    for k in range(8):
        assert CLEARNESS_BINS[k] == luminance[k]["eps_lo"]
        for row, letter in enumerate("abcde"):
            np.testing.assert_array_equal(LUMINANCE[k, row], [luminance[k][f"{letter}{n}"] for n in range(1, 5)])
        np.testing.assert_array_equal(DIFFUSE_EFFICACY[k], [efficacy[k][f"diff_{letter}"] for letter in "abcd"])
        np.testing.assert_array_equal(DIRECT_EFFICACY[k], [efficacy[k][f"dir_{letter}"] for letter in "abcd"])


@pytest.mark.parametrize("case", range(7))
def test_patches_are_those_of_gendaymtx_within_its_rounding(case):
    """Its own sun, spread over the four nearest patches, taken away; it writes three digits, 0.5 % at most."""
    table = np.genfromtxt(DATA / "gendaymtx_m1_O1_visible.csv", delimiter=",", comments="#", skip_header=3)
    theirs = table[1:, 1 + case]
    rounding = 0.5 * 10.0 ** (np.floor(np.log10(theirs)) - 2.0)
    basis = sky_basis("tregenza145")
    centres, solid_angles = np.asarray(basis.centres)[:-1], np.asarray(basis.solid_angles)[:-1]
    sun, parameters = moment(case)
    direct, diffuse = IRRADIANCES[case]
    nearest = np.argsort(-(centres @ sun))[:4]
    share = 1.0 / (1.002 - centres[nearest] @ sun)
    theirs[nearest] -= share / share.sum() * direct / solid_angles[nearest]
    ours = basis.all_weather(parameters, sun[None], np.array([float(diffuse)]), 0)[0, :-1]
    assert (np.abs(ours - theirs) <= 0.001 * theirs + rounding).all()
    far = np.setdiff1d(np.arange(145), nearest)
    assert np.abs(ours[far] / theirs[far] - 1.0).max() < 0.01


@pytest.mark.parametrize("case", range(7))
def test_means_of_patches_differ_from_centres_by_what_bends_within_them(case):
    """Further than 20° from the sun by 4 % at most in patches of 12°, by 2 % (at the horizon) in those of 3°."""
    sun, parameters = moment(case)
    for name, limit in (("tregenza145", 0.04), ("reinhart2305", 0.02)):
        basis = sky_basis(name)
        one = np.array([1.0])
        centre, mean = (basis.all_weather(parameters, sun[None], one, order)[0, :-1] for order in (0, 6))
        far = np.asarray(basis.centres)[:-1] @ sun < np.cos(np.radians(20.0))
        ratio = mean[far] / centre[far]
        assert np.abs(ratio / np.median(ratio) - 1.0).max() < limit


def test_kernel_agrees_with_the_formula_at_every_node():
    """The compiled mean is that of the formula over the same points, to single precision."""
    sky = PerezSky(
        direct_normal_irradiance_w_m2=700.0,
        diffuse_horizontal_irradiance_w_m2=120.0,
        sun_altitude_deg=40.0,
        sun_azimuth_deg=130.0,
    )
    for name, order in (("tregenza145", 4), ("reinhart577", 3), ("reinhart2305", 2), ("troplux5221", 2)):
        assert quadrature_order(name) == order
        means = patch_means(sky.luminance_cd_m2, basis=name, order=order)
        found = sky.matrix(name).values[:-1]
        ratio = found / means
        np.testing.assert_allclose(ratio, ratio.mean(), rtol=2e-5)
        assert ratio.mean() == pytest.approx(1.0, abs=1e-2)


@pytest.mark.parametrize("basis", ["tregenza145", "reinhart577", "reinhart2305"])
def test_patches_light_a_horizontal_plane_with_the_diffuse_illuminance(basis):
    sky = PerezSky(direct_normal_irradiance_w_m2=850.0, diffuse_horizontal_irradiance_w_m2=90.0, sun_altitude_deg=49.5)
    patches = sky_basis(basis)
    bounds = np.asarray(patches.bounds)[:-1]
    projected = np.asarray(patches.solid_angles)[:-1] * 0.5 * (np.sin(bounds[:, 0]) + np.sin(bounds[:, 1]))
    matrix = sky.matrix(basis, ground_reflectance=0.25)
    assert matrix.values[:-1] @ projected == pytest.approx(sky.diffuse_horizontal_lx, rel=1e-5)
    lit = sky.diffuse_horizontal_lx + sky.direct_normal_illuminance_lx * np.sin(np.radians(49.5))
    assert matrix.values[-1] == pytest.approx(0.25 * lit / np.pi, rel=1e-9)


def test_point_luminance_integrates_to_the_diffuse_illuminance():
    sky = PerezSky(direct_normal_irradiance_w_m2=300.0, diffuse_horizontal_irradiance_w_m2=200.0, sun_altitude_deg=30.0)
    upward = patch_means(lambda v: sky.luminance_cd_m2(v) * v[:, 2], basis="reinhart2305", order=4)
    total = upward @ np.asarray(sky_basis("reinhart2305").solid_angles)[:-1]
    assert total == pytest.approx(sky.diffuse_horizontal_lx, rel=2e-4)


def test_clearness_and_brightness_by_hand():
    """ε = ((D + B)/D + κZ³)/(1 + κZ³), Δ = mD/I₀, at 30° of altitude: Z = 1.0472, κZ³ = 1.1955, m = 1.994."""
    found = conditions([500.0], [100.0], [30.0])
    assert found.clearness[0] == pytest.approx((6.0 + 1.19548) / 2.19548, rel=1e-4)
    assert found.brightness[0] == pytest.approx(1.9939 * 100.0 / 1367.0, rel=1e-3)
    assert found.bin[0] == 5


def test_efficacies_by_hand():
    """Bin 6 at the same moment with W = exp(0.07·11 − 0.075) = 2.0037 cm."""
    found = conditions([500.0], [100.0], [30.0])
    delta = found.brightness[0]
    water = 2.00371
    diffuse = 106.42 + 3.83 * water - 36.15 * np.cos(np.pi / 3) - 28.83 * np.log(delta)
    direct = 107.19 - 1.25 * water - 1.51 * np.exp(5.73 * np.pi / 3 - 5.0) - 26.73 * delta
    assert diffuse_efficacy_lm_w(found)[0] == pytest.approx(diffuse, rel=1e-5)
    assert direct_efficacy_lm_w(found)[0] == pytest.approx(direct, rel=1e-5)
    assert 90.0 < direct < 110.0 < diffuse < 160.0


@pytest.mark.parametrize(
    ("clearness", "expected"), [(1.0, 0), (1.0649, 0), (1.065, 1), (1.23, 2), (4.4999, 5), (4.5, 6), (6.2, 7), (1e9, 7)]
)
def test_bins_begin_at_their_lower_bounds(clearness, expected):
    assert np.searchsorted(CLEARNESS_BINS[1:], clearness, side="right") == expected


def test_clamps():
    """Brightness within 0.01..0.6 and at least 0.2 between ε = 1.065 and 2.8; efficacies never negative."""
    assert conditions([0.0], [0.01], [50.0]).brightness[0] == 0.01
    assert conditions([0.0], [900.0], [5.0]).brightness[0] == 0.6
    between = conditions([60.0], [100.0], [60.0])
    assert 1.065 < between.clearness[0] < 2.8
    assert between.brightness[0] < 0.2
    raised = between._replace(brightness=np.array([0.2]))
    np.testing.assert_array_equal(luminance_parameters(between), luminance_parameters(raised))
    assert direct_efficacy_lm_w(conditions([1.0], [10.0], [0.0]))[0] == 0.0
    assert conditions([100.0], [0.0], [30.0]).bin[0] == 7
    assert conditions([0.0], [0.0], [30.0]).clearness[0] == 1.0


def test_luminance_is_never_negative_or_infinite():
    rng = np.random.default_rng(3)
    direct, diffuse = rng.uniform(0.0, 1000.0, 400), rng.uniform(0.5, 600.0, 400)
    altitude = rng.uniform(-5.0, 90.0, 400)
    parameters = luminance_parameters(conditions(direct, diffuse, altitude))
    for row in parameters:
        values = relative_luminance(row, rng.uniform(0.0, 1.0, 200), rng.uniform(-1.0, 1.0, 200))
        assert np.isfinite(values).all()
        assert (values >= 0.0).all()


def test_sky_turns_with_the_sun():
    """The sky of an eastern sun is that of the western one seen in a mirror."""
    found = []
    for azimuth in (90.0, 270.0):
        sky = PerezSky(
            direct_normal_irradiance_w_m2=600.0,
            diffuse_horizontal_irradiance_w_m2=150.0,
            sun_altitude_deg=25.0,
            sun_azimuth_deg=azimuth,
        )
        found.append(sky.matrix("tregenza145"))
    mirrored = sky_basis("tregenza145").find(np.asarray(sky_basis("tregenza145").centres)[:-1] * [-1.0, 1.0, 1.0])
    np.testing.assert_allclose(found[0].values[:-1], found[1].values[np.asarray(mirrored)], rtol=1e-4)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"sun_altitude_deg": 91.0}, "sun_altitude_deg must lie in -90..90, got 91"),
        ({"direct_normal_irradiance_w_m2": -1.0}, "direct_normal_irradiance_w_m2 must not be negative, got -1"),
        ({"dew_point_c": 99.9}, "dew_point_c must lie in -90..60, got 99.9"),
    ],
)
def test_impossible_skies_are_refused(changed, message):
    good = {
        "direct_normal_irradiance_w_m2": 1.0,
        "diffuse_horizontal_irradiance_w_m2": 1.0,
        "sun_altitude_deg": 1.0,
    }
    with pytest.raises(ClerestoryError, match=message):
        PerezSky(**{**good, **changed})


def test_sky_lights_a_room_like_any_other():
    room = Room.shoebox(
        width_m=2.0,
        depth_m=2.0,
        height_m=2.0,
        openings=[Opening(width_m=1.0, height_m=1.0)],
        sensors=[Sensors(points_m=[[1.0, 1.0, 0.8]])],
    )
    sky = PerezSky(direct_normal_irradiance_w_m2=0.0, diffuse_horizontal_irradiance_w_m2=100.0, sun_altitude_deg=30.0)
    coefficients = daylight_coefficients(room, basis="tregenza145", rounds=2)
    found = illuminance(coefficients, sky).total
    again = illuminance(coefficients, sky.matrix("tregenza145")).total
    np.testing.assert_allclose(found, again)
