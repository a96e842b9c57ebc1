"""Runs what is not yet done of a study, and keeps each result as soon as it is there."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.saving import write_text
from clerestory.sweep.cluster import on_cluster
from clerestory.sweep.fingerprint import build, key_of
from clerestory.sweep.local import in_processes, in_this_process
from clerestory.sweep.plan import Case, Sweep
from clerestory.sweep.store import Store
from clerestory.sweep.work import Outcome, Task, _bytes_of


@dataclass(kw_only=True)
class Tally:
    """How a study stands.

    Parameters
    ----------
    cases : int
        All of them.
    done_before, computed, failed : int
        Finished in earlier runs, finished in this one, failed in this one.
    interrupted : bool
        Whether the run was stopped.
    seconds : float
        Of this run.
    tasks, tasks_done : int
        Of this run: as many as cases, more where cases are split among tasks.
    failures : list of dict
        Number, values and error of each case that failed.
    """

    cases: int
    done_before: int = 0
    computed: int = 0
    failed: int = 0
    interrupted: bool = False
    seconds: float = 0.0
    tasks: int = 0
    tasks_done: int = 0
    failures: list[dict[str, Any]] = field(default_factory=list)

    @property
    def left(self) -> int:
        """Cases that are neither finished nor failed."""
        return self.cases - self.done_before - self.computed - self.failed

    def seconds_left(self) -> float | None:
        """What the rest will take if it goes on as it went, or None before the first task is done."""
        return self.seconds / self.tasks_done * (self.tasks - self.tasks_done) if self.tasks_done else None


Progress = Callable[[Tally], object]
"""Called after each task."""


def run_sweep(
    sweep: Sweep,
    folder: str | os.PathLike[str],
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Tally:
    """Computes every case of a study that is not finished yet.

    Parameters
    ----------
    sweep : Sweep
    folder : path-like
        Where results are kept, a file a case, named by the case's hash; the same folder again goes on where it stopped.
    workers : int, optional
        Processes on this machine; default one for each processor, 0 for none but this one.
    scheduler : str, optional
        Address of a Dask scheduler whose workers are used instead.
    progress : callable, optional
        See `Progress`.

    Returns
    -------
    Tally
        Also kept as ``summary.json``. Ctrl-C ends the run and keeps what is finished.

    Raises
    ------
    ClerestoryError
        If the folder cannot be written or the scheduler does not answer; a case that fails is no error, the tally
        tells of it.

    Notes
    -----
    A script that calls this with several workers begins under ``if __name__ == "__main__":``, as each process imports
    it.
    """
    if workers is None:
        workers = os.cpu_count() or 1
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 0:
        raise ClerestoryError(f"workers must be a whole number of at least 0, got {workers!r}")
    started = time.perf_counter()
    store = Store(Path(folder))
    store.tidy()
    cases = {case.key: case for case in sweep.cases}
    finished = store.keys()
    tally = Tally(cases=len(cases), done_before=len(cases.keys() & finished))
    jobs = _Jobs(sweep, store, [case for case in cases.values() if case.key not in finished], finished)
    tasks = list(jobs.tasks())
    tally.tasks = len(tasks)
    outcomes: Iterator[Outcome]
    if not tasks:
        outcomes = iter(())
    elif scheduler is not None:
        outcomes = on_cluster(tasks, scheduler)
    elif workers == 0:
        outcomes = in_this_process(tasks)
    else:
        outcomes = in_processes(tasks, min(workers, len(tasks)))
    try:
        for outcome in outcomes:
            ended = jobs.take(outcome)
            tally.tasks_done += 1
            if ended is not None and ended.error is None:
                tally.computed += 1
            elif ended is not None:
                tally.failed += 1
                case = cases[ended.key]
                tally.failures.append({"case": case.number, "values": case.values, "error": ended.error})
            tally.seconds = time.perf_counter() - started
            if progress is not None:
                progress(tally)
    except KeyboardInterrupt:
        tally.interrupted = True
    finally:
        if hasattr(outcomes, "close"):
            outcomes.close()
        tally.seconds = time.perf_counter() - started
        tally.failures.sort(key=lambda failure: int(failure["case"]))
        _write_summary(store, sweep, tally)
    return tally


class _Jobs:
    """Cases as tasks: one each, or several for one with many sensors, joined when the last part is there."""

    def __init__(self, sweep: Sweep, store: Store, cases: list[Case], finished: set[str]) -> None:
        self.sweep, self.store, self.cases, self.finished = sweep, store, cases, finished
        self.by_key = {case.key: case for case in cases}
        self.parts: dict[str, list[str]] = {}
        self.whole_of: dict[str, str] = {}
        self.failed: set[str] = set()
        self.seconds: dict[str, float] = {}

    def tasks(self) -> Iterator[Task]:
        where = str(self.sweep.where.resolve())
        for case in self.cases:
            pieces = self._pieces(case)
            if len(pieces) < 2:
                yield Task(key=case.key, kind=case.kind, tables=case.tables, files=case.files, where=where)
                continue
            keys = []
            for piece in pieces:
                key = key_of(case.kind, piece, case.files)
                keys.append(key)
                self.whole_of[key] = case.key
            self.parts[case.key] = keys
            if set(keys) <= self.finished:
                # all parts were there, but the run ended before they were joined: the last is done again
                self.finished.discard(keys[-1])
            for key, piece in zip(keys, pieces, strict=True):
                if key not in self.finished:
                    yield Task(key=key, kind=case.kind, tables=piece, files=case.files, where=where)

    def _pieces(self, case: Case) -> list[dict[str, Any]]:
        size = self.sweep.sensors_per_task
        if size is None:
            return []
        from clerestory.sweep.room_case import CHUNK, count_of_sensors

        try:
            count = count_of_sensors(case.tables, self.sweep.where)
        except Exception:
            # what is wrong with the case is told by the task
            return []
        return [{**case.tables, CHUNK: [first, min(first + size, count)]} for first in range(0, count, size)]

    def take(self, outcome: Outcome) -> Outcome | None:
        """Keeps an outcome; returns that of a case that has ended by it."""
        whole = self.whole_of.get(outcome.key)
        if whole is None:
            return self._keep(outcome)
        if whole in self.failed:
            return None
        self.seconds[whole] = self.seconds.get(whole, 0.0) + outcome.seconds
        if outcome.content is None:
            self.failed.add(whole)
            return self._keep(Outcome(key=whole, error=outcome.error, details=outcome.details))
        self.store.put(outcome.key, outcome.content)
        self.finished.add(outcome.key)
        keys = self.parts[whole]
        if not set(keys) <= self.finished:
            return None
        from clerestory.sweep.room_case import joined

        content = _bytes_of(joined([self.store.read(key) for key in keys]))
        ended = self._keep(Outcome(key=whole, content=content, seconds=self.seconds[whole]))
        for key in keys:
            self.store.remove(key)
        return ended

    def _keep(self, outcome: Outcome) -> Outcome:
        if outcome.content is not None:
            self.store.put(outcome.key, outcome.content)
        else:
            case = self.by_key[outcome.key]
            report = {"case": case.number, "values": case.values, "error": outcome.error, "details": outcome.details}
            self.store.fail(outcome.key, report | {"program": build()})
        return outcome


def _write_summary(store: Store, sweep: Sweep, tally: Tally) -> None:
    whole = {"study": sweep.name, "kind": sweep.kind, "program": build(), **asdict(tally), "left": tally.left}
    write_text(store.folder / "summary.json", json.dumps(whole, indent=2, default=str) + "\n")
