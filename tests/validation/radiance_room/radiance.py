"""The reference room as a Radiance scene, and its daylight coefficients by rfluxmtx."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from clerestory.room import Room, Sensors

Array = NDArray[np.float64]

TRANSMISSIVITY = 0.96003
"""Of Radiance's glass for a transmittance of 0.88: T = (1 − r)² t / (1 − r² t²), r = (0.52 / 2.52)²."""
SKY = """#@rfluxmtx h=u u=Y
void glow ground_glow 0 0 4 1 1 1 0
ground_glow source ground 0 0 4 0 0 -1 180
#@rfluxmtx h=r1 u=Y
void glow sky_glow 0 0 4 1 1 1 0
sky_glow source sky 0 0 4 0 0 1 180
"""


def scene_text(room: Room, windows: str | None = None) -> str:
    """Surfaces as plastic with seams for holes, windows as glass unless their text is given."""
    lines = [f"void glass pane 0 0 3 {TRANSMISSIVITY} {TRANSMISSIVITY} {TRANSMISSIVITY}"]
    for index, surface in enumerate(room.surfaces):
        level = surface.material.diffuse_reflectance
        lines.append(f"void plastic m{index} 0 0 5 {level} {level} {level} 0 0")
        corners = list(surface.outline_m)
        for hole in surface.holes_m:
            corners += [corners[0], *hole[::-1], hole[-1]]
        lines.append(_polygon(f"m{index}", f"s{index}", corners))
    if windows is None:
        lines += [_polygon("pane", f"w{index}", list(window.outline_m)) for index, window in enumerate(room.windows)]
    else:
        lines.append(windows)
    return "\n".join(lines) + "\n"


def radiance_coefficients(
    room: Room, sensors: Sensors, *, divisions: int, seed: int, windows: str | None = None
) -> Array:
    """Coefficients in Radiance's order, ground first, shape (sensors, 146)."""
    import pyradiance

    with tempfile.TemporaryDirectory() as folder:
        scene, sky, octree = (Path(folder) / name for name in ("room.rad", "sky.rad", "room.oct"))
        scene.write_text(scene_text(room, windows))
        sky.write_text(SKY)
        octree.write_bytes(pyradiance.oconv(str(scene)))
        rays = "".join(
            " ".join(f"{value:.9g}" for value in (*point, *normal)) + "\n"
            for point, normal in zip(sensors.points_m, sensors.normals, strict=True)
        )
        # with -u+ it draws by the clock, other numbers each second
        settings = f"-I+ -h- -faa -u- -ab 12 -ad {divisions} -lr -14 -lw {0.2 / divisions} -n 1".split()
        # other pixels of the same random sequence: the seed shifts where it begins
        padding = rays.splitlines(keepends=True)[0] * seed
        answer = pyradiance.rfluxmtx(str(sky), rays=(padding + rays).encode(), params=settings, octree=str(octree))
    rows = [row.split() for row in answer.decode().splitlines() if row.strip()]
    table = np.array(rows, dtype=np.float64)[seed:]
    return table.reshape(len(sensors), -1, 3)[:, :, 0]


def _polygon(modifier: str, name: str, corners: list[tuple[float, float, float]]) -> str:
    numbers = " ".join(f"{value:.12g}" for corner in corners for value in corner)
    return f"{modifier} polygon {name} 0 0 {3 * len(corners)} {numbers}"
