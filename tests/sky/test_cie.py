"""The CIE general skies against the standard and its integrals."""

import csv
from pathlib import Path

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.sky import GENERAL_SKIES, CieSky, horizontal_over_zenith, relative_luminance
from clerestory.sun import direction_of

DATA = Path(__file__).parents[1] / "data" / "sky"


def rows(name):
    with (DATA / name).open() as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def test_parameters_are_those_of_the_standard():
    table = {int(row["type"]): [float(row[key]) for key in "abcde"] for row in rows("cie_general_sky_params.csv")}
    assert {number: list(sky[:5]) for number, sky in GENERAL_SKIES.items()} == table


def test_horizontal_illuminance_over_zenith_luminance_matches_the_reference():
    for row in rows("cie_general_sky_Eh_over_Lz.csv"):
        ours = horizontal_over_zenith(int(row["type"]), np.sin(np.radians(float(row["sun_elev_deg"]))))
        assert float(ours) == pytest.approx(float(row["Eh_over_Lz"]), rel=2e-6)


def test_closed_forms_of_the_simple_skies():
    assert float(horizontal_over_zenith(5, 0.5)) == pytest.approx(np.pi, rel=1e-12)
    assert float(horizontal_over_zenith(16, 0.5)) == pytest.approx(7.0 * np.pi / 9.0, rel=1e-12)


@pytest.mark.parametrize("sky_type", range(1, 17))
def test_zenith_has_the_zenith_luminance(sky_type):
    sky = CieSky(sky_type=sky_type, sun_altitude_deg=35.0, zenith_luminance_cd_m2=4321.0)
    assert float(sky.luminance_cd_m2([0.0, 0.0, 1.0])) == pytest.approx(4321.0, rel=1e-12)


@pytest.mark.parametrize("sky_type", range(1, 17))
def test_general_skies_are_mirrored_in_the_suns_meridian(sky_type):
    sky = CieSky(sky_type=sky_type, sun_altitude_deg=35.0, sun_azimuth_deg=120.0, zenith_luminance_cd_m2=1.0)
    turn = np.array([10.0, 50.0, 140.0])
    left, right = (sky.luminance_cd_m2(direction_of(25.0, 120.0 + sign * turn)) for sign in (1.0, -1.0))
    np.testing.assert_allclose(left, right, rtol=1e-12)


def test_standard_overcast_zenith_is_three_times_the_horizon():
    """Type 1 keeps the classic 1:3 within 1 %: 1 + 4 exp(−0.7) = 2.99; the traditional sky has it exactly."""
    assert float(relative_luminance(1, 0.0, 0.0, 0.5)) == pytest.approx(1.0 / (1.0 + 4.0 * np.exp(-0.7)), rel=1e-12)
    assert float(relative_luminance(16, 0.0, 0.0, 0.5)) == pytest.approx(1.0 / 3.0, rel=1e-12)


@pytest.mark.parametrize("sky_type", [1, 5, 12, 16])
def test_both_scales_describe_one_sky(sky_type):
    by_zenith = CieSky(sky_type=sky_type, sun_altitude_deg=50.0, zenith_luminance_cd_m2=3000.0)
    by_ground = CieSky(
        sky_type=sky_type, sun_altitude_deg=50.0, diffuse_horizontal_illuminance_lx=by_zenith.diffuse_horizontal_lx
    )
    assert by_ground.zenith_cd_m2 == pytest.approx(3000.0, rel=1e-12)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"sky_type": 17, "zenith_luminance_cd_m2": 1.0}, r"sky_type must be 1..15 .* got 17"),
        ({"sky_type": 12, "zenith_luminance_cd_m2": 1.0}, r"sun_altitude_deg must be given"),
        ({"sky_type": 5}, r"one of zenith_luminance_cd_m2 and diffuse_horizontal_illuminance_lx must be given, got 0"),
        ({"sky_type": 5, "zenith_luminance_cd_m2": -1.0}, r"zenith_luminance_cd_m2 must not be negative, got -1"),
        (
            {"sky_type": 5, "zenith_luminance_cd_m2": 1.0, "sun_altitude_deg": -5.0},
            r"sun_altitude_deg must lie in 0..90",
        ),
    ],
)
def test_impossible_sky_says_name_rule_and_value(values, message):
    with pytest.raises(ClerestoryError, match=message):
        CieSky(**values)
