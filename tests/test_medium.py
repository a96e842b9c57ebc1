"""Media: laws, ranges, units, round trips and every way of being refused."""

import copy
import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from clerestory.errors import ClerestoryError
from clerestory.medium import AIR, BK7, PMMA, POLYCARBONATE, SODA_LIME_CLEAR, Medium, medium_names
from clerestory.medium_laws import AbsorptionSpectrum, Dispersion


def test_constant_medium_needs_no_wavelength():
    medium = Medium(n=1.49, absorption_per_mm=0.02)
    assert (medium.index(), medium.absorption_per_mm_at()) == (1.49, 0.02)
    assert medium.index(400.0) == 1.49
    assert not medium.is_spectral
    assert medium.wavelength_range_nm is None
    assert AIR.index() == 1.0


def test_bk7_has_its_catalogue_indices():
    """n_d, n_F, n_C of Schott's data sheet: 1.51680, 1.52238, 1.51432."""
    lines_nm = np.array([587.5618, 486.1327, 656.2725])
    np.testing.assert_allclose(BK7.index(lines_nm), [1.51680, 1.52238, 1.51432], atol=0.5e-5)


def test_abbe_number_of_bk7_is_the_catalogues():
    n_d, n_f, n_c = (BK7.index(w) for w in (587.5618, 486.1327, 656.2725))
    assert (n_d - 1) / (n_f - n_c) == pytest.approx(64.17, abs=0.005)


def test_cauchy_by_hand():
    medium = Medium.cauchy(1.5, 0.004, 0.0001, wavelength_range_nm=(400, 700))
    # 1.5 + 0.004 / 0.25 + 0.0001 / 0.0625 at 0.5 µm
    assert medium.index(500.0) == pytest.approx(1.5176, abs=1e-15)


def test_sellmeier_by_hand():
    medium = Medium.sellmeier([1.2], [0.01], wavelength_range_nm=(400, 700))
    assert medium.index(500.0) == pytest.approx(math.sqrt(1 + 1.2 * 0.25 / 0.24), abs=1e-15)


def test_extinction_becomes_absorption_per_mm():
    medium = Medium.tabulated([500, 600], [1.5, 1.5], extinction=[1e-7, 3e-7])
    wavelengths = np.array([500.0, 550.0])
    # α = 4πk/λ, λ in mm
    expected = 4 * np.pi * np.array([1e-7, 2e-7]) / (wavelengths * 1e-6)
    np.testing.assert_allclose(medium.absorption_per_mm_at(wavelengths), expected, rtol=1e-14)


def test_named_medium_holds_where_both_its_measurements_do():
    assert PMMA.wavelength_range_nm == (420.0, 1620.0)
    assert PMMA.is_spectral
    assert "Beadie" in PMMA.source
    assert "Zhang" in PMMA.source


def test_shapes_follow_the_wavelengths():
    assert isinstance(PMMA.index(550.0), float)
    assert PMMA.index([[500.0, 550.0, 600.0]]).shape == (1, 3)
    assert PMMA.index([]).shape == (0,)


def test_dispersion_is_normal_in_the_visible():
    wavelengths = np.linspace(450, 700, 26)
    for name in medium_names():
        assert np.all(np.diff(Medium.named(name).index(wavelengths)) < 0)


OWN = [
    Medium(1.52, 0.01, "mine"),
    Medium.cauchy(1.5, 0.004, wavelength_range_nm=(400, 700), absorption_per_mm=0.1),
    Medium.tabulated([400, 500, 700], [1.52, 1.51, 1.5], absorption_per_mm=[0.1, 0.2, 0.1]),
    # a packaged name on other numbers is not the packaged medium
    Medium(1.5, 0.0, "pmma"),
]


@pytest.mark.parametrize("medium", [*OWN, *map(Medium.named, medium_names())], ids=repr)
def test_media_survive_dict_pickle_and_copy(medium):
    for again in (Medium.from_dict(medium.to_dict()), pickle.loads(pickle.dumps(medium)), copy.deepcopy(medium)):
        assert again == medium
        assert hash(again) == hash(medium)
        assert again.index(550.0) == medium.index(550.0)
        assert again.absorption_per_mm_at(550.0) == medium.absorption_per_mm_at(550.0)


@given(
    pairs=st.lists(
        st.tuples(st.floats(200.0, 3000.0), st.floats(1.0, 4.0), st.floats(0.0, 10.0)),
        min_size=2,
        max_size=30,
        unique_by=lambda pair: pair[0],
    ),
    where=st.floats(0.0, 1.0),
)
def test_table_never_leaves_its_values(pairs, where):
    """Between two measurements lies a value between theirs; the whole survives a dictionary."""
    wavelength_nm, n, absorption = (np.array(column) for column in zip(*sorted(pairs), strict=True))
    medium = Medium.tabulated(wavelength_nm, n, absorption_per_mm=absorption)
    at = np.clip(wavelength_nm[0] + where * np.ptp(wavelength_nm), wavelength_nm[0], wavelength_nm[-1])
    np.testing.assert_allclose(medium.index(at), np.interp(at, wavelength_nm, n), rtol=1e-12)
    np.testing.assert_allclose(medium.absorption_per_mm_at(at), np.interp(at, wavelength_nm, absorption), atol=1e-11)
    assert Medium.from_dict(medium.to_dict()) == medium


def test_packaged_medium_is_its_name_alone():
    assert POLYCARBONATE.to_dict() == {"name": "polycarbonate"}
    assert Medium.from_dict("polycarbonate") == POLYCARBONATE
    assert repr(POLYCARBONATE) == "Medium.named('polycarbonate')"


def test_other_absorption_keeps_the_index():
    clear = SODA_LIME_CLEAR.with_absorption(0.0)
    assert clear.index(550.0) == SODA_LIME_CLEAR.index(550.0)
    assert clear.absorption_per_mm_at(550.0) == 0.0 < SODA_LIME_CLEAR.absorption_per_mm_at(550.0)
    assert "absorption_per_mm" in clear.to_dict()


@pytest.mark.parametrize(
    ("mistake", "message"),
    [
        (lambda: Medium(n=0.99), r"n must be .*at least 1, got 0\.99"),
        (lambda: Medium(n=math.nan), r"n must be finite"),
        (lambda: Medium(n=math.inf), r"n must be finite"),
        (lambda: Medium(n="glass"), r"n must be a number, got 'glass'"),
        (lambda: Medium(absorption_per_mm=-0.1), r"absorption_per_mm must be .*not negative, got -0\.1"),
        (lambda: Medium(absorption_per_mm=math.nan), r"absorption_per_mm must be finite"),
        (lambda: Medium.named("perspex"), r"must be one of pmma.*got \"perspex\""),
        (lambda: PMMA.index(), r"wavelength_nm must be given .*420 to 1620"),
        (lambda: PMMA.index(419.9), r"420 to 1620 nm.*got 419\.9"),
        (lambda: PMMA.index([500.0, 1700.0]), r"got 1700"),
        (lambda: PMMA.absorption_per_mm_at(math.nan), r"wavelength_nm must be finite"),
        (lambda: Medium().index(-5.0), r"wavelength_nm must be .*greater than 0, got -5"),
        (lambda: Medium().index("red"), r"wavelength_nm must be a number"),
        (lambda: Medium.cauchy(1.5, 0.0, wavelength_range_nm=(700, 400)), r"the shorter .*first"),
        (lambda: Medium.cauchy(0.9, 0.0, wavelength_range_nm=(400, 700)), r"n must be .* got 0\.9 at 400 nm"),
        (lambda: Medium.sellmeier([1.0], [0.36], wavelength_range_nm=(400, 700)), r"n must be finite"),
        (lambda: Medium.sellmeier([1.0, 2.0], [0.01], wavelength_range_nm=(400, 700)), r"c_um2 must have 2"),
        (lambda: Medium.tabulated([500, 400], [1.5, 1.5]), r"increasing; got 400 after 500"),
        (lambda: Medium.tabulated([400, 500], [1.5]), r"n must have 2 values, got 1"),
        (lambda: Medium.tabulated([400, 500], [1.5, 1.5], extinction=[0, -1]), r"extinction must be .*at 500 nm"),
        (
            lambda: Medium.tabulated([400, 500], [1.5, 1.5], extinction=[0, 0], absorption_per_mm=0.0),
            r"must not both be given",
        ),
        (
            lambda: Medium(PMMA.n, AbsorptionSpectrum("per_mm", (200.0, 300.0), (0.0, 0.0))),
            r"420 to 1620 nm.*200 to 300 nm.*must overlap",
        ),
        (lambda: Dispersion("abbe", (1.5,)), r"law must be one of"),
        (lambda: Medium(Dispersion("sellmeier", (0.0, 1.0))), r"coefficients of a sellmeier law must be"),
        (lambda: Medium.from_dict({"n": 1.5, "index": 1.5}), r"keys of medium must be among .*got 'index'"),
        (lambda: Medium.from_dict(1.5), r"medium must be a name or a table, got 1\.5"),
        (lambda: Medium.from_dict({"name": 5}), r"name must be text, got 5"),
        (lambda: Medium(1.5, 0.0, 5), r"name must be text, got 5"),
        (lambda: Medium.from_dict({"n": {"law": "cauchy"}}), r"keys of n must include 'coefficients'"),
    ],
)
def test_mistakes_say_name_rule_and_value(mistake, message):
    with pytest.raises(ClerestoryError, match=message):
        mistake()
