"""Whatever is asked is answered or refused in words: no request is a fault of the program."""

import copy
import random
import time
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

#: Jobs, and questions about what a job or a file must first be there for: they have tests of their own.
_OTHERS = ("/api/jobs", "/api/result/", "/api/room/light")


def questions(client: Any) -> dict[str, dict[str, Any]]:
    """Endpoint → a request that is answered, of which fields are then exchanged: its own examples and defaults."""
    found = {}
    for path, methods in client.get("/api/openapi.json").json()["paths"].items():
        body = methods.get("post", {}).get("requestBody", {}).get("content", {}).get("application/json")
        if body and not path.startswith(_OTHERS):
            fields = body["schema"]["properties"]
            found[path] = {
                name: one["examples"][0] if "examples" in one else one.get("default")
                for name, one in fields.items()
                if "examples" in one or "default" in one or name in body["schema"].get("required", ())
            }
    return found


ODD = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=6,
)


@pytest.fixture(scope="module")
def key(client: Any) -> str:
    return str(client.post("/api/bsdf/open", json={"path": "blinds.xml"}).json()["key"])


@pytest.fixture(scope="module")
def good(client: Any, key: str) -> dict[str, dict[str, Any]]:
    own = {"key": key, "path": "blinds.xml"}
    return {
        path: {name: own.get(name, value) if path.startswith("/api/bsdf/") else value for name, value in asked.items()}
        for path, asked in questions(client).items()
    }


def test_the_examples_of_every_call_are_answered(client: Any, good: dict[str, dict[str, Any]]) -> None:
    assert len(good) > 10
    for path, asked in good.items():
        answer = client.post(path, json=asked)
        assert answer.status_code == 200, (path, asked, answer.text)


@settings(max_examples=100)
@given(data=st.data())
def test_an_odd_request_is_answered_or_refused_in_words(
    client: Any, good: dict[str, dict[str, Any]], data: st.DataObject
) -> None:
    path = data.draw(st.sampled_from([*good, "/api/jobs"]))
    asked = copy.deepcopy(good.get(path, {"kind": "nothing"}))
    places = [(asked, name) for name in asked]
    for value in asked.values():
        if isinstance(value, dict):
            places += [(value, one) for one in (*value, data.draw(st.text(max_size=8)))]
    for _ in range(data.draw(st.integers(1, 2))):
        holder, name = data.draw(st.sampled_from(places)) if places else (asked, data.draw(st.text(max_size=8)))
        holder[name] = data.draw(ODD)
    answer = client.post(path, json=asked)
    assert answer.status_code in (200, 422), (path, asked, answer.text)
    if answer.status_code == 422:
        assert all(fault["message"] for fault in answer.json()["errors"])


def test_an_odd_job_is_refused_or_ends_and_the_next_one_is_done(client: Any) -> None:
    told = client.get("/api/openapi.json").json()["paths"]["/api/jobs"]["post"]
    kinds = told["requestBody"]["content"]["application/json"]["schema"]["oneOf"]
    chance = random.Random(7)
    odd = [None, True, 0, -1.5, 1e300, "", "front", "x" * 300, [], [[]], {}, {"kind": "pane"}, {"kind": {}}]
    jobs = []
    for _ in range(40):
        fields = chance.choice(kinds)["properties"]
        asked = {
            name: field["examples"][0] if "examples" in field and chance.random() < 0.6 else chance.choice(odd)
            for name, field in fields.items()
            if chance.random() < 0.9
        }
        asked["kind"] = chance.choice([*fields["kind"]["enum"], chance.choice(odd)])
        answer = client.post("/api/jobs", json=asked)
        assert answer.status_code in (200, 422), (asked, answer.text)
        if answer.status_code == 200:
            jobs.append(answer.json()["job"])
    for job in jobs:
        client.delete(f"/api/jobs/{job}")
    good = {"kind": "angular", "panel": {"kind": "pane", "thickness_mm": 4.0}}
    last = client.post("/api/jobs", json=good).json()["job"]
    late = time.monotonic() + 180.0
    while client.get(f"/api/jobs/{last}").json()["state"] != "done":
        assert time.monotonic() < late
        time.sleep(0.05)
