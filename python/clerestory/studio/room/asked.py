"""The room of a request: its tables, its variants, its site."""

from __future__ import annotations

import contextlib
import hashlib
import json
import re
import threading
from collections import OrderedDict
from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import date, time
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.glazing_table import glazing_tables
from clerestory.room.scene import Room
from clerestory.room.toml_file import read_toml, room_of
from clerestory.room.toml_table import Table
from clerestory.rules import one_of
from clerestory.site import Site
from clerestory.studio.doors.requests import Asked, table
from clerestory.studio.doors.shapes import MisshapenError
from clerestory.studio.room.files import confined, files_of, stamp, with_room_file
from clerestory.studio.room.weather import weather_of
from clerestory.year.study import YEAR_TABLES

#: Rooms kept at once, and the most that one may hold.
_KEPT = 24
MOST_TRIANGLES = 200_000
_NOT_THE_ROOM = frozenset(YEAR_TABLES)
_FIELD = re.compile(r"(?:^|: )([a-z]\w*)(?: of [^:]*?)? must ")
#: Tables that no light depends on.
_DARK = _NOT_THE_ROOM | {"name", "site", "sensors"}


@dataclass(frozen=True, eq=False)
class AskedRoom:
    """A room of a request, with its variants.

    Attributes
    ----------
    root, folder : Path
        The studio's folder, and where files that the tables name are looked for.
    tables : dict
        As asked, with those of the room file that a year file names.
    key : str
        The same for the same tables and files.
    """

    root: Path
    folder: Path
    tables: dict[str, Any]
    key: str
    _rooms: dict[str, Room] = field(default_factory=dict)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    @cached_property
    def base(self) -> Room:
        """The room without a variant."""
        inner = {name: value for name, value in self.tables.items() if name not in _NOT_THE_ROOM}
        return room_of(inner, folder=self.folder)

    @cached_property
    def variants(self) -> dict[str, dict[str, Any]]:
        """Label → glazing name by window; the first is the room as it stands."""
        found: dict[str, dict[str, Any]] = {self.base.name: {}}
        for one in Table(self.tables, "the room").tables("variant"):
            name = str(one.take("name"))
            if name in found:
                raise ClerestoryError(f"name of {one.where} must be its own, got {name!r}")
            found[name] = one.table("glazing").values
            one.finish()
        return found

    def room(self, variant: Any = None) -> Room:
        """The room of a variant, by default as it stands.

        Raises
        ------
        ClerestoryError
            If there is no such variant, or the room is wrong.
        """
        with self._lock, _beside_its_field():
            label = one_of("variant", self.base.name if variant is None else variant, tuple(self.variants))
            if label not in self._rooms:
                glazing = glazing_tables(Table(self.tables.get("glazings", {}), "[glazings]"), self.folder)
                others = {window: glazing(name) for window, name in self.variants[label].items()}
                room = self.base.with_glazing(others)
                triangles = len(np.asarray(room.scene.triangles()[1]))
                if triangles > MOST_TRIANGLES:
                    raise ClerestoryError(
                        f"a room must have at most {MOST_TRIANGLES} triangles here, got {triangles}; "
                        "simplify its meshes, or use the command line"
                    )
                self._rooms[label] = room
            return self._rooms[label]

    def light_key(self, variant: Any = None) -> str:
        """A hash of what the light in a variant depends on: not its site, its skies, its sensors or its name."""
        label = self.base.name if variant is None else variant
        bright = {name: value for name, value in self.tables.items() if name not in _DARK}
        files = [stamp(path) for path in files_of(self.root, self.folder, self.tables)]
        text = json.dumps([str(self.folder), bright, self.variants[label], files], sort_keys=True, default=str)
        return hashlib.sha256(text.encode()).hexdigest()[:24]

    @property
    def site(self) -> Site | None:
        """Where it is: its own site, or that of its weather file."""
        if self.base.site is not None:
            return self.base.site
        weather = self.tables.get("weather")
        if not isinstance(weather, dict) or "file" not in weather:
            return None
        return weather_of(self.root, self.folder, weather["file"], weather.get("timezone")).site


@contextlib.contextmanager
def _beside_its_field() -> Iterator[None]:
    """A mistake in a table is told with the name of the value, "[site] of the room: NAME must …"."""
    try:
        yield
    except ClerestoryError as error:
        told = _FIELD.findall(str(error))
        if told:
            raise MisshapenError(told[-1], str(error)) from None
        raise


class Rooms:
    """The rooms that were asked for last, by what makes them."""

    def __init__(self) -> None:
        self._rooms: OrderedDict[str, AskedRoom] = OrderedDict()
        self._lock = threading.Lock()

    def get(self, root: Path, room: Any) -> AskedRoom:
        """The room of ``{"tables": …}`` or ``{"path": …}``."""
        tables, folder = _tables_of(root, room)
        tables, folder = with_room_file(root, folder, tables)
        files = [stamp(path) for path in files_of(root, folder, tables)]
        # it gives the room its place, if [site] does not
        weather = tables.get("weather")
        if "site" not in tables and isinstance(weather, dict) and "file" in weather:
            confined(root, folder, weather["file"], "file of [weather]")
        text = json.dumps([str(folder), tables, files], sort_keys=True, default=str)
        key = hashlib.sha256(text.encode()).hexdigest()[:24]
        with self._lock:
            found = self._rooms.get(key)
            if found is None:
                found = self._rooms[key] = AskedRoom(root, folder, tables, key)
            self._rooms.move_to_end(key)
            while len(self._rooms) > _KEPT:
                self._rooms.popitem(last=False)
        return found


def asked_room(state: Any, asked: Asked) -> AskedRoom:
    """The room of a request, checked by the API's own dataclasses."""
    rooms: Rooms = state.rooms
    return rooms.get(state.settings.folder, table(asked, "room"))


def _tables_of(root: Path, room: Any) -> tuple[dict[str, Any], Path]:
    for name in room:
        one_of("a field of room", name, ("tables", "path"))
    if len(room) != 1:
        raise ClerestoryError(f"room must have tables or a path, got {sorted(room)}")
    if "path" in room:
        path = confined(root, root, room["path"], "path")
        tables: dict[str, Any] = _without_dates(read_toml(path))
        return tables, path.parent
    tables = room["tables"]
    if not isinstance(tables, dict):
        raise ClerestoryError(f"tables must be those of a room file, got {type(tables).__name__}")
    return tables, root


def _without_dates(value: Any) -> Any:
    """Dates and times, which JSON has not, as the text that the file has."""
    if isinstance(value, (date, time)):
        return value.isoformat()
    if isinstance(value, dict):
        return {name: _without_dates(one) for name, one in value.items()}
    return [_without_dates(one) for one in value] if isinstance(value, list) else value
