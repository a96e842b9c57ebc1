"""Angular tables: against the closed form of a slab, energy, shapes, wavelengths and how they are saved."""

import json
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from clerestory import ClerestoryError, LaserCutPanel, Medium, Pane, PrismaticPanel, panel_from_dict, save
from clerestory.glass import slab
from clerestory.spectrum import photopic_quadrature

CLEAR = Medium(n=1.49)
LCP = LaserCutPanel(spacing_mm=6, thickness_mm=3, medium=CLEAR)
TOLERANCE = 1e-9
ENERGY = ["transmittance", "reflectance", "absorptance", "residual"]


@pytest.mark.parametrize("polarisation", ["resolved", "averaged"])
@pytest.mark.parametrize("side", ["front", "back"])
def test_a_pane_is_the_closed_form_slab(polarisation, side):
    medium = Medium(n=1.52, absorption_per_mm=0.02)
    elevation, azimuth = np.array([-80.0, 0.0, 30.0, 74.0, 89.0]), np.array([-50.0, 0.0, 20.0])
    table = Pane(thickness_mm=8, medium=medium).angular(
        elevation_deg=elevation, azimuth_deg=azimuth, side=side, polarisation=polarisation, tolerance=TOLERANCE
    )
    cos_i = np.cos(np.radians(azimuth)) * np.cos(np.radians(elevation[:, None]))
    shares = slab(np.degrees(np.arccos(cos_i)), 1.52, absorption_per_mm=0.02, thickness_mm=8, polarisation=polarisation)
    for name, expected in shares._asdict().items():
        np.testing.assert_allclose(table[name], expected, rtol=0, atol=2 * TOLERANCE)


def test_power_is_accounted_for():
    panel = LaserCutPanel(spacing_mm=4, thickness_mm=6, cut_width_mm=0.3)
    table = panel.angular(elevation_deg=[-60, 10], azimuth_deg=[0, 35], side="back", wavelength_nm=550)
    np.testing.assert_allclose(sum(table[name] for name in ENERGY), 1.0, rtol=0, atol=1e-12)
    parts = table.transmittance_deflected + table.transmittance_undeflected
    np.testing.assert_allclose(parts, table.transmittance, rtol=0, atol=1e-12)
    assert float(table.residual.max()) <= 1e-6
    assert float(table.absorptance.min()) > 0.0


def test_an_ideal_laser_cut_panel_transmits_what_its_slab_does():
    """A perfect mirror across the sheet turns rays, it takes none."""
    elevation = [10, 40, 70]
    table = LCP.angular(elevation_deg=elevation, tolerance=TOLERANCE)
    expected = slab(elevation, 1.49).transmittance
    np.testing.assert_allclose(table.transmittance[:, 0], expected, rtol=0, atol=2 * TOLERANCE)
    assert (table.transmittance_deflected > 0.05).all()


def test_dimensions_follow_the_question():
    assert dict(LCP.angular(elevation_deg=60).sizes) == {"elevation": 1, "azimuth": 1}
    table = LCP.angular(elevation_deg=[0, 60], azimuth_deg=[0, 10, 20], wavelength_nm=[500, 600, 700, 800])
    assert table.transmittance.dims == ("elevation", "azimuth", "wavelength")
    assert table.transmittance.shape == (2, 3, 4)
    at_one = LCP.angular(elevation_deg=[0, 60], wavelength_nm=550)
    assert at_one.transmittance.dims == ("elevation", "azimuth")
    assert at_one.wavelength.item() == 550.0


def test_light_of_daylight_is_the_weighted_mean_of_its_wavelengths():
    panel = PrismaticPanel(pitch_mm=2, lower_deg=45, upper_deg=45, base_mm=2)
    wavelengths, weights = photopic_quadrature("D65", 5)
    elevation = [10, 35, 60]
    visible = panel.angular(elevation_deg=elevation)
    spectral = panel.angular(elevation_deg=elevation, wavelength_nm=wavelengths)
    for name in ENERGY:
        np.testing.assert_allclose(visible[name].values, spectral[name].values @ weights, rtol=0, atol=1e-12)
    assert json.loads(visible.attrs["wavelength_nm"]) == wavelengths.tolist()
    assert float(np.ptp(spectral.transmittance.values, axis=-1).max()) > 1e-3


def test_curved_cuts_converge_with_their_chords():
    panel = LaserCutPanel(spacing_mm=5, thickness_mm=5, cut_radius_mm=25, medium=CLEAR)
    coarse, fine, finer = (
        panel.angular(elevation_deg=50, arc_chords=chords).transmittance_deflected for chords in (2, 8, 16)
    )
    assert float(abs(fine - finer).max()) < 0.5 * float(abs(coarse - finer).max())
    assert panel.angular(elevation_deg=30, arc_chords=16).attrs["arc_chords"] == 16
    assert "arc_chords" not in LCP.angular(elevation_deg=30).attrs


def test_a_table_says_what_it_was_made_from():
    table = LCP.angular(elevation_deg=[0, 60])
    assert panel_from_dict(json.loads(table.attrs["panel"])) == LCP
    assert {"clerestory_version", "date", "method", "side", "polarisation", "tolerance"} <= set(table.attrs)
    for variable in table.variables.values():
        assert {"units", "long_name"} <= set(variable.attrs)


def test_a_table_survives_netcdf(tmp_path: Path):
    table = LCP.angular(elevation_deg=[0, 60], azimuth_deg=[0, 10], wavelength_nm=[500, 600])
    path = save(table, tmp_path / "table.nc")
    with xr.open_dataset(path) as read:
        xr.testing.assert_identical(read.load(), table)
    assert list(tmp_path.iterdir()) == [path]


def test_only_known_endings_are_written(tmp_path: Path):
    with pytest.raises(ClerestoryError, match=r"path must end in \.nc or \.csv"):
        save(LCP.angular(elevation_deg=0), tmp_path / "table.xls")


@pytest.mark.parametrize("azimuth", [0, 40])
def test_rays_agree_with_beams_within_their_standard_error(azimuth):
    panel = LaserCutPanel(spacing_mm=4, thickness_mm=6, cut_width_mm=0.3, medium=Medium(n=1.49, absorption_per_mm=0.01))
    at = {"elevation_deg": [-20, 35, 70], "azimuth_deg": azimuth}
    exact, walked = panel.angular(**at), panel.angular(**at, method="monte_carlo", rays=20_000, seed=3)
    for name in ["transmittance", "reflectance", "absorptance", "transmittance_deflected"]:
        error = walked[f"{name}_standard_error"]
        assert float(error.max()) < 5e-3, "too noisy to judge"
        assert float(error.min()) > 0.0
        assert (abs(walked[name] - exact[name]) <= 4.5 * error + 1e-6).all()
    np.testing.assert_allclose(sum(walked[name] for name in ENERGY), 1.0, rtol=0, atol=1e-12)


def test_the_same_seed_gives_the_same_result():
    at = {"elevation_deg": [20, 20], "method": "monte_carlo", "rays": 2000}
    first, again, other = (LCP.angular(**at, seed=seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(first.transmittance_deflected, again.transmittance_deflected)
    assert (first.transmittance_deflected != other.transmittance_deflected).all()
    assert first.transmittance_deflected[0] != first.transmittance_deflected[1]
    assert (first.attrs["rays"], first.attrs["seed"]) == (2000, 1)


def test_rippled_cuts_spread_light_that_smooth_cuts_deflect():
    rough = LaserCutPanel(spacing_mm=6, thickness_mm=3, cut_slope_deg=3, cut_diffuse=0.3, medium=CLEAR)
    smooth = LCP.angular(elevation_deg=40)
    walked = rough.angular(elevation_deg=40, method="monte_carlo", rays=20_000)
    lost = smooth.transmittance_deflected - walked.transmittance_deflected
    assert lost.item() > 10 * walked.transmittance_deflected_standard_error.item()


def test_rough_cuts_need_rays():
    rough = LaserCutPanel(spacing_mm=6, thickness_mm=3, cut_slope_deg=1)
    with pytest.raises(ClerestoryError, match="use method='monte_carlo'"):
        rough.angular(elevation_deg=30)
