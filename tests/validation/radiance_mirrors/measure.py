"""Sun by way of mirrors, at sensors on ceiling, floor and back wall, by both programs."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from tests.validation.claim import Claim, Measured

from clerestory.glazing import Open
from clerestory.plots.style import COLOURS, blank, styled
from clerestory.room import LightShelf, Material, Opening, Part, Room, SensorGrid
from clerestory.sun import SUN_DIAMETER_DEG, direction_of
from clerestory.sun_coefficients import sun_coefficients

Array = NDArray[np.float64]
SHELF = Material(diffuse_reflectance=0.0, specular_reflectance=0.85)
WALL = Material(diffuse_reflectance=0.0, specular_reflectance=0.7)
SUNS = ((35.0, 150.0), (50.0, 165.0), (25.0, 140.0), (60.0, 130.0), (15.0, 150.0), (40.0, 200.0))


def black_room(*, mirrors: bool, spacing_m: float) -> Room:
    """The room, with its mirrors or with all of it black."""
    black = Material(diffuse_reflectance=0.0)
    room = Room.shoebox(
        width_m=4.0,
        depth_m=6.0,
        height_m=3.0,
        floor=0.0,
        walls=0.0,
        ceiling=0.0,
        openings=[Opening(width_m=3.2, height_m=2.0, sill_m=0.8, parts=(Part(glazing=Open()),))],
        obstructions=[LightShelf(height_m=1.6, outside_m=0.8, inside_m=0.5, material=SHELF if mirrors else black)],
        sensors=[
            SensorGrid(spacing_m=spacing_m, height_m=0.001, surface=surface, flip=surface == "ceiling")
            for surface in ("floor", "ceiling", "back")
        ],
    )
    walls = [replace(one, material=WALL) if mirrors and one.name == "left" else one for one in room.surfaces]
    return replace(room, surfaces=tuple(walls))


def radiance_sun(room: Room, points: Array, normals: Array, towards: Array) -> Array:
    """Illuminance over the sun's normal illuminance, shape (sensors,)."""
    import pyradiance

    # a source of radiance 1 / Ω lights a plane facing it by 1
    radiance = 1.0 / (2.0 * np.pi * (1.0 - np.cos(np.radians(SUN_DIAMETER_DEG) / 2.0)))
    x, y, z = towards
    lines = [f"void light sun 0 0 3 {radiance} {radiance} {radiance}"]
    lines.append(f"sun source disc 0 0 4 {x} {y} {z} {SUN_DIAMETER_DEG}")
    lines.append("void plastic black 0 0 5 0 0 0 0 0")
    for index, surface in enumerate(room.surfaces):
        share = surface.material.specular_reflectance
        material = f"m{index}" if share > 0.0 else "black"
        if share > 0.0:
            lines.append(f"void mirror {material} 0 0 3 {share} {share} {share}")
        corners = list(surface.outline_m)
        for hole in surface.holes_m:
            corners += [corners[0], *hole[::-1], hole[-1]]
        numbers = " ".join(f"{value:.12g}" for corner in corners for value in corner)
        lines.append(f"{material} polygon s{index} 0 0 {3 * len(corners)} {numbers}")
    rays = "".join(
        " ".join(f"{value:.9g}" for value in (*point, *normal)) + "\n"
        for point, normal in zip(points, normals, strict=True)
    )
    with tempfile.TemporaryDirectory() as folder:
        scene, octree = Path(folder) / "room.rad", Path(folder) / "room.oct"
        scene.write_text("\n".join(lines) + "\n")
        octree.write_bytes(pyradiance.oconv(str(scene)))
        settings = ["-ab", "0", "-dj", "0", "-ds", "0", "-dt", "0", "-dc", "1", "-dr", "6", "-lr", "12", "-lw", "1e-6"]
        answer = pyradiance.rtrace(rays.encode(), octree, header=False, irradiance=True, params=settings)
    return np.array([row.split()[0] for row in answer.decode().splitlines() if row.strip()], dtype=np.float64)


def claim(thorough: bool) -> Claim:
    """Every sensor outside penumbras, for suns that the mirrors throw about in different ways."""
    spacing = 0.1 if thorough else 0.25
    room, dark = (black_room(mirrors=mirrors, spacing_m=spacing) for mirrors in (True, False))
    placed = room.sensor_points()
    points, normals = (np.concatenate([getattr(one, what) for one in placed]) for what in ("points_m", "normals"))
    suns = SUNS if thorough else SUNS[:3]
    altitude, azimuth = np.array(suns).T
    found, straight = (
        sun_coefficients(one, altitude_deg=altitude, azimuth_deg=azimuth, rounds=32, seed=3) for one in (room, dark)
    )
    ours = found.direct.values
    # all rounds alike but for the cosine of the disc's points
    sharp = found.direct_standard_error.values < 1e-3
    sharp &= (ours > 0.0) == (ours > 0.02)
    theirs = np.stack([radiance_sun(room, points, normals, one) for one in direction_of(altitude, azimuth)], axis=1)
    off = np.abs(ours - theirs)
    lit = sharp & (ours > 0.0)
    by_mirror = lit & (ours > straight.direct.values + 0.02)
    with styled():
        figure = blank(6.4, 4.0)
        axes = figure.add_subplot()
        for index, (high, around) in enumerate(suns[:3]):
            ceiling = normals[:, 2] < -0.5
            rows = np.unique(points[ceiling, 1])
            means = [
                [values[ceiling, index][points[ceiling, 1] == row].mean() for row in rows] for values in (ours, theirs)
            ]
            colour = COLOURS[index]
            axes.plot(rows, means[0], color=colour, label=f"sun at {high:g}°, azimuth {around:g}°")
            axes.plot(rows, means[1], "o", color=colour, markersize=4)
        axes.set(xlabel="Distance from the window [m]", ylabel="E / E$_n$, mean of each row")
        axes.set_title("Ceiling by way of mirrors: lines Clerestory, dots Radiance")
        axes.legend()
    return Claim(
        [
            Measured("largest difference outside penumbras", float(off[sharp].max()), 2e-3),
            Measured("sensors in penumbras, share", float((~sharp).mean()), 0.05),
            Measured(
                "of the lit sensors, lit by way of mirrors, share", float(by_mirror.sum() / lit.sum()), 0.25, True
            ),
        ],
        figure,
    )
