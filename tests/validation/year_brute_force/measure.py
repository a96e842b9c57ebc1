"""A room's year by coefficients and by paths."""

from __future__ import annotations

import numpy as np
from tests.validation.claim import Claim, Measured
from tests.validation.year_brute_force.paths import Box, Hours, illuminance
from tests.validation.year_sky.measure import EPW

from clerestory import (
    Opening,
    Part,
    PlainTransmittance,
    Room,
    Sensors,
    Weather,
    annual_illuminance,
    annual_sun_coefficients,
    daylight_coefficients,
    read_epw,
)
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.sky.perez import luminance_parameters
from clerestory.weather.light import light_of

SIZE_M = (3.0, 4.0, 2.7)
WINDOW_M = (0.5, 2.5, 0.9, 2.3)
TRANSMITTANCE = 0.7
REFLECTANCES = (0.2, 0.5, 0.8)
GROUND = 0.2
POINTS_M = [[0.8, 0.6, 0.8], [2.2, 1.2, 0.8], [1.5, 1.8, 0.8], [0.9, 2.4, 0.8], [2.1, 3.0, 0.8], [1.5, 3.6, 0.8]]
RUNS = 4


def room() -> Room:
    """The box as a room; its facade looks south."""
    left, right, low, high = WINDOW_M
    window = Opening(
        width_m=right - left,
        height_m=high - low,
        sill_m=low,
        left_m=left,
        parts=[Part(glazing=PlainTransmittance(transmittance=TRANSMITTANCE))],
    )
    return Room.shoebox(
        width_m=SIZE_M[0],
        depth_m=SIZE_M[1],
        height_m=SIZE_M[2],
        floor=REFLECTANCES[0],
        walls=REFLECTANCES[1],
        ceiling=REFLECTANCES[2],
        openings=[window],
        sensors=[Sensors(points_m=POINTS_M)],
        ground_reflectance=GROUND,
    )


def some_hours(every: int) -> Weather:
    """Lit hours of the year, each so many-th."""
    year = read_epw(EPW)
    lit = np.flatnonzero(light_of(year).diffuse_horizontal_lx > 0.0)[every // 2 :: every]
    return Weather.from_frame(year.frame.iloc[lit], year.site, interval_minutes=60.0, max_gap_hours=None)


def claim(thorough: bool) -> Claim:
    """Sums over hours, sensor by sensor."""
    weather = some_hours(8 if thorough else 64)
    light = light_of(weather)
    parameters = luminance_parameters(light.conditions)
    hours = Hours(
        parameters,
        Hours.scales(parameters, light.sun_direction, light.diffuse_horizontal_lx),
        light.diffuse_horizontal_lx,
        light.direct_normal_lx,
        light.sun_direction,
    )
    box = Box(SIZE_M, WINDOW_M, TRANSMITTANCE, REFLECTANCES, GROUND)
    paths, path_error = illuminance(box, hours, np.array(POINTS_M), paths=4096 if thorough else 1024, seed=3)
    runs = []
    for seed in range(RUNS):
        coefficients = daylight_coefficients(
            room(), basis="reinhart2305", rounds=8, nodes=4096, window_samples=4096, seed=seed
        )
        suns = annual_sun_coefficients(room(), None, weather, rounds=32, seed=seed)
        runs.append(annual_illuminance(coefficients, suns, weather).total.values.astype(np.float64))
    ours = np.mean(runs, axis=0)
    scatter = np.array(runs).mean(axis=2).std(axis=0, ddof=1) / np.sqrt(RUNS)
    by_sensor = np.sqrt((path_error**2).sum(axis=1)) / len(weather)
    z = (ours.mean(axis=1) - paths.mean(axis=1)) / np.hypot(scatter, by_sensor)
    mean = float(paths.mean())
    # the runs are drawn anew as a whole, the paths sensor by sensor
    scatter_of_mean = np.array(runs).mean(axis=(1, 2)).std(ddof=1) / np.sqrt(RUNS)
    both = float(np.hypot(scatter_of_mean, np.sqrt((by_sensor**2).sum()) / len(POINTS_M)))
    off = abs(float(ours.mean()) - mean)
    with styled():
        figure = blank(4.8, 4.4)
        axes = figure.add_subplot()
        lit = (paths > 0.0) & (ours > 0.0)
        axes.plot([10.0, 1e5], [10.0, 1e5], color=COLOURS[6], linewidth=0.8)
        axes.plot(paths[lit], ours[lit], ".", markersize=3, color=COLOURS[0])
        axes.set(xscale="log", yscale="log", xlabel="By paths, hour by hour [lx]", ylabel="By coefficients [lx]")
        axes.set_title(f"{len(weather)} hours of Miami, six sensors")
    return Claim(
        [
            Measured("mean of hours and sensors: combined standard error, relative", both / mean, 0.01),
            Measured("mean of hours and sensors: off by, relative", off / mean, 4.0 * both / mean + 0.005),
            Measured("sums of six sensors: standardised differences, rms", float(np.sqrt(np.mean(z**2))), 2.0),
            Measured("hours", float(len(weather)), 60.0, is_floor=True),
        ],
        figure,
    )
