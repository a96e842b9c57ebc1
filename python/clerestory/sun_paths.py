"""The way of the sun through each window to where it lands, and on."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from clerestory.provenance import provenance
from clerestory.room.beams import Array, sun_way
from clerestory.room.scene import Room

_METRES = {"units": "m"}


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
    r"""The way of the sun through each window of a room to where it lands and on, and the patches that it lights.

    Parameters
    ----------
    room : Room
    altitude_deg, azimuth_deg : float [deg]
        Where the sun stands, clockwise from north. Below the horizon it lights nothing: there are no paths then.
    points : int, 1..10000, default 24
        About so many places of each window, in even rows, from which paths are drawn.
    bounces : int, 0..8, default 1
        Diffuse reflections that each path is drawn on for.
    least_power : float, default 0.01
        Share of the light on a window below which a beam or path is followed no further.
    beyond_m : float, default 3 [m]
        How far paths are drawn outside: towards the sun, and where they leave the room.

    Returns
    -------
    Dataset
        Dims ("window",): `cos_incidence`, of the sun on the outside, not above 0 where it is behind; `sunlit_share`
        [0..1] of its area that nothing opaque hides from the sun; `blocked_by`, the surface that hides most of it, or
        ``""``; `entering` [0..1], the share of the light on it that goes on into the room.

        Dims ("beam",): each exact direction in which light leaves a window or a mirror: `beam_source`, `beam_window`
        (by which the light came in), `beam_direction` (beam, axis), `beam_power` (share of the light on that window, or
        on the mirror outside that threw it there), `beam_strength` (illuminance across the beam over that normal to the
        sun), `beam_total_reflections`,
        `beam_kind`: ``"direct"``, ``"redirected"`` by a total reflection, or ``"reflected"`` by a mirror.

        Dims ("patch",): convex pieces of surfaces that a beam lights: `patch_beam`, `patch_surface`,
        `patch_corner_m` (patch, corner, axis), padded with NaN, `patch_source_m`, the same corners on the beam's
        source, `patch_area_m2`, `patch_strength` (illuminance over that normal to the sun). Pieces of one surface that
        meet are one patch of light; pieces of different beams may overlap, and their light adds.

        Dims ("path",): `position_m` (path, vertex, axis), padded with NaN, from outside to the last place; `event`
        (path, vertex), what is there: ``"sun"``, ``"glazing"``, ``"mirror"``, ``"diffuse"``, ``"interface"`` or
        ``"sky"``; `surface` (path, vertex); `power` (path, vertex), what arrives there as a share of the light that
        fell on the window or mirror where the path begins; `vertices`, how many there are; `path_window`; `path_kind`
        as of beams.

    Raises
    ------
    ClerestoryError
        If the room is wrong or a parameter out of range.

    Warns
    -----
    SunWarning
        If the room has boundaries between media: beams and paths end there.

    Notes
    -----
    Beams are those of `sun_coefficients`, followed forwards for the middle of the sun's disc (theory/room.md, eqs. 12
    and 16): a sensor lies in a patch if the sun's middle is seen from it by way of windows and mirrors. Patches are
    polygons cut by those that hide them, or among more than 150 facets in the way of a beam the cells of a grid of
    rays. Light that a window spreads, as a `Bsdf` does, has paths in
    directions drawn in proportion to power, and no patches. Paths that reach a diffuse surface go on in one direction
    each, spread evenly by the cosine (theory/room.md, eq. 17), and are drawn no further than the next window.
    """
    way = sun_way(
        room,
        altitude_deg=altitude_deg,
        azimuth_deg=azimuth_deg,
        points=points,
        bounces=bounces,
        least_power=least_power,
        beyond_m=beyond_m,
    )
    return xr.Dataset(
        {**_windows(way.windows), **_beams(way.beams), **_patches(way.patches), **_paths(way.paths)},
        coords={"window": way.windows["name"].tolist(), "axis": ["x", "y", "z"]},
        attrs=provenance(
            room=room.name,
            sun_altitude_deg=float(altitude_deg),
            sun_azimuth_deg=float(azimuth_deg),
            points=int(points),
            bounces=int(bounces),
            least_power=float(least_power),
        ),
    )


def _windows(windows: dict[str, Array]) -> dict[str, Any]:
    return {
        "cos_incidence": ("window", windows["cos_incidence"], {"units": "1"}),
        "sunlit_share": ("window", windows["sunlit_share"], {"units": "1"}),
        "blocked_by": ("window", windows["blocked_by"]),
        "entering": (
            "window",
            windows["entering"],
            {"units": "1", "long_name": "share of the light that goes into the room"},
        ),
    }


def _beams(beams: dict[str, Array]) -> dict[str, Any]:
    return {
        "beam_source": ("beam", beams["source"]),
        "beam_window": ("beam", beams["window"]),
        "beam_direction": (("beam", "axis"), beams["direction"]),
        "beam_power": ("beam", beams["power"], {"units": "1"}),
        "beam_strength": ("beam", beams["strength"], {"units": "1"}),
        "beam_total_reflections": ("beam", beams["total_reflections"]),
        "beam_kind": ("beam", beams["kind"]),
    }


def _patches(patches: dict[str, Array]) -> dict[str, Any]:
    places = ("patch", "corner", "axis")
    return {
        "patch_beam": ("patch", patches["beam"]),
        "patch_surface": ("patch", patches["surface"]),
        "patch_corner_m": (places, _rows(patches["corner"], patches["corners"], np.nan), _METRES),
        "patch_source_m": (places, _rows(patches["source"], patches["corners"], np.nan), _METRES),
        "patch_area_m2": ("patch", patches["area"], {"units": "m2"}),
        "patch_strength": ("patch", patches["strength"], {"units": "1"}),
    }


def _paths(paths: dict[str, Array]) -> dict[str, Any]:
    steps, counts = ("path", "vertex"), paths["vertices"]
    return {
        "position_m": ((*steps, "axis"), _rows(paths["position"], counts, np.nan), _METRES),
        "event": (steps, _rows(paths["event"], counts, "")),
        "surface": (steps, _rows(paths["surface"], counts, "")),
        "power": (steps, _rows(paths["power"], counts, np.nan), {"units": "1"}),
        "vertices": ("path", counts),
        "path_window": ("path", paths["window"]),
        "path_kind": ("path", paths["kind"]),
    }


def _rows(values: Array, counts: Array, padding: Any) -> Array:
    """So many of some values in each row of a table, padded."""
    there = np.arange(counts.max(initial=0)) < counts[:, None]
    table = np.full((*there.shape, *values.shape[1:]), padding, dtype=values.dtype)
    table[there] = values
    return table
