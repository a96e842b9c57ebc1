"""The light of any sun on a plane: paths are followed once and kept, and each sun is looked for on them."""

from __future__ import annotations

from clerestory import _native
from clerestory.room.scene import Room
from clerestory.room.sensors import Sensors
from clerestory.studio.room.pool import Batch
from clerestory.sun import direction_of

#: Passes that are kept, and independent rounds of each.
PASSES, ROUNDS = 2, 2
#: Points of the room's surfaces in a round, as of `sun_coefficients`.
_NODES = 1024


def paths_of(room: Room, sensors: Sensors) -> _native.AnySun:
    """The paths of all passes: those of `sun_coefficients` for any sun, with the number of the pass for a seed."""
    return _native.AnySun(
        room.scene, sensors.points_m, sensors.normals, seeds=range(PASSES), rounds=ROUNDS, nodes=_NODES
    )


def pass_of(paths: _native.AnySun, sun: tuple[float, float], number: int) -> Batch:
    """One independent estimate of what one sun gives a plane, per illuminance normal to it."""
    rounds = paths.light(direction_of(*sun)[None], number * ROUNDS, (number + 1) * ROUNDS)
    parts, variance = rounds.mean(axis=0), rounds.var(axis=0, ddof=1).sum(axis=0) / ROUNDS
    return Batch(parts[..., None], float(ROUNDS), parts.sum(axis=0), variance, ROUNDS)
