"""Results that the page has opened, kept while they are looked at."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import xarray as xr

from clerestory.studio.shelf import Shelf

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


class ResultShelf(Shelf[Result]):
    """A few opened results by a key that the same content always has."""

    def __init__(self) -> None:
        super().__init__(
            _KEPT,
            "key must be that of a result that is open: open the file again",
            most_bytes=_MOST_BYTES,
            size=lambda one: one.data.nbytes,
        )


def signature(path: Path) -> str:
    """What changes when a file or a store of the folder does: its path, its size and when it was written."""
    one = path / "zarr.json" if path.is_dir() else path
    told = one.stat()
    return f"{path}:{told.st_size}:{told.st_mtime_ns}"
