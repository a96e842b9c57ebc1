"""What the studio says of a panel is what the API says."""

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from clerestory import LaserCutPanel, panel_from_dict
from clerestory.panels.section_beams import section_beams
from clerestory.panels.writing import kinds
from clerestory.spectrum import photopic_quadrature

PANELS: list[dict[str, Any]] = [
    {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 5.0},
    {"kind": "laser-cut", "spacing_mm": [4.0, 5.0], "thickness_mm": 5.0, "cut_tilt_deg": 5.0, "medium": {"n": 1.5}},
    {"kind": "prismatic", "pitch_mm": 2.0, "lower_deg": 45.0, "upper_deg": 80.0, "base_mm": 3.0, "ridges": "back"},
    {"kind": "pane", "thickness_mm": 4.0},
]


@pytest.mark.parametrize("panel", PANELS, ids=lambda panel: panel["kind"])
def test_lobes_and_shares_are_those_of_the_api(client: Any, panel: dict[str, Any]) -> None:
    for elevation, azimuth, side in ((40.0, 0.0, "front"), (-25.0, 30.0, "back"), (0.0, 0.0, "front")):
        asked = {"panel": panel, "elevation_deg": elevation, "azimuth_deg": azimuth, "side": side}
        told = client.post("/api/panel/lobes", json=asked).json()
        own = panel_from_dict(panel)
        lobes = own.lobes(elevation_deg=elevation, azimuth_deg=azimuth, side=side)
        assert [one["power"] for one in told["lobes"]] == lobes["power"].values.tolist()
        assert [one["elevation_deg"] for one in told["lobes"]] == lobes["elevation_deg"].values.tolist()
        shares = own.angular(elevation_deg=elevation, azimuth_deg=azimuth, side=side)
        for name, value in told["shares"].items():
            assert value == pytest.approx(float(shares[name].squeeze()), abs=2e-6), name
        parts = ("transmittance", "reflectance", "absorptance", "residual")
        assert sum(told["shares"][name] for name in parts) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("panel", PANELS, ids=lambda panel: panel["kind"])
def test_the_section_is_that_of_the_api(client: Any, panel: dict[str, Any]) -> None:
    told = client.post("/api/panel/section", json={"panel": panel, "elevation_deg": 40.0}).json()
    media = panel_from_dict(panel).media
    # of daylight's five wavelengths, the one that counts most
    nodes, weights = photopic_quadrature("D65", 5)
    at_nm = float(nodes[np.argmax(weights)]) if any(medium.is_spectral for medium in media) else None
    beams = section_beams(panel_from_dict(panel), elevation_deg=40.0, wavelength_nm=at_nm)
    assert [strip["power"] for strip in told["strips"]] == beams["power"].values.tolist()
    corners = np.array([strip["corners"] for strip in told["strips"]])
    np.testing.assert_allclose(corners, beams["corners"].values, atol=6e-5)
    profile = panel_from_dict(panel).native_profile
    assert (told["pitch_mm"], told["front_mm"], told["back_mm"]) == (profile.pitch_mm, *profile.depth_range_mm)
    # the light that leaves and what is absorbed on the way are no more than what arrives
    assert 0.5 < sum(strip["power"] for strip in told["strips"] if strip["leaves"]) <= 1.0
    assert not told["strips"][0]["leaves"]


def test_mistakes_are_told_beside_their_field(client: Any) -> None:
    good = PANELS[0]
    for change, field in (
        ({"cut_width_mm": 7.0}, "cut_width_mm"),
        ({"thickness_mm": -1}, "thickness_mm"),
        ({"spacing_mm": "wide"}, "spacing_mm"),
        ({"medium": "jelly"}, "medium"),
        ({"kind": "curtain"}, "kind"),
    ):
        answer = client.post("/api/panel/lobes", json={"panel": good | change, "elevation_deg": 40.0})
        assert answer.status_code == 422
        assert answer.json()["errors"][0]["field"] == field, answer.text
    answer = client.post("/api/panel/lobes", json={"panel": good, "elevation_deg": 95.0})
    assert answer.json()["errors"][0]["field"] == "elevation_deg"
    answer = client.post("/api/panel/lobes", json={"panel": good})
    assert "elevation_deg must be given" in answer.json()["errors"][0]["message"]


@pytest.mark.parametrize("panel", PANELS, ids=lambda panel: panel["kind"])
def test_toml_goes_out_and_comes_back(client: Any, panel: dict[str, Any]) -> None:
    text = client.post("/api/panel/toml", json={"panel": panel}).json()["text"]
    assert panel_from_dict(tomllib.loads(text)) == panel_from_dict(panel)
    back = client.post("/api/panel/read", json={"text": text}).json()["panel"]
    assert panel_from_dict(back) == panel_from_dict(panel)
    for wrong in ("spacing_mm = ", 'kind = "laser-cut"\nspacing_mm = 1', 7, "[[["):
        assert client.post("/api/panel/read", json={"text": wrong}).status_code == 422


def test_every_kind_starts_as_a_panel_and_every_medium_is_one(client: Any) -> None:
    told = client.post("/api/panel/kinds", json={}).json()
    assert {one["kind"] for one in told["kinds"]} == {"laser-cut", "prismatic", "pane", "drawn"}
    for kind in told["kinds"]:
        assert kind["medium"] in told["media"]
        sizes = {one["name"]: one["start"] for one in kind["sliders"] if one["start"] is not None}
        words = {one["name"]: one["start"] for one in [*kind["choices"], *kind["texts"]]}
        for medium in told["media"]:
            made = {"media": [medium]} if kind["kind"] == "drawn" else {"medium": medium}
            asked = {"panel": {"kind": kind["kind"], **made, **sizes, **words}}
            assert client.post("/api/panel/toml", json=asked).status_code == 200, asked
        for slider in kind["sliders"]:
            assert slider["low"] <= slider["sets"] <= slider["high"]
            # what is asked for on demand is a panel too
            changed = {"panel": {"kind": kind["kind"], **sizes, **words, slider["name"]: slider["sets"]}}
            assert client.post("/api/panel/toml", json=changed).status_code == 200, changed
    for preset in told["presets"]:
        panel_from_dict(preset["panel"])


def test_every_argument_of_a_panel_has_its_slider_or_choice(client: Any) -> None:
    for kind in client.post("/api/panel/kinds", json={}).json()["kinds"]:
        if kind["kind"] == "drawn":
            continue
        offered = {one["name"] for one in [*kind["sliders"], *kind["choices"]]} | {"medium"}
        made = kinds()[kind["kind"]]
        assert offered == {name for name, one in made.__dataclass_fields__.items() if one.init} - {"kind"}


def test_an_answer_at_once_is_by_rays_and_within_its_standard_error(client: Any) -> None:
    slow = {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 6.0, "cut_tilt_deg": 7.0, "cut_width_mm": 0.31}
    asked = {"panel": slow, "elevation_deg": 45.0}
    quick = client.post("/api/panel/lobes", json=asked | {"detail": "quick"}).json()
    assert (quick["is_full"], quick["is_smooth"], quick["lobes"]) == (False, True, [])
    full = client.post("/api/panel/lobes", json=asked | {"most": 5}).json()
    assert full["is_full"]
    assert len(full["lobes"]) == 5 < full["count"]
    for name, error in quick["standard_errors"].items():
        assert abs(quick["shares"][name] - full["shares"][name]) < 5.0 * error + 2e-4, name
    assert quick["standard_errors"]["transmittance"] < 0.01


def test_what_was_followed_at_once_before_is_followed_again(client: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    # a busy machine takes longer for a pane than what counts as at once
    monkeypatch.setattr("clerestory.studio.panel.pace.AT_ONCE_S", 60.0)
    asked = {"panel": {"kind": "pane", "thickness_mm": 3.0}, "elevation_deg": 45.0}
    for _ in range(12):
        client.post("/api/panel/lobes", json=asked)
    assert client.post("/api/panel/lobes", json=asked | {"detail": "quick"}).json()["is_full"]


def test_a_rough_panel_has_shares_with_standard_errors_and_a_section(client: Any) -> None:
    rough = {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 6.0, "cut_slope_deg": 3.0, "cut_diffuse": 0.2}
    asked = {"panel": rough, "elevation_deg": 40.0}
    told = client.post("/api/panel/lobes", json=asked).json()
    assert (told["is_full"], told["is_smooth"]) == (False, False)
    own = panel_from_dict(rough).angular(elevation_deg=40.0, method="monte_carlo", rays=400_000, seed=9)
    for name in ("transmittance", "reflectance", "absorptance", "transmittance_deflected"):
        error = told["standard_errors"][name]
        assert 0.0 < error < 0.01
        assert abs(told["shares"][name] - float(own[name].squeeze())) < 5.0 * error, name
    section = client.post("/api/panel/section", json=asked).json()
    assert not section["is_smooth"]
    assert len(section["strips"]) > 3


@pytest.mark.parametrize("side", ["front", "back"])
def test_light_on_the_back_comes_from_the_room(client: Any, side: str) -> None:
    asked = {"panel": PANELS[2], "elevation_deg": 40.0, "side": side}
    told = client.post("/api/panel/section", json=asked).json()
    arrives = np.array(told["strips"][0]["corners"])
    # the light that arrives runs towards the panel: from z < 0 on the front, from beyond it on the back
    assert (arrives[0, 0] < arrives[2, 0]) == (side == "front")
    shares = client.post("/api/panel/lobes", json=asked).json()["shares"]
    own = panel_from_dict(PANELS[2]).angular(elevation_deg=40.0, side=side)
    assert shares["transmittance"] == pytest.approx(float(own["transmittance"].squeeze()), abs=2e-6)


DRAWN: dict[str, Any] = {"kind": "drawn", "source": "points", "pitch_mm": 3.0, "joins": "film", "media": ["pmma"]}


def test_a_drawing_is_the_panel_that_it_shows(client: Any, folder: Path) -> None:
    bar = "0,0 6,0 6,3 0,3  # a bar"
    (folder / "bar.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0,0 H6 V-3 H0 Z"/></svg>')
    own = LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0).angular(elevation_deg=40.0)
    for source in (
        {"points": bar},
        {"source": "svg", "path_data": "M0,0 H6 V-3 H0 Z"},
        {"source": "file", "file": "bar.svg"},
    ):
        asked = {"panel": DRAWN | source, "elevation_deg": 40.0}
        told = client.post("/api/panel/lobes", json=asked).json()
        assert told["shares"]["transmittance_deflected"] == pytest.approx(
            float(own["transmittance_deflected"].squeeze()), abs=2e-6
        )
    # a hole of air, an arc, and the file of it
    round_hole = "0,0 6,0 6,3 0,3\n0: 2,1.5,1 4,1.5,1"
    text = client.post("/api/panel/toml", json={"panel": DRAWN | {"points": round_hole}}).json()["text"]
    facets = tomllib.loads(text)["profile"]["facets"]
    assert sum(abs(facet.get("bulge", 0.0)) == 1.0 for facet in facets) == 2
    assert (
        client.post("/api/panel/section", json={"panel": tomllib.loads(text), "elevation_deg": 9.0}).status_code == 200
    )


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"points": "0,0 6,0"}, "points"),
        ({"points": ""}, "points"),
        ({"points": "0,0 6,x 6,3"}, "points"),
        ({"points": "9x: 0,0 6,0 6,3"}, "points"),
        ({"pitch_mm": -1.0, "points": "0,0 6,0 6,3"}, "pitch_mm"),
        ({"points": "2: 0,0 6,0 6,2"}, "media"),
        ({"source": "svg", "path_data": "hello"}, "path_data"),
        ({"source": "file", "file": "../secret.xml"}, "file"),
        ({"source": "file", "file": "/etc/passwd"}, "file"),
        ({"source": "file", "file": "none.svg"}, "file"),
        ({"source": "file", "file": "blinds.xml"}, "file"),
    ],
)
def test_a_mistake_in_a_drawing_is_told_beside_its_field(client: Any, change: dict[str, Any], field: str) -> None:
    asked = {"panel": DRAWN | change, "elevation_deg": 40.0}
    answer = client.post("/api/panel/lobes", json=asked)
    assert answer.status_code == 422
    fault = answer.json()["errors"][0]
    assert fault["field"] == field, fault
    assert "root:" not in fault["message"]
    assert "/tmp" not in fault["message"]
