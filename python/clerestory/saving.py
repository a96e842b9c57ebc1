"""Files written whole or not at all: beside their place first, then renamed into it."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from clerestory.errors import ClerestoryError

if TYPE_CHECKING:
    import xarray as xr


def write_whole(path: str | os.PathLike[str], write: Callable[[Path], object]) -> Path:
    """Lets ``write`` make a file beside ``path``, then puts it in place; whatever fails leaves ``path`` as it was.

    Parameters
    ----------
    path : path
        Its folder is made if need be.
    write : callable
        Given the path to write to, of the same ending.

    Returns
    -------
    Path
        Of the file.

    Raises
    ------
    ClerestoryError
        If the file cannot be written.
    """
    where = Path(path)
    try:
        where.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=f".{where.name}.", dir=where.parent) as beside:
            draft = Path(beside) / where.name
            write(draft)
            os.replace(draft, where)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ClerestoryError(f"{where} must be a place to write to, got: {reason}; choose another path") from None
    return where


def write_text(path: str | os.PathLike[str], text: str) -> Path:
    """Writes text as UTF-8, whole or not at all; arguments, result and errors as of :func:`write_whole`."""
    return write_whole(path, lambda draft: draft.write_text(text, encoding="utf-8", newline="\n"))


def save(dataset: xr.Dataset, path: str | os.PathLike[str]) -> Path:
    """Writes a result to NetCDF or CSV, whole or not at all.

    Parameters
    ----------
    dataset : Dataset
    path : path
        ``.nc`` for NetCDF 4, with all attributes; ``.csv`` for a table with a row for each point of the coordinates,
        what the result was made from in ``#`` lines before it, and units in the columns' names.

    Returns
    -------
    Path
        Of the file.

    Raises
    ------
    ClerestoryError
        If the ending is another, or the file cannot be written.
    """
    ending = Path(path).suffix.lower()
    if ending == ".nc":
        return write_whole(path, lambda draft: dataset.to_netcdf(draft, engine="netcdf4"))
    if ending == ".csv":
        return write_text(path, table_text(dataset))
    raise ClerestoryError(f"path must end in .nc or .csv, got {str(path)!r}; choose one")


#: Endings of columns for the units of coordinates.
_SUFFIX = {"degree": "_deg", "nm": "_nm"}


def table_text(dataset: xr.Dataset) -> str:
    """The dataset as CSV with ``#`` lines; :func:`clerestory.measured.read_measured` reads such files."""
    heading = [f"# {name}: {value}" for name, value in dataset.attrs.items()]
    frame = dataset.to_dataframe().reset_index()
    units = {str(name): _SUFFIX.get(dataset[name].attrs.get("units", ""), "") for name in dataset.coords}
    named = {name: name + suffix for name, suffix in units.items() if not name.endswith(suffix) or not suffix}
    return "\n".join(heading) + "\n" + str(frame.rename(columns=named).to_csv(index=False, lineterminator="\n"))
