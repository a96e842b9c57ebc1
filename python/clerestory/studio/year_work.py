"""A study of a year, run from the page as ``clerestory year FILE --out out/NAME`` runs it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clerestory.errors import ClerestoryError
from clerestory.room.toml_file import read_toml
from clerestory.studio.folder import inside

if TYPE_CHECKING:
    from clerestory.studio.work import Tell

#: Keys of a year file whose texts name files.
_FILES = ("file", "room")
_DEEPEST = 12


def year(*, folder: str, path: str, tell: Tell) -> dict[str, Any]:
    """Runs the study of a year file and writes what it came to; finished pieces are kept and not computed again.

    Parameters
    ----------
    folder : str
        The studio's.
    path : str
        Of the year file in it.
    tell : callable
        Told of how far the run is.

    Returns
    -------
    dict
        ``path`` of the year.nc in the folder.
    """
    from clerestory.year import State, read_year, run_year, write_year

    home = Path(folder)
    file = inside(home, path)
    stays_inside(home, path)
    study = read_year(file)
    out = where_to(home, path)

    def follow(state: State) -> None:
        left = None if math.isnan(state.seconds_left) else round(state.seconds_left, 1)
        tell(state.done, 1.0, {"variant": state.variant, "what": state.what, "seconds_left": left, "path": None})

    results = run_year(study, out, follow)
    tell(1.0, 1.0, {"variant": "", "what": "report", "seconds_left": None, "path": None})
    write_year(study, results, out)
    return {"variant": "", "what": "done", "seconds_left": 0.0, "path": (out / "year.nc").relative_to(home).as_posix()}


def where_to(folder: Path, path: str) -> Path:
    """The folder that the results of a year file go to: ``out/NAME`` of the studio's folder."""
    out = folder / "out" / Path(path).stem
    # what is there already must not lead elsewhere
    for one in (out.parent, out):
        if one.exists() and not one.resolve().is_relative_to(folder):
            raise ClerestoryError(f"path must have its results in the studio's folder, got out/{out.name} elsewhere")
    return out


def stays_inside(folder: Path, path: str) -> None:
    """Refuses a year file that names files outside the studio's folder.

    Raises
    ------
    ClerestoryError
    """
    file = inside(folder, path)
    tables = read_toml(file)
    _files_inside(folder, file.parent, tables, 0)
    room = tables.get("room")
    if isinstance(room, str):
        named = inside(folder, _within(folder, file.parent, room), "room")
        _files_inside(folder, named.parent, read_toml(named), 0)


def _files_inside(folder: Path, where: Path, value: Any, depth: int) -> None:
    if depth > _DEEPEST:
        raise ClerestoryError(f"path must be a year file that nests at most {_DEEPEST} deep, got more")
    if isinstance(value, dict):
        for name, one in value.items():
            if name in _FILES and isinstance(one, str):
                inside(folder, _within(folder, where, one), name)
            else:
                _files_inside(folder, where, one, depth + 1)
    elif isinstance(value, list):
        for one in value:
            _files_inside(folder, where, one, depth + 1)


def _within(folder: Path, where: Path, named: str) -> str:
    """A file that a table names, relative to the studio's folder."""
    try:
        found = (where / named).resolve()
        return found.relative_to(folder).as_posix()
    except (ValueError, OSError, RuntimeError):
        raise ClerestoryError(
            f"file must lie in the studio's folder, got {named[:80]!r}; start the studio in a folder that holds it"
        ) from None
