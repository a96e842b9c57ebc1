"""Strips of a drawing against the lobes of the solver."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured
from tests.validation.laser_cut_series.measure import ideal

from clerestory.panels.section_beams import section_beams
from clerestory.plots import section


def leaving_shares(beams, front, back):
    """Power by elevation and side of the strips that end outside."""
    shares = {}
    corners, power = beams.corners.values, beams.power.values
    for strip, share in zip(corners[1:], power[1:], strict=True):
        z, y = strip[3] - strip[0]
        if strip[2, 0] > back or strip[2, 0] < front:
            key = (round(float(np.degrees(np.arctan2(y, abs(z)))), 6), "back" if z > 0 else "front")
            shares[key] = shares.get(key, 0.0) + float(share)
    return shares


def claim(thorough: bool) -> Claim:
    """Largest difference of any direction's share."""
    panel, worst = ideal(0.5, 1.49), 0.0
    front, back = panel.profile.depth_range_mm
    for elevation in (20.0, 50.0, 65.0):
        drawn = leaving_shares(section_beams(panel, elevation_deg=elevation, least_power=1e-7), front, back)
        lobes = panel.lobes(elevation_deg=elevation, polarisation="averaged", tolerance=1e-9)
        for e, side, power in zip(lobes.elevation_deg.values, lobes.side.values, lobes.power.values, strict=True):
            worst = max(worst, abs(drawn.get((round(float(e), 6), str(side)), 0.0) - power))
    picture = section(
        panel, section_beams(panel, elevation_deg=50.0), title="Laser-cut panel D/W = 0.5, light from 50°"
    )
    return Claim([Measured("largest difference of a direction's share at 20°, 50°, 65°", worst, 1e-5)], picture)
