"""The exact sun through prisms of odd angles between and behind panes: what arrives is what the stack sends."""

import numpy as np
import pytest

from clerestory import Medium, Pane, PrismaticPanel, Stack
from clerestory.room import Opening, Part, Room, Sensors
from clerestory.sun_coefficients import sun_coefficients

PANE = Pane(thickness_mm=4.0, medium=Medium(n=1.52))
CLEAR = Medium(n=1.49, absorption_per_mm=0.002)
STEEP = PrismaticPanel(pitch_mm=2.0, lower_deg=45.0, upper_deg=80.0, base_mm=3.0, medium=CLEAR)
FLAT = PrismaticPanel(pitch_mm=2.0, lower_deg=60.0, upper_deg=20.0, base_mm=3.0, ridges="back", medium=CLEAR)
STACKS = {
    "behind": Stack([PANE, STEEP]),
    "before": Stack([FLAT, PANE]),
    "between": Stack([PANE, STEEP, PANE]),
    "two": Stack([STEEP, FLAT]),
}


def lit(stack, altitude_deg, turn_deg):
    """What a sensor close behind the middle of the window gets that faces it, and one that faces down."""
    room = Room.shoebox(
        width_m=4.0,
        depth_m=5.0,
        height_m=3.0,
        floor=0.0,
        walls=0.0,
        ceiling=0.0,
        openings=[Opening(width_m=3.6, height_m=2.8, sill_m=0.1, parts=[Part(glazing=stack)])],
    )
    sensors = Sensors(points_m=[[2.0, 0.005, 1.5]] * 2, normals=[[0.0, -1.0, 0.0], [0.0, 0.0, -1.0]])
    return sun_coefficients(room, sensors, altitude_deg=altitude_deg, azimuth_deg=180.0 + turn_deg, rounds=4)


@pytest.mark.parametrize("name", STACKS)
def test_the_sun_behind_odd_prisms_is_what_their_beams_say(name):
    altitude_deg, turn_deg = 35.0, 20.0
    found = lit(STACKS[name], altitude_deg, turn_deg)
    beams = STACKS[name].lobes(elevation_deg=altitude_deg, azimuth_deg=turn_deg)
    cos_in = np.cos(np.radians(altitude_deg)) * np.cos(np.radians(turn_deg))
    _, up, inward = beams.direction.values.T
    through = beams.power.values * cos_in * (inward > 0.0)
    facing = float(through.sum())
    rising = float((through * np.maximum(up, 0.0) / np.maximum(inward, 1e-9))[inward > 0.01].sum())
    together = (found.direct + found.redirected).values[:, 0]
    missing = float(found.cut_off[0])
    assert beams.attrs["walked"] > 1e-3
    assert 0.0 < missing < 5e-3
    # within the sun's disc shares change by a percent; the walks of the discs' points by their standard errors
    for light, expected in zip(together, (facing, rising), strict=True):
        assert expected > 0.05
        assert abs(light - expected) < 0.01 * expected + missing + 4.5 * 2e-4
