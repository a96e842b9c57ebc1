"""Comparison with measurements: regression by hand, CSV files, and other tables."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from clerestory import ClerestoryError, LaserCutPanel, Medium, compare, read_measured, save
from clerestory.compare import regression

LCP = LaserCutPanel(spacing_mm=6, thickness_mm=3, medium=Medium(n=1.49))


def test_regression_by_hand():
    x, y = np.array([0.0, 1.0, 2.0]), np.array([1.0, 2.0, 4.0])
    # means 1 and 7/3; sums of squares 2 and 14/3, of products 3
    found = regression("transmittance", y, x, np.array([0.0, 10.0, 20.0]))
    assert (found.n, found.largest_difference, found.largest_at_elevation_deg) == (3, 2.0, 20.0)
    assert found.slope == pytest.approx(1.5)
    assert found.intercept == pytest.approx(7 / 3 - 1.5)
    assert found.r_squared == pytest.approx(9 / (2 * 14 / 3))
    assert found.rms == pytest.approx(np.sqrt((1 + 1 + 4) / 3))


def test_points_that_were_not_measured_do_not_count():
    x = np.array([0.0, np.nan, 1.0])
    found = regression("reflectance", np.array([0.0, 5.0, 1.0]), x, np.zeros(3))
    assert (found.n, found.r_squared, found.rms) == (2, 1.0, 0.0)


def test_what_does_not_vary_has_no_r_squared():
    found = regression("absorptance", np.array([0.0, 0.1]), np.zeros(2), np.zeros(2))
    assert np.isnan(found.r_squared)
    assert found.to_dict()["r_squared"] is None


def test_a_table_agrees_with_its_own_csv(tmp_path: Path):
    table = LCP.angular(elevation_deg=[0, 30, 60], azimuth_deg=[0, 20])
    path = save(table, tmp_path / "table.csv")
    for comparison in compare(table, path).values():
        assert comparison.n == 6
        assert comparison.rms == 0.0


def test_a_measured_file_is_compared_by_name(tmp_path: Path):
    path = tmp_path / "measured.csv"
    path.write_text(
        "# gonioscope, 2024\ntheta_deg,transmittance,transmittance_deflected\n\n10,0.91,0.05\n45,0.9,\n20,0.9,0.1\n"
    )
    table = LCP.angular(elevation_deg=range(0, 61, 5))
    found = compare(table, path)
    assert list(found) == ["transmittance", "transmittance_deflected"]
    assert (found["transmittance"].n, found["transmittance_deflected"].n) == (3, 2)
    expected = table.transmittance_deflected.sel(elevation=[10, 20]).values[:, 0]
    np.testing.assert_allclose(found["transmittance_deflected"].values, expected, rtol=1e-12)
    assert read_measured(path).attrs["source"] == str(path)


def test_between_its_elevations_a_table_is_straight():
    table = LCP.angular(elevation_deg=[0, 10])
    middle = xr.DataArray([0.5, 0.5], coords={"elevation": [5.0, 2.5]}, name="transmittance")
    ends = table.transmittance.values[:, 0]
    expected = [ends.mean(), 0.75 * ends[0] + 0.25 * ends[1]]
    np.testing.assert_allclose(compare(table, middle)["transmittance"].values, expected, rtol=1e-12)


def test_another_table_is_a_reference_too():
    table = LCP.angular(elevation_deg=[0, 30, 60])
    walked = LCP.angular(elevation_deg=[30, 60], method="monte_carlo", rays=20_000)
    found = compare(table, walked)["transmittance_deflected"]
    assert found.n == 2
    assert found.rms < 5 * float(walked.transmittance_deflected_standard_error.max())


def test_points_beyond_the_table_are_refused():
    outside = xr.DataArray([0.5, 0.5], coords={"elevation": [5.0, 40.0]}, name="transmittance")
    with pytest.raises(ClerestoryError, match=r"elevation_deg of the reference must lie within .* \(0 to 10\), got 40"):
        compare(LCP.angular(elevation_deg=[0, 10]), outside)


def test_several_wavelengths_are_refused():
    table = LCP.angular(elevation_deg=[0, 10], wavelength_nm=[500, 600])
    with pytest.raises(ClerestoryError, match="must be of one wavelength"):
        compare(table, table.transmittance)
