"""What the studio says of a panel is what the API says."""

import tomllib
from typing import Any

import numpy as np
import pytest

from clerestory import panel_from_dict
from clerestory.panels.section_beams import section_beams

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
    beams = section_beams(panel_from_dict(panel), elevation_deg=40.0)
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
    assert {one["kind"] for one in told["kinds"]} == {"laser-cut", "prismatic", "pane"}
    for kind in told["kinds"]:
        assert kind["medium"] in told["media"]
        sizes = {slider["name"]: slider["start"] for slider in kind["sliders"]}
        choices = {choice["name"]: choice["start"] for choice in kind["choices"]}
        for medium in told["media"]:
            panel_from_dict({"kind": kind["kind"], "medium": medium, **sizes, **choices})
        for slider in kind["sliders"]:
            assert slider["low"] <= slider["start"] <= slider["high"]
