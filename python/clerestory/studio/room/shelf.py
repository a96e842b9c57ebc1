"""Coefficients that were computed, kept while they are looked at."""

from __future__ import annotations

import hashlib
import threading
from collections import OrderedDict
from dataclasses import dataclass, field
from typing import Any

from clerestory import _native
from clerestory.room.sensors import Sensors
from clerestory.studio.room.asked import AskedRoom
from clerestory.studio.room.pool import Pool
from clerestory.studio.room.suns import paths_of
from clerestory.studio.shelf import Shelf

#: Coefficients kept at once, suns of each, and memory of all.
_KEPT, _SUNS, _MOST_BYTES = 24, 64, 512 * 2**20
#: Planes of which the paths of any sun are kept.
_MOST_PATHS = 8

Sun = tuple[float, float]


@dataclass(eq=False)
class Kept:
    """The coefficients of one plane in one room, as good as they are by now.

    Attributes
    ----------
    pool : Pool
        Parts, sensors and patches; replaced, never changed.
    suns : mapping of (altitude_deg, azimuth_deg) → Pool
        Parts, sensors and that one sun.
    paths : AnySun, optional
        By which any sun's light comes, once a sun is asked for.
    following : Lock
        Held while these are followed: whoever else asks waits for them.
    """

    key: str
    asked: AskedRoom
    variant: str | None
    sensors: Sensors
    basis: str
    warned: tuple[str, ...] = ()
    pool: Pool = field(default_factory=Pool)
    suns: OrderedDict[Sun, Pool] = field(default_factory=OrderedDict)
    paths: _native.AnySun | None = None
    following: threading.Lock = field(default_factory=threading.Lock)

    @property
    def nbytes(self) -> int:
        """Memory of what is kept."""
        paths = self.paths
        return self.pool.nbytes + (0 if paths is None else paths.nbytes)


class RoomShelf(Shelf[Kept]):
    """A few planes' coefficients by a key that the same room, plane and basis always have."""

    def __init__(self) -> None:
        super().__init__(
            _KEPT,
            "key must be that of a room that was computed: compute it again",
            most_bytes=_MOST_BYTES,
            size=lambda one: one.nbytes,
        )

    def plane(self, asked: AskedRoom, variant: str | None, sensors: Sensors, basis: str) -> Kept:
        """Where the coefficients of a plane are kept, new and empty if they are not yet."""
        key = key_of(asked, variant, sensors, basis)
        return self.place(key, lambda: Kept(key, asked, variant, sensors, basis))

    def get(self, key: Any) -> Kept:
        """The coefficients of a key.

        Raises
        ------
        ClerestoryError
            If they are not kept (any more), or not begun.
        """
        with self.lock:
            found = super().get(key)
            if not found.pool.batches:
                raise self.gone()
            return found

    def add(self, key: str, number: int, pooled: Any) -> Pool | None:
        """Takes the next pass of a calculation; one that came twice counts once.

        Parameters
        ----------
        key : str
        number : int
            Of the pass, from 0.
        pooled : tuple of Batch and float
            And the seconds of processor time it took.
        """
        with self.lock:
            found = self.find(key)
            if found is None:
                return None
            if number == found.pool.passes:
                found.pool = found.pool.with_batch(*pooled)
            self.trim()
            return found.pool

    def warn(self, key: str, notes: list[str]) -> None:
        """Keeps what was told of sensors that stand where no one would put one."""
        with self.lock:
            found = self.find(key)
            if found is not None:
                found.warned = tuple(notes)

    def add_sun(self, key: str, sun: Sun, number: int, pooled: Any) -> Pool | None:
        """As `add`, of one sun."""
        with self.lock:
            found = self.find(key)
            if found is None:
                return None
            pool = found.suns.get(sun, Pool())
            if number == pool.passes:
                pool = found.suns[sun] = pool.with_batch(*pooled)
            found.suns.move_to_end(sun)
            while len(found.suns) > _SUNS:
                found.suns.popitem(last=False)
            return pool

    def sun(self, kept: Kept, sun: Sun) -> Pool:
        """What is known of one sun, perhaps nothing."""
        with self.lock:
            return kept.suns.get(sun, Pool())

    def paths(self, kept: Kept) -> _native.AnySun:
        """The paths by which any sun lights a plane, followed when they are first asked for."""
        with kept.following:
            found = kept.paths
            if found is None:
                found = kept.paths = paths_of(kept.asked.room(kept.variant), kept.sensors)
        self.trim()
        return found

    def trim(self) -> None:
        """Lets go of the paths of the planes looked at longest ago, then of planes."""
        with self.lock:
            having = {key: one.paths.nbytes for key, one in self._things.items() if one.paths is not None}
            while len(having) > 1 and (len(having) > _MOST_PATHS or sum(having.values()) > _MOST_BYTES // 2):
                oldest = next(iter(having))
                self._things[oldest].paths = None
                del having[oldest]
            super().trim()


def key_of(asked: AskedRoom, variant: str | None, sensors: Sensors, basis: str) -> str:
    """A hash of everything that coefficients depend on."""
    made = hashlib.sha256()
    for part in (_native.__version__, asked.light_key(variant), sensors.name, basis):
        made.update(part.encode() + b"\0")
    made.update(sensors.points_m.tobytes())
    made.update(sensors.normals.tobytes())
    return made.hexdigest()[:24]
