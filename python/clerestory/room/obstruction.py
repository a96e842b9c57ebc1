"""What stands before a facade: buildings, overhangs, light shelves, louvres.

All are given in the axes of a shoebox room: x along the facade, y from the facade inwards (outside is y < 0), z up.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from clerestory.room.material import Material, as_material
from clerestory.room.opening import rectangle
from clerestory.room.shoebox import Shoebox
from clerestory.room.surface import Outline, Surface, check_name
from clerestory.rules import not_negative, number, positive, within


@dataclass(frozen=True, kw_only=True)
class FacingBuilding:
    """A wall parallel to the facade: the other side of a street, an urban canyon; a mirror if its material is.

    Parameters
    ----------
    distance_m : float
        From the facade's outer face.
    height_m : float
        Its upper edge above the room's floor.
    base_m : float, default 0
        Its lower edge above the room's floor, below 0 for a room upstairs.
    width_m : float, default 100
        Centred on the room.
    material : Material or diffuse reflectance, default 0.3
    name : str, default "building"
    """

    distance_m: float
    height_m: float
    base_m: float = 0.0
    width_m: float = 100.0
    material: Material | float = 0.3
    name: str = "building"

    def __post_init__(self) -> None:
        check_name(self.name)
        positive(f"distance_m of {self.name!r}", self.distance_m)
        for name in ("base_m", "height_m"):
            number(f"{name} of {self.name!r}", getattr(self, name))
        positive(f"height_m - base_m of {self.name!r}", self.height_m - self.base_m)
        positive(f"width_m of {self.name!r}", self.width_m)

    def outlines(self, room: Shoebox) -> list[Outline]:
        """Its polygons in the room's axes."""
        left = (room.width_m - self.width_m) / 2.0
        y = -room.wall_thickness_m - self.distance_m
        return [rectangle((left, y, self.base_m), (self.width_m, 0.0, 0.0), (0.0, 0.0, self.height_m - self.base_m))]


@dataclass(frozen=True, kw_only=True)
class Overhang:
    """A level slab that leaves the facade.

    Parameters
    ----------
    depth_m : float
        How far it reaches out.
    height_m : float
        Above the room's floor.
    width_m : float, optional
        Centred on the room; default the room's width.
    material : Material or diffuse reflectance, default 0.5
    name : str, default "overhang"
    """

    depth_m: float
    height_m: float
    width_m: float | None = None
    material: Material | float = 0.5
    name: str = "overhang"

    def __post_init__(self) -> None:
        check_name(self.name)
        positive(f"depth_m of {self.name!r}", self.depth_m)
        number(f"height_m of {self.name!r}", self.height_m)
        if self.width_m is not None:
            positive(f"width_m of {self.name!r}", self.width_m)

    def outlines(self, room: Shoebox) -> list[Outline]:
        """Its polygons in the room's axes."""
        width = room.width_m if self.width_m is None else self.width_m
        left = (room.width_m - width) / 2.0
        face = -room.wall_thickness_m
        return [rectangle((left, face - self.depth_m, self.height_m), (width, 0.0, 0.0), (0.0, self.depth_m, 0.0))]


@dataclass(frozen=True, kw_only=True)
class LightShelf:
    """A level shelf at the facade, outside, inside or both; a mirror if its material is.

    Parameters
    ----------
    height_m : float
        Above the room's floor.
    outside_m, inside_m : float, default 0
        How far it reaches from the outer and from the inner face of the wall.
    width_m : float, optional
        Centred on the room; default the room's width.
    material : Material or diffuse reflectance, default 0.8
    name : str, default "light shelf"
    """

    height_m: float
    outside_m: float = 0.0
    inside_m: float = 0.0
    width_m: float | None = None
    material: Material | float = 0.8
    name: str = "light shelf"

    def __post_init__(self) -> None:
        check_name(self.name)
        positive(f"height_m of {self.name!r}", self.height_m)
        not_negative(f"outside_m of {self.name!r}", self.outside_m)
        not_negative(f"inside_m of {self.name!r}", self.inside_m)
        positive(f"outside_m + inside_m of {self.name!r}", self.outside_m + self.inside_m)
        if self.width_m is not None:
            positive(f"width_m of {self.name!r}", self.width_m)

    def outlines(self, room: Shoebox) -> list[Outline]:
        """Its polygons in the room's axes."""
        width = room.width_m if self.width_m is None else self.width_m
        left = (room.width_m - width) / 2.0
        face = -room.wall_thickness_m
        made = []
        if self.outside_m > 0.0:
            made.append(
                rectangle((left, face - self.outside_m, self.height_m), (width, 0.0, 0.0), (0.0, self.outside_m, 0.0))
            )
        if self.inside_m > 0.0:
            made.append(rectangle((left, 0.0, self.height_m), (width, 0.0, 0.0), (0.0, self.inside_m, 0.0)))
        return made


@dataclass(frozen=True, kw_only=True)
class Louvres:
    """Equal slats along the facade, outside; mirrors on both sides if their material is.

    Parameters
    ----------
    bottom_m, top_m : float
        Heights of the lowest and the highest slat's axis above the room's floor.
    count : int, at least 2
    depth_m : float
        Width of a slat.
    tilt_deg : float, -90..90, default 0
        Positive lowers the outer edge.
    distance_m : float, default 0.1
        From the facade's outer face to the slats' axes; at least half a slat.
    width_m : float, optional
        Centred on the room; default the room's width.
    material : Material or diffuse reflectance, default 0.5
    name : str, default "louvres"
    """

    bottom_m: float
    top_m: float
    count: int
    depth_m: float
    tilt_deg: float = 0.0
    distance_m: float = 0.1
    width_m: float | None = None
    material: Material | float = 0.5
    name: str = "louvres"

    def __post_init__(self) -> None:
        check_name(self.name)
        for name in ("bottom_m", "top_m", "distance_m"):
            number(f"{name} of {self.name!r}", getattr(self, name))
        positive(f"top_m - bottom_m of {self.name!r}", self.top_m - self.bottom_m)
        within(f"count of {self.name!r}", self.count, 2, 10_000)
        positive(f"depth_m of {self.name!r}", self.depth_m)
        within(f"tilt_deg of {self.name!r}", self.tilt_deg, -90.0, 90.0)
        reach = self.depth_m / 2.0 * np.cos(np.radians(self.tilt_deg))
        positive(f"distance_m - depth_m / 2 · cos(tilt_deg) of {self.name!r}", self.distance_m - reach)
        if self.width_m is not None:
            positive(f"width_m of {self.name!r}", self.width_m)

    def outlines(self, room: Shoebox) -> list[Outline]:
        """Its polygons in the room's axes."""
        width = room.width_m if self.width_m is None else self.width_m
        left = (room.width_m - width) / 2.0
        axis = -room.wall_thickness_m - self.distance_m
        tilt = np.radians(self.tilt_deg)
        across, rise = self.depth_m * float(np.cos(tilt)), self.depth_m * float(np.sin(tilt))
        return [
            rectangle((left, axis - across / 2.0, float(z) - rise / 2.0), (width, 0.0, 0.0), (0.0, across, rise))
            for z in np.linspace(self.bottom_m, self.top_m, self.count)
        ]


Obstruction = FacingBuilding | Overhang | LightShelf | Louvres


def obstruction_surfaces(obstruction: Obstruction, room: Shoebox) -> list[Surface]:
    """The polygons of an obstruction in the world's axes."""
    outlines = obstruction.outlines(room)
    names = (
        [obstruction.name] if len(outlines) == 1 else [f"{obstruction.name} {k}" for k in range(1, len(outlines) + 1)]
    )
    material = as_material(obstruction.name, obstruction.material)
    return [
        Surface(name=name, outline_m=room.to_world(outline), material=material)
        for name, outline in zip(names, outlines, strict=True)
    ]
