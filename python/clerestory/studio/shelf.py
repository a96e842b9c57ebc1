"""A few things that were opened or computed, kept by key while they are looked at."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from typing import Any, Generic, TypeVar

from clerestory.errors import ClerestoryError

Thing = TypeVar("Thing")


class Shelf(Generic[Thing]):
    """Things by a key that the same content always has; the one looked at longest ago leaves first.

    Parameters
    ----------
    most : int
        Things kept at once.
    gone : str
        What is said of a key that is not there (any more); begins with the word "key", which the page reads.
    most_bytes : float, optional
        Memory of all things together. The newest stays, however large it is.
    size : callable, optional
        Bytes of a thing, as it is now.

    Attributes
    ----------
    lock : RLock
        Held while the shelf is read or changed; also by those who change a thing that is on it.
    """

    def __init__(
        self,
        most: int,
        gone: str,
        *,
        most_bytes: float = float("inf"),
        size: Callable[[Thing], int] = lambda thing: 0,
    ) -> None:
        self.most, self.most_bytes, self._gone, self._size = most, most_bytes, gone, size
        self._things: OrderedDict[str, Thing] = OrderedDict()
        self.lock = threading.RLock()

    def put(self, key: str, thing: Thing) -> str:
        """Keeps a thing as the newest, in the place of one that had its key."""
        with self.lock:
            self._things[key] = thing
            self._things.move_to_end(key)
            self.trim()
        return key

    def place(self, key: str, make: Callable[[], Thing]) -> Thing:
        """The thing of a key, made if it is not there."""
        with self.lock:
            found = self._things.get(key)
            if found is None:
                found = make()
            self.put(key, found)
        return found

    def find(self, key: Any) -> Thing | None:
        """The thing of a key, which does not count as looked at; None if it is not there."""
        with self.lock:
            return self._things.get(key) if isinstance(key, str) else None

    def get(self, key: Any) -> Thing:
        """The thing of a key, which counts as looked at.

        Raises
        ------
        ClerestoryError
            If it is not there (any more).
        """
        with self.lock:
            found = self.find(key)
            if found is None:
                raise self.gone()
            self._things.move_to_end(key)
            return found

    def gone(self) -> ClerestoryError:
        """What is said of a key that is not there."""
        return ClerestoryError(self._gone)

    def trim(self) -> None:
        """Lets go of what is too many or too large; to be asked for when a thing on the shelf has grown."""
        with self.lock:
            while len(self._things) > 1 and (
                len(self._things) > self.most or sum(map(self._size, self._things.values())) > self.most_bytes
            ):
                self._things.popitem(last=False)
