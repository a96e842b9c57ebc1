"""Annual sums of the reference room by both programs."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured
from tests.validation.radiance_room.radiance import radiance_coefficients
from tests.validation.year_sky.measure import EPW
from tests.validation.year_sky.radiance import radiance_year

from clerestory import annual_illuminance, annual_sun_coefficients, daylight_coefficients, read_epw
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.room import Opening, Room, SensorGrid

RUNS, OWN_RUNS = 8, 4
SYSTEMATIC = 0.01
"""What centres of patches and a sun 0.4° off may do to one sensor's sum."""
ROOM = Room.shoebox(
    width_m=4.0,
    depth_m=8.0,
    height_m=3.0,
    openings=[Opening(width_m=3.6, height_m=1.8)],
    sensors=[SensorGrid(spacing_m=1.0)],
)


def claim(thorough: bool) -> Claim:
    """Sums over the year, sensor by sensor."""
    weather = read_epw(EPW)
    (sensors,) = ROOM.sensor_points()
    theirs = radiance_year(EPW, hours=len(weather))
    runs = [
        radiance_coefficients(ROOM, sensors, divisions=4096 if thorough else 512, seed=seed)
        for seed in range(1, RUNS + 1)
    ]
    # the ground comes first there and last here
    ordered = np.roll(np.array(runs), -1, axis=2)
    sky_runs = ordered @ theirs.luminance.sum(axis=1) / len(weather)
    sun_runs = ordered @ theirs.with_sun.sum(axis=1) / len(weather)
    suns = annual_sun_coefficients(ROOM, None, weather, rounds=32 if thorough else 8, seed=2)
    own = []
    for seed in range(OWN_RUNS):
        coefficients = daylight_coefficients(
            ROOM, basis="tregenza145", rounds=8, nodes=8192, window_samples=4096, seed=seed
        )
        year = annual_illuminance(coefficients, suns, weather)
        own.append([year[name].values.astype(np.float64).mean(axis=1) for name in ("sky", "total")])
    sky, total = np.mean(own, axis=0)
    own_error = np.array(own)[:, 0].std(axis=0, ddof=1) / np.sqrt(OWN_RUNS)
    known, error = sky_runs.mean(axis=0), sky_runs.std(axis=0, ddof=1) / np.sqrt(RUNS)
    noise = float(sky_runs.mean(axis=1).std(ddof=1) / np.sqrt(RUNS) / known.mean())
    with_sun = sun_runs.mean(axis=0)
    rows, place = sensors.row, sensors.points_m[:, 1]
    assert rows is not None
    with styled():
        figure = blank(6.4, 4.2)
        axes = figure.add_subplot()
        distance = [place[rows == row].mean() for row in np.unique(rows)]
        for label, values, colour, mark in (
            ("sky, Clerestory", sky, COLOURS[0], "o-"),
            ("sky, Radiance", known, COLOURS[1], "o--"),
            ("sky and sun, Clerestory", total, COLOURS[2], "s-"),
            ("sky and sun, Radiance, sun in four patches", with_sun, COLOURS[3], "s--"),
        ):
            axes.plot(distance, [values[rows == r].mean() for r in np.unique(rows)], mark, color=colour, label=label)
        axes.set(yscale="log", xlabel="Distance from the window [m]", ylabel="Mean illuminance of the year [lx]")
        axes.set_title("Reference room in Miami, mean of each row")
        axes.legend()
    z = (sky - known) / np.sqrt(error**2 + own_error**2 + (SYSTEMATIC * known) ** 2)
    return Claim(
        [
            Measured(
                "sky: standardised differences of the sums of 32 sensors, rms", float(np.sqrt(np.mean(z**2))), 1.5
            ),
            Measured("sky: Radiance's standard error of the mean, relative", noise, 0.01),
            Measured("sky: mean of room and year, relative difference", abs(sky.mean() / known.mean() - 1.0), 0.02),
            Measured("sky and sun: mean, relative difference", abs(total.mean() / with_sun.mean() - 1.0), 0.05),
        ],
        figure,
    )
