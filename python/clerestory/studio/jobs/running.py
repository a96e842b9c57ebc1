"""Long jobs of the page: each in a process of its own, followed as it goes, ended at once when nobody wants it."""

from __future__ import annotations

import multiprocessing
import secrets
import threading
import time
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.studio.jobs.worker import STOP, faults_of, serve_jobs

#: Jobs that are over and can still be asked about.
_KEPT = 64
#: How long a process may take to leave a job that was cancelled before it is ended [s].
_PATIENCE_S = 0.4


@dataclass(eq=False)
class Job:
    """One long job.

    Attributes
    ----------
    asked : dict
        What the page asked, which may be told again; ``arguments`` is what became of it.
    followers : int
        Who reads its events now.
    state : {"waiting", "running", "done", "failed", "cancelled"}
    done, total : float
        How far it is; total 0: not known.
    partial : what there is so far, the newest alone
    result : what there is in the end
    errors : list of {"field", "message"}
    version : int
        Counts changes, so that a reader knows what it has not seen.
    """

    kind: str
    arguments: dict[str, Any]
    finish: Callable[[Any], Any]
    heard: Callable[[Any], Any]
    is_slow: bool = False
    asked: dict[str, Any] = field(default_factory=dict)
    asked_at: datetime = field(default_factory=lambda: datetime.now(UTC))
    followers: int = 0
    key: str = field(default_factory=lambda: secrets.token_urlsafe(9))
    state: str = "waiting"
    done: float = 0.0
    total: float = 0.0
    partial: Any = None
    result: Any = None
    errors: list[dict[str, Any]] = field(default_factory=list)
    version: int = 0

    @property
    def is_over(self) -> bool:
        """Whether nothing more will come."""
        return self.state in ("done", "failed", "cancelled")

    def told(self) -> dict[str, Any]:
        """As the page reads it."""
        return {
            "job": self.key,
            "kind": self.kind,
            "state": self.state,
            "done": self.done,
            "total": self.total,
            "partial": None if self.is_over else self.partial,
            "result": self.result,
            "errors": self.errors,
        }


class Jobs:
    """A few processes that do jobs in the order they were asked for.

    Parameters
    ----------
    workers : int
        Processes; started with the first job.
    most_jobs : int
        That may wait or run at once.
    most_seconds : float
        After which a job is stopped.
    """

    def __init__(self, *, workers: int, most_jobs: int, most_seconds: float) -> None:
        self.workers, self.most_jobs, self.most_seconds = workers, most_jobs, most_seconds
        self._jobs: OrderedDict[str, Job] = OrderedDict()
        self._changed = threading.Condition()
        self._threads: list[threading.Thread] = []
        self._processes: list[_Process] = []
        self._is_open = True

    def start(
        self,
        kind: str,
        arguments: dict[str, Any],
        finish: Callable[[Any], Any] = lambda result: result,
        heard: Callable[[Any], Any] = lambda partial: partial,
        *,
        is_slow: bool = False,
        asked: dict[str, Any] | None = None,
    ) -> Job:
        """Puts a job in line.

        Parameters
        ----------
        kind : str
            Name of a function of :mod:`clerestory.studio.jobs.work`.
        arguments : dict
            Its keyword arguments, which can be sent to another process.
        finish : callable, optional
            Makes what the page gets of what the function returned.
        heard : callable, optional
            Makes what the page gets of what there is so far.
        is_slow : bool, default False
            Whether it may take minutes: one process is left for others, if there is more than one.
        asked : dict, optional
            What the page asked, to be told again.

        Raises
        ------
        ClerestoryError
            If too many jobs wait already.
        """
        with self._changed:
            if not self._is_open:
                raise ClerestoryError("a job must be asked for while the studio runs: start it again")
            if sum(not job.is_over for job in self._jobs.values()) >= self.most_jobs:
                raise ClerestoryError(f"at most {self.most_jobs} jobs may wait at once: cancel one, or wait")
            job = Job(kind, arguments, finish, heard, is_slow, asked or {})
            self._jobs[job.key] = job
            for key in [key for key, one in self._jobs.items() if one.is_over][: max(0, len(self._jobs) - _KEPT)]:
                del self._jobs[key]
            self._hire()
            self._changed.notify_all()
        return job

    def warm(self) -> None:
        """Starts a process before the first job needs it."""
        with self._changed:
            if not self._threads:
                self._hire()

    def _hire(self) -> None:
        if len(self._threads) < self.workers and self._is_open:
            thread = threading.Thread(target=self._work, name=f"studio-{len(self._threads)}", daemon=True)
            self._threads.append(thread)
            thread.start()

    def get(self, key: str) -> Job | None:
        """The job of a key, None if it is not known (any more)."""
        with self._changed:
            return self._jobs.get(key)

    def every(self) -> list[Job]:
        """All that are known, the oldest first."""
        with self._changed:
            return list(self._jobs.values())

    def cancel(self, key: str) -> Job | None:
        """Ends a job; its process stops at once or is ended. One that is over stays as it is."""
        with self._changed:
            job = self._jobs.get(key)
            if job is not None and not job.is_over:
                self._set(job, state="cancelled")
            return job

    def processes(self) -> list[_Process]:
        """Those that were started."""
        with self._changed:
            return list(self._processes)

    def close(self) -> None:
        """Ends all jobs and their processes."""
        with self._changed:
            self._is_open = False
            for job in self._jobs.values():
                if not job.is_over:
                    job.state = "cancelled"
            self._changed.notify_all()
        for thread in self._threads:
            thread.join(5.0)

    def _set(self, job: Job, **values: Any) -> None:
        for name, value in values.items():
            setattr(job, name, value)
        job.version += 1
        self._changed.notify_all()

    def _next(self) -> Job | None:
        with self._changed:
            while self._is_open:
                slow = sum(one.is_slow and one.state == "running" for one in self._jobs.values())
                takes_slow = slow < max(1, self.workers - 1)
                waiting = (one for one in self._jobs.values() if one.state == "waiting")
                job = next((one for one in waiting if takes_slow or not one.is_slow), None)
                if job is not None:
                    self._set(job, state="running")
                    return job
                self._changed.wait()
        return None

    def _work(self) -> None:
        process: _Process | None = self._started()
        while (job := self._next()) is not None:
            if process is None or not process.is_alive:
                process = self._started()
            if not self._follow(job, process):
                process.end()
                # the next job finds it ready
                process = self._started() if self._is_open else None
        if process is not None:
            process.end()

    def _started(self) -> _Process:
        process = _Process()
        with self._changed:
            self._processes = [*(one for one in self._processes if one.is_alive), process]
        return process

    def _follow(self, job: Job, process: _Process) -> bool:
        """Reads what the process says of a job; False if the process is to be ended."""
        try:
            while not process.is_ready(0.05):
                if job.is_over:
                    return True
            late = time.monotonic() + self.most_seconds
            process.begin(job.kind, job.arguments)
            while True:
                if process.pipe.poll(0.05):
                    word, value = process.pipe.recv()
                    process.is_busy = word == "progress"
                    if self._heard(job, word, value):
                        return True
                with self._changed:
                    if not job.is_over and time.monotonic() > late:
                        self._fail(job, f"a job may take {self.most_seconds:g} seconds, it took more: ask for less")
                        return False
                if job.is_over:
                    return process.stop()
        except (EOFError, OSError):
            with self._changed:
                if not job.is_over:
                    self._fail(job, "the process of this job ended by itself: ask again, or for less")
            return False

    def _heard(self, job: Job, word: str, value: Any) -> bool:
        """Takes one message; True if it was the last of the job."""
        if word == "done":
            try:
                value = job.finish(value)
            except Exception as error:
                word, value = "failed", faults_of(error, job.arguments)
        elif word == "progress" and value[2] is not None:
            value = (*value[:2], job.heard(value[2]))
        with self._changed:
            if not job.is_over:
                if word == "progress":
                    done, total, partial = value
                    self._set(job, done=done, total=total, partial=job.partial if partial is None else partial)
                elif word == "done":
                    self._set(job, state="done", result=value, done=job.total)
                else:
                    self._set(job, state="failed", errors=value)
        return word != "progress"

    def _fail(self, job: Job, message: str) -> None:
        self._set(job, state="failed", errors=[{"field": None, "message": message}])


class _Process:
    """A process that does one job after another.

    Attributes
    ----------
    is_busy : bool
        Whether it does one.
    """

    def __init__(self) -> None:
        self.is_busy, self._is_ready = False, False
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self._process = context.Process(target=serve_jobs, args=(theirs,), daemon=True)
        self._process.start()
        theirs.close()

    @property
    def is_alive(self) -> bool:
        """Whether it runs."""
        return self._process.is_alive()

    @property
    def pid(self) -> int:
        """Its number on this machine."""
        return int(self._process.pid or 0)

    def is_ready(self, patience_s: float) -> bool:
        """Whether it has loaded what it needs, or does so within some seconds."""
        if not self._is_ready and self.pipe.poll(patience_s):
            self._is_ready = self.pipe.recv()[0] == "ready"
        return self._is_ready

    def begin(self, kind: str, arguments: dict[str, Any]) -> None:
        """Gives it a job."""
        self.is_busy = True
        self.pipe.send((kind, arguments))

    def stop(self) -> bool:
        """Asks it to leave its job; False if it does not answer soon and is to be ended."""
        self.pipe.send(STOP)
        late = time.monotonic() + _PATIENCE_S
        while self.pipe.poll(max(0.0, late - time.monotonic())):
            # it may have been done just then
            if self.pipe.recv()[0] in ("stopped", "done", "failed"):
                self.is_busy = False
                return True
        return False

    def end(self) -> None:
        """Ends it, whatever it is doing."""
        self.is_busy = False
        self._process.terminate()
        self._process.join(1.0)
        if self._process.is_alive():
            self._process.kill()
        self.pipe.close()
