"""The calls are what /api/openapi.json says, whatever is asked: schemathesis asks.

CLERESTORY_FUZZ=400 asks more of each call, as `make validate` does.
"""

import os
import time
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from clerestory.studio.app import make_app
from clerestory.studio.doors.requests import Call
from clerestory.studio.settings import Settings

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

schemathesis = pytest.importorskip("schemathesis")

TOKEN = "a-long-token-of-ours"
FOLDER = Path(__file__).parents[1] / "data" / "bsdf"
#: Panels that stand in for the tables that chance makes, of which hardly any is one.
PANELS: list[dict[str, Any]] = [
    {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 5.0},
    {"kind": "laser-cut", "spacing_mm": [4.0, 5.0], "thickness_mm": 5.0, "cut_tilt_deg": 5.0, "medium": {"n": 1.5}},
    {"kind": "prismatic", "pitch_mm": 2.0, "lower_deg": 45.0, "upper_deg": 80.0, "base_mm": 3.0},
    {"kind": "pane", "thickness_mm": 4.0, "medium": "soda_lime_clear"},
]

APP = make_app(Settings(folder=FOLDER, host="testserver", token=TOKEN, workers=1, most_jobs=1000, most_seconds=240.0))
CONFIG = schemathesis.Config.from_dict(
    {
        "auth": {"openapi": {"bearer": {"bearer": TOKEN}}},
        "generation": {
            "max-examples": int(os.environ.get("CLERESTORY_FUZZ", "15")),
            "deterministic": True,
            "database": "none",
            "with-security-parameters": False,
        },
        # how long an example takes to draw depends on the machine
        "suppress-health-check": ["too_slow"],
        # what has the right shape may still make no sense: the API's dataclasses say so
        "checks": {"positive_data_acceptance": {"expected-statuses": ["2xx", "404", "422"]}},
    }
)


async def living(scope: Any, receive: Any, send: Any) -> None:
    """The studio, which lives longer than one test of schemathesis lets it."""
    if scope["type"] != "lifespan":
        await APP(scope, receive, send)


SCHEMA = schemathesis.openapi.from_asgi(
    "/api/openapi.json", living, config=CONFIG, headers={"authorization": f"Bearer {TOKEN}"}
)


@pytest.fixture(scope="module", autouse=True)
def _life() -> Iterator[None]:
    with TestClient(APP):
        yield


@pytest.fixture(scope="module")
def key() -> str:
    path = FOLDER / "blinds_tensortree3.xml"
    return str(APP.state.shelf.read(path.read_bytes(), path.name))


@SCHEMA.parametrize()
def test_a_call_answers_as_it_says(case: Any, key: str) -> None:
    if case.meta.generation.mode.is_positive and isinstance(case.body, dict):
        # half of what could be a question is made one that is answered
        turn = sum(map(ord, repr(sorted(case.body.items(), key=repr))))
        if turn % 2:
            stand_ins = {"panel": PANELS[turn % len(PANELS)], "key": key, "path": "blinds_tensortree3.xml"}
            case.body = case.body | {name: value for name, value in stand_ins.items() if name in case.body}
    case.call_and_validate()


def test_every_call_is_described_with_its_fields_and_what_it_refuses(client: Any) -> None:
    told = client.get("/api/openapi.json").json()
    calls = [one for one in client.app.routes if isinstance(one, Call)]
    assert calls
    for one in calls:
        told_of = told["paths"][one.path][one.method.lower()]
        assert told_of["summary"], one.path
        assert {"200", "403", "413"} <= set(told_of["responses"])
        assert "401" not in told_of["responses"]
    shape = told["paths"]["/api/panel/lobes"]["post"]["requestBody"]["content"]["application/json"]["schema"]
    assert shape["required"] == ["panel", "elevation_deg"]
    assert shape["properties"]["side"]["default"] == "front"
    assert all("description" in field for field in shape["properties"].values())


def test_a_call_that_is_asked_another_way_says_which(client: Any) -> None:
    for path, method, allowed in (
        ("/api/panel/lobes", "GET", "POST"),
        ("/api/openapi.json", "POST", "GET"),
        ("/api/jobs/none", "POST", "GET, DELETE"),
    ):
        answer = client.request(method, path)
        assert (answer.status_code, answer.headers["allow"]) == (405, allowed)
        assert answer.json()["errors"][0]["message"]


def test_the_description_is_behind_the_guard(client: Any) -> None:
    assert client.get("/api/openapi.json", headers={"host": "evil.example"}).status_code == 403
    assert client.get("/api/openapi.json", headers={"sec-fetch-site": "cross-site"}).status_code == 403


def test_jobs_of_chance_never_hang_a_worker_nor_end_the_server() -> None:
    # whatever the fuzz put in line is over when its time is, and the next one is done
    for job in list(APP.state.jobs._jobs.values()):
        APP.state.jobs.cancel(job.key)
    asked = {"panel": PANELS[0], "azimuth_deg": 0.0, "side": "front"}
    job = APP.state.jobs.start("angular", asked)
    late = time.monotonic() + 180.0
    while not job.is_over and time.monotonic() < late:
        time.sleep(0.05)
    assert job.state == "done", job.errors
