"""The other side of the pipe: a process that does long jobs and tells how far they are."""

from __future__ import annotations

import signal
from multiprocessing.connection import Connection
from typing import Any

from clerestory.errors import ClerestoryError


def serve_jobs(pipe: Connection) -> None:
    """Does jobs from ``pipe`` until it is closed: ("progress", (done, total, partial)) …, then "done" or "failed"."""
    # Ctrl-C is the server's to hear, which then ends its processes
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    from clerestory.studio import work
    from clerestory.studio.answers import field_of

    while True:
        try:
            kind, arguments = pipe.recv()
        except EOFError:
            return
        try:
            pipe.send(("done", work.JOBS[kind](**arguments, tell=_Tell(pipe))))
        except ClerestoryError as error:
            pipe.send(("failed", [{"field": field_of(error, arguments), "message": " ".join(str(error).split())}]))
        except MemoryError:
            pipe.send(("failed", [{"field": None, "message": "there is not enough memory for this: ask for less"}]))


class _Tell:
    """Sends how far a job is, with what there is of it."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe = pipe

    def __call__(self, done: float, total: float, partial: Any = None) -> None:
        self._pipe.send(("progress", (done, total, partial)))
