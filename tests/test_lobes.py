"""Lobes: energy, Snell's and the mirror's directions, symmetry, scale and polarisation."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from clerestory import LaserCutPanel, Medium, Pane, PrismaticPanel

CLEAR = Medium(n=1.49)
LCP = LaserCutPanel(spacing_mm=6, thickness_mm=3, medium=CLEAR)
PRISM = PrismaticPanel(pitch_mm=2, lower_deg=45, upper_deg=45, base_mm=2, medium=CLEAR)

incidence = {
    "elevation_deg": st.floats(-89.5, 89.5),
    "azimuth_deg": st.floats(-80, 80),
    "side": st.sampled_from(["front", "back"]),
}


@given(panel=st.sampled_from([LCP, PRISM]), polarisation=st.sampled_from(["resolved", "averaged"]), **incidence)
@settings(max_examples=40)
def test_power_absorbed_and_residual_add_to_one(panel, **at):
    lobes = panel.lobes(tolerance=1e-4, **at)
    assert float(lobes.power.sum()) + lobes.absorbed + lobes.residual == pytest.approx(1.0, abs=1e-12)
    np.testing.assert_allclose(np.linalg.norm(lobes.direction, axis=1), 1.0, atol=1e-12)
    assert (lobes.power > 0).all()


@given(**incidence)
@settings(max_examples=40)
def test_light_keeps_its_component_along_the_cuts(**at):
    """A panel is invariant along x: in air the x component of the direction is conserved."""
    lobes = PRISM.lobes(tolerance=1e-4, **at)
    x = np.sin(np.radians(at["azimuth_deg"])) * np.cos(np.radians(at["elevation_deg"]))
    np.testing.assert_allclose(lobes.direction.sel(axis="x"), x, atol=1e-12)


def test_a_laser_cut_panel_has_four_lobes():
    """Straight through, deflected, mirrored and sent back the way it came (Edmonds 1993)."""
    lobes = LCP.lobes(elevation_deg=60)
    s, c = np.sin(np.radians(60)), np.cos(np.radians(60))
    expected = {(-s, c): "back", (s, c): "back", (-s, -c): "front", (s, -c): "front"}
    found = {
        (round(y, 12), round(z, 12)): side
        for (_, y, z), side in zip(lobes.direction.values, lobes.side.values, strict=True)
    }
    assert found == {(round(y, 12), round(z, 12)): side for (y, z), side in expected.items()}
    through = lobes.isel(lobe=int(lobes.elevation_deg.values.argmin()))
    assert through.total_reflections == 0
    assert set(lobes.total_reflections.values.tolist()) == {0, 1}


def test_upward_light_leaves_at_positive_elevation():
    lobes = LCP.lobes(elevation_deg=30, azimuth_deg=40)
    deflected = lobes.isel(lobe=(lobes.side.values == "back") & (lobes.direction.values[:, 1] > 0))
    assert deflected.elevation_deg.values == pytest.approx([30.0])
    assert deflected.azimuth_deg.values == pytest.approx([40.0])


def test_mirrored_incidence_gives_mirrored_lobes():
    right, left = (PRISM.lobes(elevation_deg=25, azimuth_deg=a, tolerance=1e-9) for a in (35, -35))
    np.testing.assert_allclose(left.power, right.power, atol=1e-9)
    np.testing.assert_allclose(left.direction * [-1, 1, 1], right.direction, atol=1e-9)
    # handedness turns with the mirror: S2 and S3 change sign
    np.testing.assert_allclose(left.stokes * [1, 1, -1, -1], right.stokes, atol=1e-9)


@pytest.mark.parametrize("scale", [1e-3, 25.4])
def test_only_ratios_of_lengths_count(scale):
    scaled = LaserCutPanel(spacing_mm=6 * scale, thickness_mm=3 * scale, medium=CLEAR)
    np.testing.assert_allclose(scaled.lobes(elevation_deg=50).power, LCP.lobes(elevation_deg=50).power, atol=1e-9)


def test_polarisation_matters_where_it_should():
    """A slab of n = 1.49 at 74 degrees transmits 2.2 points more once s and p are told apart."""
    pane = Pane(thickness_mm=3, medium=CLEAR)
    resolved, averaged = (
        float(pane.lobes(elevation_deg=74, polarisation=p).query(lobe="side == 'back'").power.sum())
        for p in ("resolved", "averaged")
    )
    assert resolved - averaged == pytest.approx(0.022, abs=5e-4)


def test_stokes_vectors_are_physical_and_begin_with_the_power():
    lobes = PRISM.lobes(elevation_deg=50, azimuth_deg=30)
    np.testing.assert_array_equal(lobes.stokes[:, 0], lobes.power)
    assert (np.linalg.norm(lobes.stokes[:, 1:], axis=1) <= lobes.power * (1 + 1e-12)).all()
    assert "stokes" not in PRISM.lobes(elevation_deg=50, polarisation="averaged")


def test_dispersed_light_leaves_in_several_directions():
    prism = PrismaticPanel(pitch_mm=2, lower_deg=30, upper_deg=90, base_mm=1)
    white, green = prism.lobes(elevation_deg=40), prism.lobes(elevation_deg=40, wavelength_nm=550)
    assert white.sizes["lobe"] > 3 * green.sizes["lobe"]
    assert float(white.power.sum()) + white.absorbed + white.residual == pytest.approx(1.0, abs=1e-12)
