"""What the studio says of a room is what the API says."""

import copy
import tomllib
from typing import Any

import numpy as np
import pandas as pd
import pytest

from clerestory import (
    CieSky,
    daylight_coefficients,
    daylight_factor,
    direct_normal_illuminance_lx,
    illuminance,
    read_epw,
    read_room,
    sun_coefficients,
    sun_paths,
    sun_position,
    uniformity,
)
from clerestory.sky.availability import usual_diffuse_horizontal_lx
from clerestory.studio.room.asked import asked_room
from clerestory.studio.room.kinds import room_kinds, start_tables
from clerestory.studio.room.planes import plane_sensors
from clerestory.studio.room.work import one_pass
from clerestory.sun import direction_of

ROOM = {"tables": start_tables()}
WHEN = {"day_of_year": 172, "hour": 11.0}
CLEAR = {"kind": "cie", "sky_type": 12, "luminous_turbidity": 4.0}
EPW = "USA_FL_Miami.Intl.AP.722020_TMY3.epw"


def ask(client: Any, path: str, **asked: Any) -> Any:
    answer = client.post(f"/api/room/{path}", json=asked)
    assert answer.status_code == 200, answer.text
    return answer.json()


def refused(client: Any, path: str, **asked: Any) -> dict[str, Any]:
    answer = client.post(f"/api/room/{path}", json=asked)
    assert answer.status_code == 422, answer.text
    return dict(answer.json()["errors"][0])


def changed(*path: Any, value: Any) -> dict[str, Any]:
    """The room shown first with one value changed."""
    tables = copy.deepcopy(start_tables())
    inner: Any = tables
    for part in path[:-1]:
        inner = inner[part]
    inner[path[-1]] = value
    return {"tables": tables}


@pytest.fixture(scope="module")
def asked(rooms: Any) -> Any:
    return asked_room(rooms.app.state, {"room": ROOM})


@pytest.fixture(scope="module")
def lit(rooms: Any) -> Any:
    """A room that no other file asks for: all that is kept of its light was added here, whatever ran before."""
    return asked_room(rooms.app.state, {"room": changed("shoebox", "depth_m", value=7.75)})


@pytest.fixture(scope="module")
def key(rooms: Any, lit: Any) -> str:
    """Coefficients of the work plane, three passes of them."""
    sensors, _ = plane_sensors(lit.room(), None)
    shelf = rooms.app.state.room_shelf
    kept = shelf.plane(lit, None, sensors, "tregenza145")
    for number in range(3):
        shelf.add(kept.key, number, (one_pass(lit.room(), sensors, "tregenza145", number, 512)[0], 0.1))
    return str(kept.key)


def test_the_room_shown_first_is_one_and_every_slider_moves_a_value_of_it(rooms: Any) -> None:
    told = ask(rooms, "kinds")
    assert told == room_kinds()
    for slider in told["sliders"]:
        assert slider["low"] <= slider["start"] <= slider["high"]
        for end in ("low", "high"):
            if slider["name"] not in ("width_m", "height_m", "sill_m", "depth_m"):
                ask(rooms, "scene", room=changed(*slider["path"], value=slider[end]))
    for one in told["glazings"]:
        room = changed("shoebox", "opening", 0, "part", 0, "glazing", value=one["name"])
        assert one["table"] == told["start"]["glazings"][one["name"]]
        assert ask(rooms, "scene", room=room)["windows"][0]["name"] == "window 1"
    assert {one["sky"]["kind"] for one in told["skies"]} == {"overcast", "cie"}


def test_the_scene_is_the_room(rooms: Any, asked: Any) -> None:
    told = ask(rooms, "scene", room=ROOM)
    room = asked.room()
    assert [one["name"] for one in told["surfaces"]] == list(room.scene.surfaces)
    triangles = np.concatenate([np.reshape(one["triangles"], (-1, 3, 3)) for one in told["surfaces"]])
    np.testing.assert_allclose(triangles, room.scene.triangles()[0], atol=6e-5)
    sides = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    assert np.linalg.norm(sides, axis=1).sum() / 2.0 == pytest.approx(float(np.sum(room.scene.areas)), rel=1e-3)
    (placed,) = room.sensor_points()
    (plane,) = told["planes"]
    np.testing.assert_allclose(plane["points_m"], placed.points_m)
    np.testing.assert_allclose(np.mean(plane["cells"], axis=1), placed.points_m, atol=1e-12)
    assert len(placed) == plane["rows"] * plane["columns"]
    assert told["windows"][0]["normal"] == [0.0, -1.0, 0.0]
    assert told["windows"][0]["glazing"] == "glass + laser-cut panel"
    assert (told["windows"][0]["kind"], told["windows"][1]["kind"]) == ("laser-cut", "glass")
    assert told["variants"] == ["laser-cut panel above", "glass only"]
    assert ask(rooms, "scene", room=ROOM, variant="glass only")["windows"][0]["kind"] == "glass"


def test_planes_lie_on_surfaces_and_look_into_the_room(rooms: Any) -> None:
    names = ask(rooms, "scene", room=ROOM)["plane_names"]
    assert names == ["work plane", "on floor", "on ceiling", "on facade", "on back", "on left", "on right"]
    planes = ask(rooms, "scene", room=ROOM, planes=names, spacing_m=0.5)["planes"]
    middle = np.array([-2.0, -4.0, 1.5])
    for plane in planes:
        towards = middle - np.mean(plane["points_m"], axis=0)
        if plane["name"] != "work plane":
            assert np.dot(plane["normals"][0], towards) > 0.0, plane["name"]
            assert plane["spacing_m"] == 0.5
    assert refused(rooms, "scene", room=ROOM, planes=["on roof"])["message"].startswith("surface must be one of")


def test_the_sun_is_that_of_the_api(rooms: Any, asked: Any) -> None:
    site = start_tables()["site"]
    told = ask(rooms, "sun", site=site, **WHEN)
    own = sun_position(asked.site, "2026-06-21 11:00").isel(time=0)
    assert told["altitude_deg"] == pytest.approx(float(own.apparent_altitude_deg), abs=1e-12)
    assert told["azimuth_deg"] == pytest.approx(float(own.azimuth_deg), abs=1e-12)
    assert told["time"] == "2026-06-21T11:00:00-03:00"
    assert "analemmas" not in told
    for hour, end in ((told["sunrise_h"], 1), (told["sunset_h"], -1)):
        before, after = (ask(rooms, "sun", site=site, day_of_year=172, hour=hour + off) for off in (-0.01, 0.01))
        assert end * before["altitude_deg"] < 0.0 < end * after["altitude_deg"]
    year = ask(rooms, "sun", site=site, **WHEN, year=True)
    assert [one["label"] for one in year["seasons"]] == ["21 June", "21 March", "21 December"]
    loop = next(one for one in year["analemmas"] if one["hour"] == 12)
    assert {point["day_of_year"] for point in loop["points"]} == set(range(1, 366, 7))
    assert all(point["hour"] == one["hour"] for one in year["analemmas"] for point in one["points"])
    for point in (*loop["points"], *year["seasons"][0]["points"], *told["day"]):
        towards = direction_of(point["altitude_deg"], point["azimuth_deg"])
        np.testing.assert_allclose(point["direction"], towards, atol=2e-5)


def test_a_sun_that_never_sets_and_clocks_that_change(rooms: Any) -> None:
    north = {"latitude_deg": 70.0, "longitude_deg": 20.0, "timezone": "Europe/Oslo"}
    told = ask(rooms, "sun", site=north, day_of_year=172, hour=0.0)
    assert (told["is_up"], told["sunrise_h"], told["sunset_h"]) == (True, None, None)
    told = ask(rooms, "sun", site=north, day_of_year=355, hour=12.0)
    assert (told["is_up"], told["sunrise_h"], told["sunset_h"]) == (False, None, None)
    # 2026-03-29 02:30 does not exist in Oslo, 2026-10-25 02:30 does twice
    assert ask(rooms, "sun", site=north, day_of_year=88, hour=2.5)["time"] == "2026-03-29T03:00:00+02:00"
    assert ask(rooms, "sun", site=north, day_of_year=298, hour=2.5)["time"] == "2026-10-25T02:30:00+02:00"
    ask(rooms, "sun", site=north, day_of_year=365, hour=24.0)


def test_paths_and_patches_are_those_of_the_api(rooms: Any, asked: Any) -> None:
    told = ask(rooms, "paths", room=ROOM, altitude_deg=52.0, azimuth_deg=12.0, density=20)
    own = sun_paths(asked.room(), altitude_deg=52.0, azimuth_deg=12.0, points=20)
    assert (len(told["paths"]), len(told["beams"]), len(told["patches"])) == tuple(
        own.sizes[name] for name in ("path", "beam", "patch")
    )
    for k, path in enumerate(told["paths"]):
        count = int(own["vertices"][k])
        np.testing.assert_allclose(path["points"], own["position_m"].values[k, :count], atol=6e-5)
        np.testing.assert_allclose(path["segment_power"], own["power"].values[k, 1:count], atol=6e-6)
        assert path["stages"] == own["event"].values[k, :count].tolist()
        assert path["power"] == pytest.approx(float(own["power"][k, count - 1]), abs=6e-6)
        assert (path["window"], path["kind"]) == (own["path_window"].values[k], own["path_kind"].values[k])
    for name in ("source", "window", "kind", "power", "total_reflections"):
        assert [beam[name] for beam in told["beams"]] == own[f"beam_{name}"].values.tolist(), name
    np.testing.assert_allclose([beam["direction"] for beam in told["beams"]], own["beam_direction"], atol=1e-6)
    for k, patch in enumerate(told["patches"]):
        corners = own["patch_corner_m"].values[k]
        np.testing.assert_allclose(patch["polygon"], corners[~np.isnan(corners[:, 0])], atol=6e-5)
        assert patch["illuminance_per_normal"] == float(own["patch_strength"][k])
        source = own["patch_source_m"].values[k, : len(patch["polygon"])]
        np.testing.assert_allclose(patch["source"], source, atol=6e-5)
        of = (patch["beam"], patch["surface"], patch["area_m2"])
        assert of == tuple(own[f"patch_{name}"].values[k] for name in ("beam", "surface", "area_m2"))
    at = ask(rooms, "paths", room=ROOM, **WHEN)
    sun = ask(rooms, "sun", site=start_tables()["site"], **WHEN)
    assert (at["altitude_deg"], at["direction"]) == (sun["altitude_deg"], sun["direction"])
    night = ask(rooms, "paths", room=ROOM, day_of_year=172, hour=1.0)
    assert (night["is_up"], night["paths"], night["beams"], night["patches"]) == (False, [], [], [])


def test_light_is_that_of_the_api_pooled(rooms: Any, lit: Any, key: str) -> None:
    """The mean of three calls of `daylight_coefficients`, and of the sun's; their scatter is the error."""
    told = ask(rooms, "light", key=key, sky=CLEAR, **WHEN)
    room, site = lit.room(), lit.site
    sun = sun_position(site, "2026-06-21 11:00").isel(time=0)
    altitude, azimuth = float(sun.apparent_altitude_deg), float(sun.azimuth_deg)
    direct = float(direct_normal_illuminance_lx(site, "2026-06-21 11:00", luminous_turbidity=4.0)[0])
    diffuse = float(usual_diffuse_horizontal_lx(12, altitude))
    assert told["outside"]["direct_normal_lx"] == pytest.approx(direct)
    assert told["outside"]["diffuse_horizontal_lx"] == pytest.approx(diffuse)
    sky = CieSky(
        sky_type=12,
        sun_altitude_deg=altitude,
        sun_azimuth_deg=azimuth,
        diffuse_horizontal_illuminance_lx=diffuse,
        direct_normal_illuminance_lx=direct,
    )
    passes = [
        daylight_coefficients(room, basis="tregenza145", rounds=2, nodes=512, window_samples=64, seed=seed)
        for seed in range(3)
    ]
    each = np.stack([illuminance(one, sky).total.values for one in passes])
    np.testing.assert_allclose(told["parts"]["sky"], each.mean(axis=0), rtol=2e-6)
    np.testing.assert_allclose(told["sky_standard_error_lx"], each.std(axis=0, ddof=1) / np.sqrt(3.0), rtol=1e-2)
    suns = [
        sun_coefficients(
            room, altitude_deg=round(altitude, 4), azimuth_deg=round(azimuth, 4), rounds=2, seed=seed, any_sun=True
        ).isel(sun=0)
        for seed in range(2)
    ]
    for part in ("direct", "redirected", "interreflected"):
        own = np.mean([one[part].values for one in suns], axis=0) * direct
        np.testing.assert_allclose(told["parts"][f"sun_{part}"], own, rtol=1e-9)
    total = sum(np.array(part) for part in told["parts"].values())
    np.testing.assert_allclose(told["total_lx"], total, rtol=1e-12)
    assert told["mean_lx"] == pytest.approx(total.mean())
    assert told["uniformity"] == pytest.approx(total.min() / total.mean())
    # each sensor's own errors, of the sun as its rounds scatter
    parts = ("direct", "redirected", "interreflected")
    rounds = np.sqrt(sum(one[f"{part}_standard_error"].values ** 2 for one in suns for part in parts)) / 2.0
    np.testing.assert_allclose(told["sun_standard_error_lx"], rounds * direct, rtol=1e-9)
    together = np.hypot(told["sky_standard_error_lx"], told["sun_standard_error_lx"])
    np.testing.assert_allclose(told["standard_error_lx"], together, rtol=1e-12)
    assert np.ptp(together) > 0.01 * together.max(), "or another sensor's would do as well"
    # sensors err together: the mean is worse than if they did not
    assert told["mean_standard_error_lx"] > np.linalg.norm(told["standard_error_lx"]) / len(total)
    lit = np.stack([sum(one[part].values for part in parts) for one in suns]) * direct
    even, darkest = np.full(len(total), 1.0 / len(total)), np.arange(len(total)) == total.argmin()
    # of least over mean, by the quotient's rule
    slope = darkest / total.mean() - even * total.min() / total.mean() ** 2
    for name, weights in (("mean_standard_error_lx", even), ("uniformity_standard_error", slope)):
        by_sky, by_sun = ((one @ weights).std(ddof=1) / np.sqrt(len(one)) for one in (each, lit))
        assert told[name] == pytest.approx(np.hypot(by_sky, by_sun), rel=1e-2), name
    factor = np.mean([daylight_factor(one).total.values for one in passes], axis=0)
    np.testing.assert_allclose(told["daylight_factor_percent"], factor, rtol=1e-9)
    scale = factor / np.mean([one.sky_illuminance.values for one in passes], axis=0)
    error = np.sqrt(sum(one.sky_illuminance_standard_error.values**2 for one in passes)) / 3.0
    np.testing.assert_allclose(told["daylight_factor_standard_error_percent"], scale * error, rtol=1e-6)
    assert float(uniformity(daylight_factor(passes[0]).total)) > 0.0


def test_an_overcast_sky_has_the_daylight_factor(rooms: Any, key: str) -> None:
    sky = {"kind": "overcast", "diffuse_horizontal_illuminance_lx": 10_000.0}
    told = ask(rooms, "light", key=key, sky=sky, **WHEN)
    np.testing.assert_allclose(told["total_lx"], np.array(told["daylight_factor_percent"]) * 100.0, rtol=1e-5)
    assert told["outside"]["direct_normal_lx"] == 0.0
    assert told["parts"]["sun_direct"] == [0.0] * len(told["total_lx"])


@pytest.mark.parametrize("sky", [CLEAR, {"kind": "overcast"}, {"kind": "weather", "path": EPW}])
def test_a_night_has_no_light_and_no_error(rooms: Any, key: str, sky: dict[str, Any]) -> None:
    told = ask(rooms, "light", key=key, sky=sky, day_of_year=172, hour=1.0)
    assert set(told["total_lx"]) == set(told["standard_error_lx"]) == {0.0}
    assert (told["mean_lx"], told["uniformity"], told["worst_relative_error"]) == (0.0, None, 0.0)


def test_weather_is_the_hour_of_the_file(rooms: Any, key: str, room_folder: Any) -> None:
    told = ask(rooms, "light", key=key, sky={"kind": "weather", "path": EPW}, day_of_year=200, hour=13.7)
    weather = read_epw(room_folder / EPW)
    moment = pd.Timestamp(f"{weather.times[5000].year}-07-19 13:42").tz_localize(weather.site.timezone)
    own = weather.sky(moment)
    assert told["outside"]["diffuse_horizontal_lx"] == pytest.approx(own.diffuse_horizontal_lx)
    assert told["outside"]["direct_normal_lx"] == pytest.approx(own.direct_normal_illuminance_lx)
    assert told["sun"]["altitude_deg"] == pytest.approx(own.sun_altitude_deg)
    assert told["mean_lx"] > 0.0
    for day, hour in ((1, 0.0), (365, 24.0)):
        ask(rooms, "light", key=key, sky={"kind": "weather", "path": EPW}, day_of_year=day, hour=hour)


def test_files_of_the_folder_are_rooms_years_too(rooms: Any, room_folder: Any) -> None:
    told = ask(rooms, "scene", room={"path": "classroom.toml"})
    assert told["variants"] == ["glass only", "glass and laser-cut panel"]
    own = read_room(room_folder / "classroom.toml")
    assert [one["name"] for one in told["windows"]] == [one.name for one in own.windows]
    year = ask(rooms, "scene", room={"path": "year.toml"})
    assert year["variants"] == ["glass", "laser-cut panel above", "prismatic sheet above"]
    assert year["site"]["latitude_deg"] == pytest.approx(25.82)
    named = ask(rooms, "scene", room={"path": "sub/named.toml"})
    assert named["variants"][0] == "glass only"
    assert ask(rooms, "paths", room={"path": "year.toml"}, variant="prismatic sheet above", day_of_year=15, hour=12.0)[
        "beams"
    ]


def test_toml_goes_out_and_comes_back(rooms: Any, tmp_path: Any) -> None:
    text = ask(rooms, "toml", room=ROOM)["text"]
    assert tomllib.loads(text) == start_tables()
    assert ask(rooms, "read", text=text)["tables"] == start_tables()
    (tmp_path / "room.toml").write_text(text, encoding="utf-8")
    assert [one.name for one in read_room(tmp_path / "room.toml").windows] == ["window 1", "window 2"]
    for wrong in ("name = ", "[shoebox]\nwidth_m = 1.0\n", "[[[", "name = 'x'"):
        refused(rooms, "read", text=wrong)


@pytest.mark.parametrize(
    ("path", "value", "field"),
    [
        (("shoebox", "width_m"), -1.0, "width_m"),
        (("shoebox", "floor"), 1.5, None),
        (("shoebox", "opening", 0, "sill_m"), 9.0, None),
        (("shoebox", "opening", 0, "part", 0, "glazing"), "crystal", None),
        (("glazings", "glass", "transmittance"), 2.0, "transmittance"),
        (("site", "latitude_deg"), 100.0, "latitude_deg"),
        (("ground_reflectance",), -0.1, "ground_reflectance"),
        (("sensors", 0, "spacing_m"), 0.0, None),
        (("shoebox", "widht_m"), 4.0, None),
    ],
)
def test_mistakes_are_told_beside_their_field(rooms: Any, path: tuple[Any, ...], value: Any, field: str | None) -> None:
    fault = refused(rooms, "scene", room=changed(*path, value=value))
    assert fault["message"]
    if field:
        assert fault["field"] == field, fault


def test_other_mistakes_are_told(rooms: Any, key: str) -> None:
    assert refused(rooms, "scene", room=ROOM, variant="gold")["field"] == "variant"
    assert refused(rooms, "scene", room={})["message"].startswith("room must have tables or a path")
    assert refused(rooms, "scene", room={"tables": []})["field"] == "tables"
    assert refused(rooms, "sun", site={"latitude_deg": 1.0}, **WHEN)["message"]
    assert refused(rooms, "sun", site=start_tables()["site"], day_of_year=366, hour=1.0)["field"] == "day_of_year"
    assert refused(rooms, "sun", site=start_tables()["site"], day_of_year=1, hour=25.0)["field"] == "hour"
    assert refused(rooms, "paths", room=ROOM)["field"] == "day_of_year"
    assert refused(rooms, "paths", room=ROOM, altitude_deg=20.0)["field"] == "altitude_deg"
    assert refused(rooms, "paths", room=ROOM, density=0, **WHEN)["field"] == "density"
    assert refused(rooms, "light", key="none", sky=CLEAR, **WHEN)["field"] == "key"
    for sky, field in (
        ({"kind": "pink"}, "kind"),
        ({"kind": "cie", "sky_type": 17}, "sky_type"),
        (CLEAR | {"luminous_turbidity": 0.5}, "luminous_turbidity"),
        (CLEAR | {"diffuse_horizontal_illuminance_lx": -1.0}, "diffuse_horizontal_illuminance_lx"),
        (CLEAR | {"cloud": 1}, None),
    ):
        fault = refused(rooms, "light", key=key, sky=sky, **WHEN)
        assert field is None or fault["field"] == field, fault
    many = changed("sensors", 0, "spacing_m", value=0.01)
    assert "at most 4000 sensors" in refused(rooms, "scene", room=many)["message"]


def test_windows_of_unknown_beams_leave_the_sky(rooms: Any, asked: Any) -> None:
    """Rough cuts have no beams: the sky's light is told, the sun's is left out, and a note says so."""
    tables = copy.deepcopy(start_tables())
    tables["glazings"]["laser-cut-panel"]["cut_slope_deg"] = 3.0
    rough = asked_room(rooms.app.state, {"room": {"tables": tables}})
    sensors, _ = plane_sensors(rough.room(), None)
    shelf = rooms.app.state.room_shelf
    kept = shelf.plane(rough, None, sensors, "tregenza145")
    shelf.add(kept.key, 0, (one_pass(rough.room(), sensors, "tregenza145", 0, 64)[0], 0.1))
    told = ask(rooms, "light", key=kept.key, sky=CLEAR, **WHEN)
    assert told["mean_lx"] > 0.0
    assert told["notes"][0].startswith("the sun's own light is left out")
