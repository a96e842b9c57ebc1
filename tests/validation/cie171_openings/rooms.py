"""The rooms of CIE 171:2006 test cases 5.9 to 5.12."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from clerestory.glazing import Glazing
from clerestory.room import Material, Room, Sensors, Surface, Window
from clerestory.sky import CieSky

Array = NDArray[np.float64]

SIZE_M = 4.0
HEIGHT_M = 3.0
GROUND_REFLECTANCE = 0.30
SUN_ALTITUDE_DEG = 60.0
STEPS_M = 0.25 + 0.5 * np.arange(8)
BLACK = Material(diffuse_reflectance=0.0)


@dataclass(frozen=True)
class Case:
    """One opening of one test case: its rectangle, its room, and the published points by letter."""

    name: str
    rectangle: tuple[Array, Array, Array]
    sun_azimuth_deg: float
    points: dict[str, tuple[Array, Array]]

    def room(self, glazing: Glazing) -> Room:
        """The black room with the opening glazed; walls that the opening takes up whole are left out."""
        corner, first, second = self.rectangle
        outline = [corner, corner + first, corner + first + second, corner + second]
        surfaces = []
        for name, wall in _walls().items():
            holds = all(_on(wall, spot) for spot in outline)
            whole = holds and np.isclose(np.linalg.norm(np.cross(first, second)), _area(wall))
            if not whole:
                holes = [outline] if holds else []
                surfaces.append(Surface(name=name, outline_m=wall, material=BLACK, holes_m=holes))
        window = Window(name="opening", outline_m=outline, glazing=glazing)
        return Room(
            surfaces=tuple(surfaces),
            windows=(window,),
            sensors=(self.sensors(),),
            ground_reflectance=GROUND_REFLECTANCE,
            name=self.name,
        )

    def sensors(self) -> Sensors:
        """All points, a hair off their surface."""
        places = np.array([place + 1e-6 * normal for place, normal in self.points.values()])
        return Sensors(points_m=places, normals=np.array([normal for _, normal in self.points.values()]))

    def sky(self, sky_type: int) -> CieSky:
        """The sky of the case: 100 lx on the open ground, so that illuminances are percentages."""
        return CieSky(
            sky_type=sky_type,
            sun_altitude_deg=SUN_ALTITUDE_DEG,
            sun_azimuth_deg=self.sun_azimuth_deg,
            diffuse_horizontal_illuminance_lx=100.0,
        )

    def away_from_edges(self, least_m: float = 0.5) -> Array:
        """Whether each point is at least so far from the opening's rectangle."""
        corner, first, second = self.rectangle
        nearest = []
        for place, _ in self.points.values():
            along = [np.clip((place - corner) @ edge / (edge @ edge), 0.0, 1.0) for edge in (first, second)]
            nearest.append(np.linalg.norm(place - corner - along[0] * first - along[1] * second))
        return np.array(nearest) >= least_m


def roof(width_m: float) -> Case:
    """Case 5.9 and 5.10: a square opening in the middle of the roof; the sun opposite the wall y = 0."""
    low = (SIZE_M - width_m) / 2.0
    # corners anticlockwise as seen from below
    rectangle = (np.array([low, low, HEIGHT_M]), np.array([0.0, width_m, 0.0]), np.array([width_m, 0.0, 0.0]))
    wall = {letter: _at(2.0, 0.0, 2.75 - 0.5 * k, normal=(0, 1, 0)) for k, letter in enumerate("ABCDEF")}
    floor = {letter: _at(2.0, y, 0.0, normal=(0, 0, 1)) for y, letter in zip(STEPS_M, "GHIJKLMN", strict=True)}
    return Case(f"roof {width_m:g} m", rectangle, 0.0, wall | floor)


def facade(width_m: float, height_m: float, sill_m: float) -> Case:
    """Case 5.11 and 5.12: an opening in the south wall, points on the north wall, the floor and the ceiling."""
    low = (SIZE_M - width_m) / 2.0
    # corners anticlockwise as seen from the room
    rectangle = (np.array([low + width_m, 0.0, sill_m]), np.array([-width_m, 0, 0]), np.array([0, 0, height_m]))
    wall = {letter: _at(2.0, SIZE_M, 2.75 - 0.5 * k, normal=(0, -1, 0)) for k, letter in enumerate("ABCDEF")}
    across = list(zip(SIZE_M - STEPS_M, "GHIJKLMN", strict=True))
    floor = {letter: _at(2.0, y, 0.0, normal=(0, 0, 1)) for y, letter in across}
    ceiling = {f"{letter}'": _at(2.0, y, HEIGHT_M, normal=(0, 0, -1)) for y, letter in across}
    return Case(f"facade {width_m:g} x {height_m:g} m", rectangle, 180.0, wall | floor | ceiling)


def _walls() -> dict[str, Array]:
    w, h = SIZE_M, HEIGHT_M
    corners = {
        "floor": [(0, 0, 0), (w, 0, 0), (w, w, 0), (0, w, 0)],
        "ceiling": [(0, 0, h), (w, 0, h), (w, w, h), (0, w, h)],
        "south": [(0, 0, 0), (w, 0, 0), (w, 0, h), (0, 0, h)],
        "north": [(0, w, 0), (w, w, 0), (w, w, h), (0, w, h)],
        "west": [(0, 0, 0), (0, w, 0), (0, w, h), (0, 0, h)],
        "east": [(w, 0, 0), (w, w, 0), (w, w, h), (w, 0, h)],
    }
    return {name: np.array(outline, dtype=np.float64) for name, outline in corners.items()}


def _on(wall: Array, spot: Array) -> bool:
    normal = np.cross(wall[1] - wall[0], wall[3] - wall[0])
    return bool(abs((spot - wall[0]) @ normal) < 1e-9)


def _area(wall: Array) -> float:
    return float(np.linalg.norm(np.cross(wall[1] - wall[0], wall[3] - wall[0])))


def _at(x: float, y: float, z: float, *, normal: tuple[int, int, int]) -> tuple[Array, Array]:
    return np.array([x, y, z], dtype=np.float64), np.array(normal, dtype=np.float64)
