"""A study of a year, run from the page as ``clerestory year FILE --out out/NAME`` runs it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clerestory.errors import ClerestoryError
from clerestory.room.toml_file import read_toml
from clerestory.studio.doors.folder import inside
from clerestory.studio.room.files import confined, files_of, with_room_file

if TYPE_CHECKING:
    from clerestory.studio.jobs.work import Tell


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
    from clerestory.sweep.store import Store
    from clerestory.year import State, read_year, run_year, write_year

    home = Path(folder)
    file = inside(home, path)
    stays_inside(home, path)
    study = read_year(file)
    out = where_to(home, path)

    def follow(state: State) -> None:
        left = None if math.isnan(state.seconds_left) else round(state.seconds_left, 1)
        tell(state.done, 1.0, {"variant": state.variant, "what": state.what, "seconds_left": left, "path": None})

    # what a run that was cancelled left half written
    Store(out / "pieces").tidy()
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
    tables, where = with_room_file(folder, file.parent, read_toml(file))
    files_of(folder, where, tables)
    weather = tables.get("weather")
    if not isinstance(weather, dict) or "file" not in weather:
        raise ClerestoryError(f"path must be a year file, with a file under [weather], got {path!r}")
    confined(folder, file.parent, weather["file"], "file of [weather]")
