"""A table of a TOML file whose every key must be known."""

from __future__ import annotations

from difflib import get_close_matches
from typing import Any

from clerestory.errors import ClerestoryError

_REQUIRED = object()


class Table:
    """A table of a TOML file: keys are taken out one by one, and none may be left.

    Parameters
    ----------
    values : dict
    where : str
        What the table is called in messages, such as ``"[site] of room.toml"``.
    """

    def __init__(self, values: Any, where: str) -> None:
        if not isinstance(values, dict):
            raise ClerestoryError(f"{where} must be a table of names and values, got {values!r}")
        self.values = dict(values)
        self.where = where
        self._known: list[str] = []

    def take(self, key: str, default: Any = _REQUIRED) -> Any:
        """The value of a key, or the default where one is allowed."""
        self._known.append(key)
        if key in self.values:
            return self.values.pop(key)
        if default is _REQUIRED:
            raise ClerestoryError(f"{self.where} must have {key}, got {', '.join(self.values) or 'nothing'}")
        return default

    def table(self, key: str) -> Table:
        """A table within, empty if it is not there."""
        return Table(self.take(key, {}), f"[{key}] of {self.where}")

    def tables(self, key: str) -> list[Table]:
        """An array of tables within, empty if it is not there."""
        rows = self.take(key, [])
        if not isinstance(rows, list):
            raise ClerestoryError(f"[[{key}]] of {self.where} must be an array of tables, got {rows!r}")
        return [Table(row, f"[[{key}]] {index} of {self.where}") for index, row in enumerate(rows, 1)]

    def rest(self, *known: str) -> dict[str, Any]:
        """What is left, each key one of those known."""
        self._known += known
        for key in self.values:
            if key not in self._known:
                close = get_close_matches(key, self._known, n=1)
                hint = f"; did you mean {close[0]}?" if close else ""
                raise ClerestoryError(f"{self.where} must hold only {', '.join(self._known)}, got {key}{hint}")
        return self.values

    def finish(self) -> None:
        """Fails if a key is left that no one took."""
        self.rest()
