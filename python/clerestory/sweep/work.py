"""One task, as a process or a machine of a cluster does it: inputs in, the bytes of a finished result out."""

from __future__ import annotations

import os
import tempfile
import time
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.sweep.fingerprint import build, files_of, same_build
from clerestory.sweep.kinds import evaluate


@dataclass(frozen=True, kw_only=True)
class Task:
    """What a worker needs to know: the inputs, what their hash was made from, and the name of the result."""

    key: str
    kind: str
    tables: dict[str, Any] = field(repr=False)
    files: dict[str, str] = field(repr=False)
    where: str
    program: dict[str, str] = field(default_factory=lambda: dict(build()), repr=False)


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """What became of a task: the bytes of a NetCDF file, or what went wrong."""

    key: str
    content: bytes | None = field(default=None, repr=False)
    error: str | None = None
    details: str | None = field(default=None, repr=False)
    seconds: float = 0.0


def work(task: Task) -> Outcome:
    """Does a task; whatever goes wrong within it is an outcome, not an error."""
    started = time.perf_counter()
    try:
        _check_same(task)
        found = evaluate(task.kind, task.tables, where=Path(task.where))
        return Outcome(key=task.key, content=_bytes_of(found), seconds=time.perf_counter() - started)
    except ClerestoryError as error:
        told, details = " ".join(str(error).split()), None
    except Exception as error:
        told = f"{type(error).__name__}: {' '.join(str(error).split())}"
        details = traceback.format_exc()
    return Outcome(key=task.key, error=told, details=details, seconds=time.perf_counter() - started)


def _check_same(task: Task) -> None:
    here = build()
    if not same_build(task.program, here):
        raise ClerestoryError(
            f"a worker must run the program of the study (clerestory {task.program['version']}, sources "
            f"{task.program['sources']}), got {here['version']}, {here['sources']}; install one version everywhere"
        )
    if files_of(task.tables, Path(task.where)) != task.files:
        raise ClerestoryError(
            f"a worker must see the files that the study names in {task.where} as they were when it began; use a "
            "folder that all machines share, and run again if a file was changed"
        )


def _bytes_of(found: Any) -> bytes:
    with tempfile.TemporaryDirectory(prefix="clerestory-") as folder:
        path = Path(folder) / "result.nc"
        found.to_netcdf(path, engine="netcdf4")
        return path.read_bytes()


#: Variables that tell native libraries how many threads to use.
_THREAD_VARIABLES = ("RAYON_NUM_THREADS", "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


@contextmanager
def limited_threads(threads: int) -> Iterator[None]:
    """Within it, processes that begin use so many native threads each, unless the environment says otherwise."""
    changed = [name for name in _THREAD_VARIABLES if name not in os.environ]
    os.environ.update(dict.fromkeys(changed, str(threads)))
    try:
        yield
    finally:
        for name in changed:
            os.environ.pop(name, None)
