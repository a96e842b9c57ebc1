"""A study run, stopped, killed and run again: no case is lost, repeated or half written."""

import json
import multiprocessing
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import tomli_w
import xarray as xr
from tests.sweep.studies import quick, slow
from typer.testing import CliRunner

from clerestory.cli import app
from clerestory.errors import ClerestoryError
from clerestory.sweep import as_grid, gather, run_sweep, work
from clerestory.sweep.gather import write_zarr
from clerestory.sweep.local import in_processes
from clerestory.sweep.panel_case import evaluate
from clerestory.sweep.plan import sweep_of
from clerestory.sweep.store import Store

#: Whoever runs the tests in the background may have had Ctrl-C ignored.
HEARS = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
COMMAND = [sys.executable, "-c", f"{HEARS}; from clerestory.cli import app; app()", "sweep"]


def test_each_case_is_what_its_kind_finds_and_a_failed_one_stops_no_other(tmp_path):
    tally = run_sweep(quick(), tmp_path, workers=0)
    assert (tally.computed, tally.failed, tally.left) == (5, 1, 0)
    assert "cut_width_mm must be smaller than spacing_mm (3), got 3.5" in tally.failures[0]["error"]
    found = gather(quick(), tmp_path)
    assert found["status"].values.tolist() == ["done", "done", "failed", "done", "done", "done"]
    assert np.isnan(found.mean_transmittance[2])
    for case in quick().cases:
        if case.number != 2:
            alone = evaluate(case.tables)
            assert found.mean_transmittance[case.number] == alone.mean_transmittance
    report = json.loads((tmp_path / "failed" / f"{quick().cases[2].key}.json").read_text())
    assert report["values"] == quick().rows[2]


def test_a_finished_case_is_never_repeated(tmp_path, monkeypatch):
    run_sweep(quick(), tmp_path, workers=0)
    store = Store(tmp_path)
    store.remove(quick().cases[3].key)
    done = []
    whole = work.evaluate

    def counted(kind, tables, where):
        done.append(tables)
        return whole(kind, tables, where=where)

    monkeypatch.setattr(work, "evaluate", counted)
    tally = run_sweep(quick(), tmp_path, workers=0)
    assert (tally.done_before, tally.computed, tally.failed) == (4, 1, 1)
    # the one that was removed, and the one that failed is tried again
    assert [tables["panel"] for tables in done] == [quick().cases[k].tables["panel"] for k in (2, 3)]


def test_the_same_case_twice_is_computed_once(tmp_path):
    twice = sweep_of(slow(1, rays=100) | {"parameters": {"light.seed": [7, 7]}}, name="twice.toml")
    assert run_sweep(twice, tmp_path, workers=0).computed == 1
    assert gather(twice, tmp_path).sizes["case"] == 2


def test_a_process_that_is_killed_takes_no_case_with_it(tmp_path):
    study = sweep_of(slow(6, rays=30_000), name="slow.toml")
    killed = []

    def kill_one(tally):
        if tally.computed == 2:
            victim = multiprocessing.active_children()[0]
            victim.kill()
            killed.append(victim.pid)

    tally = run_sweep(study, tmp_path, workers=2, progress=kill_one)
    assert killed
    assert (tally.computed, tally.failed, tally.left) == (6, 0, 0)
    alone = evaluate(study.cases[5].tables)
    there = gather(study, tmp_path).transmittance[5].drop_vars(["case", "key", "status", "seed"])
    xr.testing.assert_equal(there, alone.transmittance)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signals")
@pytest.mark.parametrize(("sent", "code"), [(signal.SIGINT, 130), (signal.SIGKILL, -9)])
def test_whatever_ends_a_run_what_is_there_is_whole_and_the_next_goes_on(tmp_path, sent, code):
    path = tmp_path / "slow.toml"
    path.write_text(tomli_w.dumps(slow(8, rays=60_000)))
    out = tmp_path / "out"
    words = [*COMMAND, str(path), "--out", str(out), "--workers", "2", "--json"]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
    deadline = time.monotonic() + 240.0
    while not list((out / "cases").glob("*.nc")):
        assert time.monotonic() < deadline, "no case was done"
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.01)
    process.send_signal(sent)
    process.wait(timeout=240)
    assert process.returncode == code
    whole = sorted((out / "cases").glob("*.nc"))
    assert 1 <= len(whole) < 8
    for one in whole:
        with xr.open_dataset(one) as found:
            assert found.load().transmittance.notnull().all()
    written = {one: one.stat().st_mtime_ns for one in whole}
    done = subprocess.run([*words[:-2], "0", "--json"], capture_output=True, text=True, timeout=600, check=True)
    tally = json.loads(done.stdout)
    assert tally["done_before"] >= len(whole)
    assert tally["done_before"] + tally["computed"] == 8
    assert {one: one.stat().st_mtime_ns for one in whole} == written, "a finished case was written again"


def test_other_files_than_the_study_began_with_are_refused(tmp_path):
    panel = tmp_path / "panel.toml"
    panel.write_text('kind = "pane"\nthickness_mm = 4\n')
    tables = {
        "kind": "panel",
        "base": {"panel": {"file": "panel.toml"}, "light": {}},
        "parameters": {"light.tilt_deg": [0]},
    }
    study = sweep_of(tables, where=tmp_path, name="s.toml")
    assert study.cases
    panel.write_text('kind = "pane"\nthickness_mm = 5.5\n')
    tally = run_sweep(study, tmp_path / "out", workers=0)
    assert "as they were when it began" in tally.failures[0]["error"]


def test_a_worker_with_another_program_is_refused():
    case = quick().cases[0]
    task = work.Task(key=case.key, kind=case.kind, tables=case.tables, files={}, where=".")
    assert work.work(task).content is not None
    task.program["version"] = "0.0.1"
    assert "install one version everywhere" in work.work(task).error
    task.program["version"] = work.build()["version"]


def test_results_are_one_dataset_and_a_grid(tmp_path):
    run_sweep(quick(), tmp_path, workers=0)
    found = gather(quick(), tmp_path)
    written = write_zarr(found, tmp_path / "results.zarr")
    write_zarr(found, written)
    with xr.open_zarr(written, consolidated=False) as read:
        np.testing.assert_array_equal(read.transmittance.values, found.transmittance.values)
        assert read["status"].values.tolist() == found["status"].values.tolist()
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith(".")] == []
    grid = as_grid(found, "spacing_mm", "cut_width_mm")
    assert grid.mean_transmittance.sel(spacing_mm=4.0, cut_width_mm=0.5) == found.mean_transmittance[4]
    with pytest.raises(ClerestoryError, match="must tell all cases apart, got 2 of 6"):
        as_grid(found, "spacing_mm")


def test_the_command_lists_runs_and_tells(tmp_path: Path):
    path = tmp_path / "quick.toml"
    study = quick()
    tables = {"kind": "panel", "base": study.base, "parameters": {"panel.spacing_mm": [3.0, -4.0]}}
    path.write_text(tomli_w.dumps(tables))

    def run(*words):
        return CliRunner().invoke(app, ["sweep", str(path), "--out", str(tmp_path / "out"), "--workers", "0", *words])

    listed = run("--dry-run", "--json")
    assert listed.exit_code == 0
    assert [row["done"] for row in json.loads(listed.stdout)["cases"]] == [False, False]
    assert not (tmp_path / "out").exists()
    told = run()
    assert told.exit_code == 1, "a failed case is told by the exit code"
    assert "1 computed" in told.stdout
    assert "spacing_mm = -4.0" in told.stdout
    assert {"results.zarr", "results.csv", "summary.json"} <= {one.name for one in (tmp_path / "out").iterdir()}
    rows = [line for line in (tmp_path / "out" / "results.csv").read_text().splitlines() if not line.startswith("#")]
    assert len(rows) == 3
    path.write_text("kind = 'pannel'\n")
    wrong = run()
    assert wrong.exit_code == 2
    assert "did you mean 'panel'?" in wrong.stderr
    assert wrong.stderr.count("\n") == 1


class Deadly:
    """A task that ends the process that is given it."""

    key = "deadly"

    def __reduce__(self):
        return os._exit, (1,)


def test_a_case_that_kills_its_process_each_time_has_failed_and_the_others_are_done():
    case = quick().cases[0]
    tasks = [Deadly(), work.Task(key=case.key, kind=case.kind, tables=case.tables, files={}, where=".")]
    outcomes = {outcome.key: outcome for outcome in in_processes(tasks, 2)}
    assert "its process died 3 times" in outcomes["deadly"].error
    assert outcomes[case.key].error is None
