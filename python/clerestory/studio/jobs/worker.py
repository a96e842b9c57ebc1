"""The other side of the pipe: a process that does long jobs and tells how far they are."""

from __future__ import annotations

import contextlib
import os
import signal
from collections.abc import Callable, Mapping
from multiprocessing.connection import Connection
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.studio.answers import field_of

#: What a process is told that is to leave its job.
STOP = "stop"


def serve_jobs(pipe: Connection) -> None:
    """Does jobs from ``pipe`` until it is closed.

    Says ("ready", None), then of each job ("progress", (done, total, partial)) … and last "done" or "failed"; after a
    "stop" on the way, "stopped".
    """
    # Ctrl-C is the server's to hear, which then ends its processes
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(os, "nice"):
        # who drags comes before what is computed beside
        os.nice(10)
    from clerestory.studio.jobs import work
    from clerestory.studio.warming import warm

    warm()
    # a server that was killed leaves nobody to tell
    with contextlib.suppress(BrokenPipeError, ConnectionResetError):
        _serve(pipe, work.JOBS)


def _serve(pipe: Connection, jobs: Mapping[str, Callable[..., Any]]) -> None:
    pipe.send(("ready", None))
    while True:
        try:
            asked = pipe.recv()
        except EOFError:
            return
        if asked == STOP:
            # it came when the job was done
            continue
        kind, arguments = asked
        try:
            pipe.send(("done", jobs[kind](**arguments, tell=_Tell(pipe))))
        except _StoppedError:
            pipe.send(("stopped", None))
        except Exception as error:
            pipe.send(("failed", faults_of(error, arguments)))


def faults_of(error: Exception, arguments: dict[str, Any]) -> list[dict[str, Any]]:
    """What the page is told of an error: a user's mistake beside its field, anything else as what it is."""
    if isinstance(error, ClerestoryError):
        return [{"field": field_of(error, arguments), "message": " ".join(str(error).split())}]
    if isinstance(error, MemoryError):
        return [{"field": None, "message": "there is not enough memory for this: ask for less"}]
    fault = f"a fault of the program: {type(error).__name__}; please report it with what you did"
    return [{"field": None, "message": fault}]


class _StoppedError(Exception):
    """Nobody wants the job any more."""


class _Tell:
    """Sends how far a job is, with what there is of it; ends the job if it is not wanted any more."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe = pipe

    def __call__(self, done: float, total: float, partial: Any = None) -> None:
        self._pipe.send(("progress", (done, total, partial)))
        if self._pipe.poll() and self._pipe.recv() == STOP:
            raise _StoppedError
