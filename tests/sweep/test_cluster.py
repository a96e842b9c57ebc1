"""A real Dask scheduler and workers on loopback, one of them killed half way."""

import socket
import subprocess
import sys

import pytest
import xarray as xr
from tests.sweep.studies import slow

from clerestory.errors import ClerestoryError
from clerestory.sweep import gather, run_sweep
from clerestory.sweep.panel_case import evaluate
from clerestory.sweep.plan import sweep_of

pytest.importorskip("distributed")


@pytest.fixture
def cluster():
    """Address of a scheduler, and its two workers."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"tcp://127.0.0.1:{port}"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    python = [sys.executable, "-m"]
    scheduler = [
        *python,
        "distributed.cli.dask_scheduler",
        "--host",
        "127.0.0.1",
        "--port",
        str(port),
        "--no-dashboard",
    ]
    worker = [*python, "distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard"]
    begun = [subprocess.Popen(words, **quiet) for words in (scheduler, worker, worker)]
    yield address, begun[1:]
    for process in begun[::-1]:
        process.kill()
        process.wait(timeout=20)


def test_a_worker_killed_half_way_loses_nothing_and_counts_nothing_twice(tmp_path, cluster):
    address, workers = cluster
    study = sweep_of(slow(10, rays=30_000), name="slow.toml")
    told = []

    def kill_one(tally):
        told.append(tally.computed)
        if tally.computed == 3:
            workers[0].kill()

    tally = run_sweep(study, tmp_path, scheduler=address, progress=kill_one)
    assert tally.failures == []
    assert workers[0].wait(timeout=20) != 0
    assert told == list(range(1, 11)), "each case is counted once"
    assert (tally.computed, tally.failed, tally.left) == (10, 0, 0)
    found = gather(study, tmp_path)
    for case in study.cases:
        alone = evaluate(case.tables)
        there = found.isel(case=case.number).transmittance
        xr.testing.assert_equal(there.drop_vars(["case", "key", "status", "seed"]), alone.transmittance)


def test_no_scheduler_is_told_with_what_to_do(tmp_path, monkeypatch):
    monkeypatch.setattr("clerestory.sweep.cluster.CONNECT_S", 0.3)
    with pytest.raises(ClerestoryError, match="start one with dask scheduler"):
        run_sweep(sweep_of(slow(1, rays=10), name="s.toml"), tmp_path, scheduler="tcp://127.0.0.1:1")
