"""Whatever stands in the tables of a room, it is drawn or refused in words."""

import copy
import random
from typing import Any

from clerestory.studio.room.asked import asked_room
from clerestory.studio.room.kinds import start_tables
from clerestory.studio.room.planes import plane_sensors
from clerestory.studio.room.work import one_pass

ODD: list[Any] = [None, True, 0, -1, 1.5, 1e300, -1e300, 1e-300, "", "x" * 300, "glass", [], [[]], {}, [1, 2, 3]]
ODD += [[[0, 0, 0]], {"kind": "glass"}, "2026-01-01", [None], ["glass", 3], 10**12, {"a": {}}, [{}], "\0", "../x"]


def everything() -> dict[str, Any]:
    """The room shown first with one of each thing besides."""
    tables = start_tables()
    ring = [[-4.0, -1.0, 1.0], [-4.0, -1.0, 2.0], [-4.0, -2.0, 2.0], [-4.0, -2.0, 1.0]]
    tables["materials"] = {"grey": {"diffuse_reflectance": 0.3}}
    tables["obstruction"] = [
        {"kind": "overhang", "depth_m": 0.5, "height_m": 2.9},
        {"kind": "louvres", "bottom_m": 1.0, "top_m": 2.0, "count": 4, "depth_m": 0.1, "distance_m": 0.2},
    ]
    tables["surface"] = [{"name": "shelf", "outline_m": [[0, -1, 1], [-1, -1, 1], [-1, -2, 1]], "material": "grey"}]
    tables["window"] = [{"name": "side", "outline_m": ring, "glazing": "glass", "wall": "right"}]
    corners = [[-1, -1, 0.1], [-2, -1, 0.1], [-1, -2, 0.1]]
    tables["mesh"] = [{"name": "box", "vertices_m": corners, "triangles": [[0, 1, 2]], "material": 0.3}]
    tables["interface"] = [{"name": "film", "vertices_m": corners, "triangles": [[0, 1, 2]], "back_index": 1.0}]
    tables["sensors"].append({"points_m": [[-1.0, -1.0, 1.0]], "name": "eye", "normals": [0, 0, 1]})
    return tables


def places(value: Any) -> list[tuple[Any, Any]]:
    if isinstance(value, dict):
        return [(value, "bogus"), *((value, name) for name in value), *(p for v in value.values() for p in places(v))]
    if isinstance(value, list):
        return [*((value, k) for k in range(len(value))), *(p for v in value for p in places(v))]
    return []


def test_odd_tables_are_drawn_or_refused_in_words(rooms: Any) -> None:
    assert rooms.post("/api/room/scene", json={"room": {"tables": everything()}}).status_code == 200
    chance, drawn = random.Random(11), 0
    for _ in range(120):
        tables = copy.deepcopy(everything())
        for _ in range(chance.choice([1, 1, 2])):
            holder, name = chance.choice(places(tables))
            holder[name] = copy.deepcopy(chance.choice(ODD))
        for path, more in (("scene", {"planes": ["on floor"]}), ("paths", {"altitude_deg": 50.0, "azimuth_deg": 5.0})):
            answer = rooms.post(f"/api/room/{path}", json={"room": {"tables": tables}, **more})
            assert answer.status_code in (200, 422), (path, tables, answer.text)
            assert answer.status_code == 200 or answer.json()["errors"][0]["message"]
            drawn += answer.status_code == 200
    assert drawn > 20


def test_glazings_that_hold_themselves_are_refused(rooms: Any) -> None:
    tables = start_tables()
    tables["glazings"]["glass"] = {"kind": "stack", "layers": ["double-glass"]}
    answer = rooms.post("/api/room/scene", json={"room": {"tables": tables}})
    assert answer.status_code == 422
    assert "must not hold" in answer.json()["errors"][0]["message"]


def test_odd_questions_about_light_are_answered_or_refused_in_words(rooms: Any) -> None:
    asked = asked_room(rooms.app.state, {"room": {"tables": start_tables()}})
    sensors, _ = plane_sensors(asked.room(), "on back", 1.0)
    kept = rooms.app.state.room_shelf.plane(asked, None, sensors, "tregenza145")
    rooms.app.state.room_shelf.add(kept.key, 0, (one_pass(asked.room(), sensors, "tregenza145", 0, 64)[0], 0.1))
    sky = {"kind": "cie", "sky_type": 12, "luminous_turbidity": 4.0, "diffuse_horizontal_illuminance_lx": 1e4}
    good = {"key": kept.key, "day_of_year": 172, "hour": 11.0, "sky": sky, "sun_rounds": 4}
    chance, answered = random.Random(5), 0
    for _ in range(150):
        question = copy.deepcopy(good)
        holder, name = chance.choice(places(question))
        holder[name] = copy.deepcopy(chance.choice([*ODD, "weather", "overcast", 2, 16]))
        answer = rooms.post("/api/room/light", json=question)
        assert answer.status_code in (200, 422), (question, answer.text)
        assert answer.status_code == 200 or answer.json()["errors"][0]["message"]
        answered += answer.status_code == 200
    assert 5 < answered < 100
