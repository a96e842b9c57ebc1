"""Daylight coefficients: what each patch of the sky gives each sensor."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import xarray as xr

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance
from clerestory.room.scene import Room
from clerestory.room.sensors import SensorGrid, Sensors
from clerestory.room.whereabouts import misplaced_sensors
from clerestory.rules import one_of, positive
from clerestory.sky.basis import patch_coordinates, sky_basis
from clerestory.sky.cie_sky import CieSky

PARTS = ("direct", "redirected", "interreflected")
"""What a coefficient is made of; the sum is all of it."""

Progress = Callable[[int, int, float, float], "bool | None"]
"""Called with rounds done, rounds expected, the worst relative standard error and the seconds so far; False stops."""

_LONG_NAMES = {
    "direct": "specular paths without total reflection",
    "redirected": "specular paths with a total reflection",
    "interreflected": "paths with a diffuse reflection",
}


class SensorWarning(UserWarning):
    """A sensor that stands where no one would put one."""


def daylight_coefficients(
    room: Room,
    sensors: SensorGrid | Sensors | Iterable[SensorGrid | Sensors] | None = None,
    *,
    basis: str = "reinhart577",
    sampling: str = "patch",
    sky: CieSky | None = None,
    target_relative_error: float | None = None,
    rounds: int = 16,
    nodes: int = 512,
    window_samples: int = 512,
    max_rounds: int = 4096,
    max_bounces: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    r"""Daylight coefficients: illuminance at each sensor per luminance of each patch of the sky, by ray tracing.

    Parameters
    ----------
    room : Room
    sensors : SensorGrid, Sensors or a sequence of them, optional
        Default the room's own.
    basis : str, default "reinhart577"
        ``"tregenza145"``, ``"reinhart577"``, ``"reinhart2305"`` …, ``"troplux5221"``.
    sampling : "patch" or "centre", default "patch"
        ``"centre"`` casts one ray at each sector's centre and finds the sector that it really reaches, as the published
        method of TropLux does; its direct and redirected parts have no standard error.
    sky : CieSky, optional
        The sky under which errors are judged; default the traditional overcast one, so that they are those of the
        daylight factor.
    target_relative_error : float, optional
        Goes on until the illuminance under ``sky`` is that good (one standard error) at every sensor.
    rounds : int, default 16
        Independent repetitions without a target; at least 2, as the standard errors come from their scatter.
    nodes : int, default 512
        Points of the room's surfaces, shared by all sensors, that one round draws for the interreflected part. Few
        rounds of many nodes are the better use of time; many rounds give the better standard error.
    window_samples : int, default 512
        Directions through the windows that one round draws at each sensor for the direct and redirected parts.
    max_rounds : int, default 4096
        Where a target gives up; `converged` then says 0.
    max_bounces : int, optional
        Most diffuse reflections. Default no limit: paths end by Russian roulette and nothing is lost. With one, `lost`
        says what is missing.
    seed : int, default 0
        The same seed gives the same result, whatever the number of threads.
    threads : int, optional
        Default all processors.
    progress : callable, optional
        See `Progress`. Stopping, or Ctrl-C, keeps what is there so far; `interrupted` then says 1.

    Returns
    -------
    Dataset, dims ("sensor", "patch")
        `direct`, `redirected` and `interreflected` [sr], each with `…_standard_error`; `sky_illuminance` and
        `sky_illuminance_standard_error` [lx], under ``sky`` of 1 cd/m² at the zenith, and `sky_luminance`, its patches.
        The last patch is the ground. The published method's "direct" is `direct`, its "diffuse" the sum of the others.

    Raises
    ------
    ClerestoryError
        If the room is wrong or a parameter out of range, before any ray is traced.

    Warns
    -----
    SensorWarning
        If a sensor stands outside the room or inside a solid.

    Notes
    -----
    :math:`E_s = \sum_p C_{sp} L_p` (theory/illuminance.md, eqs. 1-3); P. R. Tregenza, I. M. Waters, Lighting Research &
    Technology 15(2), 1983.
    """
    one_of("sampling", sampling, ("patch", "centre"))
    if target_relative_error is not None:
        positive("target_relative_error", target_relative_error)
    for name, value, least in (("rounds", rounds, 2), ("max_rounds", max_rounds, 2), ("seed", seed, 0)):
        _whole(name, value, least)
    for name, value in (("nodes", nodes), ("window_samples", window_samples)):
        _whole(name, value, 1)
    if max_bounces is not None:
        _whole("max_bounces", max_bounces, 0)
    patches = sky_basis(basis)
    placed = room.sensor_points(sensors)
    points = np.concatenate([one.points_m for one in placed])
    normals = np.concatenate([one.normals for one in placed])
    judged = sky or CieSky(sky_type=16, zenith_luminance_cd_m2=1.0)
    luminance = judged.matrix(basis, ground_reflectance=room.ground_reflectance).values / judged.zenith_cd_m2
    for message in misplaced_sensors(room, placed):
        warnings.warn(message, SensorWarning, stacklevel=2)
    started = time.process_time()
    traced = _native.daylight_coefficients(
        room.scene,
        points,
        normals,
        patches,
        seed=seed,
        rounds=rounds,
        nodes=nodes,
        window_samples=window_samples,
        max_bounces=max_bounces,
        target_relative_error=target_relative_error,
        max_rounds=max_rounds,
        weights=luminance,
        threads=threads,
        progress=progress,
    )
    variables: dict[str, Any] = {}
    published = _native.centre_coefficients(room.scene, points, normals, patches) if sampling == "centre" else {}
    for part in PARTS:
        about = {"units": "sr", "long_name": f"daylight coefficient, {_LONG_NAMES[part]}"}
        exact = published.get(part)
        values = traced[part] if exact is None else exact
        error = traced[f"{part}_standard_error"] if exact is None else np.zeros_like(exact)
        variables[part] = (("sensor", "patch"), values, about)
        variables[f"{part}_standard_error"] = (
            ("sensor", "patch"),
            error,
            {"units": "sr", "long_name": f"standard error of {part}"},
        )
    if traced["lost"] is not None:
        about = {"units": "sr", "long_name": "light beyond max_bounces"}
        variables["lost"] = (("sensor", "patch"), traced["lost"], about)
    weighted = traced["weighted"] if not published else sum(variables[part][1] for part in PARTS) @ luminance
    variables["sky_luminance"] = ("patch", luminance, {"units": "1", "long_name": "sky that errors are judged under"})
    variables["sky_illuminance"] = (
        "sensor",
        weighted,
        {"units": "lx", "long_name": f"under {judged.description}, 1 cd/m2"},
    )
    variables["sky_illuminance_standard_error"] = ("sensor", traced["weighted_standard_error"], {"units": "lx"})
    return xr.Dataset(
        variables,
        coords={**sensor_coordinates(placed), **patch_coordinates(basis)},
        attrs=provenance(
            room=room.name,
            basis=basis,
            sampling=sampling,
            ground_reflectance=room.ground_reflectance,
            judged_sky=judged.description,
            target_relative_error=target_relative_error,
            max_bounces=max_bounces,
            seed=seed,
            rounds=int(traced["rounds"]),
            nodes=nodes,
            window_samples=window_samples,
            converged=int(traced["converged"]),
            interrupted=int(traced["interrupted"]),
            cpu_seconds=time.process_time() - started,
        ),
    )


def sensor_coordinates(placed: list[Sensors]) -> dict[str, Any]:
    """Coordinates of the dimension "sensor": place, normal, group, and row and column in a grid (-1 without)."""
    points = np.concatenate([one.points_m for one in placed])
    normals = np.concatenate([one.normals for one in placed])
    absent = [np.full(len(one), -1) for one in placed]
    row = np.concatenate([none if one.row is None else one.row for one, none in zip(placed, absent, strict=True)])
    column = np.concatenate(
        [none if one.column is None else one.column for one, none in zip(placed, absent, strict=True)]
    )
    metres = {"units": "m"}
    return {
        "sensor": ("sensor", np.arange(len(points))),
        **{f"{axis}_m": ("sensor", points[:, k], metres) for k, axis in enumerate("xyz")},
        **{f"normal_{axis}": ("sensor", normals[:, k]) for k, axis in enumerate("xyz")},
        "group": ("sensor", np.repeat([one.name for one in placed], [len(one) for one in placed])),
        "row": ("sensor", row),
        "column": ("sensor", column),
    }


def _whole(name: str, value: Any, least: int) -> None:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < least:
        raise ClerestoryError(f"{name} must be a whole number of at least {least}, got {value!r}")
