"""A real Dask scheduler and workers on loopback, one of them killed half way."""

import json
import subprocess
import sys
import time

import pytest
import xarray as xr
from tests.sweep.studies import slow

from clerestory.errors import ClerestoryError
from clerestory.sweep import gather, run_sweep
from clerestory.sweep.panel_case import evaluate
from clerestory.sweep.plan import sweep_of

pytest.importorskip("distributed")


def address_in(file):
    """Of a scheduler by its file, None until it is there as a whole."""
    try:
        return json.loads(file.read_text())["address"]
    except (OSError, ValueError):
        return None


@pytest.fixture
def cluster(tmp_path):
    """Address of a scheduler, which it tells in a file, and its two workers."""
    told = tmp_path / "scheduler.json"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    python = [sys.executable, "-m"]
    scheduler = [
        *python,
        "distributed.cli.dask_scheduler",
        "--host",
        "127.0.0.1",
        "--port",
        "0",
        "--scheduler-file",
        str(told),
        "--no-dashboard",
    ]
    worker = [*python, "distributed.cli.dask_worker", "--scheduler-file", str(told)]
    worker += ["--nthreads", "1", "--no-nanny", "--no-dashboard"]
    begun = [subprocess.Popen(words, **quiet) for words in (scheduler, worker, worker)]
    while not (address := address_in(told)):
        assert begun[0].poll() is None, "the scheduler ended"
        time.sleep(0.05)
    yield address, begun[1:]
    for process in begun[::-1]:
        process.kill()
        process.wait(timeout=240)


def test_a_worker_killed_half_way_loses_nothing_and_counts_nothing_twice(tmp_path, cluster, monkeypatch):
    monkeypatch.setattr("clerestory.sweep.cluster.CONNECT_S", 240.0)
    address, workers = cluster
    study = sweep_of(slow(10, rays=30_000), name="slow.toml")
    told = []

    def kill_one(tally):
        told.append(tally.computed)
        if tally.computed == 3:
            workers[0].kill()

    tally = run_sweep(study, tmp_path, scheduler=address, progress=kill_one)
    assert tally.failures == []
    assert workers[0].wait(timeout=240) != 0
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
