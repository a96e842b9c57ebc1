"""The list of jobs, by which a page that was loaded again finds its own."""

import json
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
from tests.studio.conftest import TestClient
from tests.studio.following import ended, started, works

from clerestory.studio.app import make_app
from clerestory.studio.settings import Settings

IDEAL = {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 5.0}
#: Its BSDF takes minutes.
SLOW = IDEAL | {"spacing_mm": [3.1, 4.7, 5.3], "thickness_mm": 9.0, "cut_width_mm": 0.31, "cut_tilt_deg": 7.3}


def listed(client: Any, **query: str) -> list[dict[str, Any]]:
    """The list, as the description of the calls declares it."""
    answer = client.get("/api/jobs", params=query)
    assert answer.status_code == 200, answer.text
    told = client.get("/api/openapi.json").json()
    shape = told["paths"]["/api/jobs"]["get"]["responses"]["200"]["content"]["application/json"]["schema"]
    jsonschema_rs.validate(shape | {"components": told["components"]}, answer.json())
    found: list[dict[str, Any]] = answer.json()["jobs"]
    return found


def test_jobs_are_listed_with_what_they_were_asked_and_how_far_they_are(client: Any) -> None:
    done = started(client, kind="angular", panel=IDEAL, azimuth_deg=3.0)
    ended(client, done)
    busy = started(client, kind="klems", panel=SLOW)
    works(client, busy)
    waits = started(client, kind="angular", panel=SLOW)
    found = listed(client)
    assert [one["job"] for one in found[:3]] == [waits, busy, done]
    assert (found[1]["state"], found[1]["followers"]) == ("running", 0)
    assert found[1]["partial"]["stage"] in ("rays", "fine")
    # what was left out has its default
    assert found[1]["asked"] == {
        "kind": "klems",
        "panel": SLOW,
        "basis": "klems_full",
        "accuracy": "fine",
    }
    assert found[2]["state"] == "done"
    assert len(found[2]["result"]["elevation_deg"]) == 89
    assert {one["kind"] for one in listed(client, kind="klems")} == {"klems"}
    assert waits not in {one["job"] for one in listed(client, kind="klems")}
    with client.stream("GET", f"/api/jobs/{busy}/events") as stream:
        next(stream.iter_lines())
        assert listed(client, kind="klems")[0]["followers"] == 1
    for key in (busy, waits):
        client.delete(f"/api/jobs/{key}")
    wrong = client.get("/api/jobs", params={"kind": "mining"})
    assert (wrong.status_code, wrong.json()["errors"][0]["field"]) == (422, "kind")


def test_the_list_names_no_place_of_the_machine(rooms: Any, room_folder: Path) -> None:
    key = started(rooms, kind="room", room={"path": "classroom.toml"}, basis="tregenza145", target_relative_error=1e-5)
    works(rooms, key)
    told = json.dumps(listed(rooms))
    rooms.delete(f"/api/jobs/{key}")
    assert "classroom.toml" in told
    assert str(room_folder) not in told
    assert str(room_folder.parent) not in told


def test_who_has_no_token_sees_no_jobs(folder: Path) -> None:
    settings = Settings(folder=folder, host="192.0.2.7", token="a-long-token-of-ours", workers=1)
    with TestClient(make_app(settings), base_url="http://192.0.2.7:8765") as one:
        assert one.get("/api/jobs").status_code == 401
        let_in = {"authorization": "Bearer a-long-token-of-ours"}
        assert one.get("/api/jobs", headers=let_in).json() == {"jobs": []}
        assert one.get("/api/jobs", headers=let_in | {"origin": "http://evil.example"}).status_code == 403


def test_the_events_are_described_as_the_job_is(client: Any) -> None:
    told = client.get("/api/openapi.json").json()
    shape = told["paths"]["/api/jobs/{key}/events"]["get"]["responses"]["200"]["content"]["text/event-stream"]["schema"]
    assert shape["contentSchema"] == {"$ref": "#/components/schemas/Job"}
    job = {"$ref": "#/components/schemas/Job", "components": told["components"]}
    events = ended(client, started(client, kind="dispersion", panel=IDEAL, elevation_deg=40.0))
    for event in events:
        jsonschema_rs.validate(job, event)
    last = events[-1]
    last["result"]["beams"][0]["power"] = "much"
    with pytest.raises(jsonschema_rs.ValidationError):
        jsonschema_rs.validate(job, last)
