"""The way of the sun through each window to where it lands, and on."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance
from clerestory.room.light_walk import GLAZING, SUN, Array, Rays, Surroundings, Walk, WindowFrame, joined
from clerestory.room.scene import Room
from clerestory.rules import number, positive
from clerestory.sun import direction_of
from clerestory.sun_coefficients import SunWarning

#: Cells of a window whose middle is looked out of, to say how much of it the sun reaches.
_CELLS = 576


def sun_paths(
    room: Room,
    *,
    altitude_deg: float,
    azimuth_deg: float,
    points: int = 24,
    bounces: int = 1,
    least_power: float = 0.01,
    beyond_m: float = 3.0,
) -> xr.Dataset:
    """The way of the sun through each window to where it lands, and on."""
    for name, value, least, most in (("points", points, 1, 10_000), ("bounces", bounces, 0, 8)):
        if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not least <= value <= most:
            raise ClerestoryError(f"{name} must be a whole number of {least}..{most}, got {value!r}")
    positive("least_power", least_power)
    positive("beyond_m", beyond_m)
    towards = direction_of(number("altitude_deg", altitude_deg), number("azimuth_deg", azimuth_deg))
    around = Surroundings(room)
    if room.interfaces:
        warnings.warn(
            f"the sun through interface {room.interfaces[0].name!r} is not followed: paths and patches end there; "
            "put what bends light into a window as a panel",
            SunWarning,
            stacklevel=2,
        )
    walk = Walk(around, least_power=least_power, bounces=bounces, beyond_m=beyond_m)
    seen = [_seen(around, window, towards) for window in around.windows.values()]
    starts, begun = [], []
    for index, window in enumerate(around.windows.values()):
        if seen[index]["cos"] <= 0.0 or towards[2] <= 0.0:
            continue
        places = _laid_over(window, points)
        lit = around.meets(places, np.tile(towards, (len(places), 1)))[1] < 0
        starts.append(_start(walk, window, places[lit], towards, beyond_m))
        begun += [index] * int(lit.sum())
    for rays, index in zip(starts, dict.fromkeys(begun), strict=False):
        following = walk.through(rays, list(around.windows.values())[index])
        if following:
            walk.follow(joined(following))
    return _told(walk, around, seen, towards, altitude_deg, azimuth_deg)


def _start(walk: Walk, window: WindowFrame, places: Array, towards: Array, beyond_m: float) -> Rays:
    count = len(places)
    rays = Rays(
        origin=places,
        direction=np.tile(-towards, (count, 1)),
        power=np.ones(count),
        vertex=np.full(count, -1),
        turned=np.zeros(count, dtype=np.int64),
        mirrored=np.zeros(count, dtype=bool),
        bounces=np.zeros(count, dtype=np.int64),
    )
    sun = walk.add(places + beyond_m * towards, SUN, rays, np.full(count, -1))
    rays = rays.at(slice(None), vertex=sun)
    met = walk.add(places, GLAZING, rays, np.full(count, window.surface))
    return rays.at(slice(None), vertex=met)


def _laid_over(window: WindowFrame, count: int) -> Array:
    """About so many points, the middles of the squares of a grid over the window."""
    flat = (window.outline - window.corner) @ window.axes[:2].T
    low, size = flat.min(axis=0), np.ptp(flat, axis=0)
    step = float(np.sqrt(size[0] * size[1] / count))
    numbers = np.maximum(1, np.round(size / step)).astype(int)
    x, y = ((np.arange(n) + 0.5) / n * length + start for n, length, start in zip(numbers, size, low, strict=True))
    grid = np.stack(np.meshgrid(x, y, indexing="xy"), axis=-1).reshape(-1, 2)
    from clerestory.room.sensors import _inside

    grid = grid[_inside(grid, flat)] if len(grid) > 1 else grid
    return np.asarray(window.corner + grid @ window.axes[:2])


def _seen(around: Surroundings, window: WindowFrame, towards: Array) -> dict[str, Any]:
    cos = float(window.axes[2] @ -towards)
    if cos <= 0.0 or towards[2] <= 0.0:
        return {"cos": cos, "share": 0.0, "blocked_by": ""}
    places = _laid_over(window, _CELLS)
    _, met = around.meets(places, np.tile(towards, (len(places), 1)))
    hidden = met[met >= 0]
    by = around.names[int(np.bincount(hidden).argmax())] if len(hidden) else ""
    return {"cos": cos, "share": float((met < 0).mean()), "blocked_by": by}


def _told(
    walk: Walk, around: Surroundings, seen: Any, towards: Array, altitude_deg: float, azimuth_deg: float
) -> xr.Dataset:
    ends = np.setdiff1d(np.arange(len(walk.parent)), walk.parent)
    chains = []
    for end in ends:
        chain = [int(end)]
        while walk.parent[chain[-1]] >= 0:
            chain.append(int(walk.parent[chain[-1]]))
        chains.append(chain[::-1])
    longest = max(map(len, chains), default=0)
    index = np.full((len(chains), longest), -1)
    for row, chain in enumerate(chains):
        index[row, : len(chain)] = chain
    there = index >= 0
    names = np.array([*around.names, ""])
    kind = np.where(walk.mirrored[ends], "reflected", np.where(walk.turned[ends] > 0, "redirected", "direct"))
    first = index[:, 1] if longest > 1 else np.empty(0, dtype=np.int64)
    windows = list(around.windows.values())
    return xr.Dataset(
        {
            "position_m": (
                ("path", "vertex", "axis"),
                np.where(there[..., None], walk.position[index], np.nan),
                {"units": "m"},
            ),
            "power": (("path", "vertex"), np.where(there, walk.power[index], np.nan), {"units": "1"}),
            "event": (("path", "vertex"), np.where(there, walk.event[index], "")),
            "surface": (("path", "vertex"), np.where(there, names[walk.surface[index]], "")),
            "vertices": ("path", there.sum(axis=1)),
            "kind": ("path", kind),
            "path_window": ("path", names[walk.surface[first]]),
            "cos_incidence": ("window", [one["cos"] for one in seen]),
            "sunlit_share": ("window", [one["share"] for one in seen]),
            "blocked_by": ("window", [one["blocked_by"] for one in seen]),
        },
        coords={"window": [one.name for one in windows], "axis": ["x", "y", "z"]},
        attrs=provenance(
            room=around.room.name, sun_altitude_deg=float(altitude_deg), sun_azimuth_deg=float(azimuth_deg)
        ),
    )
