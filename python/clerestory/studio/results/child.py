"""The process that reads files of anybody's: what goes wrong in a library of formats ends it, and not the studio."""

from __future__ import annotations

import contextlib
import io
import json
import signal
import warnings
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import xarray as xr

#: Most that a file may hold once it is unpacked, and most variables of one.
MOST_BYTES, MOST_VARIABLES = 768 * 2**20, 600
#: Memory of the process, where the system can limit it.
MOST_MEMORY = 3 * 2**30
#: Most files of an archive.
MOST_ENTRIES = 10_000
#: Longest table and longest comment before it.
MOST_ROWS, MOST_COMMENTS = 100_000, 200


class RefusedError(Exception):
    """What is wrong with a file, in words."""


def serve_files(pipe: Connection) -> None:
    """Reads file after file: asked with JSON, answered with JSON and then the bytes of each array."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    while True:
        try:
            asked = json.loads(pipe.recv_bytes())
        except (EOFError, OSError):
            return
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                heading, arrays = _read(Path(asked["path"]), bool(asked["heads"]))
        except RefusedError as error:
            heading, arrays = {"refused": str(error)}, []
        except MemoryError:
            heading, arrays = {"refused": "it needs more memory than the studio gives one file"}, []
        except (OSError, EOFError):
            # "[Errno -101] NetCDF: HDF error" says nothing to a reader
            heading, arrays = {"refused": "it is no whole file of its kind: it may have been cut off, or damaged"}, []
        except UnicodeDecodeError:
            heading, arrays = {"refused": "it is no text in UTF-8, as a CSV file of a result is"}, []
        except Exception as error:
            # whatever a library makes of a broken file is an answer, not a fault
            said = " ".join(str(error).split())[:160]
            heading, arrays = {"refused": f"it cannot be read: {said or type(error).__name__}"}, []
        pipe.send_bytes(json.dumps(heading).encode())
        for array in arrays:
            pipe.send_bytes(np.ascontiguousarray(array).tobytes())


def _read(path: Path, heads: bool) -> tuple[dict[str, Any], list[Any]]:
    import xarray as xr

    if path.is_dir():
        if not (path / "zarr.json").is_file():
            raise RefusedError("this folder is no zarr store")
        # version 3 alone: a codec of version 2 unpickles what a file holds
        with xr.open_zarr(path, consolidated=False, chunks=None, zarr_format=3) as found:
            return _told(found, heads)
    ending = path.suffix.lower()
    if ending == ".zip":
        return _zipped(path, heads)
    if ending == ".csv":
        return _told(_table(path, heads), heads)
    if ending == ".nc":
        with path.open("rb") as file:
            start = file.read(8)
        if not start.startswith((b"\x89HDF\r\n\x1a\n", b"CDF")):
            raise RefusedError("it is no NetCDF file")
        with xr.open_dataset(path, engine="netcdf4") as found:
            return _told(found, heads)
    raise RefusedError(f"files ending in {ending[:12] or 'nothing'} are none of a study's results")


def _zipped(path: Path, heads: bool) -> tuple[dict[str, Any], list[Any]]:
    """A zarr store in a ZIP archive, which is read from where it lies: nothing is unpacked, whatever its names are."""
    import zipfile

    import xarray as xr
    from zarr.storage import ZipStore

    try:
        with zipfile.ZipFile(path) as archive:
            entries = archive.infolist()
    except zipfile.BadZipFile:
        raise RefusedError("it is no ZIP archive, or not the whole of one") from None
    if outside := [one.filename for one in entries if _leads_elsewhere(one.filename)]:
        raise RefusedError(f"its files must lie within it, got {outside[0][:80]!r}")
    if len(entries) > MOST_ENTRIES:
        raise RefusedError(f"it holds {len(entries)} files, {MOST_ENTRIES} are most")
    size = sum(one.file_size for one in entries)
    if size > MOST_BYTES:
        raise RefusedError(f"it unpacks to {size / 2**20:.0f} MiB, {MOST_BYTES / 2**20:.0f} are most")
    roots = [one.filename.removesuffix("zarr.json") for one in entries if one.filename.split("/")[-1] == "zarr.json"]
    depth = min((one.count("/") for one in roots), default=0)
    stores = {one for one in roots if one.count("/") == depth}
    if len(stores) != 1:
        raise RefusedError(f"it must hold one zarr store (version 3), such as results.zarr, it holds {len(stores)}")
    store = ZipStore(path, mode="r")
    with xr.open_zarr(
        store, group=stores.pop().strip("/") or None, consolidated=False, chunks=None, zarr_format=3
    ) as found:
        return _told(found, heads)


def _leads_elsewhere(name: str) -> bool:
    return "\\" in name or name.startswith("/") or not {".", ".."}.isdisjoint(name.split("/"))


def _told(found: xr.Dataset, heads: bool) -> tuple[dict[str, Any], list[Any]]:
    if len(found.variables) > MOST_VARIABLES:
        raise RefusedError(f"it holds {len(found.variables)} variables, {MOST_VARIABLES} are most")
    size = sum(one.size * max(one.dtype.itemsize, 8) for one in found.variables.values())
    if size > MOST_BYTES:
        raise RefusedError(f"it holds {size / 2**20:.0f} MiB of numbers, {MOST_BYTES / 2**20:.0f} are most")
    heading: dict[str, Any] = {"attrs": _plain(found.attrs), "variables": []}
    arrays: list[Any] = []
    for name, one in found.variables.items():
        told: dict[str, Any] = {
            "name": str(name),
            "dims": [str(dim) for dim in one.dims],
            "shape": list(one.shape),
            "coordinate": name in found.coords,
            "attrs": _plain(one.attrs),
        }
        heading["variables"].append(told)
        few = one.ndim <= 1 and one.size <= 64
        if heads and not (few and one.dtype.kind in "OUST"):
            continue
        values = np.asarray(one.values)
        if values.dtype.kind == "M":
            told["type"] = "time"
            arrays.append(values.astype("datetime64[ns]").astype(np.int64))
        elif values.dtype.kind in "fiub":
            kind = values.dtype.newbyteorder("=") if values.dtype.itemsize <= 8 else np.dtype(np.float64)
            told["type"] = kind.str
            arrays.append(values.astype(kind))
        elif values.dtype.kind in "OUST":
            told["text"] = [_word(value) for value in values.ravel().tolist()]
        else:
            told["skipped"] = True
    return heading, arrays


def _table(path: Path, heads: bool) -> xr.Dataset:
    """A CSV table, the ``# name: value`` lines before it as attributes."""
    import pandas as pd
    import xarray as xr

    lines = path.read_text(encoding="utf-8", errors="strict").splitlines()
    attrs: dict[str, str] = {}
    begin = 0
    for line in lines[:MOST_COMMENTS]:
        if not line.startswith("#"):
            break
        name, _, value = line.lstrip("# ").partition(":")
        attrs[name.strip()[:80]] = value.strip()[:4000]
        begin += 1
    if len(lines) - begin > MOST_ROWS:
        raise RefusedError(f"it has {len(lines) - begin} rows, {MOST_ROWS} are most")
    frame = pd.read_csv(io.StringIO("\n".join(lines[begin:])), nrows=3 if heads else None)
    return xr.Dataset({str(name): ("row", frame[name].to_numpy()) for name in frame.columns}, attrs=attrs)


def _word(value: Any) -> str:
    if value is None or (isinstance(value, float) and np.isnan(value)):
        return ""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _plain(attrs: Any) -> dict[str, Any]:
    told: dict[str, Any] = {}
    for name, value in list(attrs.items())[:200]:
        if isinstance(value, bytes):
            value = value.decode("utf-8", "replace")
        if isinstance(value, (np.ndarray, np.generic)):
            value = value.tolist()
        if isinstance(value, (str, int, float, list)):
            told[str(name)] = value
    return told
