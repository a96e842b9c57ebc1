"""A year that is killed or stopped leaves nothing that reads as whole, and goes on where it was."""

import os
import signal
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from tests.year.small import write_small

from clerestory.year import read_year, run_year

RUN = """
import sys
from clerestory.cli import app
app(["year", sys.argv[1], "--out", sys.argv[2], "--json"])
"""


def pieces(out):
    return sorted(path for path in (out / "pieces").rglob("*.nc") if not path.parent.name.startswith("."))


def wait_for(condition, seconds):
    until = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < until, "nothing was kept in time"
        time.sleep(0.02)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signals")
def test_killed_in_the_middle_it_goes_on(tmp_path):
    path, out = write_small(tmp_path), tmp_path / "out"
    running = subprocess.Popen([sys.executable, "-c", RUN, str(path), str(out)], stderr=subprocess.PIPE)
    try:
        wait_for(lambda: pieces(out), 120)
    finally:
        running.send_signal(signal.SIGKILL)
        running.wait()
    kept = pieces(out)
    assert not (out / "year.nc").exists()
    assert not (out / "report.html").exists()
    before = {}
    for piece in kept:
        with xr.open_dataset(piece) as whole:
            assert whole.attrs["key"] == piece.stem
            before[piece] = (piece.stat().st_mtime_ns, float(whole["total"].sum()))
    told = []
    found = run_year(read_year(path), out, told.append)
    # what was finished counts as done from the start, and is not traced again
    assert told[0].done >= len(kept) / 5
    assert all(piece.stat().st_mtime_ns == stamp for piece, (stamp, _) in before.items())
    fresh = run_year(read_year(path))
    for label in fresh:
        np.testing.assert_array_equal(found[label]["illuminance"], fresh[label]["illuminance"])


def test_stopped_by_its_follower_it_keeps_finished_pieces(tmp_path):
    study, out = read_year(write_small(tmp_path)), tmp_path / "out"
    with pytest.raises(KeyboardInterrupt):
        run_year(study, out, lambda state: state.done < 0.3)
    kept = pieces(out)
    assert len(kept) == 1
    # another seed is another piece
    other = replace(study, calculation=replace(study.calculation, seed=9))
    with pytest.raises(KeyboardInterrupt):
        run_year(other, out, lambda state: state.done < 0.3)
    assert len(pieces(out)) == 2
    assert kept[0] in pieces(out)


def test_a_draft_is_no_piece(tmp_path):
    study, out = read_year(write_small(tmp_path)), tmp_path / "out"
    with pytest.raises(KeyboardInterrupt):
        run_year(study, out, lambda state: state.done < 0.3)
    (piece,) = pieces(out)
    # cut in half under the name that a draft has while it is written
    draft = piece.parent / f".{piece.name}.abc" / piece.name
    draft.parent.mkdir()
    draft.write_bytes(piece.read_bytes()[: piece.stat().st_size // 2])
    piece.unlink()
    told = []
    with pytest.raises(KeyboardInterrupt):
        run_year(study, out, lambda state: told.append(state) or state.done < 0.1)
    assert told[0].done < 0.1
