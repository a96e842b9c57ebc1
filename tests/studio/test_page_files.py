"""The page's state as a file and as a link, in a real browser: saved, opened, dropped, odd ones refused."""

import json
import random
import tomllib
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest
from tests.studio import chromium

pytestmark = chromium.NEEDED
EXAMPLES = Path(__file__).parents[2] / "examples"
PRISM = {
    "kind": "prismatic",
    "pitch_mm": 4,
    "lower_deg": 45,
    "upper_deg": 62,
    "base_mm": 3,
    "ridges": "front",
    "medium": "pmma",
}


#: What the address may say of each view.
NAMES = {
    "panel": ["a.kind", "a.spacing_mm", "a.medium", "b", "elevation", "azimuth", "compares"],
    "room": ["file", "tables", "variant", "day", "minute", "sky", "plane", "quantity", "low", "picked", "view", "eye"],
    "year": ["path", "key", "metric", "plane", "series", "day", "hidden", "sensor", "x", "y"],
    "bsdf": ["path", "key", "elevation", "azimuth", "side", "band", "plane"],
}


#: The address says under which key the studio has the BSDF: it is written a moment after the discs are drawn.
HAS_KEY = "() => location.hash.includes('bsdf.key=')"


def drop(page: Any, place: str, path: Path) -> None:
    """Lets a file fall on an element."""
    page.evaluate(
        """([place, name, text]) => {
            const data = new DataTransfer();
            data.items.add(new File([text], name));
            const target = document.querySelector(place);
            for (const kind of ["dragenter", "dragover", "drop"])
                target.dispatchEvent(new DragEvent(kind, {dataTransfer: data, bubbles: true, cancelable: true}));
        }""",
        [place, path.name, path.read_text(encoding="utf-8")],
    )


def said(**pairs: Any) -> str:
    return "#" + "&".join(f"{name.replace('__', '.')}={quote(json.dumps(value))}" for name, value in pairs.items())


def test_a_saved_page_is_opened_again_as_it_was(page: Any, browser: Any, studio: str, tmp_path: Path) -> None:
    page.goto(
        studio
        + said(
            view="bsdf",
            theme="dark",
            panel__compares=True,
            panel__elevation=-12.5,
            bsdf__path="blinds.xml",
            bsdf__plane=30,
        )
    )
    page.locator(".disc.picks").wait_for()
    page.wait_for_function(HAS_KEY)
    page.evaluate("() => { location.hash += '&panel.b.kind=%22prismatic%22&panel.b.upper_deg=62' }")
    page.wait_for_function("() => document.querySelectorAll('.disc.picks').length === 1")
    chromium.is_still(page)
    page.wait_for_function(HAS_KEY)
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Save page").click()
    assert waiting.value.suggested_filename == "studio.toml"
    file = tmp_path / "studio.toml"
    waiting.value.save_as(file)
    tables = tomllib.loads(file.read_text(encoding="utf-8"))
    assert (tables["kind"], tables["view"], tables["theme"]) == ("studio-page", "bsdf", "dark")
    assert tables["panel"]["b"] == PRISM
    link = page.evaluate("() => location.hash")

    other = browser.new_page(viewport=chromium.SIZE)
    wrong = chromium.watched(other, studio)
    other.goto(studio)
    other.locator(".pageFiles input[type=file]").set_input_files(file)
    other.locator(".disc.picks").wait_for()
    other.wait_for_function(HAS_KEY)
    assert other.locator("html").get_attribute("data-theme") == "dark"
    assert set(other.evaluate("() => location.hash").strip("#").split("&")) == set(link.strip("#").split("&"))
    # the way back leads to what was there before
    other.go_back()
    other.get_by_role("heading", name="Section, to scale").wait_for()
    other.go_forward()
    other.locator(".disc.picks").wait_for()
    other.close()
    assert not wrong


def test_a_toml_dropped_anywhere_opens_the_view_it_is_for(page: Any, tmp_path: Path) -> None:
    panel = tmp_path / "panel.toml"
    panel.write_text('kind = "pane"\nthickness_mm = 9.0\nmedium = "bk7"\n')
    page.get_by_role("tab", name="BSDF").click()
    drop(page, ".dropPlace", panel)
    # it is told for some seconds
    page.get_by_role("status").filter(has_text="panel.toml is open").wait_for()
    page.get_by_role("heading", name="Section, to scale").wait_for()
    page.wait_for_function("() => document.querySelector('#a-thickness_mm')?.value === '9'")
    drop(page, "h1", EXAMPLES / "classroom/classroom.toml")
    page.locator('[role="tab"][aria-selected="true"]', has_text="Room").wait_for()
    sweep = tmp_path / "sweep.toml"
    sweep.write_text('kind = "room"\nbase = "classroom.toml"\n[parameters]\n"shoebox.depth_m" = [4, 5]\n')
    drop(page, "body", sweep)
    page.get_by_text("clerestory sweep FILE").wait_for()


def test_a_bad_file_is_refused_in_words_and_the_page_stays(page: Any, tmp_path: Path) -> None:
    page.locator(".drawing .solid").first.wait_for()
    before = page.evaluate("() => location.hash")
    for name, text, words in (
        ("bad.toml", "kind = ", "must be that of a TOML file"),
        ("odd.toml", "a = 1", "must be the TOML of a page"),
        ("page.toml", 'kind = "studio-page"\ntheme = "pink"\nview = "panel"', "theme must be one of"),
        ("bad.xml", "<x/>", "bad.xml"),
    ):
        file = tmp_path / name
        file.write_text(text)
        drop(page, "h1", file)
        page.locator(".top [role=alert]", has_text=words).wait_for()
    assert page.evaluate("() => location.hash") == before
    assert page.locator(".drawing .solid").count() > 0


@pytest.mark.parametrize("view", ["panel", "room", "year", "bsdf"])
def test_an_odd_address_breaks_no_view(page: Any, studio: str, view: str) -> None:
    chance = random.Random(view)
    page.goto(studio + said(view=view))
    page.locator("main h3, main .empty, main fieldset").first.wait_for()
    names = [*(f"{view}.{name}" for name in NAMES[view]), "theme", "panel.a.kind", "panel.compares"]
    values = [None, True, 0, -1, 1e300, 0.5, "", "x", "start", [], [1], ["x"], {}, {"x": [1]}, 10**15]
    for _ in range(25):
        told = {name: chance.choice(values) for name in chance.sample(names, 4)}
        hash_ = "#" + "&".join(
            [f"view=%22{view}%22", *(f"{name}={quote(json.dumps(one))}" for name, one in told.items())]
        )
        page.evaluate("hash => { location.hash = hash }", hash_)
        chromium.is_drawn(page)
    page.evaluate("view => { location.hash = `#view=%22${view}%22` }", view)
    page.locator("main h3, main .empty, main fieldset").first.wait_for()
    assert page.locator("main").inner_text().strip()
