"""What the studio says of results is what their files hold; what is none is refused in words."""

import json
import shutil
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from tests.studio.conftest import TestClient
from tests.studio.following import looked

from clerestory.illuminance import daylight_factor
from clerestory.site import Site
from clerestory.studio.app import make_app
from clerestory.studio.glazing_words import glazing_words
from clerestory.studio.settings import Settings
from clerestory.sun import sun_position
from clerestory.year.figures import FIGURES

YEAR = "out/year/year.nc"


@pytest.fixture(scope="module")
def client(result_folder: Path) -> Iterator[TestClient]:
    with TestClient(make_app(Settings(folder=result_folder, workers=1)), base_url="http://127.0.0.1:8765") as one:
        yield one


@pytest.fixture(scope="module")
def year(result_folder: Path) -> xr.Dataset:
    with xr.open_dataset(result_folder / YEAR) as found:
        return found.load()


def asked(client: TestClient, call: str, /, **fields: Any) -> dict[str, Any]:
    answer = client.post(f"/api/result/{call}", json=fields)
    assert answer.status_code == 200, answer.text
    told: dict[str, Any] = answer.json()
    return told


def wrong(client: TestClient, call: str, /, **fields: Any) -> str:
    answer = client.post(f"/api/result/{call}", json=fields)
    assert answer.status_code == 422, answer.text
    return str(answer.json()["errors"][0]["message"])


def opened(client: TestClient, path: str) -> dict[str, Any]:
    return asked(client, "open", path=path)


def test_the_folder_lists_each_result_once_with_its_kind(client: TestClient) -> None:
    found = asked(client, "files")
    assert {(one["path"], one["kind"]) for one in found["results"]} == {
        ("out/year/year.nc", "year"),
        ("out/room/summary.json", "room"),
        ("out/sweep/results.zarr", "sweep"),
        ("out/design/summary.json", "design"),
        ("out/panel/angular.nc", "panel"),
    }
    assert [(one["path"], one["title"]) for one in found["years"]] == [("year.toml", "Small room")]


def test_a_year_is_told_with_its_figures_and_where_it_comes_from(client: TestClient, year: xr.Dataset) -> None:
    told = opened(client, YEAR)
    assert (told["kind"], told["title"], told["source"]) == ("year", "Small room", "year.toml")
    assert told["variants"] == year["variant"].values.tolist()
    assert {row["name"] for row in told["figures"]} == {one.name for one in FIGURES if one.name in year}
    for row in told["figures"]:
        np.testing.assert_allclose([cell["value"] for cell in row["cells"]], year[row["name"]].values)
        error = f"{row['name']}_standard_error"
        if error in year:
            np.testing.assert_allclose([cell["error"] for cell in row["cells"]], year[error].values)
    assert {"Version", "Computed", "Calculation, seed"} <= {one["label"] for one in told["provenance"]}
    # the darker panes let less light in, by more than their errors
    row = next(one for one in told["figures"] if one["name"] == "mean_daylight_factor")
    assert told["variants"].index("dark") not in row["best"]
    assert row["best"]


def test_plans_hold_the_values_of_the_sensors_where_they_are(client: TestClient, year: xr.Dataset) -> None:
    told = opened(client, YEAR)
    for metric in told["metrics"]:
        plan = asked(client, "plan", key=told["key"], metric=metric["key"])
        name, _, entry = metric["key"].partition("|")
        values = year[name].sel(band=entry) if entry else year[name]
        factor = 100.0 if name == "relative_standard_error" else 1.0
        sensors = np.array(plan["sensors"])
        for place, label in enumerate(told["variants"]):
            own = np.array(plan["variants"][place]["values"], dtype=float)
            np.testing.assert_allclose(own, factor * values.sel(variant=label).values[sensors], rtol=1e-12)
            if f"{name}_standard_error" in year and plan["variants"][place]["errors"]:
                error = year[f"{name}_standard_error"]
                error = error.sel(band=entry) if entry else error
                own = np.array(plan["variants"][place]["errors"], dtype=float)
                np.testing.assert_allclose(own, error.sel(variant=label).values[sensors], rtol=1e-12)
        assert plan["low"] <= plan["variants"][0]["most"] <= plan["high"] * (1 + 1e-12)
    # the floor of 3 by 5 m, the window in the wall that rows count from
    assert np.ptp(plan["outline"], axis=0) == pytest.approx([3.0, 5.0])
    assert all(point[1] <= 1e-3 for window in plan["windows"] for point in window["points"])
    assert plan["x"] == pytest.approx([0.5, 1.5, 2.5])
    assert plan["y"] == pytest.approx([0.5, 1.5, 2.5, 3.5, 4.5])
    nearest = int(np.argmin(np.abs(year["y_m"].values)))
    assert plan["sensors"].index(nearest) // 3 == 0


def test_a_case_of_a_sweep_is_a_year_of_one_variant(client: TestClient, year: xr.Dataset, tmp_path: Path) -> None:
    path = tmp_path / "case.nc"
    year.isel(variant=1).drop_vars(["variant", "glazings"]).assign_attrs(variant="panel above").to_netcdf(path)
    told = client.post("/api/result?name=case.nc", content=path.read_bytes()).json()
    assert (told["kind"], told["variants"]) == ("year", ["panel above"])
    plan = asked(client, "plan", key=told["key"], metric="daylight_autonomy")
    values = year["daylight_autonomy"].values[1]
    np.testing.assert_allclose(plan["variants"][0]["values"], values[plan["sensors"]])
    assert asked(client, "carpet", key=told["key"])["variants"][0]["label"] == "panel above"


def test_a_difference_and_a_section_are_those_of_the_plans(client: TestClient) -> None:
    told = opened(client, YEAR)
    look = {"key": told["key"], "metric": "daylight_autonomy"}
    plan, section = asked(client, "plan", **look), asked(client, "section", **look)
    change = asked(client, "difference", variant="dark", minus="glass", **look)
    dark, glass = (plan["variants"][told["variants"].index(label)] for label in ("dark", "glass"))
    np.testing.assert_allclose(change["variants"][0]["values"], np.subtract(dark["values"], glass["values"]))
    np.testing.assert_allclose(change["variants"][0]["errors"], np.hypot(dark["errors"], glass["errors"]))
    assert change["low"] == -change["high"]
    rows = np.array(glass["values"]).reshape(5, 3)
    np.testing.assert_allclose(section["variants"][0]["mean"], rows.mean(axis=1))
    np.testing.assert_allclose(section["variants"][0]["least"], rows.min(axis=1))
    assert "must be one of" in wrong(client, "difference", variant="none", minus="glass", **look)
    assert "metric must be one of" in wrong(client, "plan", key=told["key"], metric="nothing")


def test_a_carpet_is_the_year_by_the_wall_clock(client: TestClient, year: xr.Dataset) -> None:
    key = opened(client, YEAR)["key"]
    carpet = asked(client, "carpet", key=key)
    days = pd.DatetimeIndex(year["local_time"].values)
    assert carpet["days"] == sorted({f"{day:%Y-%m-%d}" for day in days})
    told = carpet["variants"]
    assert [one["label"] for one in told] == year["variant"].values.tolist()
    cells, shut = (
        np.array([one[name] for one in told], dtype=float).reshape(len(told), carpet["rows"], -1)
        for name in ("values", "blinds")
    )
    used = np.array(carpet["in_use"], dtype=float).reshape(carpet["rows"], -1)
    for place, at in enumerate(days):
        row, column = at.hour, carpet["days"].index(f"{at:%Y-%m-%d}")
        np.testing.assert_allclose(cells[:, row, column], year["mean_illuminance"][:, place], rtol=1e-3)
        closed = year["blinds_closed"].isel(time=place).mean("window_group")
        np.testing.assert_allclose(shut[:, row, column], closed, atol=0.006)
        assert bool(used[row, column]) == bool(year["in_use"][0, place])
    # 25.8° north in March: the sun rises near six of solar time; the clock of 75° W is 21 min ahead of 80.3° W
    rise, fall = carpet["sunrise"][1], carpet["sunset"][1]
    assert 6.0 < rise < 7.0
    assert fall - rise == pytest.approx(12.1, abs=0.1)
    one = asked(client, "carpet", key=key, series="sensor", sensor=7)
    noon = year["illuminance"].values[:, 7, days.hour == 12][:, 0]
    found = [np.array(cells["values"]).reshape(24, -1)[12, 0] for cells in one["variants"]]
    assert found == pytest.approx(noon, rel=1e-3)
    assert len(set(noon)) == 3
    assert "sensor must be" in wrong(client, "carpet", key=key, series="sensor", sensor=10_000)
    months = asked(client, "months", key=key)
    for k, mean in enumerate(year["mean_illuminance"].values):
        in_use = year["in_use"][k].values.astype(bool)
        assert months["variants"][k]["in_use"] == [pytest.approx(mean[in_use].mean())]
        assert months["variants"][k]["daylit"] == [pytest.approx(mean[mean > 0.0].mean())]


def test_one_hour_is_the_light_of_that_hour(client: TestClient, year: xr.Dataset) -> None:
    key = opened(client, YEAR)["key"]
    day = str(year["local_time"].values[0])[:10]
    plan = asked(client, "hour", key=key, day=day, hour=13.2)
    place = int(np.flatnonzero(pd.DatetimeIndex(year["local_time"].values).hour == 13)[0])
    light = year["illuminance"].values[:, :, place]
    site = Site(latitude_deg=float(year.attrs["latitude_deg"]), longitude_deg=float(year.attrs["longitude_deg"]))
    sun = sun_position(site, pd.DatetimeIndex([year["time"].values[place]], tz="UTC")).isel(time=0)
    assert plan["sun"]["altitude_deg"] == pytest.approx(float(sun.apparent_altitude_deg))
    assert plan["sun"]["azimuth_deg"] == pytest.approx(float(sun.azimuth_deg))
    for variant in range(3):
        own = np.array(plan["variants"][variant]["values"], dtype=float)
        np.testing.assert_allclose(own, light[variant][plan["sensors"]], rtol=1e-6)
    assert plan["time"] == f"{day}T13:30"
    assert 50.0 < plan["sun"]["altitude_deg"] < 65.0
    closed = year["blinds_closed"].values[:, 0, place]
    assert [bool(plan["blinds_closed"][label]) for label in year["variant"].values.tolist()] == closed.tolist()
    assert "hour must be" in wrong(client, "hour", key=key, day="1999-01-01", hour=12)
    assert "date such as" in wrong(client, "hour", key=key, day="noon", hour=12)


def test_rooms_of_a_study_stand_side_by_side(client: TestClient, result_folder: Path) -> None:
    told = opened(client, "out/room/summary.json")
    assert (told["kind"], told["source"]) == ("room", "room.toml")
    assert told["variants"] == ["glass", "panel above", "dark"]
    with xr.open_dataset(result_folder / "out/room/dark-coefficients.nc") as found:
        factor = daylight_factor(found.load())
    plan = asked(client, "plan", key=told["key"], metric="daylight_factor")
    np.testing.assert_allclose(plan["variants"][2]["values"], factor["total"].values[plan["sensors"]])
    np.testing.assert_allclose(plan["variants"][2]["errors"], factor["total_standard_error"].values[plan["sensors"]])
    skies = [
        asked(client, "plan", key=told["key"], metric=f"illuminance|{sky}") for sky in ("overcast", "bright overcast")
    ]
    np.testing.assert_allclose(skies[1]["variants"][0]["values"], 2.0 * np.array(skies[0]["variants"][0]["values"]))
    for name in ("dark-illuminance.nc", "dark-coefficients.nc", "dark-daylight-factor.csv"):
        alone = opened(client, f"out/room/{name}")
        assert (alone["kind"], alone["variants"]) == ("room", ["dark"]), name
    with open(result_folder / "out/room/summary.json", encoding="utf-8") as file:
        mean = json.load(file)["glass"]["daylight_factor_percent"]["mean"]
    row = next(one for one in told["figures"] if one["name"] == "daylight_factor.mean")
    assert row["cells"][0]["value"] == pytest.approx(mean)


@pytest.mark.parametrize("path", ["out/sweep/results.zarr", "out/sweep/results.csv", "out/sweep/summary.json"])
def test_a_sweep_is_a_table_of_its_cases(client: TestClient, result_folder: Path, path: str) -> None:
    table = pd.read_csv(result_folder / "out/sweep/results.csv", comment="#")
    told = opened(client, path)
    cases = asked(client, "cases", key=told["key"])
    columns = {one["name"]: one for one in cases["columns"]}
    assert {name for name, one in columns.items() if one["role"] == "parameter"} == {"spacing_mm", "cut_width_mm"}
    assert columns["spacing_mm"]["unit"] == "mm"
    for name, one in columns.items():
        if one["is_number"]:
            np.testing.assert_allclose(np.array(one["values"], dtype=float), table[name].to_numpy(dtype=float))
    # two of the six have cuts wider than their spacing allows
    assert columns["status"]["values"] == table["status"].tolist()
    assert "failed" in columns["status"]["values"]
    assert cases["start"]["x"] in columns


@pytest.mark.parametrize("path", ["out/design/summary.json", "out/design/history.csv"])
def test_a_design_has_its_front_and_its_best(client: TestClient, result_folder: Path, path: str) -> None:
    cases = asked(client, "cases", key=opened(client, path)["key"])
    summary = json.loads((result_folder / "out/design/summary.json").read_text())
    columns = {one["name"]: one for one in cases["columns"]}
    trials = columns["trial"]["values"]
    assert {trials[row] for row in cases["front"]} == {one["number"] for one in summary["front"]}
    assert trials[cases["best"]] == summary["best"]["number"]
    assert [one["figure"] for one in cases["objectives"]] == ["mean_band_transmittance", "mean_transmittance"]
    figures = [columns[name]["values"][cases["best"]] for name in ("mean_band_transmittance", "mean_transmittance")]
    assert figures == pytest.approx(summary["best"]["figures"])
    along = [columns["mean_band_transmittance"]["values"][row] for row in cases["front"]]
    assert along == sorted(along)


def test_a_panels_table_is_drawn_against_elevation(client: TestClient, result_folder: Path) -> None:
    cases = asked(client, "cases", key=opened(client, "out/panel/angular.nc")["key"])
    columns = {one["name"]: one["values"] for one in cases["columns"]}
    with xr.open_dataset(result_folder / "out/panel/angular.nc") as found:
        np.testing.assert_allclose(columns["transmittance_deflected"], found["transmittance_deflected"].values.ravel())
    assert columns["elevation"] == [0, 20, 40, 60]
    assert (cases["start"]["x"], cases["start"]["y"][0]) == ("elevation", "transmittance_deflected")


@pytest.mark.parametrize(
    ("told", "words"),
    [
        (
            "window 1: LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, cut_width_mm=0.0, medium=Medium.named('pmma'))",
            "window 1: laser-cut panel, spacing 4 mm, thickness 6 mm, medium pmma",
        ),
        (
            "w: Stack(layers=(Glass(transmittance=0.88), Pane(thickness_mm=4.0, tilt_deg=None)))",
            "w: stack of 2: glass, transmittance 0.88 + pane, thickness 4 mm",
        ),
        ("anything else", "anything else"),
        ("w: Odd((", "w: Odd(("),
    ],
)
def test_glazings_are_told_in_words(told: str, words: str) -> None:
    assert glazing_words(told) == words


def test_what_is_dropped_is_the_same_as_what_is_opened(client: TestClient, result_folder: Path) -> None:
    told = opened(client, YEAR)
    dropped = client.post("/api/result?name=mine.nc", content=(result_folder / YEAR).read_bytes()).json()
    assert dropped["figures"] == told["figures"]
    assert (dropped["path"], dropped["source"]) == ("", "year.toml")
    assert asked(client, "open", key=dropped["key"])["name"] == "mine.nc"


def test_bad_files_are_refused_with_their_name_and_the_studio_lives_on(client: TestClient, result_folder: Path) -> None:
    whole = (result_folder / YEAR).read_bytes()
    piece = next((result_folder / "out/year/pieces").rglob("*.nc")).read_bytes()
    random = np.random.default_rng(1)
    broken = []
    for _ in range(12):
        at = bytearray(whole)
        for place in random.integers(8, min(len(at), 30_000), 40):
            at[place] = random.integers(0, 256)
        broken.append(bytes(at))
    cases: list[tuple[str, bytes, str]] = [
        ("empty.nc", b"", "no NetCDF"),
        ("text.nc", b"hello" * 100, "no NetCDF"),
        ("cut.nc", whole[: len(whole) // 3], "cut off, or damaged"),
        ("bytes.csv", b"\xff\xfe" * 30, "no text in UTF-8"),
        ("noise.nc", b"\x89HDF\r\n\x1a\n" + random.bytes(40_000), "noise.nc"),
        ("piece.nc", piece, "open the year.nc"),
        ("metrics.csv", (result_folder / "out/year/metrics.csv").read_bytes(), "year.nc beside it"),
        ("summary.json", (result_folder / "out/room/summary.json").read_bytes(), "drop …-illuminance.nc"),
        ("other.csv", b"a,b\n1,2\n", "is no result that the studio knows"),
        ("other.json", b"[" * 60_000, "must be JSON"),
        ("year.xlsx", b"PK", "must be a NetCDF, CSV or JSON"),
        ("../../x.nc", b"CDF\x01" + b"\0" * 100, "x.nc"),
    ]
    for name, content, says in cases:
        answer = client.post("/api/result", params={"name": name}, content=content)
        assert answer.status_code == 422, name
        message = answer.json()["errors"][0]["message"]
        assert says in message, (name, message)
        assert "clerestory-" not in message
        assert str(result_folder) not in message
    for content in broken:
        # a few bytes that are wrong may still be a year, of odd numbers
        answer = client.post("/api/result?name=broken.nc", content=content)
        assert answer.status_code in (200, 422), answer.text
        if answer.status_code == 200:
            for path in ("carpet", "months", "plan"):
                more = {"metric": "daylight_autonomy"} if path == "plan" else {}
                found = client.post(f"/api/result/{path}", json={"key": answer.json()["key"], **more})
                assert found.status_code in (200, 422), found.text
    assert opened(client, YEAR)["kind"] == "year"


def test_nothing_outside_the_folder_is_opened(client: TestClient, result_folder: Path) -> None:
    outside = result_folder.parent / "outside"
    outside.mkdir(exist_ok=True)
    shutil.copy(result_folder / YEAR, outside / "year.nc")
    link = result_folder / "link.nc"
    link.symlink_to(outside / "year.nc")
    store = result_folder / "linked.zarr"
    shutil.copytree(result_folder / "out/sweep/results.zarr", store)
    (store / "more").symlink_to(outside)
    try:
        for path in ("../outside/year.nc", str(outside / "year.nc"), "link.nc", "nothing.nc", "out"):
            assert "results" not in wrong(client, "open", path=path) or path == "out"
        assert "links out of it" in wrong(client, "open", path="linked.zarr")
    finally:
        link.unlink()
        shutil.rmtree(store)
    assert "open the file again" in wrong(client, "plan", key="none", metric="daylight_autonomy")
    sweep = opened(client, "out/sweep/results.csv")["key"]
    assert "kind year" in wrong(client, "carpet", key=sweep)


def test_a_year_file_must_lie_in_the_folder_with_all_that_it_names(client: TestClient, result_folder: Path) -> None:
    text = (result_folder / "year.toml").read_text()
    own = result_folder / "elsewhere.toml"
    try:
        for old, new in (('"clear.wea"', '"../outside/clear.wea"'), ("[weather]", 'room = "/etc/passwd"\n[weather]')):
            own.write_text(text.replace(old, new, 1))
            answer = client.post("/api/jobs", json={"kind": "year", "path": "elsewhere.toml"})
            assert answer.status_code == 422, new
            assert "studio's folder" in answer.json()["errors"][0]["message"]
    finally:
        own.unlink()
    for path in ("../year.toml", "clear.wea", "none.toml"):
        assert client.post("/api/jobs", json={"kind": "year", "path": path}).status_code == 422, path


def test_a_year_is_run_cancelled_and_goes_on_from_its_pieces(client: TestClient, result_folder: Path) -> None:
    text = (result_folder / "year.toml").read_text()
    (result_folder / "again.toml").write_text(
        text.replace("nodes = 256", "nodes = 512").replace("seed = 3", "seed = 4")
    )
    pieces = result_folder / "out/again/pieces"
    job = client.post("/api/jobs", json={"kind": "year", "path": "again.toml"}).json()["job"]
    told, late = {"state": "waiting"}, time.monotonic() + 600.0
    while time.monotonic() < late and not list(pieces.glob("cases/*.nc")):
        told = looked(client, job)
        assert told["state"] in ("waiting", "running"), told
        time.sleep(0.01)
    told = looked(client, job)
    assert 0.0 < told["done"] < 1.0
    assert told["partial"]["variant"] in ("glass", "panel above", "dark")
    client.delete(f"/api/jobs/{job}")
    kept = {path: path.stat().st_mtime_ns for path in pieces.glob("cases/*.nc")}
    assert kept
    assert not (result_folder / "out/again/year.nc").exists()
    job = client.post("/api/jobs", json={"kind": "year", "path": "again.toml"}).json()["job"]
    while time.monotonic() < late and told["state"] != "done":
        told = looked(client, job)
        assert told["state"] in ("waiting", "running", "done", "cancelled"), told
        time.sleep(0.1)
    assert told["result"]["path"] == "out/again/year.nc"
    assert all(path.stat().st_mtime_ns == at for path, at in kept.items())
    assert opened(client, told["result"]["path"])["source"] == "again.toml"
