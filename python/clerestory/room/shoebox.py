"""A rectangular room with openings, thick walls and what stands before it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.room.material import Material, as_material
from clerestory.room.opening import Opening, rectangle
from clerestory.room.surface import Outline, Surface
from clerestory.room.window import Window
from clerestory.rules import Points, not_negative, number, positive

Vector = tuple[float, float, float]


@dataclass(frozen=True, kw_only=True)
class Shoebox:
    """A rectangular room, in its own axes: x along the facade, y from the facade inwards, z up, the origin at the left
    lower inner corner of the facade as seen from outside.

    Parameters
    ----------
    width_m, depth_m, height_m : float
        Inner sizes along the facade, away from it, and up.
    openings : sequence of Opening
    wall_thickness_m : float, default 0
        The windows stand in the outer face of the wall, in reveals of the wall's material.
    facade_azimuth_deg : float, default 180
        Where the facade looks, clockwise from north. At 180 the room's axes are the world's.
    floor, walls, ceiling : Material or diffuse reflectance, default 0.2, 0.5, 0.8
    """

    width_m: float
    depth_m: float
    height_m: float
    openings: tuple[Opening, ...] = ()
    wall_thickness_m: float = 0.0
    facade_azimuth_deg: float = 180.0
    floor: Material | float = 0.2
    walls: Material | float = 0.5
    ceiling: Material | float = 0.8

    def __post_init__(self) -> None:
        for name in ("width_m", "depth_m", "height_m"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        not_negative("wall_thickness_m", self.wall_thickness_m)
        number("facade_azimuth_deg", self.facade_azimuth_deg)
        for name in ("floor", "walls", "ceiling"):
            object.__setattr__(self, name, as_material(name, getattr(self, name)))
        object.__setattr__(self, "openings", tuple(self.openings))
        names = [opening.name for opening in self.openings]
        for name in names:
            if names.count(name) > 1:
                raise ClerestoryError(f"openings must have names of their own, got {name!r} {names.count(name)} times")

    def build(self) -> tuple[list[Surface], list[Window]]:
        """Surfaces and windows in the world's axes."""
        surfaces: list[Surface] = []
        windows: list[Window] = []
        for side, origin, along, upward, inwards, material in self._sides():
            length, height = float(np.linalg.norm(along)), float(np.linalg.norm(upward))
            right, up = np.array(along) / length, np.array(upward) / height
            back = -self.wall_thickness_m * np.array(inwards)
            holes: list[Outline] = []
            for opening in self.openings:
                if opening.wall != side:
                    continue
                parts = opening.rectangles(length, height)
                left, top = parts[0][0], parts[0][3]
                bottom, far = parts[-1][1], parts[-1][2]
                hole = _rectangle(origin, right, up, left, bottom, far, top)
                holes.append(hole)
                if self.wall_thickness_m > 0.0:
                    surfaces += _reveals(opening.name, hole, back, material, self.to_world)
                windows += self._glazed(opening, parts, np.array(origin) + back, right, up)
            outline = rectangle(origin, along, upward)
            surfaces.append(
                Surface(
                    name=side,
                    outline_m=self.to_world(outline),
                    material=material,
                    holes_m=tuple(self.to_world(hole) for hole in holes),
                )
            )
        return surfaces, windows

    def _sides(self) -> list[tuple[str, Vector, Vector, Vector, Vector, Material]]:
        """Name, corner, edge to the right, edge up, inward normal and material, all as seen from the room."""
        w, d, h = self.width_m, self.depth_m, self.height_m
        floor, walls, ceiling = (as_material(name, getattr(self, name)) for name in ("floor", "walls", "ceiling"))
        return [
            ("floor", (0, 0, 0), (w, 0, 0), (0, d, 0), (0, 0, 1), floor),
            ("ceiling", (0, 0, h), (w, 0, 0), (0, d, 0), (0, 0, -1), ceiling),
            ("facade", (w, 0, 0), (-w, 0, 0), (0, 0, h), (0, 1, 0), walls),
            ("back", (0, d, 0), (w, 0, 0), (0, 0, h), (0, -1, 0), walls),
            ("left", (0, 0, 0), (0, d, 0), (0, 0, h), (1, 0, 0), walls),
            ("right", (w, d, 0), (0, -d, 0), (0, 0, h), (-1, 0, 0), walls),
        ]

    def _glazed(
        self,
        opening: Opening,
        parts: tuple[tuple[float, float, float, float], ...],
        corner: Points,
        right: Points,
        up: Points,
    ) -> list[Window]:
        made = []
        for index, (part, (left, bottom, far, top)) in enumerate(zip(opening.parts, parts, strict=True), 1):
            name = opening.name if len(parts) == 1 else f"{opening.name} {index}"
            outline = _rectangle(corner, right, up, left, bottom, far, top)
            # right and up is anticlockwise seen from the room; but the ceiling's edges are those of a plan from above
            outline = outline[::-1] if opening.wall == "ceiling" else outline
            world = self.to_world(outline)
            if part.tilt_deg == 0.0:
                made.append(Window(name=name, outline_m=world, glazing=part.glazing))
                continue
            if opening.wall == "ceiling":
                raise ClerestoryError(f"tilt_deg of {name!r} must be 0 in the ceiling, got {part.tilt_deg:g}")
            hanging = Window(name=name, outline_m=world, glazing=part.glazing).tilted(part.tilt_deg)
            made += [hanging, Window(name=f"{name} behind", outline_m=world, glazing=part.behind)]
        return made

    def to_world(self, outline: Outline) -> Outline:
        """An outline in the room's axes, in those of the world."""
        # the facade looks along −y in the room's axes; turn clockwise from south
        turn = np.radians(self.facade_azimuth_deg - 180.0)
        cos, sin = (round(float(f(turn)), 15) for f in (np.cos, np.sin))
        return tuple((_clean(x * cos + y * sin), _clean(y * cos - x * sin), _clean(z)) for x, y, z in outline)


def _clean(value: float) -> float:
    """A length without the dust of rounding: to a picometre, and no minus zero."""
    return round(value, 12) + 0.0


def _rectangle(
    origin: Sequence[float] | Points,
    right: Points,
    up: Points,
    left: float,
    bottom: float,
    far: float,
    top: float,
) -> Outline:
    corners = [
        np.asarray(origin) + x * right + y * up for x, y in ((left, bottom), (far, bottom), (far, top), (left, top))
    ]
    return tuple((float(x), float(y), float(z)) for x, y, z in corners)


def _reveals(
    name: str,
    hole: Outline,
    back: Points,
    material: Material,
    to_world: Callable[[Outline], Outline],
) -> list[Surface]:
    """The four inner faces of an opening in a thick wall."""
    made = []
    for edge, first, second in zip(("sill", "right", "head", "left"), hole, (*hole[1:], hole[0]), strict=True):
        a, b = np.array(first), np.array(second)
        outline = tuple((float(x), float(y), float(z)) for x, y, z in (a, b, b + back, a + back))
        made.append(Surface(name=f"{name} {edge} reveal", outline_m=to_world(outline), material=material))
    return made
