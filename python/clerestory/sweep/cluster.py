"""Tasks on the machines of a Dask cluster."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from importlib import import_module
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.sweep.work import Outcome, Task, work

IN_FLIGHT = 5000
"""Tasks that the scheduler holds at once: enough for a thousand workers, few enough for its memory."""

CONNECT_S = 20.0
"""How long to wait for a scheduler."""


def on_cluster(tasks: Iterable[Task], scheduler: str, do: Callable[[Task], Outcome] = work) -> Iterator[Outcome]:
    """Tasks on the workers of a scheduler, in the order in which they are done.

    Parameters
    ----------
    tasks : sequence of Task
    scheduler : str
        Address such as ``"tcp://10.0.0.1:8786"``, or the path of a scheduler file.
    do : callable, default `work`
        What a worker does with a task.

    Raises
    ------
    ClerestoryError
        If the extra ``cluster`` is not installed or no scheduler answers.

    Notes
    -----
    The scheduler gives the task of a worker that is lost to another one; a task's name is its hash, so that none is
    counted twice. A task that loses its worker four times has failed (``distributed.scheduler.allowed-failures``).
    """
    try:
        dask: Any = import_module("distributed")
    except ImportError:
        raise ClerestoryError(
            "--scheduler needs the extra cluster, got no package distributed; pip install 'clerestory[cluster]'"
        ) from None
    is_file = scheduler.endswith(".json")
    try:
        client = dask.Client(
            **({"scheduler_file": scheduler} if is_file else {"address": scheduler}),
            timeout=CONNECT_S,
            set_as_default=False,
        )
    except (OSError, TimeoutError, ValueError) as cause:
        raise ClerestoryError(
            f"scheduler must be the address of a Dask scheduler, got {scheduler!r}: no answer within {CONNECT_S:g} s; "
            "start one with dask scheduler"
        ) from cause
    todo = deque(tasks)

    def submit(task: Task) -> Any:
        # tasks of the same name are one task to the scheduler, whoever asks
        return client.submit(do, task, key=f"clerestory-{task.key}", pure=True)

    try:
        first = [submit(todo.popleft()) for _ in range(min(IN_FLIGHT, len(todo)))]
        with client.as_current():
            queue = dask.as_completed(first)
        del first
        for future in queue:
            key = str(future.key).removeprefix("clerestory-")
            if future.status == "finished":
                yield future.result()
            elif future.status == "error":
                error = future.exception()
                told = f"{type(error).__name__}: {' '.join(str(error).split())}"
                if isinstance(error, dask.KilledWorker):
                    told = "its worker died four times; it may need more memory"
                yield Outcome(key=key, error=told)
            else:
                raise ClerestoryError(
                    f"scheduler {scheduler!r} must answer until the study is done, got {future.status}; what is "
                    "finished is kept, run again to go on"
                )
            future.release()
            if todo:
                queue.add(submit(todo.popleft()))
    except (OSError, dask.CancelledError) as cause:
        raise ClerestoryError(
            f"scheduler {scheduler!r} must answer until the study is done, got: {cause}; what is finished is kept, run "
            "again to go on"
        ) from cause
    finally:
        client.close(timeout=5.0)
