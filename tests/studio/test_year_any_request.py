"""Whatever is asked of a result is answered as its call says, or refused in words."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.studio.conftest import TestClient
from tests.studio.test_any_request import ODD

from clerestory.studio.app import make_app
from clerestory.studio.doors.requests import Call
from clerestory.studio.doors.shapes import fit
from clerestory.studio.results.calls import ROUTES
from clerestory.studio.results.reader import Reader
from clerestory.studio.settings import Settings

YEAR, ROOM, DESIGN = "out/year/year.nc", "out/room/summary.json", "out/design/history.csv"
PLAN = {"metric": "daylight_autonomy", "plane": "floor"}
#: Call, the result it is asked about, and a request that is answered.
GOOD: list[tuple[str, str, dict[str, Any]]] = [
    ("files", "", {}),
    ("open", "", {"path": YEAR}),
    ("open", "", {"path": "out/sweep/results.zarr"}),
    ("open", YEAR, {}),
    ("plan", YEAR, PLAN),
    ("plan", ROOM, {"metric": "illuminance|overcast"}),
    ("difference", YEAR, PLAN | {"variant": "dark", "minus": "glass"}),
    ("section", ROOM, {"metric": "daylight_factor"}),
    ("carpet", YEAR, {"series": "sensor", "sensor": 3}),
    ("carpet", YEAR, {"series": "least"}),
    ("months", YEAR, {"series": "mean"}),
    ("hour", YEAR, {"day": "2023-03-20", "hour": 12.0, "plane": "floor"}),
    ("cases", DESIGN, {}),
    ("cases", "out/panel/angular.nc", {}),
    ("cases", "out/sweep/results.zarr", {}),
]
GIVES = {one.path.removeprefix("/api/result/"): one.gives for one in ROUTES if isinstance(one, Call)}


@pytest.fixture(scope="module")
def client(result_folder: Path) -> Iterator[TestClient]:
    with TestClient(make_app(Settings(folder=result_folder, workers=1)), base_url="http://127.0.0.1:8765") as one:
        yield one


@pytest.fixture(scope="module")
def keys(client: TestClient) -> dict[str, str]:
    paths = {path for _, path, _ in GOOD if path}
    return {path: str(client.post("/api/result/open", json={"path": path}).json()["key"]) for path in paths}


def _asked(keys: dict[str, str], path: str, fields: dict[str, Any]) -> dict[str, Any]:
    return {"key": keys[path], **fields} if path else dict(fields)


@pytest.mark.parametrize(("call", "path", "fields"), GOOD)
def test_an_answer_has_the_shape_that_is_declared(
    client: TestClient, keys: dict[str, str], call: str, path: str, fields: dict[str, Any]
) -> None:
    answer = client.post(f"/api/result/{call}", json=_asked(keys, path, fields))
    assert answer.status_code == 200, answer.text
    fit(call, answer.json(), GIVES[call])


@settings(max_examples=120)
@given(data=st.data())
def test_an_odd_request_is_answered_or_refused_in_words(
    client: TestClient, keys: dict[str, str], data: st.DataObject
) -> None:
    call, path, fields = data.draw(st.sampled_from(GOOD))
    asked = _asked(keys, path, fields)
    names = st.sampled_from(sorted(asked)) if asked else st.text(max_size=8)
    for _ in range(data.draw(st.integers(1, 2))):
        asked[data.draw(names)] = data.draw(ODD | st.sampled_from(sorted(keys.values())))
    answer = client.post(f"/api/result/{call}", json=asked)
    assert answer.status_code in (200, 422), (call, asked, answer.text)
    if answer.status_code == 422:
        assert all(fault["message"] for fault in answer.json()["errors"])
    else:
        fit(call, answer.json(), GIVES[call])


def test_a_file_that_is_too_large_is_refused_before_it_is_read(result_folder: Path) -> None:
    small = Settings(folder=result_folder, workers=1, most_upload_bytes=5000)
    with TestClient(make_app(small), base_url="http://127.0.0.1:8765") as one:
        answer = one.post("/api/result?name=year.nc", content=(result_folder / YEAR).read_bytes())
        assert answer.status_code == 413
        assert "at most 5000 bytes" in answer.json()["errors"][0]["message"]


def test_a_reader_that_ended_is_replaced(result_folder: Path) -> None:
    reader = Reader()
    try:
        first = reader.read(result_folder / YEAR, "year.nc")
        reader._process.kill()
        reader._process.join(5.0)
        assert reader.read(result_folder / YEAR, "year.nc").identical(first)
    finally:
        reader.close()
