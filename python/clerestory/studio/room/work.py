"""The long jobs of a room: coefficients and the sun, coarse at once and better with every pass."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from clerestory.coefficients import PARTS, SensorWarning, daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.room.scene import Room
from clerestory.room.sensors import Sensors
from clerestory.studio.room.asked import AskedRoom
from clerestory.studio.room.pool import Batch, Pool, relative
from clerestory.sun_coefficients import SunWarning, sun_coefficients

Tell = Callable[..., None]

#: Of the first pass: rounds, points of the room's surfaces, directions through the windows.
_ROUNDS, _NODES, _SAMPLES = 2, 512, 64
_MOST_NODES = 8192
#: Rounds whose scatter tells something.
_LEAST_ROUNDS = 8
#: Passes grow until one takes this long [s].
_LONG_S = 3.0
_SUN_ROUNDS, _MOST_SUN_ROUNDS = 4, 64


def room(
    *,
    root: str,
    folder: str,
    tables: dict[str, Any],
    variant: str | None,
    sensors: Sensors,
    basis: str,
    key: str,
    kept: Pool,
    target_relative_error: float,
    max_rounds: int,
    tell: Tell,
) -> dict[str, Any]:
    """Passes over the coefficients of a plane until they are good enough.

    Parameters
    ----------
    kept : Pool
        What there is already, without the parts: it goes on from there.
    target_relative_error : float
        Of the illuminance under an overcast sky, at the worst sensor.
    tell : callable
        Told of each pass: its `Batch`, and how good all are together.
    """
    asked = AskedRoom(Path(root), Path(folder), tables, key)
    scene, pool = asked.room(variant), kept
    pace = 0.0
    worst = _told(key, pool, target_relative_error)["worst_relative_error"] if pool.passes else np.inf
    while pool.rounds < _LEAST_ROUNDS or (worst > target_relative_error and pool.rounds < max_rounds):
        started, cpu = time.perf_counter(), time.process_time()
        nodes = min(_NODES * 2 ** (pool.passes // 4), _MOST_NODES)
        while nodes > _NODES and pace * nodes > _LONG_S:
            nodes //= 2
        batch, warned = one_pass(scene, sensors, basis, pool.passes, nodes)
        pace = (time.perf_counter() - started) / nodes
        spent = time.process_time() - cpu
        number, pool = pool.passes, pool.with_batch(_without_parts(batch), spent)
        about = _told(key, pool, target_relative_error) | {"notes": warned}
        worst = about["worst_relative_error"]
        goal = 1.0 if worst <= target_relative_error else min((target_relative_error / worst) ** 2, 0.99)
        tell(goal, 1.0, {"number": number, "batch": batch, "cpu_seconds": spent, "told": about})
    return _told(key, pool, target_relative_error)


def room_sun(
    *,
    root: str,
    folder: str,
    tables: dict[str, Any],
    variant: str | None,
    sensors: Sensors,
    key: str,
    sun: tuple[float, float],
    kept: Pool,
    target_relative_error: float,
    max_rounds: int,
    tell: Tell,
) -> dict[str, Any]:
    """As `room`, of the light of one sun."""
    asked = AskedRoom(Path(root), Path(folder), tables, key)
    scene, pool = asked.room(variant), kept
    worst = relative(*reversed(pool.judged()))[0] if pool.passes else np.inf
    while pool.rounds < _LEAST_ROUNDS or (worst > target_relative_error and pool.rounds < max_rounds):
        cpu = time.process_time()
        rounds = min(_SUN_ROUNDS * 2 ** (pool.passes // 2), _MOST_SUN_ROUNDS)
        try:
            batch = sun_pass(scene, sensors, sun, pool.passes, rounds)
        except ClerestoryError as error:
            # of some windows the sun's beams are not known: there is nothing to refine
            return _nothing(key, sun) | {"notes": [f"the sun's own light is left out: {error}"]}
        spent = time.process_time() - cpu
        number, pool = pool.passes, pool.with_batch(_without_parts(batch), spent)
        about = sun_told(key, sun, pool, target_relative_error)
        worst = about["worst_relative_error"]
        goal = 1.0 if worst <= target_relative_error else min((target_relative_error / worst) ** 2, 0.99)
        tell(goal, 1.0, {"number": number, "batch": batch, "cpu_seconds": spent, "told": about})
    return sun_told(key, sun, pool, target_relative_error)


def one_pass(room: Room, sensors: Sensors, basis: str, number: int, nodes: int) -> tuple[Batch, list[str]]:
    """One independent estimate of the coefficients of a plane; the number of the pass is its seed."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always", SensorWarning)
        found = daylight_coefficients(
            room, sensors, basis=basis, rounds=_ROUNDS, nodes=nodes, window_samples=_SAMPLES, seed=number
        )
    parts = np.stack([found[part].values for part in PARTS]).astype(np.float32)
    batch = Batch(
        parts,
        float(_ROUNDS * nodes),
        found.sky_illuminance.values,
        found.sky_illuminance_standard_error.values**2,
        int(found.attrs["rounds"]),
    )
    return batch, [str(one.message) for one in told if issubclass(one.category, SensorWarning)]


def sun_pass(room: Room, sensors: Sensors, sun: tuple[float, float], number: int, rounds: int) -> Batch:
    """One independent estimate of what one sun gives a plane, per illuminance normal to it."""
    with warnings.catch_warnings():
        # what is not looked for is told where its paths are
        warnings.simplefilter("ignore", SunWarning)
        found = sun_coefficients(
            room, sensors, altitude_deg=sun[0], azimuth_deg=sun[1], rounds=rounds, seed=number, any_sun=True
        )
    parts = np.stack([found[part].values for part in PARTS])
    variance = np.sum([found[f"{part}_standard_error"].values[:, 0] ** 2 for part in PARTS], axis=0)
    return Batch(parts, float(rounds), parts.sum(axis=0)[:, 0], variance, rounds)


def bare(pool: Pool) -> Pool:
    """A pool without its parts, which is all that a job needs to go on."""
    return Pool(tuple(_without_parts(one) for one in pool.batches), pool.passes, pool.cpu_seconds)


def sun_told(key: str, sun: tuple[float, float], pool: Pool, target_relative_error: float) -> dict[str, Any]:
    """How good the light of one sun is, as the page shows it."""
    return _told(key, pool, target_relative_error) | {"altitude_deg": sun[0], "azimuth_deg": sun[1]}


def _told(key: str, pool: Pool, target_relative_error: float) -> dict[str, Any]:
    mean, error = pool.judged()
    worst, average = relative(error, mean)
    return {
        "key": key,
        "rounds": pool.rounds,
        "passes": pool.passes,
        "worst_relative_error": worst,
        "mean_relative_error": average,
        "cpu_seconds": pool.cpu_seconds,
        "converged": worst <= target_relative_error,
    }


def _nothing(key: str, sun: tuple[float, float]) -> dict[str, Any]:
    good = {"rounds": 0, "passes": 0, "worst_relative_error": 0.0, "mean_relative_error": 0.0, "cpu_seconds": 0.0}
    return {"key": key, **good, "converged": True, "altitude_deg": sun[0], "azimuth_deg": sun[1]}


def _without_parts(batch: Batch) -> Batch:
    return Batch(np.empty((0, 0, 0)), batch.weight, batch.judged, batch.judged_variance, batch.rounds)
