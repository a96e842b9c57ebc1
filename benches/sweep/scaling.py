"""How parameter studies scale: measured with one and two workers, reckoned for a hundred; writes docs/scaling.md."""

from __future__ import annotations

import math
import os
import platform
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import psutil

from clerestory import __version__
from clerestory.sweep import gather, run_sweep
from clerestory.sweep.cluster import on_cluster
from clerestory.sweep.gather import write_zarr
from clerestory.sweep.plan import Sweep, sweep_of
from clerestory.sweep.store import Store
from clerestory.sweep.work import Outcome, Task
from clerestory.sweep.work import work as real_work

ROOT = Path(__file__).parents[2]
CASES, RAYS, REPEATS = 16, 100_000, 3
TASKS = 2000
PAYLOAD = 64 * 1024


def study(cases: int, rays: int) -> Sweep:
    """Panels followed by rays: cases of one length that need no file and one thread."""
    panel = {"kind": "laser-cut", "spacing_mm": 4.0, "thickness_mm": 6.0, "medium": {"n": 1.49}}
    light = {"elevation_deg": [30, 50], "method": "monte_carlo", "rays": rays}
    seeds = {"light.seed": {"range": {"start": 1, "stop": cases, "step": 1}}}
    return sweep_of(
        {"kind": "panel", "base": {"panel": panel, "light": light}, "parameters": seeds}, name="scaling.toml"
    )


class Watch:
    """Wall and CPU time of the processes that do a study, from case to case: their start is left out."""

    def __init__(self, processes: Callable[[], list[psutil.Process]]) -> None:
        self.processes = processes
        self.wall: list[float] = []
        self.cpu: list[float] = []

    def __call__(self, _: object) -> None:
        self.wall.append(time.perf_counter())
        self.cpu.append(sum(cpu(one) for one in self.processes()))

    def seconds(self, workers: int) -> tuple[float, float]:
        """Wall seconds of all cases and CPU seconds of one, once every worker has done its first."""
        first, count = workers - 1, CASES - workers
        return (self.wall[-1] - self.wall[first]) / count * CASES, (self.cpu[-1] - self.cpu[first]) / count


def local(workers: int) -> tuple[float, float]:
    """Wall seconds of the study and CPU seconds of a case, in processes of this machine."""
    watch = Watch(lambda: psutil.Process().children())
    with tempfile.TemporaryDirectory() as folder:
        run_sweep(study(CASES, RAYS), folder, workers=workers, progress=watch)
    return watch.seconds(workers)


@contextmanager
def cluster(workers: int) -> Iterator[tuple[str, list[psutil.Process]]]:
    """A scheduler and its workers on loopback: address, and the processes, the scheduler first."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"tcp://127.0.0.1:{port}"
    python = [sys.executable, "-m"]
    scheduler = [*python, "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", str(port)]
    worker = [*python, "distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard"]
    environment = os.environ | {"RAYON_NUM_THREADS": "1"}
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "env": environment}
    begun = [subprocess.Popen(words, **quiet) for words in (scheduler, *[worker] * workers)]
    try:
        yield address, [psutil.Process(one.pid) for one in begun]
    finally:
        for one in begun[::-1]:
            one.kill()
            one.wait()


def cpu(process: psutil.Process) -> float:
    times = process.cpu_times()
    return float(times.user + times.system)


def nothing(task: Task) -> Outcome:
    """No work, and a result of so many bytes."""
    return Outcome(key=task.key, content=os.urandom(task.tables["payload"]))


def overhead(payload: int) -> dict[str, float]:
    """CPU milliseconds that a task without work costs scheduler, worker and client, and wall milliseconds."""
    empty = Task(key="", kind="panel", tables={"payload": payload}, files={}, where=str(ROOT))
    tasks = [Task(**(vars(empty) | {"key": f"{payload}-{number:06d}"})) for number in range(TASKS)]
    with cluster(2) as (address, processes):
        list(on_cluster([Task(**(vars(empty) | {"key": f"warm-{n}"})) for n in range(20)], address, nothing))
        before, began = [cpu(one) for one in [*processes, psutil.Process()]], time.perf_counter()
        done = list(on_cluster(tasks, address, nothing))
        wall = time.perf_counter() - began
        spent = [cpu(one) - was for one, was in zip([*processes, psutil.Process()], before, strict=True)]
    assert len({outcome.key for outcome in done}) == TASKS
    scheduler, *workers, client = (1e3 * seconds / TASKS for seconds in spent)
    return {"scheduler": scheduler, "worker": sum(workers), "client": client, "wall": 1e3 * wall / TASKS}


def on_dask(workers: int) -> tuple[float, float]:
    """Wall seconds of the study and CPU seconds of a case, on Dask workers; the workers' alone."""
    with cluster(workers) as (address, processes), tempfile.TemporaryDirectory() as folder:
        # workers load what they need with their first tasks
        run_sweep(study(8 * workers, 1000), folder, scheduler=address)
        watch = Watch(lambda: processes[1:])
        run_sweep(study(CASES, RAYS), folder, scheduler=address, progress=watch)
    return watch.seconds(workers)


def bookkeeping() -> dict[str, float]:
    """CPU milliseconds a case costs the command itself: its hash, its file, its place in the gathered results."""
    outcome, asked = real_work(_first(study(1, 2))), study(400, 2)
    with tempfile.TemporaryDirectory() as folder:
        began = time.process_time()
        cases = asked.cases
        hashed = time.process_time()
        store = Store(Path(folder))
        for case in cases:
            store.put(case.key, outcome.content or b"")
        kept = time.process_time()
        write_zarr(gather(asked, folder), Path(folder) / "results.zarr")
        gathered = time.process_time()
    each = 1e3 / len(cases)
    return {"hash": each * (hashed - began), "keep": each * (kept - hashed), "gather": each * (gathered - kept)}


def _first(asked: Sweep) -> Task:
    case = asked.cases[0]
    return Task(key=case.key, kind=case.kind, tables=case.tables, files=case.files, where=str(ROOT))


def reckoned(cases: int, workers: int, seconds: float, limits_ms: dict[str, float]) -> tuple[float, str]:
    """Wall seconds until a study is done and what limits it: the workers, or the busier of scheduler and command."""
    rounds = math.ceil(cases / workers) * seconds
    ceilings = {name: cases * each / 1e3 for name, each in limits_ms.items()}
    name = max(ceilings, key=lambda one: ceilings[one])
    return (ceilings[name], name) if ceilings[name] > rounds else (rounds, "workers")


def page() -> str:
    """The whole of docs/scaling.md."""
    # one thread a worker, as on a cluster
    os.environ["RAYON_NUM_THREADS"] = "1"
    ways = {"processes of this machine": local, "Dask on loopback": on_dask}
    timed = {way: [_best(how, workers) for workers in (1, 2)] for way, how in ways.items()}
    small, large, own = overhead(0), overhead(PAYLOAD), bookkeeping()
    load, system = os.getloadavg()[0], f"{platform.system()}, Python {platform.python_version()}"
    limits = {"scheduler": large["scheduler"], "command": large["client"] + own["keep"]}
    lines = [
        "# How studies scale",
        "",
        f"Written by `python benches/sweep/scaling.py`, a part of `make bench`: Clerestory {__version__},",
        f"{os.cpu_count()} cores, {system}, load {load:.1f} while it ran. Where the load is more than the cores, other",
        "programs ran too: wall times and *times faster* then tell more of them than of the study, and only CPU holds.",
        "",
        "## Measured",
        "",
        f"{CASES} cases of one length, one thread a worker, the start of the processes left out, the best of {REPEATS}",
        "runs. The CPU of a Dask worker has its upkeep in it (heartbeats, monitors), which grows with the time that a",
        "case takes.",
        "",
        "| | 1 worker | 2 workers | times faster | CPU a case, 1 worker | 2 workers |",
        "|---|---|---|---|---|---|",
    ]
    for way, ((one, cpu_one), (two, cpu_two)) in timed.items():
        lines.append(f"| {way} | {one:.2f} s | {two:.2f} s | {one / two:.2f} | {cpu_one:.3f} s | {cpu_two:.3f} s |")
    lines += [
        "",
        f"What a case costs besides its work: {TASKS} tasks that do nothing, two Dask workers on loopback,",
        "milliseconds:",
        "",
        f"| | no result | a result of {PAYLOAD // 1024} KiB |",
        "|---|---|---|",
    ]
    for name, told in (("scheduler", "scheduler, CPU"), ("client", "the command, CPU"), ("worker", "worker, CPU")):
        lines.append(f"| {told} | {small[name]:.2f} | {large[name]:.2f} |")
    lines += [
        f"| wall, all on this machine | {small['wall']:.2f} | {large['wall']:.2f} |",
        "",
        f"Besides, the command takes {own['hash']:.2f} ms of CPU to hash a case, {own['keep']:.2f} to keep its",
        f"file, and {own['gather']:.2f} to gather it at the end.",
        "",
        "## Reckoned: 10 000 cases",
        "",
        "N cases of t seconds each on W workers take the longest of three: ⌈N / W⌉ · t of the workers,",
        f"N · {limits['scheduler']:.2f} ms of the scheduler, and N · {limits['command']:.2f} ms of the command,",
        f"which receives and keeps the results; and then N · {own['gather']:.2f} ms to gather them.",
        "",
        "| a case | workers | the study takes | of the workers' time used | the limit |",
        "|---|---|---|---|---|",
    ]
    for seconds, what in ((0.1, "a panel"), (10.0, "a room"), (60.0, "a year")):
        for workers in (1, 2, 10, 100, 1000):
            wall, limit = reckoned(10_000, workers, seconds, limits)
            wall += 10.0 * own["gather"]
            share = 10_000 * seconds / workers / wall
            lines.append(f"| {what}, {seconds:g} s | {workers} | {_time(wall)} | {share:.0%} | {limit} |")
    lines += ["", "So many workers can be fed before more are of no use:", ""]
    lines += ["| a case takes | by the scheduler | by the command |", "|---|---|---|"]
    for seconds in (0.1, 1.0, 10.0, 60.0):
        counts = (1e3 * seconds / limits[name] for name in ("scheduler", "command"))
        lines.append(f"| {seconds:g} s | " + " | ".join(f"{count:.0f}" for count in counts) + " |")
    lines += [
        "",
        "Cases of less than a tenth of a second are better run on one machine. Cases of unequal length lose up to the",
        "longest at the end; a room with very many sensors is then better split (`sensors_per_task`).",
        "",
    ]
    return "\n".join(lines)


def _best(how: Callable[[int], tuple[float, float]], workers: int) -> tuple[float, float]:
    found = [how(workers) for _ in range(REPEATS)]
    return min(wall for wall, _ in found), min(spent for _, spent in found)


def _time(seconds: float) -> str:
    if seconds < 90.0:
        return f"{seconds:.0f} s"
    return f"{seconds / 60.0:.0f} min" if seconds < 5400.0 else f"{seconds / 3600.0:.1f} h"


def main() -> None:
    target = ROOT / "docs" / "scaling.md"
    draft = target.with_suffix(".part")
    draft.write_text(page(), encoding="utf-8")
    draft.replace(target)
    print(f"written: {target.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
