"""Published formulas and panes, against closed forms and each other."""

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.glass import (
    edmonds_deflected_fraction,
    edmonds_greenup_compagnon,
    edmonds_panel_tilt_deg,
    slab,
    slab_single_pass,
    tregenza_sharples,
)

ANGLES = np.arange(0.0, 91.0, 5.0)


def test_polarisation_matters_by_two_points():
    """A lossless slab of n = 1.49 at 74°: 2.2 points of transmittance between following s and p and averaging them."""
    difference = slab(74.0, 1.49).transmittance - slab(74.0, 1.49, polarisation="averaged").transmittance
    assert difference == pytest.approx(0.022, abs=5e-4)


@pytest.mark.parametrize("polarisation", ["resolved", "averaged", "s", "p"])
def test_power_is_neither_made_nor_lost(polarisation):
    shares = slab(
        ANGLES[:, None], [1.0, 1.49, 2.4], absorption_per_mm=0.05, thickness_mm=6.0, polarisation=polarisation
    )
    assert shares.transmittance.shape == (19, 3)
    np.testing.assert_allclose(sum(shares), 1.0, atol=1e-14)


def test_resolved_light_is_the_mean_of_s_and_p():
    both = slab(ANGLES, 1.52, absorption_per_mm=0.01, thickness_mm=4.0)
    s, p = (
        slab(ANGLES, 1.52, absorption_per_mm=0.01, thickness_mm=4.0, polarisation=polarisation)
        for polarisation in ("s", "p")
    )
    for mean, one, other in zip(both, s, p, strict=True):
        np.testing.assert_allclose(mean, (one + other) / 2, atol=1e-15)


def test_absorption_follows_the_refracted_path():
    """Without a boundary (n = 1) the pane is Beer and Lambert's alone: e^(−αd / cos θ)."""
    shares = slab([0.0, 30.0, 60.0], 1.0, absorption_per_mm=0.02, thickness_mm=5.0)
    np.testing.assert_allclose(shares.transmittance, np.exp(-0.1 / np.cos(np.radians([0.0, 30.0, 60.0]))), rtol=1e-14)


def test_light_along_the_pane_is_all_mirrored():
    assert tuple(slab(90.0, 1.49, absorption_per_mm=0.01)) == (0.0, 1.0, 0.0)
    assert slab_single_pass(90.0, 1.49) == 0.0


def test_inner_reflections_only_add_light():
    single = slab_single_pass(ANGLES, 1.49, absorption_per_mm=0.01, thickness_mm=6.0)
    full = slab(ANGLES, 1.49, absorption_per_mm=0.01, thickness_mm=6.0, polarisation="averaged").transmittance
    assert np.all(single[:-1] < full[:-1])


def test_surface_formula_makes_the_same_slab():
    """An opaque slab reflects what its first surface does."""
    reflectance = slab(ANGLES, 1.526, absorption_per_mm=1e3, thickness_mm=10.0).reflectance
    np.testing.assert_allclose(edmonds_greenup_compagnon(ANGLES, 1.526), reflectance, atol=1e-14)


def test_tregenza_sharples_is_clamped_where_the_polynomial_turns_negative():
    assert tregenza_sharples(0.0) == pytest.approx(0.87881, abs=1e-12)
    assert tregenza_sharples(89.47) > 0.0
    assert tregenza_sharples(89.49) == 0.0


def test_tregenza_sharples_describes_6_mm_float():
    """Within three points of the exact slab of 6 mm absorbing glass up to 80°."""
    angles = np.arange(0.0, 81.0)
    exact = slab(angles, 1.526, absorption_per_mm=0.0083, thickness_mm=6.0).transmittance
    assert np.abs(tregenza_sharples(angles) - exact).max() < 0.03


def test_deflected_fraction_is_the_geometry_of_parallel_cuts():
    """Count by brute force: rays spread over the entry, those that cross an odd number of cuts."""
    n, spacing, thickness = 1.49, 6.0, 13.0
    starts = (np.arange(20000) + 0.5) / 20000 * spacing
    for degrees in (5.0, 23.0, 50.0, 81.0):
        climb = thickness * np.tan(np.arcsin(np.sin(np.radians(degrees)) / n))
        odd = (np.floor((starts + climb) / spacing) % 2 == 1).mean()
        fraction = edmonds_deflected_fraction(degrees, n, spacing_mm=spacing, thickness_mm=thickness)
        # one ray of the count
        assert fraction == pytest.approx(odd, abs=1 / 20000)


def test_deflected_fraction_has_no_scale():
    one = edmonds_deflected_fraction(ANGLES, 1.49, spacing_mm=3.0, thickness_mm=6.0)
    other = edmonds_deflected_fraction(ANGLES, 1.49, spacing_mm=0.5, thickness_mm=1.0)
    np.testing.assert_array_equal(one, other)


def test_panel_tilt_is_half_the_altitude_above_eight_degrees():
    np.testing.assert_allclose(edmonds_panel_tilt_deg([8.0, 60.0, 0.0]), [0.0, 26.0, -4.0], atol=1e-13)


def test_scalars_in_floats_out():
    assert isinstance(tregenza_sharples(30), float)
    assert isinstance(edmonds_greenup_compagnon(30, 1.5), float)
    assert edmonds_greenup_compagnon([30, 40], [[1.5], [1.6], [1.7]]).shape == (3, 2)


@pytest.mark.parametrize(
    ("mistake", "message"),
    [
        (lambda: slab(90.1, 1.5), r"incidence_deg must be .*at most 90, got 90\.1"),
        (lambda: slab(-1.0, 1.5), r"incidence_deg must be at least 0.*got -1"),
        (lambda: slab(np.nan, 1.5), r"incidence_deg"),
        (lambda: slab(0.0, 0.9), r"n must be finite and at least 1, got 0\.9"),
        (lambda: slab(0.0, 1.5, absorption_per_mm=-1.0), r"absorption_per_mm must be .*at least 0, got -1"),
        (lambda: slab(0.0, 1.5, thickness_mm=0.0), r"thickness_mm must be .*greater than 0, got 0"),
        (lambda: slab(0.0, 1.5, polarisation="circular"), r"polarisation must be .*got \"circular\""),
        (lambda: slab([0.0, 1.0], [1.5, 1.5, 1.5]), r"shapes must broadcast"),
        (lambda: edmonds_deflected_fraction(0.0, 1.5, spacing_mm=0.0, thickness_mm=1.0), r"spacing_mm must be"),
        (lambda: edmonds_panel_tilt_deg(91.0), r"sun_altitude_deg must be .*at most 90, got 91"),
        (lambda: tregenza_sharples("steep"), r"incidence_deg must be a number"),
    ],
)
def test_mistakes_say_name_rule_and_value(mistake, message):
    with pytest.raises(ClerestoryError, match=message):
        mistake()
