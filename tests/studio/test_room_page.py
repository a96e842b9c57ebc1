"""The page's room in a real browser: the room in 3D, its sun and light moved, its numbers compared with the API.

CLERESTORY_PICTURES=folder keeps the pictures of docs/how-to/studio.md there.
"""

import base64
import csv
import json
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
import pytest
from tests.studio import chromium

from clerestory import (
    CieSky,
    daylight_coefficients,
    direct_normal_illuminance_lx,
    illuminance,
    read_room,
    sun_coefficients,
    sun_illuminance,
    sun_position,
)
from clerestory.room.toml_file import room_of
from clerestory.sky.availability import usual_diffuse_horizontal_lx
from clerestory.studio.room.kinds import start_tables

CLASSROOM = Path(__file__).parents[2] / "examples/classroom/classroom.toml"
#: Few sensors, so that the target is reached soon.
GRID = [{"surface": "floor", "spacing_m": 1.0, "height_m": 0.8, "name": "work plane"}]
COARSE = f"&room.tables={quote(json.dumps({'sensors': GRID}))}&room.error=0.05"

pytestmark = chromium.NEEDED


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("rooms")
    shutil.copy(CLASSROOM, folder)
    with chromium.studio_of(folder) as url:
        yield url


@pytest.fixture
def tab(browser: Any, studio: str) -> Iterator[Any]:
    """An empty tab that fails the test on any error in the page, and on any request that leaves the studio."""
    one = browser.new_page(viewport=chromium.SIZE)
    wrong = chromium.watched(one, studio)
    yield one
    one.close()
    assert not wrong


def opened(tab: Any, studio: str, state: str = "", theme: str = "light") -> None:
    """The room view, its first numbers there."""
    tab.goto("about:blank")
    tab.goto(f'{studio}#view="room"&theme="{theme}"{state}')
    tab.wait_for_selector("canvas[data-drawn]")
    number(tab, "mean")


def number(tab: Any, name: str) -> float:
    """A number as the page got it, waited for."""
    tab.wait_for_function(
        "name => document.querySelector(`[data-number=${name}]`)?.dataset.value"
        " && !document.querySelector('.roomNumbers.stale')",
        arg=name,
    )
    return float(tab.locator(f"[data-number={name}]").get_attribute("data-value"))


def changed(tab: Any, name: str, old: float) -> float:
    """A number once it is another."""
    tab.wait_for_function(
        "([name, old]) => { const now = document.querySelector(`[data-number=${name}]`)?.dataset.value;"
        " return now && Number(now) !== old && !document.querySelector('.roomNumbers.stale'); }",
        arg=[name, old],
    )
    return number(tab, name)


def colours(tab: Any) -> "np.ndarray[Any, Any]":
    """The canvas as the screen shows it, by way of the page's own decoder of PNG."""
    shot = base64.b64encode(tab.locator(".stage canvas").screenshot()).decode()
    values = tab.evaluate(
        """async shot => {
            const image = new Image();
            image.src = `data:image/png;base64,${shot}`;
            await image.decode();
            const canvas = document.createElement("canvas");
            [canvas.width, canvas.height] = [160, 80];
            const pen = canvas.getContext("2d");
            pen.drawImage(image, 0, 0, 160, 80);
            return Array.from(pen.getImageData(0, 0, 160, 80).data);
        }""",
        shot,
    )
    return np.array(values, dtype=float).reshape(80, 160, 4)[..., :3]


def settled(tab: Any) -> None:
    """Waits until the work has reached its target, of the sun as well, and is drawn."""
    tab.wait_for_selector(".roomProgress[data-whole=true]")
    chromium.is_still(tab)


def api_light(minute: int) -> tuple[Any, Any]:
    """Illuminance at the sensors on 21 June and its standard error, as a script asks for them."""
    room = room_of(start_tables() | {"sensors": GRID})
    when = f"2026-06-21 {minute // 60:02d}:{minute % 60:02d}"
    sun = sun_position(room.site, when).isel(time=0)
    altitude, azimuth = float(sun.apparent_altitude_deg), float(sun.azimuth_deg)
    normal = float(direct_normal_illuminance_lx(room.site, when, luminous_turbidity=4.0)[0])
    sky = CieSky(
        sky_type=12,
        sun_altitude_deg=altitude,
        sun_azimuth_deg=azimuth,
        diffuse_horizontal_illuminance_lx=float(usual_diffuse_horizontal_lx(12, altitude)),
        direct_normal_illuminance_lx=normal,
    )
    coefficients = daylight_coefficients(room, basis="reinhart577", target_relative_error=0.05, seed=2026, sky=sky)
    from_sky = illuminance(coefficients, sky)
    suns = sun_coefficients(room, altitude_deg=altitude, azimuth_deg=azimuth, rounds=64, seed=2026)
    from_sun = sun_illuminance(suns, normal).squeeze()
    error = np.hypot(from_sky.total_standard_error, from_sun.total_standard_error)
    return (from_sky.total + from_sun.total).values, error.values


def exported(tab: Any) -> dict[str, "np.ndarray[Any, Any]"]:
    """The plan's table as it is saved."""
    with tab.expect_download() as waiting:
        tab.locator('section[aria-label^="Plan"]').get_by_role("button", name="CSV").click()
    rows = list(csv.DictReader(Path(waiting.value.path()).read_text().splitlines()))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def test_a_room_is_seen_and_its_numbers_are_the_apis(tab: Any, studio: str) -> None:
    opened(tab, studio, COARSE)
    seen = colours(tab)
    assert seen.std(axis=(0, 1)).min() > 12.0, "nothing is drawn"
    settled(tab)
    told = exported(tab)
    expected, error = api_light(660)
    off = (told["total_lx"] - expected) / np.hypot(told["standard_error_lx"], error)
    assert len(off) == 32
    assert np.sqrt(np.mean(off**2)) < 2.0
    assert np.isclose(number(tab, "mean"), told["total_lx"].mean(), rtol=1e-6)
    parts = sum(told[f"{part}_lx"] for part in ("sky", "sun_direct", "sun_redirected", "sun_interreflected"))
    np.testing.assert_allclose(parts, told["total_lx"], rtol=1e-9)
    assert "21 June, 11:00" in (tab.locator(".stage canvas").get_attribute("aria-label") or "")


def falls(tab: Any, name: str, most: float) -> None:
    """Waits until a number is no more than that."""
    place = f'[data-number="{name}"]'
    tab.wait_for_function(
        "([place, most]) => { const told = document.querySelector(place)?.dataset.value;"
        " return told !== undefined && told !== '' && Number(told) <= most }",
        arg=[place, most],
    )


def test_time_moves_the_sun_and_the_light_until_night(tab: Any, studio: str) -> None:
    opened(tab, studio, COARSE)
    before, seen = number(tab, "mean"), colours(tab)
    tab.locator("#room-minute").fill("510")
    sun = sun_position(room_of(start_tables()).site, "2026-06-21 08:30").isel(time=0)
    tab.get_by_text(f"sun {float(sun.apparent_altitude_deg):.1f}° high").first.wait_for()
    early = changed(tab, "mean", before)
    chromium.is_drawn(tab)
    assert np.abs(colours(tab) - seen).mean() > 1.0
    tab.locator("#room-day").fill("355")
    tab.get_by_text("21 December").first.wait_for()
    # the sun is in the south, behind the room: the sky alone is left; what the first hour still refines by is far less
    falls(tab, "mean", 0.95 * early)
    tab.locator("#room-minute").fill("1320")
    tab.get_by_text("the sun is below the horizon").first.wait_for()
    falls(tab, "mean", 0.0)


def test_the_sun_is_dragged_along_its_day_and_moved_by_keys(tab: Any, studio: str) -> None:
    opened(tab, studio, COARSE)
    settled(tab)
    sun = tab.get_by_role("slider", name="Sun: drag")
    tab.wait_for_function("() => !document.querySelector('.sunHandle').hidden")
    box = sun.bounding_box()
    tab.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    tab.mouse.down()
    tab.mouse.move(box["x"] - 110, box["y"] + 90, steps=6)
    tab.mouse.up()
    tab.wait_for_function("() => Number(document.querySelector('#room-minute').value) > 720")
    chromium.is_drawn(tab)
    minute = int(tab.locator("#room-minute").input_value())
    sun.focus()
    tab.keyboard.press("ArrowRight")
    tab.wait_for_function("minute => Number(document.querySelector('#room-minute').value) === minute + 5", arg=minute)


def test_work_refines_while_one_looks_stops_and_goes_on(tab: Any, studio: str) -> None:
    opened(tab, studio, COARSE.replace("0.05", "0.0005"))
    tab.evaluate(
        """() => {
            const place = document.querySelector(".roomProgress");
            window.seen = [];
            const look = () => {
                const { rounds, error } = place.dataset;
                if (error) window.seen.push([Number(rounds), Number(error)]);
            };
            look();
            new MutationObserver(look).observe(place, { attributes: true });
        }"""
    )
    tab.wait_for_function("() => new Set(window.seen.map(one => one[0])).size >= 4")
    stop = tab.locator(".roomProgress").get_by_role("button", name="Stop")
    stop.click()
    tab.wait_for_selector(".roomProgress[data-state=cancelled]")
    seen = np.array(tab.evaluate("() => window.seen"))
    rounds, first = np.unique(seen[:, 0], return_index=True)
    errors = seen[first, 1]
    assert rounds[-1] > rounds[0]
    assert errors[-1] < errors[0]
    tab.locator(".roomProgress").get_by_role("button", name="Go on").click()
    tab.wait_for_function(
        "rounds => Number(document.querySelector('.roomProgress').dataset.rounds) > rounds", arg=rounds[-1]
    )
    stop.click()


def test_variants_and_glazings_of_window_parts_are_chosen(tab: Any, studio: str) -> None:
    opened(tab, studio, COARSE)
    before = number(tab, "mean")
    tab.locator("#room-variant").select_option("glass only")
    tab.get_by_text("window 1: glass", exact=True).wait_for()
    plain = changed(tab, "mean", before)
    tab.locator("#room-variant").select_option("laser-cut panel above")
    tab.get_by_text("window 1: glass + laser-cut panel").wait_for()
    tab.get_by_label("Glazing of window 1").select_option("panel A")
    tab.get_by_text("window 1: laser-cut panel", exact=True).wait_for()
    assert changed(tab, "mean", plain) != before
    tab.locator("#room-plane").select_option("on ceiling")
    tab.locator('section[aria-label="Plan of the surface: on ceiling"]').wait_for()


def test_rooms_are_opened_changed_and_saved_and_mistakes_told_beside_their_slider(
    tab: Any, studio: str, tmp_path: Path
) -> None:
    opened(tab, studio, "&room.error=0.1")
    tab.locator("#room-file").select_option("classroom.toml")
    tab.get_by_text("window 1: glass", exact=True).wait_for()
    tab.locator("#room-shoebox-depth_m").fill("6")
    tab.wait_for_function(
        "() => document.querySelector('#room-file').selectedOptions[0].text === 'classroom.toml, changed'"
    )
    with tab.expect_download() as waiting:
        tab.get_by_role("button", name="Save TOML").click()
    saved = tmp_path / "room.toml"
    waiting.value.save_as(saved)
    floor = next(one for one in read_room(saved).surfaces if one.name == "floor")
    assert np.ptp(np.array(floor.outline_m), axis=0).tolist() == [4.0, 6.0, 0.0]
    tab.locator("#room-shoebox-width_m").fill("3")
    fault = tab.locator("#room-shoebox-opening-0-width_m-wrong")
    fault.wait_for()
    assert "must lie within its wall" in fault.inner_text()
    tab.locator("#room-shoebox-width_m").fill("5")
    fault.wait_for(state="detached")
    text = saved.read_text().replace("depth_m = 6", "depth_m = 5.0 #")
    (tmp_path / "mine.toml").write_text(text.replace("Maceio", "Maceio"))
    own = tab.locator('.side input[accept=".toml"]')
    own.set_input_files(tmp_path / "mine.toml")
    tab.wait_for_function("() => document.querySelector('#room-shoebox-depth_m').value === '5'")
    assert number(tab, "mean") > 0.0
    (tmp_path / "mine.toml").write_text("[shoebox]\nwidth_m = 1")
    own.set_input_files(tmp_path / "mine.toml")
    tab.get_by_text("This file was not opened").wait_for()


def test_a_link_reproduces_the_picture(tab: Any, browser: Any, studio: str) -> None:
    opened(tab, studio, COARSE)
    tab.locator("#room-minute").fill("570")
    canvas = tab.locator(".stage canvas")
    canvas.focus()
    for key in ("ArrowLeft", "ArrowLeft", "ArrowUp", "+"):
        tab.keyboard.press(key)
    tab.get_by_role("button", name="patches").click()
    tab.wait_for_function("() => location.hash.includes('room.patches=false') && location.hash.includes('room.eye')")
    settled(tab)
    other = browser.new_page(viewport=chromium.SIZE)
    chromium.watched(other, studio)
    other.goto(tab.url)
    number(other, "mean")
    settled(other)
    assert other.locator("#room-minute").input_value() == "570"
    assert np.abs(colours(tab) - colours(other)).mean() < 1.0
    other.close()


def test_pictures_and_tables_are_saved(tab: Any, studio: str) -> None:
    opened(tab, studio, COARSE)
    with tab.expect_download() as waiting:
        tab.locator('section[aria-label="The room, its light and its sun"]').get_by_role("button", name="PNG").click()
    made = Path(waiting.value.path()).read_bytes()
    assert made.startswith(b"\x89PNG")
    assert len(made) > 30_000
    for figure in ("Plan", "From the window"):
        with tab.expect_download() as waiting:
            tab.locator(f'section[aria-label^="{figure}"]').get_by_role("button", name="SVG").click()
        assert Path(waiting.value.path()).read_bytes().startswith(b"<svg")


def test_without_webgl_the_plan_still_works(tab: Any, studio: str) -> None:
    tab.add_init_script(
        "const real = HTMLCanvasElement.prototype.getContext;"
        "HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {"
        " return kind.startsWith('webgl') ? null : real.call(this, kind, ...rest); };"
    )
    tab.goto(f'{studio}#view="room"{COARSE}')
    tab.get_by_text("This browser shows no 3D").wait_for()
    number(tab, "mean")
    plan = tab.locator("svg.plan .picks")
    plan.focus()
    tab.keyboard.press("ArrowRight")
    tab.wait_for_function("() => location.hash.includes('room.picked')")
    assert "lx" in (plan.get_attribute("aria-label") or "")


def test_pictures_for_the_docs(tab: Any, studio: str) -> None:
    if not os.environ.get("CLERESTORY_PICTURES"):
        pytest.skip("no pictures are asked for")
    tab.set_viewport_size({"width": 1360, "height": 1440})
    opened(tab, studio)
    settled(tab)
    chromium.picture(tab, "studio-room")
    tab.set_viewport_size(chromium.SIZE)
    opened(tab, studio, '&room.view="section"&room.minute=540&room.plane="on ceiling"', theme="dark")
    settled(tab)
    chromium.picture(tab, "studio-room-section", is_whole=False)
