"""Photopic weights, the Gauss nodes that stand for them, and colours."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.medium import PMMA, POLYCARBONATE, SODA_LIME_CLEAR
from clerestory.spectrum import (
    colour_matching,
    illuminant_power,
    luminous_efficiency,
    photopic_mean,
    photopic_quadrature,
    srgb,
    srgb_of_wavelength,
)

ILLUMINANTS = ["D65", "E"]


def weighted(illuminant):
    wavelength_nm, efficiency = luminous_efficiency()
    weights = efficiency * illuminant_power(illuminant)[1]
    return wavelength_nm, weights / weights.sum()


def test_eye_is_most_sensitive_at_555_nm():
    wavelength_nm, efficiency = luminous_efficiency()
    assert (wavelength_nm[0], wavelength_nm[-1], wavelength_nm.size) == (380.0, 780.0, 81)
    assert wavelength_nm[np.argmax(efficiency)] == 555.0
    assert efficiency.max() == 1.0
    # the scale of the photopic table: CIE's sum of V at 5 nm is 21.37
    assert efficiency.sum() == pytest.approx(21.371, abs=5e-4)


def test_white_points_are_the_cies():
    """x, y of E are a third each; of D65 0.3127, 0.3290."""
    xyz = colour_matching()[1]
    for illuminant, white in [("E", (1 / 3, 1 / 3)), ("D65", (0.3127, 0.3290))]:
        total = illuminant_power(illuminant)[1] @ xyz
        assert total[:2] / total.sum() == pytest.approx(white, abs=6e-5)


@pytest.mark.parametrize("illuminant", ILLUMINANTS)
@pytest.mark.parametrize("nodes", [1, 2, 5, 8, 12, 20])
def test_quadrature_is_exact_for_polynomials(illuminant, nodes):
    """Up to degree 2n − 1, and no further."""
    wavelength_nm, weights = weighted(illuminant)
    at, share = photopic_quadrature(illuminant, nodes)
    assert share.sum() == pytest.approx(1.0, abs=1e-13)
    assert np.all(share > 0)
    for degree in range(2 * nodes + 1):
        # Chebyshev polynomials: of size 1 whatever the degree
        polynomial = np.polynomial.Chebyshev.basis(degree, domain=(380.0, 780.0))
        difference = abs(share @ polynomial(at) - weights @ polynomial(wavelength_nm))
        if degree < 2 * nodes:
            assert difference < 1e-12
        elif nodes <= 8:
            assert difference > 1e-9


@pytest.mark.parametrize("medium", [PMMA, POLYCARBONATE])
def test_five_nodes_lie_in_the_range_of_the_plastics(medium):
    low, high = medium.wavelength_range_nm
    wavelength_nm, _ = photopic_quadrature("D65", 5)
    assert low < wavelength_nm[0]
    assert wavelength_nm[-1] < high


def test_five_nodes_do_the_index_of_glass_as_well_as_the_whole_table():
    wavelength_nm, weights = weighted("D65")
    at, share = photopic_quadrature("D65", 5)
    assert share @ SODA_LIME_CLEAR.index(at) == pytest.approx(weights @ SODA_LIME_CLEAR.index(wavelength_nm), abs=1e-7)


def test_photopic_mean_is_linear_and_keeps_constants():
    wavelength_nm = np.arange(300.0, 901.0, 7.0)
    assert photopic_mean(wavelength_nm, np.full_like(wavelength_nm, 0.3)) == pytest.approx(0.3, abs=1e-15)
    table_nm, weights = weighted("E")
    # straight lines between samples: a straight line is met exactly
    assert photopic_mean(wavelength_nm, 2 * wavelength_nm, "E") == pytest.approx(2 * weights @ table_nm, rel=1e-14)
    assert photopic_mean(wavelength_nm, np.ones((4, 3, wavelength_nm.size))).shape == (4, 3)


def test_colours_of_the_rainbow_come_in_its_order():
    blue, green, red = srgb_of_wavelength([460.0, 530.0, 640.0])
    assert [np.argmax(blue), np.argmax(green), np.argmax(red)] == [2, 1, 0]
    every = srgb_of_wavelength(np.arange(380.0, 781.0))
    assert every.shape == (401, 3)
    assert every.min() >= 0
    assert every.max() <= 1


def test_white_is_white():
    xyz = illuminant_power("D65")[1] @ colour_matching()[1]
    # the rounded matrix of the standard leaves a unit in the fourth digit
    np.testing.assert_allclose(srgb(xyz / xyz[1]), [1.0, 1.0, 1.0], atol=5e-4)
    assert srgb([0.0, 0.0, 0.0]) == pytest.approx([0, 0, 0], abs=1e-15)


@pytest.mark.parametrize(
    ("mistake", "message"),
    [
        (lambda: illuminant_power("A"), "illuminant must be D65 or E, got 'A'"),
        (lambda: photopic_quadrature(nodes=0), "nodes must be a whole number from 1 to 20, got 0"),
        (lambda: photopic_quadrature(nodes=2.5), "nodes must be"),
        (lambda: photopic_mean([400, 780], [1, 1]), "must span 380 to 780 nm, got 400 to 780"),
        (lambda: photopic_mean([380, 380, 780], [1, 1, 1]), "increasing"),
        (lambda: photopic_mean([380, 780], [1, 1, 1]), "one entry a wavelength"),
        (lambda: photopic_mean([380, 780], [1, np.nan]), "values must be finite"),
        (lambda: srgb_of_wavelength(900), "wavelength_nm must be at least 380 and at most 780, got 900"),
        (lambda: srgb([1.0, 2.0]), "xyz must have 3 values"),
    ],
)
def test_mistakes_say_name_rule_and_value(mistake, message):
    with pytest.raises(ClerestoryError, match=message):
        mistake()
