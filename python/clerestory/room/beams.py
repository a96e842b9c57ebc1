"""The way of the sun through a room's windows: beams, what they light, and paths, as the compiled half follows them."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.room.scene import Room
from clerestory.rules import number, positive, within
from clerestory.sun import direction_of
from clerestory.sun_coefficients import SunWarning

Array = npt.NDArray[Any]

#: Facets in the way of a beam, beyond which it is looked at cell by cell.
_MOST_SHADES = 150
#: What a vertex of a path is, by the number that the compiled half has for it.
_EVENTS = np.array(["sun", "glazing", "mirror", "diffuse", "interface", "sky"], dtype=object)
#: How light came: straight, by a total reflection, by a mirror.
_KINDS = np.array(["direct", "redirected", "reflected"], dtype=object)


@dataclass(frozen=True, eq=False)
class SunWay:
    """The way of one sun, as tables of one row a thing.

    Attributes
    ----------
    windows : dict of arrays, shape (window,)
        `name`, `cos_incidence`, `sunlit_share`, `blocked_by`, `entering`.
    beams : dict of arrays, shape (beam,)
        `source`, `window`, `direction` (beam, axis), `power`, `strength`, `total_reflections`, `kind`.
    patches : dict of arrays, shape (patch,)
        `beam`, `surface`, `corners` (how many), `area` [m²], `strength`; one after another of all patches, `corner` and
        `source`, (corner, axis) [m].
    paths : dict of arrays, shape (path,)
        `vertices` (how many), `window`, `kind`; one after another of all paths, `position` (vertex, axis) [m], `event`,
        `surface`, `power`.
    """

    windows: dict[str, Array]
    beams: dict[str, Array]
    patches: dict[str, Array]
    paths: dict[str, Array]


def sun_way(
    room: Room,
    *,
    altitude_deg: float,
    azimuth_deg: float,
    points: int,
    bounces: int = 1,
    least_power: float = 0.01,
    beyond_m: float = 3.0,
) -> SunWay:
    """The way of the sun through each window of a room, as `sun_paths` tells it.

    Parameters
    ----------
    room, altitude_deg, azimuth_deg, points, bounces, least_power, beyond_m
        As of `sun_paths`.

    Raises
    ------
    ClerestoryError
        If the room is wrong or a parameter out of range.

    Warns
    -----
    SunWarning
        If the room has boundaries between media.
    """
    for name, value, least, most in (("points", points, 1, 10_000), ("bounces", bounces, 0, 8)):
        if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not least <= value <= most:
            raise ClerestoryError(f"{name} must be a whole number of {least}..{most}, got {value!r}")
    within("least_power", positive("least_power", least_power), 0.0, 1.0)
    positive("beyond_m", beyond_m)
    towards = direction_of(number("altitude_deg", altitude_deg), number("azimuth_deg", azimuth_deg))
    scene = room.scene
    if room.interfaces:
        warnings.warn(
            f"the sun beyond interface {room.interfaces[0].name!r} is not followed and is missing from the result: "
            "put what bends light into a window as a panel",
            SunWarning,
            stacklevel=3,
        )
    way = _native.sun_way(
        scene,
        towards[None],
        points=int(points),
        bounces=int(bounces),
        least_power=float(least_power),
        beyond_m=float(beyond_m),
        most_shades=_MOST_SHADES,
    )
    windows, beams, patches, paths = (way[name] for name in ("windows", "beams", "patches", "paths"))
    # -1, no surface, is the last
    names = np.array([*scene.surfaces, ""], dtype=object)
    windows["name"], windows["blocked_by"] = names[windows.pop("surface")], names[windows.pop("hidden_by")]
    beams["source"], beams["window"] = names[beams["source"]], names[beams["window"]]
    patches["surface"] = names[patches["surface"]]
    paths["event"], paths["surface"] = _EVENTS[paths["event"]], names[paths["surface"]]
    paths["window"] = names[paths["window"]]
    for table in (beams, paths):
        table["kind"] = _KINDS[np.where(table.pop("is_mirrored"), 2, table["total_reflections"] > 0)]
    return SunWay(windows, beams, patches, paths)
