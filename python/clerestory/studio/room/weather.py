"""Weather files of the studio's folder, each read once."""

from __future__ import annotations

import threading
from collections import OrderedDict
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.rules import one_of
from clerestory.studio.room.files import confined, stamp
from clerestory.weather import Weather, read_epw, read_wea

#: Weather files kept at once.
_KEPT = 8
_files: OrderedDict[tuple[Any, ...], Weather] = OrderedDict()
_lock = threading.Lock()


def weather_of(root: Path, folder: Path, name: Any, timezone: Any = None) -> Weather:
    """The weather of a file (EPW or WEA) within the studio's folder.

    Raises
    ------
    ClerestoryError
        If it is not there, leads outside, or is no weather.
    """
    path = confined(root, folder, name, "weather file")
    if timezone is not None and not isinstance(timezone, str):
        raise ClerestoryError(f"timezone must be a name, got {timezone!r}")
    ending = one_of("the ending of a weather file", path.suffix.lower(), (".epw", ".wea"))
    key = (*stamp(path), timezone)
    with _lock:
        if key in _files:
            _files.move_to_end(key)
            return _files[key]
        try:
            found = read_wea(path) if ending == ".wea" else read_epw(path, timezone=timezone)
        except ClerestoryError as error:
            raise ClerestoryError(str(error).replace(str(path), path.name)) from None
        _files[key] = found
        while len(_files) > _KEPT:
            _files.popitem(last=False)
        return found
