"""A window in nothing but air, in Radiance and by plain sums: what sunlight through it does to sensors in the room.

The wall is y = 0 and the room lies behind it (y > 0); the element's axes are x = -x, y = z and z = y of the world.
"""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from tests.bsdf.panels_as_matrices import BASIS

from clerestory import Bsdf
from clerestory.bsdf import Band

Floats = NDArray[np.float64]

WORLD = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
"""Rows: the element's axes in the world's."""
HALF_M, CENTRE_M = 0.5, np.array([0.0, 0.0, 1.5])
SUN_PATCH = int(BASIS.find(0.32, -0.557))
"""The sun stands 34° high and to the left, in the middle of a patch, so that light travels to the right and down."""
ALTITUDES_DEG = (-60.0, -40.0, -20.0, 0.0, 20.0, 40.0, 60.0)
SIDEWAYS = float(BASIS.centre[SUN_PATCH][0])
"""Of the way from the window to the first sensors, along the element's x; the last ones lie on the other side."""
REACH_M = 2.5


def _ways() -> Floats:
    ways = [
        (
            side * SIDEWAYS,
            np.sin(np.radians(h)) * np.sqrt(1.0 - SIDEWAYS**2),
            np.cos(np.radians(h)) * np.sqrt(1.0 - SIDEWAYS**2),
        )
        for side in (1.0, -1.0)
        for h in ALTITUDES_DEG
    ]
    return np.array(ways)


POINTS_M = CENTRE_M + REACH_M * _ways() @ WORLD
NORMALS = -_ways() @ WORLD
"""Sensors about the window that face it, from low to high: where light keeps its x, then the mirror image."""
SUN_DEG = 0.533
SAME = "-u-"
"""Radiance draws by the clock, other numbers each second, unless it is told not to."""


def sun() -> Floats:
    """Way of the sunlight, in the element's axes."""
    x, y = BASIS.centre[SUN_PATCH]
    return np.array([x, y, np.sqrt(1.0 - x * x - y * y)])


@cache
def window_solid_angles(divisions: int = 240) -> Floats:
    """Integral of both cosines over the window that each sensor sees, by patch of travel, shape (sensor, patch)."""
    step = (np.arange(divisions) + 0.5) / divisions * 2.0 * HALF_M - HALF_M
    x, z = np.meshgrid(step, step)
    places = CENTRE_M + np.stack([x.ravel(), np.zeros(x.size), z.ravel()], axis=1)
    view = np.zeros((len(POINTS_M), len(BASIS)))
    for row, (point, normal) in enumerate(zip(POINTS_M, NORMALS, strict=True)):
        way = point - places
        distance = np.linalg.norm(way, axis=1)
        way /= distance[:, None]
        local = way @ WORLD.T
        weight = np.maximum(-way @ normal, 0.0) * local[:, 2] / distance**2 * (2.0 * HALF_M / divisions) ** 2
        view[row] = np.bincount(BASIS.find(local[:, 0], local[:, 1]), weights=weight, minlength=len(BASIS))
    return view


def by_sums(band: Band, travel: Floats) -> Floats:
    """Irradiance at the sensors under a sun of normal irradiance 1 that travels along ``travel`` (element's axes)."""
    incident = int(BASIS.find(travel[0], travel[1]))
    return np.asarray(window_solid_angles() @ band.transmission_front.values[:, incident] * travel[2])


def by_rtrace(bsdf: Bsdf, travel: Floats, *, is_upside_down: bool, is_inside_out: bool) -> Floats:
    """The same by rtrace, which turns the element by its up vector and by the way its polygon faces."""
    import pyradiance

    toward = -(travel @ WORLD)
    power = 1.0 / (2.0 * np.pi * (1.0 - np.cos(np.radians(SUN_DEG / 2.0))))
    corners = CENTRE_M + HALF_M * np.array([[1, 0, -1], [-1, 0, -1], [-1, 0, 1], [1, 0, 1]])
    # seen from the room its corners go anticlockwise: Radiance's front is the room side
    order = corners[::-1] if is_inside_out else corners
    around = np.array([[30, 0, -30], [-30, 0, -30], [-30, 0, 30], [30, 0, 30]])
    # a wall with a hole: a seam leads to the window's corners, which go round the other way
    wall = np.vstack([around, around[:1], corners[:1], corners[:0:-1], corners[:1]])
    with tempfile.TemporaryDirectory() as folder:
        xml, scene, octree = (Path(folder) / name for name in ("panel.xml", "scene.rad", "scene.oct"))
        bsdf.to_xml(xml)
        scene.write_text(
            f"void BSDF panel 6 0 {xml} 0 0 {-1 if is_upside_down else 1} . 0 0\n"
            f"panel polygon window 0 0 12 {' '.join(f'{v:g}' for v in order.ravel())}\n"
            "void plastic black 0 0 5 0 0 0 0 0\n"
            f"black polygon wall 0 0 30 {' '.join(f'{v:g}' for v in wall.ravel())}\n"
            f"void light sunlight 0 0 3 {power} {power} {power}\n"
            f"sunlight source sun 0 0 4 {' '.join(f'{v:.9g}' for v in toward)} {SUN_DEG}\n"
        )
        octree.write_bytes(pyradiance.oconv(str(scene)))
        rays = "".join(
            " ".join(f"{v:.9g}" for v in (*point, *normal)) + "\n"
            for point, normal in zip(POINTS_M, NORMALS, strict=True)
        )
        settings = f"-ab 1 -ad 32768 -as 0 -aa 0 -lw 1e-7 -dj 0 {SAME}".split()
        answer = pyradiance.rtrace(rays.encode(), octree, header=False, irradiance=True, params=settings)
    return np.array(answer.split(), dtype=float).reshape(-1, 3)[:, 0]


def view_by_rfluxmtx(samples: int = 200_000) -> Floats:
    """What Radiance's own view matrix makes of the window, shape (sensor, patch)."""
    import pyradiance

    with tempfile.TemporaryDirectory() as folder:
        window, octree = Path(folder) / "window.rad", Path(folder) / "scene.oct"
        window.write_text("#@rfluxmtx h=kf u=Z\nvoid glow panel 0 0 4 1 1 1 0\n" + _window_polygon())
        octree.write_bytes(_nothing(Path(folder)))
        rays = "".join(
            " ".join(f"{v:.9g}" for v in (*point, *normal)) + "\n"
            for point, normal in zip(POINTS_M, NORMALS, strict=True)
        )
        settings = f"-I+ -h- -faa -ab 1 -ad {samples} -lw 1e-7 -n 1 {SAME}".split()
        answer = pyradiance.rfluxmtx(str(window), rays=rays.encode(), params=settings, octree=str(octree))
    return _matrix(answer, len(POINTS_M))


def daylight_by_rfluxmtx(samples: int = 2_000) -> Floats:
    """Radiance's own daylight matrix of the window, shape (incident patch, ground and 145 patches of the sky)."""
    import pyradiance

    with tempfile.TemporaryDirectory() as folder:
        window, sky, octree = (Path(folder) / name for name in ("window.rad", "sky.rad", "scene.oct"))
        window.write_text("#@rfluxmtx h=kf u=Z\nvoid glow panel 0 0 4 1 1 1 0\n" + _window_polygon())
        sky.write_text(
            "#@rfluxmtx h=u u=Y\nvoid glow ground_glow 0 0 4 1 1 1 0\nground_glow source ground 0 0 4 0 0 -1 180\n"
            "#@rfluxmtx h=r1 u=Y\nvoid glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 0 1 180\n"
        )
        octree.write_bytes(_nothing(Path(folder)))
        settings = f"-h- -faa -c {samples} -ab 1 -lw 1e-7 -n 1 {SAME}".split()
        answer = pyradiance.rfluxmtx(str(sky), surface=str(window), params=settings, octree=str(octree))
    return _matrix(answer, len(BASIS))


def _window_polygon() -> str:
    corners = CENTRE_M + HALF_M * np.array([[1, 0, -1], [-1, 0, -1], [-1, 0, 1], [1, 0, 1]])
    return f"panel polygon window 0 0 12 {' '.join(f'{v:g}' for v in corners.ravel())}\n"


def _nothing(folder: Path) -> bytes:
    """An octree with specks about the scene, since Radiance wants one that encloses it."""
    import pyradiance

    scene = folder / "far.rad"
    scene.write_text(
        "void plastic black 0 0 5 0 0 0 0 0\n"
        "black sphere low 0 0 4 -9 -9 -9 0.001\nblack sphere high 0 0 4 9 9 9 0.001\n"
    )
    return bytes(pyradiance.oconv(str(scene)))


def _matrix(answer: bytes, rows: int) -> Floats:
    table = np.array(answer.split(), dtype=np.float64)
    return np.asarray(table.reshape(rows, -1, 3)[:, :, 0])
