"""A room: what light meets on its way, and where it is asked for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.room.material import Material
from clerestory.room.obstruction import Obstruction, obstruction_surfaces
from clerestory.room.sensors import SensorGrid, Sensors
from clerestory.room.shoebox import Shoebox
from clerestory.room.surface import Interface, Mesh, Surface, check_name
from clerestory.room.window import Window
from clerestory.rules import within
from clerestory.site import Site


@dataclass(frozen=True, kw_only=True)
class Room:
    """What light meets on its way, and where it is asked for.

    Parameters
    ----------
    surfaces, meshes, interfaces, windows : sequences
        Each thing has a name of its own.
    sensors : sequence of SensorGrid or Sensors
        Where illuminance is asked for unless a call says otherwise.
    ground_reflectance : float, 0..1, default 0.2
        Of the even, unobstructed ground that is seen below the horizon.
    site : Site, optional
    name : str, default "room"

    Raises
    ------
    ClerestoryError
        If it is empty, a name stands twice, or a value is not of its kind. Shapes are checked when the room is first
        traced or `scene` is first asked for: open, crossing and bent polygons, windows outside their wall, media that
        do not nest.
    """

    surfaces: tuple[Surface, ...] = ()
    windows: tuple[Window, ...] = ()
    meshes: tuple[Mesh, ...] = ()
    interfaces: tuple[Interface, ...] = ()
    sensors: tuple[SensorGrid | Sensors, ...] = ()
    ground_reflectance: float = 0.2
    site: Site | None = None
    name: str = "room"

    def __post_init__(self) -> None:
        kinds: dict[str, type | tuple[type, ...]] = {
            "surfaces": Surface,
            "windows": Window,
            "meshes": Mesh,
            "interfaces": Interface,
            "sensors": (SensorGrid, Sensors),
        }
        for field, kind in kinds.items():
            things = tuple(getattr(self, field))
            object.__setattr__(self, field, things)
            for index, thing in enumerate(things):
                if not isinstance(thing, kind):
                    raise ClerestoryError(f"{field}[{index}] must be of its kind, got {thing!r}")
        check_name(self.name)
        within("ground_reflectance", self.ground_reflectance, 0.0, 1.0)
        if self.site is not None and not isinstance(self.site, Site):
            raise ClerestoryError(f"site must be a Site(latitude_deg=…, longitude_deg=…), got {self.site!r}")
        names: set[str] = set()
        everything: tuple[Surface | Window | Mesh | Interface, ...] = (
            *self.surfaces,
            *self.windows,
            *self.meshes,
            *self.interfaces,
        )
        for thing in everything:
            if thing.name in names:
                raise ClerestoryError(f"everything in a room must have a name of its own, got {thing.name!r} twice")
            names.add(thing.name)
        if not names:
            raise ClerestoryError("a room must hold at least one surface, got an empty scene")

    @classmethod
    def shoebox(
        cls,
        *,
        obstructions: Iterable[Obstruction] = (),
        sensors: Iterable[SensorGrid | Sensors] = (SensorGrid(spacing_m=0.5),),
        ground_reflectance: float = 0.2,
        site: Site | None = None,
        name: str = "room",
        **shape: Any,
    ) -> Room:
        """A rectangular room.

        Parameters
        ----------
        **shape
            Sizes, openings, wall thickness, orientation and reflectances: the parameters of `Shoebox`.
        obstructions : sequence of FacingBuilding, Overhang, LightShelf or Louvres
        sensors : sequence of SensorGrid or Sensors, default every 0.5 m at 0.8 m above the floor
        ground_reflectance, site, name
            As in `Room`.

        Raises
        ------
        ClerestoryError
            If a size is not positive, an opening reaches beyond its wall, or a name stands twice.
        """
        try:
            box = Shoebox(**shape)
        except TypeError as cause:
            raise ClerestoryError(f"a shoebox room must have the parameters of Shoebox: {cause}") from cause
        surfaces, windows = box.build()
        for obstruction in obstructions:
            surfaces += obstruction_surfaces(obstruction, box)
        return cls(
            surfaces=tuple(surfaces),
            windows=tuple(windows),
            sensors=tuple(sensors),
            ground_reflectance=ground_reflectance,
            site=site,
            name=name,
        )

    @cached_property
    def scene(self) -> _native.Scene:
        """The compiled half: checked and indexed, ready for rays."""
        builder = _native.SceneBuilder()
        for surface in self.surfaces:
            builder.polygon(
                surface.name,
                np.array(surface.outline_m),
                surface.material.native(),
                holes=[np.array(hole) for hole in surface.holes_m],
            )
        for mesh in self.meshes:
            builder.mesh(mesh.name, mesh.vertices_m, mesh.triangles, mesh.material.native())
        for interface in self.interfaces:
            front, back = interface.media
            builder.interface(interface.name, interface.vertices_m, interface.triangles, front, back)
        for window in self.windows:
            builder.window(
                window.name, np.array(window.outline_m), window.glazing.glazing(), up=window.up, wall=window.wall
            )
        return builder.build()

    def sensor_points(
        self, sensors: SensorGrid | Sensors | Iterable[SensorGrid | Sensors] | None = None
    ) -> list[Sensors]:
        """Sensors laid out in the room.

        Parameters
        ----------
        sensors : SensorGrid, Sensors or a sequence of them, optional
            Default the room's own.

        Raises
        ------
        ClerestoryError
            If there are none, or a grid names no surface of the room.
        """
        asked = self.sensors if sensors is None else sensors
        asked = (asked,) if isinstance(asked, (SensorGrid, Sensors)) else tuple(asked)
        if not asked:
            raise ClerestoryError("sensors must hold at least one grid or point, got none")
        placed = [one.on(self.surfaces) for one in asked]
        names = [one.name for one in placed]
        for name in names:
            if names.count(name) > 1:
                raise ClerestoryError(f"groups of sensors must have names of their own, got {name!r} twice")
        return placed

    def with_glazing(self, glazing: dict[str, Any]) -> Room:
        """The same room with other glazings.

        Parameters
        ----------
        glazing : dict of window name → Glazing

        Raises
        ------
        ClerestoryError
            If the room has no window of that name.
        """
        known = [window.name for window in self.windows]
        for name in glazing:
            if name not in known:
                raise ClerestoryError(f"glazing must name windows of the room ({', '.join(known)}), got {name!r}")
        windows = tuple(replace(window, glazing=glazing.get(window.name, window.glazing)) for window in self.windows)
        return replace(self, windows=windows)


def materials_of(room: Room) -> dict[str, Material]:
    """Material of each opaque thing by its name."""
    found = {one.name: one.material for one in room.surfaces}
    return found | {one.name: one.material for one in room.meshes}
