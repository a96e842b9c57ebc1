"""Measured glass: angular values against those of Berkeley Lab's WINDOW engine, and files that are refused."""

import csv
from pathlib import Path

import numpy as np
import pytest

from clerestory.errors import ClerestoryError
from clerestory.glass import slab
from clerestory.measured_glass import measured_glass, medium_of_pane
from clerestory.spectrum import photopic_mean

DATA = Path(__file__).parent / "data"


def reference(file):
    """Incidence, visible transmittance and front reflectance by pywincalc, printed to five decimals."""
    with (DATA / "glass_angular_pywincalc.csv").open(encoding="utf-8") as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        return np.array(
            [[float(row[key]) for key in ("theta_deg", "Tvis", "Rvis_front")] for row in rows if row["file"] == file]
        ).T


@pytest.mark.parametrize("file", ["CLEAR_3.DAT", "CLEAR_6.DAT"])
def test_visible_values_at_every_angle_are_those_of_window(file):
    """Half a unit of the fifth decimal is the table's rounding; as much again for another table of the illuminant."""
    incidence_deg, transmittance, reflectance = reference(file)
    assert incidence_deg.size == 18
    ours = measured_glass(DATA / file).photopic(incidence_deg)
    assert np.abs(ours.transmittance - transmittance).max() < 1e-5
    assert np.abs(ours.reflectance - reflectance).max() < 1e-5


def test_normal_incidence_gives_the_measurement_back():
    glass = measured_glass(DATA / "CLEAR_3.DAT")
    front, back = glass.spectral(0.0), glass.spectral(0.0, side="back")
    np.testing.assert_allclose(front.transmittance, glass.transmittance, atol=1e-13)
    np.testing.assert_allclose(front.reflectance, glass.reflectance_front, atol=1e-13)
    np.testing.assert_allclose(back.reflectance, glass.reflectance_back, atol=1e-13)


@pytest.mark.parametrize(
    ("file", "thickness_mm"), [("CLEAR_3.DAT", 3.048), ("CLEAR_6.DAT", 5.715), ("frads_igsdb_product_7968.json", 8.0)]
)
def test_two_numbers_of_a_data_sheet_do_almost_as_well(file, thickness_mm):
    """Within 3e-4: so much does the spread of the spectrum make of the panes whose spectrum is known (2.6e-4)."""
    incidence_deg, transmittance, reflectance = reference(file)
    glass = medium_of_pane(transmittance[0], reflectance[0], thickness_mm=thickness_mm)
    ours = slab(incidence_deg, glass.index(), absorption_per_mm=glass.absorption_per_mm_at(), thickness_mm=thickness_mm)
    assert np.abs(ours.transmittance - transmittance).max() < 3e-4
    assert np.abs(ours.reflectance - reflectance).max() < 3e-4


def test_medium_of_a_measured_pane_makes_the_pane_again():
    """The mean of the two sides' reflectances stands for both: they differ by 0.001, and T follows to 1e-4."""
    glass = measured_glass(DATA / "CLEAR_6.DAT")
    medium = glass.medium()
    # opaque in the tables at 310 nm and below
    assert medium.wavelength_range_nm == (315.0, 2500.0)
    wavelengths = np.arange(380.0, 781.0, 5.0)
    shares = slab(
        60.0,
        medium.index(wavelengths),
        absorption_per_mm=medium.absorption_per_mm_at(wavelengths),
        thickness_mm=glass.thickness_mm,
    )
    assert photopic_mean(wavelengths, shares.transmittance) == pytest.approx(
        glass.photopic(60.0).transmittance, abs=1e-4
    )


def test_heading_is_read():
    glass = measured_glass(DATA / "CLEAR_6.DAT")
    assert (glass.name, glass.thickness_mm) == ("Generic Clear Glass", 5.715)
    assert (glass.wavelength_nm[0], glass.wavelength_nm[-1]) == (300.0, 2500.0)


HEADING = "{ Units, Wavelength Units } SI Microns\n{ Thickness } 3.0\n{ Coated Side: Neither }\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (HEADING + "0.38 0.9 0.08 0.08\n0.39 0.9 0.08\n", r"line 5: a row must be wavelength, T, Rf, Rb, got '0\.39"),
        (HEADING + "0.38 0.9 0.08 0.08\n0.38 0.9 0.08 0.08\n", r"line 5: wavelengths must .*increase"),
        (HEADING + "0.38 90 8 8\n0.39 90 8 8\n", r"line 4: T and R .*not per cent"),
        (HEADING + "0.38 0.9 0.08 nan\n", r"line 4: a row must be"),
        (HEADING, r"two or more rows .*got 0"),
        ("{ Thickness } 3.0\n{ Coated Side: Front }\n0.38 .9 .08 .08\n0.39 .9 .08 .08\n", r"coated side must be"),
        ("0.38 0.9 0.08 0.08\n0.78 0.9 0.08 0.08\n", r"must have a heading \{ Thickness \}"),
        (
            "{ Thickness } thin\n0.38 0.9 0.08 0.08\n0.78 0.9 0.08 0.08\n",
            r"thickness must be a number .*got 'thin'",
        ),
        ("{ Thickness } -3\n0.38 0.9 0.08 0.08\n0.78 0.9 0.08 0.08\n", r"thickness must be .*got -3"),
        ("{ Units, Wavelength Units } cm\n{ Thickness } 3\n1 .9 .08 .08\n2 .9 .08 .08\n", r"wavelength units must be"),
    ],
)
def test_mistakes_name_file_and_line(tmp_path, text, message):
    path = tmp_path / "pane.dat"
    path.write_text(text)
    with pytest.raises(ClerestoryError, match=f"pane.dat.*{message}"):
        measured_glass(path)


def test_missing_file_is_named(tmp_path):
    with pytest.raises(ClerestoryError, match=r"none\.dat must be a readable file"):
        measured_glass(tmp_path / "none.dat")


def test_spectrum_short_of_the_visible_is_refused(tmp_path):
    path = tmp_path / "pane.dat"
    path.write_text(HEADING + "0.40 0.9 0.08 0.08\n0.70 0.9 0.08 0.08\n")
    with pytest.raises(ClerestoryError, match="must span 380 to 780 nm, got 400 to 700"):
        measured_glass(path).photopic(0.0)


@pytest.mark.parametrize(
    ("mistake", "message"),
    [
        (lambda: medium_of_pane(0.0, 0.08, thickness_mm=6), "transmittance must be greater than 0"),
        (lambda: medium_of_pane(0.95, 0.08, thickness_mm=6), "their sum at most 1; got 0.95 and 0.08"),
        (lambda: medium_of_pane(0.9, 0.08, thickness_mm=0), "thickness_mm must be .*greater than 0, got 0"),
        (lambda: measured_glass(DATA / "CLEAR_3.DAT").spectral(0.0, side="left"), "side must be front or back"),
        (lambda: measured_glass(DATA / "CLEAR_3.DAT").photopic(95.0), "incidence_deg must be .*got 95"),
    ],
)
def test_mistakes_say_name_rule_and_value(mistake, message):
    with pytest.raises(ClerestoryError, match=message):
        mistake()
