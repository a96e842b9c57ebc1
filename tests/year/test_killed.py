"""A year that is killed or stopped leaves nothing that reads as whole, and goes on where it was."""

import os
import re
import signal
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from tests.year.small import write_small
from typer.testing import CliRunner

from clerestory.cli import app
from clerestory.year import read_year, run_year

#: Says when a piece is kept. Whoever runs the tests in the background may have had Ctrl-C ignored.
RUN = """
import signal, sys
from clerestory.cli import app
from clerestory.year import run
signal.signal(signal.SIGINT, signal.default_int_handler)
keep = run._keep
def kept(*words):
    keep(*words)
    print("kept", flush=True)
run._keep = kept
app(["year", sys.argv[1], "--out", sys.argv[2]])
"""


def pieces(out):
    return sorted(path for path in (out / "pieces").rglob("*.nc") if not path.parent.name.startswith("."))


def begun(path, out):
    """A year in a process of its own that has just kept its first piece."""
    running = subprocess.Popen(
        [sys.executable, "-c", RUN, str(path), str(out)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert running.stdout.readline() == "kept\n", running.stderr.read()
    return running


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signals")
def test_killed_in_the_middle_it_goes_on(tmp_path):
    path, out = write_small(tmp_path), tmp_path / "out"
    running = begun(path, out)
    running.kill()
    running.communicate()
    kept = pieces(out)
    assert kept
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


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such signals")
def test_ctrl_c_says_how_far_it_was_and_the_same_command_goes_on(tmp_path):
    path, out = write_small(tmp_path), tmp_path / "out"
    running = begun(path, out)
    running.send_signal(signal.SIGINT)
    _, said = running.communicate()
    assert running.returncode == 130, said
    assert re.search(
        r"clerestory: stopped with [1-9]\d? % done; finished pieces are in .*, the same command goes on", said
    )
    assert "Traceback" not in said
    assert not (out / "report.html").exists()
    kept = {piece: piece.stat().st_mtime_ns for piece in pieces(out)}
    assert kept
    again = CliRunner().invoke(app, ["year", str(path), "--out", str(out)])
    assert again.exit_code == 0, again.output
    assert (out / "report.html").is_file()
    assert {piece: piece.stat().st_mtime_ns for piece in kept} == kept, "a finished piece was traced again"


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
