"""Results that the page has opened, kept while they are looked at."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import xarray as xr

from clerestory.errors import ClerestoryError

#: Results kept at once, and bytes of them all; the one looked at longest ago goes first.
_KEPT, _MOST_BYTES = 10, 1536 * 2**20


@dataclass(frozen=True, eq=False)
class Result:
    """One opened result.

    Parameters
    ----------
    kind : {"year", "room", "sweep", "design", "panel"}
    name : str
        Of its file.
    path : str
        Of the file in the studio's folder, empty if it was dropped.
    data : Dataset
        Of a year or room with the dimension "variant", whatever the file had; of tables with the dimension "row".
    about : dict
        What else is known: of a design its objectives.
    """

    kind: str
    name: str
    path: str
    data: xr.Dataset
    about: dict[str, Any] = field(default_factory=dict)
    _made: dict[str, Any] = field(default_factory=dict)

    def once(self, name: str, make: Callable[[], Any]) -> Any:
        """Something that is made of the result when it is first asked for."""
        if name not in self._made:
            self._made[name] = make()
        return self._made[name]


class ResultShelf:
    """A few opened results by a key that the same content always has."""

    def __init__(self) -> None:
        self._opened: OrderedDict[str, Result] = OrderedDict()
        self._lock = threading.Lock()

    def put(self, key: str, result: Result) -> str:
        """Keeps a result."""
        with self._lock:
            self._opened[key] = result
            self._opened.move_to_end(key)
            while len(self._opened) > 1 and (
                len(self._opened) > _KEPT or sum(one.data.nbytes for one in self._opened.values()) > _MOST_BYTES
            ):
                self._opened.popitem(last=False)
        return key

    def has(self, key: str) -> bool:
        """Whether a result is kept."""
        with self._lock:
            return key in self._opened

    def get(self, key: Any) -> Result:
        """The result of a key.

        Raises
        ------
        ClerestoryError
            If it is not kept (any more).
        """
        with self._lock:
            found = self._opened.get(key) if isinstance(key, str) else None
            if found is None:
                raise ClerestoryError("key must be that of a result that is open: open the file again")
            self._opened.move_to_end(key)
            return found


def signature(path: Path) -> str:
    """What changes when a file or a store of the folder does: its path, its size and when it was written."""
    one = path / "zarr.json" if path.is_dir() else path
    told = one.stat()
    return f"{path}:{told.st_size}:{told.st_mtime_ns}"
