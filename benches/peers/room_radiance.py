"""Radiance's `rfluxmtx` in the reference room, as pyradiance ships it."""

from __future__ import annotations

import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import pyradiance
from room_reference import TRANSMITTANCE, Floats, cpu_seconds, rectangles_m, sensor_points_m, window_corners_m

from clerestory import sky_basis

_HOME = Path(pyradiance.__file__).parent
#: Diffuse bounces; five lose 4 % of the light of this room.
_BOUNCES = 12


def _scene() -> str:
    """Walls and glass; the transmissivity of `glass` follows from the transmittance (Radiance's reference manual)."""
    t = TRANSMITTANCE
    inner = (np.sqrt(0.8402528435 + 0.0072522239 * t * t) - 0.9166530661) / 0.0036261119 / t
    lines = [f"void glass pane 0 0 3 {inner:.9g} {inner:.9g} {inner:.9g}"]
    for name, reflectance, _ in rectangles_m():
        lines.append(f"void plastic m_{name} 0 0 5 {reflectance} {reflectance} {reflectance} 0 0")
    faces = [(f"m_{name}", name, corners) for name, _, corners in rectangles_m()]
    for material, name, corners in [*faces, ("pane", "window", window_corners_m())]:
        numbers = " ".join(f"{x:.9g}" for corner in corners for x in corner)
        lines.append(f"{material} polygon {name} 0 0 12 {numbers}")
    return "\n".join(lines) + "\n"


def _receivers(factor: int) -> str:
    return (
        "#@rfluxmtx h=u u=+Y\nvoid glow below 0 0 4 1 1 1 0\nbelow source ground 0 0 4 0 0 -1 180\n"
        f"#@rfluxmtx h=r{factor} u=+Y\nvoid glow over 0 0 4 1 1 1 0\nover source sky 0 0 4 0 0 1 180\n"
    )


def coefficients(divisions: int, *, basis: str = "tregenza145", repeats: int = 1) -> tuple[float, Floats]:
    """CPU seconds of one sensor grid and the coefficients, (repeats, sensors, patches)."""
    factor = {"tregenza145": 1, "reinhart577": 2, "reinhart2305": 4}[basis]
    points = np.tile(sensor_points_m(), (repeats, 1))
    rays = "\n".join(f"{x:.9g} {y:.9g} {z:.9g} 0 0 1" for x, y, z in points) + "\n"
    environment = os.environ | {
        "RAYPATH": str(_HOME / "lib"),
        "PATH": f"{_HOME / 'bin'}{os.pathsep}{os.environ['PATH']}",
    }
    with tempfile.TemporaryDirectory() as folder:
        scene, sky = Path(folder) / "room.rad", Path(folder) / "sky.rad"
        scene.write_text(_scene())
        sky.write_text(_receivers(factor))
        options = [
            "-h",
            "-I+",
            "-n",
            "1",
            "-u+",
            "-lr",
            "-14",
            "-ab",
            _BOUNCES,
            "-ad",
            divisions,
            "-lw",
            0.1 / divisions,
            "-faf",
        ]
        command = [str(part) for part in [_HOME / "bin" / "rfluxmtx", *options, "-", sky, scene]]

        def run() -> bytes:
            return subprocess.run(command, input=rays.encode(), capture_output=True, check=True, env=environment).stdout

        seconds, out = cpu_seconds(run, children=True)
    patches = sky_basis(basis)
    raw = np.frombuffer(out, dtype=np.float32).reshape(repeats, len(sensor_points_m()), len(patches.centres), 3)
    ordered = np.empty(raw.shape[:3])
    ordered[:, :, patches.order("radiance")] = raw[..., 0]
    return seconds / repeats, ordered
