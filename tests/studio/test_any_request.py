"""Whatever is asked is answered or refused in words: no request is a fault of the program."""

from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

#: Endpoint → a request that is answered, of which fields are then exchanged.
GOOD: dict[str, dict[str, Any]] = {
    "/api/about": {},
    "/api/panel/kinds": {},
    "/api/panel/section": {"panel": {"kind": "pane", "thickness_mm": 4.0}, "elevation_deg": 40.0, "azimuth_deg": 0.0},
    "/api/panel/lobes": {"panel": {"kind": "pane", "thickness_mm": 4.0}, "elevation_deg": 40.0, "side": "front"},
    "/api/panel/toml": {"panel": {"kind": "laser-cut", "spacing_mm": 4.0, "thickness_mm": 4.0}},
    "/api/panel/read": {"text": 'kind = "pane"\nthickness_mm = 4.0\n'},
    "/api/bsdf/open": {"path": "blinds.xml"},
    "/api/bsdf/discs": {"key": "", "elevation_deg": 40.0, "azimuth_deg": 0.0, "side": "front", "band": "visible"},
    "/api/bsdf/cut": {"key": "", "elevation_deg": 40.0, "side": "back", "band": "visible", "plane_deg": 0.0},
    "/api/bsdf/incidence": {"x": 10.0, "y": -20.0},
    "/api/bsdf/xml": {"key": ""},
}
ODD = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=6,
)


@pytest.fixture(scope="module")
def key(client: Any) -> str:
    return str(client.post("/api/bsdf/open", json={"path": "blinds.xml"}).json()["key"])


@pytest.mark.parametrize("path", GOOD)
def test_a_good_request_is_answered(client: Any, key: str, path: str) -> None:
    asked = GOOD[path] | ({"key": key} if "key" in GOOD[path] else {})
    assert client.post(path, json=asked).status_code == 200


@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_an_odd_request_is_answered_or_refused_in_words(client: Any, key: str, data: st.DataObject) -> None:
    path = data.draw(st.sampled_from([*GOOD, "/api/jobs"]))
    asked = dict(GOOD.get(path, {"kind": "nothing"}))
    if "key" in asked:
        asked["key"] = key
    places = [(asked, name) for name in asked]
    if isinstance(asked.get("panel"), dict):
        asked["panel"] = dict(asked["panel"])
        places += [(asked["panel"], name) for name in ("kind", "thickness_mm", "medium", "cut_depth_mm", "spacing_mm")]
    for _ in range(data.draw(st.integers(1, 2))):
        holder, name = data.draw(st.sampled_from(places)) if places else (asked, data.draw(st.text(max_size=8)))
        holder[name] = data.draw(ODD)
    answer = client.post(path, json=asked)
    assert answer.status_code in (200, 422), (path, asked, answer.text)
    if answer.status_code == 422:
        assert all(fault["message"] for fault in answer.json()["errors"])
