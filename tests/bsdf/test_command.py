"""``clerestory bsdf``: the API's answers, one line for a mistake."""

import json
from pathlib import Path

import numpy as np
import pytest
from tests.bsdf.elements import uneven_bsdf, uneven_tree_bsdf
from typer.testing import CliRunner

from clerestory import LaserCutPanel, read_bsdf
from clerestory.bsdf import read_radiance_matrix
from clerestory.cli import app


def run(*words: object):
    return CliRunner().invoke(app, ["bsdf", *map(str, words)])


@pytest.fixture
def xml(tmp_path: Path) -> Path:
    return uneven_bsdf("klems_quarter").to_xml(tmp_path / "element.xml")


def test_check_tells_and_ends_with_1_for_an_error(xml: Path) -> None:
    good = run("check", xml)
    assert good.exit_code == 0
    assert "reciprocity" in good.stdout
    text = xml.read_text()
    xml.write_text(text.replace("<ScatteringData>\n", "<ScatteringData>\n-", 1))
    bad = run("check", xml, "--json")
    assert bad.exit_code == 1
    assert json.loads(bad.stdout)[0]["severity"] == "error"
    assert "1 of 1681 values are negative" in json.loads(bad.stdout)[0]["text"]


def test_info_gives_the_shares(xml: Path) -> None:
    found = json.loads(run("info", xml, "--json").stdout)
    block = read_bsdf(xml).visible.transmission_front
    assert found["bands"]["visible"]["transmission_front"]["mean"] == pytest.approx(block.mean())
    plain = run("info", xml).stdout
    assert "Uneven & <odd> by Nobody, 6.5 mm" in plain
    assert f"{block.mean():.4f}" in plain


def test_convert_changes_format_basis_and_name(xml: Path, tmp_path: Path) -> None:
    assert run("convert", xml, tmp_path / "a.nc", "--name", "another", "--thickness-mm", "4").exit_code == 0
    turned = read_bsdf(tmp_path / "a.nc")
    assert (turned.name, turned.thickness_mm) == ("another", 4.0)
    assert run("convert", tmp_path / "a.nc", tmp_path / "b.xml", "--basis", "klems_half").exit_code == 0
    assert read_bsdf(tmp_path / "b.xml").visible.transmission_front.incident.name == "klems_half"
    assert run("convert", xml, tmp_path / "c.mtx", "--direction", "reflection_back", "--band", "solar").exit_code == 0
    np.testing.assert_allclose(
        read_radiance_matrix(tmp_path / "c.mtx").values, read_bsdf(xml).solar.reflection_back.values, rtol=1e-8
    )
    with_warning = run("convert", xml, tmp_path / "d.idf")
    assert with_warning.exit_code == 0
    assert "conductivity_w_mk" in with_warning.stderr
    assert "Construction:ComplexFenestrationState" in (tmp_path / "d.idf").read_text()


def test_a_tree_becomes_a_matrix(tmp_path: Path) -> None:
    xml = uneven_tree_bsdf(4).to_xml(tmp_path / "tree.xml")
    refused = run("convert", xml, tmp_path / "a.mtx")
    assert (refused.exit_code, refused.stderr.count("\n")) == (2, 1)
    assert run("convert", xml, tmp_path / "a.mtx", "--basis", "klems_quarter").exit_code == 0


def test_plot_writes_pictures(xml: Path, tmp_path: Path) -> None:
    found = json.loads(run("plot", xml, "--out", tmp_path / "out", "--json").stdout)
    names = {Path(path).name for path in found["written"]}
    assert {"bsdf_discs.png", "bsdf_cut.png", "bsdf_shares.svg"} <= names
    assert all(Path(path).stat().st_size > 5000 for path in found["written"])


@pytest.mark.parametrize(
    "words", [("info", "none.xml"), ("convert", "none.xml", "a.xml"), ("plot", "none.xml", "--elevation", "200")]
)
def test_a_mistake_is_one_line(words: tuple[str, ...]) -> None:
    result = run(*words)
    assert result.exit_code == 2
    assert result.stderr.startswith("clerestory: ")
    assert result.stderr.count("\n") == 1


def test_make_writes_a_panel_s_file(tmp_path: Path) -> None:
    panel = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0).to_toml(tmp_path / "panel.toml")
    found = json.loads(run("make", panel, "--basis", "klems_quarter", "--out", tmp_path / "a.xml", "--json").stdout)
    assert found["bands"]["visible"]["transmission_front"]["mean"] > 0.7
    bsdf = read_bsdf(tmp_path / "a.xml")
    assert [finding for finding in bsdf.check() if finding.severity != "note"] == []
    # light from above leaves upwards
    block = bsdf.visible.transmission_front
    high, low = (np.array([0.0, sign * np.sin(np.radians(36.0))]) for sign in (1.0, -1.0))
    assert block.at(low, high) > block.at(low, low)
    both = run("make", panel, "--basis", "klems_half", "--rank", "4", "--out", tmp_path / "b.xml")
    assert (both.exit_code, both.stderr.count("\n")) == (2, 1)
