"""Tasks in processes of this machine."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections import Counter, deque
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.process import BaseProcess

from clerestory.sweep.work import Outcome, Task, limited_threads, work

TRIES = 3
"""So often a task whose process dies is tried; what kills its process every time has failed."""


def in_this_process(tasks: Iterable[Task]) -> Iterator[Outcome]:
    """One task after another, here."""
    for task in tasks:
        yield work(task)


def in_processes(tasks: Iterable[Task], workers: int) -> Iterator[Outcome]:
    """Tasks in several processes, in the order in which they are done.

    Parameters
    ----------
    tasks : sequence of Task
    workers : int
        Processes; native threads are shared out among them.

    Notes
    -----
    A process that dies (memory, a signal) takes no more than its own task with it: the others are begun anew, and those
    that were under way run alone until it is known which of them kills. Closing the iterator ends the processes.
    """
    todo = deque(tasks)
    deaths: Counter[str] = Counter()
    threads = max(1, (os.cpu_count() or 1) // workers)
    with limited_threads(threads):
        while todo:
            running: dict[Future[Outcome], Task] = {}
            before = set(multiprocessing.active_children())
            pool = ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"), initializer=_prepare)
            ours: set[BaseProcess] = set()
            try:
                while todo or running:
                    while todo and _may_begin(todo[0], running, deaths, 2 * workers):
                        task = todo.popleft()
                        running[pool.submit(work, task)] = task
                    ours |= set(multiprocessing.active_children()) - before
                    done, _ = wait(running, return_when=FIRST_COMPLETED)
                    for future in done:
                        outcome = future.result()
                        del running[future]
                        yield outcome
                pool.shutdown()
            except BrokenProcessPool:
                for task in running.values():
                    deaths[task.key] += 1
                    if deaths[task.key] < TRIES:
                        todo.append(task)
                    else:
                        yield Outcome(key=task.key, error=f"its process died {TRIES} times; it may need more memory")
            finally:
                pool.shutdown(wait=False, cancel_futures=True)
                for process in ours:
                    if process.is_alive():
                        process.terminate()


def _may_begin(task: Task, running: dict[Future[Outcome], Task], deaths: Counter[str], most: int) -> bool:
    """A task whose process died before runs alone, so that only its own death is counted against it."""
    if deaths[task.key] or any(deaths[other.key] for other in running.values()):
        return not running
    return len(running) < most


def _prepare() -> None:
    """Ctrl-C is the parent's to answer, and without the parent there is nothing to do."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: BaseProcess) -> None:
    parent.join()
    os._exit(1)
