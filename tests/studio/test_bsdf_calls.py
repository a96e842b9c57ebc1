"""What the studio says of a BSDF is what the API says."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from clerestory import Band, Bsdf, KlemsBlock, read_bsdf
from clerestory.bsdf.klems import klems_basis

BLINDS = Path(__file__).parents[1] / "data" / "bsdf" / "blinds_tensortree3.xml"


@pytest.fixture(scope="module")
def diffuser(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A matrix that sends half of all light everywhere alike."""
    count = len(klems_basis("klems_quarter"))
    block = KlemsBlock(np.full((count, count), 0.25 / np.pi), "klems_quarter", "klems_quarter")
    band = Band(block, block, block, block)
    path = tmp_path_factory.mktemp("bsdf") / "diffuser.xml"
    return Bsdf(name="Diffuser", visible=band, solar=band, thickness_mm=3.0).to_xml(path)


def test_a_dropped_file_is_told_as_the_api_tells_it(client: Any, diffuser: Path) -> None:
    for path in (BLINDS, diffuser):
        told = client.post(f"/api/bsdf?name={path.name}", content=path.read_bytes()).json()
        own = read_bsdf(path)
        assert told["name"] == own.name
        assert [one["text"] for one in told["findings"]] == [one.text for one in own.check()]
        for name, block in own.visible:
            assert told["bands"]["visible"][name]["mean"] == block.mean()


def test_discs_and_cuts_hold_the_values_of_the_blocks(client: Any, diffuser: Path) -> None:
    key = client.post("/api/bsdf?name=d.xml", content=diffuser.read_bytes()).json()["key"]
    look = {"key": key, "elevation_deg": 35.0, "azimuth_deg": -20.0, "side": "front", "band": "visible"}
    discs = client.post("/api/bsdf/discs", json=look).json()
    block = read_bsdf(diffuser).visible.transmission_front
    np.testing.assert_allclose(discs["incident"]["values"], block.hemispherical())
    assert [one["word"] for one in discs["outgoing"]] == ["Transmitted", "Reflected"]
    np.testing.assert_allclose(discs["outgoing"][0]["values"], block.values[:, discs["picked"]])
    assert discs["outgoing"][0]["share"] == pytest.approx(float(block.hemispherical()[discs["picked"]]))
    cut = client.post("/api/bsdf/cut", json=look | {"plane_deg": 30.0}).json()
    np.testing.assert_allclose(cut["curves"][0]["values"], 0.25 / np.pi, rtol=1e-6)


def test_a_point_of_a_disc_is_where_light_comes_from(client: Any, diffuser: Path) -> None:
    key = client.post("/api/bsdf?name=d.xml", content=diffuser.read_bytes()).json()["key"]
    for elevation, azimuth in ((40.0, 0.0), (-20.0, 55.0), (0.0, 0.0), (70.0, -80.0)):
        x, y = client.post(
            "/api/bsdf/discs", json={"key": key, "elevation_deg": elevation, "azimuth_deg": azimuth}
        ).json()["point"]
        back = client.post("/api/bsdf/incidence", json={"x": x, "y": y}).json()
        assert back["elevation_deg"] == pytest.approx(elevation, abs=0.05)
        assert back["azimuth_deg"] == pytest.approx(azimuth, abs=0.1)


def test_the_file_of_an_open_bsdf_is_the_same_again(client: Any, diffuser: Path, tmp_path: Path) -> None:
    key = client.post("/api/bsdf?name=d.xml", content=diffuser.read_bytes()).json()["key"]
    path = tmp_path / "again.xml"
    path.write_bytes(client.post("/api/bsdf/xml", json={"key": key}).content)
    again = read_bsdf(path).visible.transmission_front
    np.testing.assert_allclose(again.values, read_bsdf(diffuser).visible.transmission_front.values, rtol=1e-5)


def test_a_file_of_the_folder_is_opened_and_kept_by_its_content(client: Any) -> None:
    told = client.post("/api/bsdf/open", json={"path": "blinds.xml"}).json()
    again = client.post("/api/bsdf?name=other.xml", content=BLINDS.read_bytes()).json()
    assert told["key"] == again["key"]
    assert client.post("/api/bsdf/open", json={"key": told["key"]}).json()["name"] == told["name"]


def test_a_bad_file_is_refused_with_its_name_and_place(client: Any) -> None:
    text = BLINDS.read_text()
    for content, name in (
        (b"", "empty.xml"),
        (b"<html></html>", "page.xml"),
        (text[:5000].encode(), "cut.xml"),
        (b"<!DOCTYPE x [<!ENTITY a SYSTEM 'file:///etc/passwd'>]><x>&a;</x>", "entity.xml"),
        (b"\x00\x01" * 4000, "noise.nc"),
    ):
        answer = client.post(f"/api/bsdf?name={name}", content=content)
        assert answer.status_code == 422, name
        fault = answer.json()["errors"][0]
        assert fault["field"] == "file"
        assert name in fault["message"]
        assert "clerestory-" not in fault["message"]
        assert "root:" not in fault["message"]
    for name in ("x.exe", "", "..", "/etc/passwd"):
        assert client.post("/api/bsdf", params={"name": name}, content=b"x").status_code == 422


def test_a_file_whose_numbers_cannot_be_is_opened_and_found_wrong(client: Any, diffuser: Path) -> None:
    count = len(klems_basis("klems_quarter"))
    bright = KlemsBlock(np.full((count, count), 0.8 / np.pi), "klems_quarter", "klems_quarter")
    band = Band(bright, bright, bright, bright)
    path = diffuser.parent / "bright.xml"
    Bsdf(name="Bright", visible=band, solar=band, thickness_mm=3.0).to_xml(path)
    findings = client.post("/api/bsdf?name=b.xml", content=path.read_bytes()).json()["findings"]
    assert findings[0]["severity"] == "error"
    assert "more leaves than arrives" in findings[0]["text"]


def test_what_is_not_open_is_said_so(client: Any) -> None:
    for path in ("open", "discs", "cut", "xml"):
        answer = client.post(
            f"/api/bsdf/{path}", json={"key": "none", **({} if path in ("open", "xml") else {"elevation_deg": 0})}
        )
        assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, "key"), path


def test_the_curve_holds_the_shares_of_the_blocks(client: Any, diffuser: Path) -> None:
    key = client.post("/api/bsdf?name=d.xml", content=diffuser.read_bytes()).json()["key"]
    told = client.post("/api/bsdf/curve", json={"key": key, "azimuth_deg": 20.0}).json()
    assert [one["word"] for one in told["curves"]] == ["Transmitted", "Reflected"]
    assert len(told["elevation_deg"]) == len(told["curves"][0]["values"])
    np.testing.assert_allclose(told["curves"][0]["values"], 0.25, rtol=1e-6)


@pytest.mark.parametrize("ending", ["xml", "nc", "mtx", "epJSON", "idf"])
def test_a_bsdf_goes_out_as_every_kind_of_file(client: Any, diffuser: Path, tmp_path: Path, ending: str) -> None:
    key = client.post("/api/bsdf?name=d.xml", content=diffuser.read_bytes()).json()["key"]
    asked = {"key": key, "format": ending, "basis": "klems_full", "name": "Mine", "thickness_mm": 4.0}
    content = client.post("/api/bsdf/file", json=asked).content
    path = tmp_path / f"out.{ending}"
    path.write_bytes(content)
    if ending in ("xml", "nc"):
        again = read_bsdf(path)
        assert again.name == "Mine"
        assert again.visible.transmission_front.mean() == pytest.approx(0.25, rel=1e-4)
    else:
        assert {"mtx": b"NCOMP", "epJSON": b"Matrix", "idf": b"Matrix"}[ending] in content


def test_a_tree_is_turned_into_a_matrix_for_a_file_and_refused_without(client: Any) -> None:
    key = client.post("/api/bsdf/open", json={"path": "blinds.xml"}).json()["key"]
    answer = client.post("/api/bsdf/file", json={"key": key, "format": "mtx"})
    assert answer.status_code == 422
    assert "give a basis" in answer.json()["errors"][0]["message"]
    asked = {"key": key, "format": "mtx", "basis": "klems_quarter"}
    assert client.post("/api/bsdf/file", json=asked).status_code == 200
