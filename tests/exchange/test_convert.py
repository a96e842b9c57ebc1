"""The command `convert`: files in, files out."""

import numpy as np
import pytest
from tests.exchange.model import model
from tests.exchange.test_hbjson import written
from tests.exchange.test_results import annual
from typer.testing import CliRunner

from clerestory import daylight_coefficients, read_room, save
from clerestory.cli import app
from clerestory.exchange import read_hbjson, read_matrix


def run(*words):
    return CliRunner().invoke(app, ["convert", *map(str, words)])


def test_a_model_becomes_a_room_file_that_is_the_same_room(tmp_path):
    source = written(tmp_path, model())
    assert run(source, tmp_path / "small.toml", "--room", "office").exit_code == 0
    assert read_room(tmp_path / "small.toml") == read_hbjson(source, room="office")


def test_results_become_files_by_the_ending_of_the_target(tmp_path):
    save(annual(), tmp_path / "year.nc")
    coefficients = daylight_coefficients(read_hbjson(written(tmp_path, model())), basis="tregenza145", rounds=2)
    save(coefficients, tmp_path / "c.nc")
    for words in (
        ("year.nc", "year.ill"),
        ("year.nc", "results"),
        ("c.nc", "c.pts"),
        ("c.nc", "c.mtx", "--form", "double"),
    ):
        done = run(tmp_path / words[0], tmp_path / words[1], *words[2:])
        assert done.exit_code == 0, done.output
        assert words[1] in done.output
    assert (tmp_path / "results" / "grids_info.json").is_file()
    total = sum(coefficients[part].sum().item() for part in ("direct", "redirected", "interreflected"))
    assert read_matrix(tmp_path / "c.mtx")[..., 0].sum() == pytest.approx(total, rel=1e-12)
    assert np.loadtxt(tmp_path / "c.pts").shape == (9, 6)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("year.nc", "year.xls"), "target must end in .toml, .ill, .pts, .mtx or nothing"),
        (("none.nc", "year.ill"), "must be a result in NetCDF"),
        (("year.nc", "year.mtx"), "must be over tregenza145 or a reinhart basis"),
        (("year.nc", "results", "--form", "text"), "form must be one of npy, ill, got 'text'"),
    ],
)
def test_mistakes_are_one_line(tmp_path, words, said):
    save(annual(), tmp_path / "year.nc")
    done = run(tmp_path / words[0], tmp_path / words[1], *words[2:])
    assert done.exit_code == 2
    assert said in done.stderr
    assert done.stderr.count("\n") == 1
