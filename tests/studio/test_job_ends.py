"""A job of any kind that is cancelled is left at once, and the next one runs."""

import time
from collections.abc import Iterator
from typing import Any

import pytest
from tests.studio.conftest import TestClient
from tests.studio.following import ended, is_left_at_once, looked, started, works
from tests.studio.test_room_calls import CLEAR, ROOM
from tests.year.small import YEAR, write_small

from clerestory.studio.app import make_app
from clerestory.studio.jobs import calls as job_calls
from clerestory.studio.settings import Settings

IDEAL = {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 5.0}
#: Takes a minute at least, its BSDF more.
SLOW = IDEAL | {"spacing_mm": [3.1, 4.7, 5.3], "thickness_mm": 9.0, "cut_width_mm": 0.31, "cut_tilt_deg": 7.3}


@pytest.fixture(scope="module")
def years(tmp_path_factory: pytest.TempPathFactory) -> Iterator[TestClient]:
    """A studio in a folder with a year that takes minutes."""
    folder = tmp_path_factory.mktemp("years").resolve()
    write_small(folder, YEAR.replace("nodes = 256", "nodes = 65536").replace("rounds = 4", "rounds = 64"))
    with TestClient(make_app(Settings(folder=folder, workers=1)), base_url="http://127.0.0.1:8765") as one:
        yield one


@pytest.mark.parametrize(
    "asked",
    [
        {"kind": "angular", "panel": SLOW},
        {"kind": "klems", "panel": SLOW},
    ],
    ids=lambda asked: asked["kind"],
)
def test_a_cancelled_job_of_a_panel_is_left_at_once(client: Any, asked: dict[str, Any]) -> None:
    key = started(client, **asked)
    assert works(client, key)["state"] == "running"
    is_left_at_once(client, key)


def test_a_cancelled_year_is_left_at_once(years: TestClient) -> None:
    key = started(years, kind="year", path="year.toml")
    assert works(years, key)["state"] == "running"
    is_left_at_once(years, key)
    assert not (years.app.state.settings.folder / "out/year/year.nc").exists()  # type: ignore[attr-defined]


def test_a_cancelled_room_and_its_sun_are_left_at_once(rooms: Any) -> None:
    asked = {"kind": "room", "room": ROOM, "basis": "tregenza145", "target_relative_error": 1e-6}
    key = started(rooms, **asked)
    light = works(rooms, key)["partial"]["key"]
    is_left_at_once(rooms, key)
    sun = {"kind": "room_sun", "key": light, "sky": CLEAR, "day_of_year": 160, "hour": 10.5}
    key = started(rooms, **sun, target_relative_error=1e-6)
    works(rooms, key)
    is_left_at_once(rooms, key)
    assert ended(rooms, started(rooms, **asked | {"target_relative_error": 0.9}))[-1]["state"] == "done"


def test_a_job_of_a_page_that_was_closed_ends_alone(client: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(job_calls, "ALONE_S", 0.5)
    key = started(client, kind="angular", panel=SLOW)
    with client.stream("GET", f"/api/jobs/{key}/events") as stream:
        next(stream.iter_lines())
    while looked(client, key)["state"] in ("waiting", "running"):
        time.sleep(0.05)
    assert looked(client, key)["state"] == "cancelled"
    # a year's pieces are worth more than its page
    assert {name for name, kind in job_calls.KINDS.items() if not kind.ends_alone} == {"year"}
