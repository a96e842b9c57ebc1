"""Reads files of anybody's by way of a process that may end over them."""

from __future__ import annotations

import json
import multiprocessing
import threading
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.studio.results.child import serve_files

#: Seconds that one file may take.
MOST_SECONDS = 30.0


class Reader:
    """One process that reads one file at a time; another takes its place when it ends.

    Only JSON and the bytes of arrays come back from it, so that whatever a file makes of it stays there.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._process: Any = None
        self._pipe: Any = None

    def read(self, path: Path, name: str, *, heads: bool = False) -> xr.Dataset:
        """What a file holds, all in memory.

        Parameters
        ----------
        path : Path
            A NetCDF or CSV file, or a zarr store.
        name : str
            What the file is called in messages.
        heads : bool, default False
            Only names, dimensions, attributes and short texts; all else is empty.

        Raises
        ------
        ClerestoryError
            If it cannot be read; the message begins with the name of the file.
        """
        with self._lock:
            try:
                pipe = self._ready()
                pipe.send_bytes(json.dumps({"path": str(path), "heads": heads}).encode())
                if not pipe.poll(MOST_SECONDS):
                    self._end()
                    raise ClerestoryError(f"{name} took more than {MOST_SECONDS:g} seconds to read: it may be damaged")
                heading = json.loads(pipe.recv_bytes())
                if "refused" in heading:
                    raise ClerestoryError(f"{name}: {heading['refused'].replace(str(path), name)}")
                return _dataset(heading, pipe, heads)
            except (EOFError, OSError):
                self._end()
                raise ClerestoryError(f"{name} cannot be read: it is damaged, or no result at all") from None

    def warm(self) -> None:
        """Starts the process before the first file needs it."""
        with self._lock:
            self._ready()

    def close(self) -> None:
        """Ends the process."""
        with self._lock:
            self._end()

    def _ready(self) -> Any:
        if self._process is None or not self._process.is_alive():
            self._end()
            context = multiprocessing.get_context("spawn")
            self._pipe, theirs = context.Pipe()
            self._process = context.Process(target=serve_files, args=(theirs,), daemon=True)
            self._process.start()
            theirs.close()
        return self._pipe

    def _end(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.join(2.0)
            self._pipe.close()
        self._process = self._pipe = None


def _dataset(heading: dict[str, Any], pipe: Any, heads: bool) -> xr.Dataset:
    variables: dict[str, Any] = {}
    coordinates: dict[str, Any] = {}
    for told in heading["variables"]:
        shape = tuple(told["shape"])
        if "text" in told:
            values: Any = np.array(told["text"], dtype=object).reshape(shape)
        elif "type" in told:
            content = pipe.recv_bytes()
            if told["type"] == "time":
                values = np.frombuffer(content, np.int64).astype("datetime64[ns]").reshape(shape)
            else:
                values = np.frombuffer(content, np.dtype(told["type"])).reshape(shape)
        elif heads:
            # sizes are told without their content
            values = np.broadcast_to(np.float32(0.0), shape)
        else:
            continue
        place = coordinates if told["coordinate"] else variables
        place[told["name"]] = (tuple(told["dims"]), values, told["attrs"])
    return xr.Dataset(variables, coordinates, heading["attrs"])
