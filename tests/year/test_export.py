"""A year as files of other programs: what they hold is the light that was kept, blinds open."""

import json

import numpy as np
import pytest
from tests.year.small import YEAR, write_small
from typer.testing import CliRunner

from clerestory import daylight_coefficients
from clerestory.cli import app
from clerestory.coefficients import PARTS
from clerestory.errors import ClerestoryError
from clerestory.exchange import read_ill, read_matrix, read_pts
from clerestory.year import EXPORTS, export_year, read_year, run_year
from clerestory.year.export import light_of


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    folder = tmp_path_factory.mktemp("year")
    study = read_year(write_small(folder))
    return study, run_year(study, folder / "out"), folder / "out"


def test_every_form_holds_the_light_of_its_variant(small):
    study, results, out = small
    written = export_year(study, out, EXPORTS)
    assert all(path.is_file() for path in written)
    assert {path.relative_to(out).parts[:2] for path in written} == {
        ("export", name) for name in ("glass", "panel_above", "dark")
    }
    for label, folder in zip(study.variants, ("glass", "panel_above", "dark"), strict=True):
        place = out / "export" / folder
        light = light_of(study, out, label)
        assert float(light.total.max()) > 1000.0
        # nobody closes blinds here
        as_used = results[label]["illuminance"].values
        assert (light.total.values >= as_used - 1e-3 * light.total.values.max()).all()
        assert light.total.values.sum() > 1.05 * as_used.sum()
        np.testing.assert_allclose(read_ill(place / "year.ill").values, light.total.values, atol=0.051)
        np.testing.assert_allclose(read_matrix(place / "year.mtx")[..., 0], light.total.values, rtol=1e-6)
        np.testing.assert_allclose(read_pts(place / "year.pts").points_m[:, 0], light.x_m, atol=1e-8)
        totals = np.load(place / "ladybug/__static_apertures__/default/total/floor.npy")
        direct = np.load(place / "ladybug/__static_apertures__/default/direct/floor.npy")
        hours = [float(line) for line in (place / "ladybug/sun-up-hours.txt").read_text().split()]
        lit = np.flatnonzero(light.total.values.max(axis=0) > 0.0)
        assert totals.shape == direct.shape == (15, len(lit)) == (15, len(hours))
        np.testing.assert_allclose(totals, light.total.values[:, lit], rtol=1e-6)
        np.testing.assert_allclose(direct, (light.sun_direct + light.sun_redirected).values[:, lit], rtol=1e-6)
        assert direct.max() > 0.0
    own = daylight_coefficients(
        study.variants["dark"], basis="tregenza145", rounds=4, nodes=256, window_samples=32, seed=3
    )
    found = read_matrix(out / "export/dark/coefficients.mtx")[..., 0]
    assert found.sum() == pytest.approx(sum(own[part].sum().item() for part in PARTS), rel=1e-6)


def test_the_command_exports_what_is_asked_and_traces_nothing_again(small):
    _, _, out = small
    pieces = {path: path.stat().st_mtime_ns for path in (out / "pieces").rglob("*.nc")}
    words = ["year", str(out.parent / "year.toml"), "--out", str(out), "--json"]
    done = CliRunner().invoke(app, [*words, "--export", "ill", "--export", "pts"])
    assert done.exit_code == 0, done.output
    files = json.loads(done.stdout)["files"]
    assert [name for name in files if "export" in name] == [
        str(out / "export" / variant / f"year.{form}")
        for variant in ("glass", "panel_above", "dark")
        for form in ("ill", "pts")
    ]
    assert pieces == {path: path.stat().st_mtime_ns for path in (out / "pieces").rglob("*.nc")}


def test_what_cannot_be_exported_is_told_before_any_work(tmp_path):
    path = write_small(tmp_path, YEAR.replace("[calculation]", '[calculation]\nbasis = "troplux5221"'))
    for form, said in (
        ("xls", "export must be one of ill, mtx, pts, ladybug, coefficients, got 'xls'"),
        ("coefficients", "basis must be tregenza145 or a reinhart basis"),
    ):
        done = CliRunner().invoke(app, ["year", str(path), "--out", str(tmp_path / "out"), "--export", form])
        assert (done.exit_code, done.stderr.count("\n")) == (2, 1), done.stderr
        assert said in done.stderr
    assert not (tmp_path / "out").exists()
    study = read_year(write_small(tmp_path))
    with pytest.raises(ClerestoryError, match="must hold all light of 'glass', got no"):
        export_year(study, tmp_path, ["ill"])
