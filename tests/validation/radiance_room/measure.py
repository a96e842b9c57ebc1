"""Daylight factor of the reference room by both programs."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured
from tests.validation.radiance_room.radiance import radiance_coefficients

from clerestory.coefficients import daylight_coefficients
from clerestory.illuminance import daylight_factor
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.room import Opening, Room, SensorGrid
from clerestory.sky import CieSky, sky_basis

RUNS = 8
ROOM = Room.shoebox(
    width_m=4.0,
    depth_m=8.0,
    height_m=3.0,
    openings=[Opening(width_m=3.6, height_m=1.8)],
    sensors=[SensorGrid(spacing_m=0.5)],
)


def claim(thorough: bool) -> Claim:
    """Standardised differences at 128 sensors."""
    (sensors,) = ROOM.sensor_points()
    luminance = CieSky(sky_type=16, diffuse_horizontal_illuminance_lx=100.0).matrix("tregenza145").values
    ordered = luminance[np.asarray(sky_basis("tregenza145").order("radiance"))]
    divisions = 4096 if thorough else 512
    runs = np.array(
        [radiance_coefficients(ROOM, sensors, divisions=divisions, seed=seed) @ ordered for seed in range(1, RUNS + 1)]
    )
    theirs, their_error = runs.mean(axis=0), runs.std(axis=0, ddof=1) / np.sqrt(RUNS)
    factor = daylight_factor(
        daylight_coefficients(ROOM, basis="tregenza145", rounds=1024 if thorough else 256, seed=14)
    )
    ours, our_error = factor.total.values, factor.total_standard_error.values
    z = (ours - theirs) / np.hypot(our_error, their_error)
    room_mean = theirs.mean()
    # rounds and runs are drawn anew as a whole: the scatter of the room's mean is that of the runs' means
    mean_error = float(runs.mean(axis=1).std(ddof=1) / np.sqrt(RUNS))
    ours_mean_error = float(our_error.mean())
    both = np.hypot(mean_error, ours_mean_error)
    with styled():
        figure = blank(6.4, 4.0)
        axes = figure.add_subplot()
        rows = factor.row.values
        distance = [float(factor.y_m.values[rows == row].mean()) for row in np.unique(rows)]
        for label, values, colour in (("Clerestory", ours, COLOURS[0]), ("Radiance", theirs, COLOURS[1])):
            axes.plot(
                distance, [values[rows == row].mean() for row in np.unique(rows)], "o-", color=colour, label=label
            )
        axes.set_yscale("log")
        axes.set(
            xlabel="Distance from the window [m]",
            ylabel="Daylight factor [%]",
            title="Reference room, mean of each row",
        )
        axes.legend()
    return Claim(
        [
            Measured("standardised differences at 128 sensors, rms", float(np.sqrt(np.mean(z**2))), 1.5),
            Measured("mean over the room: standard error, relative", both / room_mean, 0.01),
            Measured("mean over the room: off by, in standard errors", abs(ours.mean() - room_mean) / both, 4.0),
            Measured("mean over the room: off by, relative", abs(ours.mean() / room_mean - 1.0), 0.02),
        ],
        figure,
    )
