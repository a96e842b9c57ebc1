"""Strips that are drawn carry what the solver finds by merging them, absorption on the way included."""

import pytest

from clerestory import LaserCutPanel
from clerestory.panels.section_beams import section_beams


@pytest.mark.parametrize("elevation_deg", [20.0, 45.0, 70.0])
def test_strips_that_leave_are_dimmed_as_the_beams_are(elevation_deg):
    """Two per cent and more are absorbed; spreading what is dimmed evenly again moves the sums by 5e-5 at most."""
    panel = LaserCutPanel(spacing_mm=6.0, thickness_mm=6.0)
    asked = {"elevation_deg": elevation_deg, "wavelength_nm": 550.0}
    strips = section_beams(panel, **asked, least_power=1e-6)
    shares = panel.angular(**asked, polarisation="averaged").squeeze()
    assert shares.absorptance > 0.02
    front, back = panel.native_profile.depth_range_mm
    ends = strips.corners.values[1:, 2:, 0]
    power = strips.power.values[1:]
    through, returned = (ends > back + 1e-9).all(axis=1), (ends < front - 1e-9).all(axis=1)
    assert power[through].sum() == pytest.approx(float(shares.transmittance), abs=1e-4)
    assert power[returned].sum() == pytest.approx(float(shares.reflectance), abs=1e-4)
