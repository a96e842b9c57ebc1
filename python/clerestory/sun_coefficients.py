"""What the sun itself gives each sensor, direction by direction."""

from __future__ import annotations

import time
import warnings
from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from clerestory import _native
from clerestory.coefficients import PARTS, Progress, sensor_coordinates
from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance
from clerestory.room.scene import Room
from clerestory.room.sensors import SensorGrid, Sensors
from clerestory.sun import direction_of


class SunWarning(UserWarning):
    """A way of the sun into the room that is not looked for."""


def sun_coefficients(
    room: Room,
    sensors: SensorGrid | Sensors | Iterable[SensorGrid | Sensors] | None = None,
    *,
    altitude_deg: Any,
    azimuth_deg: Any,
    rounds: int = 8,
    max_bounces: int | None = None,
    seed: int = 0,
    any_sun: bool = False,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    r"""Illuminance from the sun at each sensor, per illuminance on a plane facing the sun.

    Parameters
    ----------
    room : Room
    sensors : SensorGrid, Sensors or a sequence of them, optional
        Default the room's own.
    altitude_deg, azimuth_deg : array_like, shape (k,) [deg]
        Where the sun stands, clockwise from north; above the horizon.
    rounds, max_bounces, seed, threads, progress
        As in `daylight_coefficients`.
    any_sun : bool, default False
        Lay the points of surfaces that all sensors share where they serve suns anywhere in the sky, not where these
        shine most: as right, and what the studio does, which keeps them from sun to sun.

    Returns
    -------
    Dataset, dims ("sensor", "sun") [1]
        `direct`, `redirected` and `interreflected`, each with `…_standard_error`. With dims ("sun",): `cut_off`, the
        summed strength, in the same measure, of the beams that were not followed to another turn and of light of which
        no direction is known (see Notes).

    Raises
    ------
    ClerestoryError
        If the room is wrong, a sun is below the horizon, or more than 3e-3 of a window's light has no definite
        directions, as a rough panel's: fill the window with its ``panel.bsdf().blurred()``.

    Warns
    -----
    SunWarning
        If the room has boundaries between media, or mirrors of too many facets: the sun by way of them is not looked
        for.

    Notes
    -----
    The panel's exact lobes say in which few directions the light of one sun enters; each is followed with the disc of
    0.533°: no patches, no blur. A beam of share p that leaves at cos θ_k when the sun comes in at cos θ_i has
    :math:`p \cos\theta_i / \cos\theta_k` of the sun's normal illuminance (theory/illuminance.md, eq. 6).

    Beams are followed from mirror to window to mirror, in any order, off the inner and the outer faces of windows, and
    through windows in a row (theory/mirrored_sun.md, eqs. 1 and 2): the sensor looks back along every direction that
    results, so what a flat mirror throws has a hard edge and no noise. A beam of less than 1e-4 of the sun is not
    followed to another turn, nor are more than 1024 directions of one sun, the strongest first. Mirrors together may
    have 256 directions of their normals and 1024 facets, the flattest being followed first. Whatever light mirrors
    throw counts as `direct`, unless a window totally reflects it on the way.

    What a window's exact lobes leave without a direction (up to 1e-4 of what each panel meets) is missing; `cut_off`
    holds it as if it left square to the window. A stack of prisms of odd angles sends thousands of weak beams: its
    shares have a standard error of up to 2e-4, and beams below 1e-3 are put together within 0.1° to 0.4°
    (theory/layers.md, eqs. 11 to 13).

    What a window spreads, as a `Bsdf` does, counts as `direct`: its points glow under the sun and are looked at
    (theory/room.md, eq. 14).
    """
    altitude, azimuth = np.broadcast_arrays(np.atleast_1d(altitude_deg), np.atleast_1d(azimuth_deg))
    if altitude.ndim != 1 or len(altitude) == 0:
        raise ClerestoryError(f"altitude_deg must be one row of angles, got shape {altitude.shape}")
    directions = direction_of(altitude, azimuth)
    if (directions[:, 2] <= 0.0).any():
        raise ClerestoryError(
            f"altitude_deg must be above the horizon, got {float(altitude[np.argmin(directions[:, 2])]):g}: "
            "leave the night out"
        )
    placed = room.sensor_points(sensors)
    unseen = _unseen(room)
    if unseen:
        warnings.warn(
            f"the sun by way of {unseen[0]} is not looked for and is missing from the result"
            + (f" (so it is for {len(unseen) - 1} more)" if len(unseen) > 1 else "")
            + ": draw curved mirrors with fewer facets, or put what bends light into a window as a panel",
            SunWarning,
            stacklevel=2,
        )
    started = time.process_time()
    traced = _native.sun_coefficients(
        room.scene,
        np.concatenate([one.points_m for one in placed]),
        np.concatenate([one.normals for one in placed]),
        directions,
        seed=seed,
        rounds=rounds,
        max_bounces=max_bounces,
        any_sun=any_sun,
        threads=threads,
        progress=progress,
    )
    variables: dict[str, Any] = {
        name: (("sensor", "sun"), traced[name], {"units": "1", "long_name": f"sun, {name.replace('_', ' ')}"})
        for part in PARTS
        for name in (part, f"{part}_standard_error")
    }
    attributes = {"units": "1", "long_name": "beams not followed, and light without a direction"}
    variables["cut_off"] = ("sun", traced["cut_off"], attributes)
    return xr.Dataset(
        variables,
        coords={
            **sensor_coordinates(placed),
            "sun_altitude_deg": ("sun", np.asarray(altitude, dtype=np.float64), {"units": "degree"}),
            "sun_azimuth_deg": ("sun", np.asarray(azimuth, dtype=np.float64), {"units": "degree"}),
        },
        attrs=provenance(
            room=room.name,
            max_bounces=max_bounces,
            seed=seed,
            rounds=int(traced["rounds"]),
            interrupted=int(traced["interrupted"]),
            cpu_seconds=time.process_time() - started,
        ),
    )


def _unseen(room: Room) -> list[str]:
    """What could turn the sun's light towards a sensor but is not followed."""
    curved = [
        f"mirror {name!r}, of {facets} facets and {normals if normals <= 256 else 'over 256'} directions,"
        for name, normals, facets in room.scene.unfollowed_mirrors()
    ]
    return curved + [f"interface {one.name!r}" for one in room.interfaces]
