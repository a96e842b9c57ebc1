"""Daylight factor of the reference room with a laser-cut panel as Klems matrices, by both programs."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from tests.validation.claim import Claim, Measured
from tests.validation.radiance_room.radiance import radiance_coefficients

from clerestory.bsdf.radiance_scene import radiance_snippet
from clerestory.coefficients import daylight_coefficients
from clerestory.illuminance import daylight_factor
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.room import Opening, Part, Room, SensorGrid
from clerestory.sky import CieSky, sky_basis

RUNS = 6
PANEL = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, cut_width_mm=0.0, medium=Medium(n=1.49))


def claim(thorough: bool) -> Claim:
    """Means over the room and over its back, and the scatter of sensors."""
    bsdf = PANEL.bsdf("klems_full").blurred()
    opening = Opening(width_m=3.6, height_m=1.8, parts=[Part(glazing=bsdf)])
    room = Room.shoebox(width_m=4.0, depth_m=8.0, height_m=3.0, openings=[opening], sensors=[SensorGrid(spacing_m=0.5)])
    (sensors,) = room.sensor_points()
    luminance = CieSky(sky_type=16, diffuse_horizontal_illuminance_lx=100.0).matrix("tregenza145").values
    ordered = luminance[np.asarray(sky_basis("tregenza145").order("radiance"))]
    divisions = 4096 if thorough else 256
    with tempfile.TemporaryDirectory() as folder:
        xml = bsdf.to_xml(Path(folder) / "panel.xml")
        windows = "\n".join(
            radiance_snippet(bsdf, xml, window.outline_m, name=f"window{number}", peak_extraction=False)
            for number, window in enumerate(room.windows)
        )
        runs = [
            radiance_coefficients(room, sensors, divisions=divisions, seed=seed, windows=windows) @ ordered
            for seed in range(1, RUNS + 1)
        ]
    theirs = np.mean(runs, axis=0)
    coefficients = daylight_coefficients(room, basis="tregenza145", rounds=1024 if thorough else 96, seed=14)
    factor = daylight_factor(coefficients)
    ours = factor.total.values
    their_error = np.std(runs, axis=0, ddof=1) / np.sqrt(RUNS)
    z = (ours - theirs) / np.hypot(factor.total_standard_error.values, their_error)
    means = np.array(runs).mean(axis=1)
    mean_error = float(np.hypot(means.std(ddof=1) / np.sqrt(RUNS), factor.total_standard_error.values.mean()))
    rows = factor.row.values
    distance = np.array([float(factor.y_m.values[rows == row].mean()) for row in np.unique(rows)])
    by_row = [np.array([values[rows == row].mean() for row in np.unique(rows)]) for values in (ours, theirs)]
    back = np.abs(factor.y_m.values - factor.y_m.values[np.argmax(ours)]) > 4.0
    with styled():
        figure = blank(6.4, 4.0)
        axes = figure.add_subplot()
        for label, values, colour in zip(("Clerestory", "Radiance"), by_row, COLOURS, strict=False):
            axes.plot(distance, values, "o-", color=colour, label=label)
        axes.set_yscale("log")
        axes.set(
            xlabel="Distance from the window [m]",
            ylabel="Daylight factor [%]",
            title="Reference room behind Klems matrices, mean of each row",
        )
        axes.legend()
    off = abs(ours.mean() - theirs.mean())
    beyond = max(0.0, off - 0.005 * theirs.mean()) / mean_error
    return Claim(
        [
            Measured("mean over the room: standard error, relative", mean_error / theirs.mean(), 0.015),
            Measured("mean over the room: off by, beyond 0.5 %, in standard errors", beyond, 4.0),
            Measured("standardised differences at 128 sensors, rms", float(np.sqrt(np.mean(z**2))), 1.7),
            Measured("back half: off by, relative", abs(float(ours[back].mean() / theirs[back].mean()) - 1.0), 0.04),
        ],
        figure,
    )
