"""Everybody can use an opened result: audited in a real browser, by keyboard alone, on a tablet."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.studio import chromium
from tests.studio.test_access import CHECKS, read_out, sniffed

pytestmark = chromium.NEEDED
#: What is opened, and what is there once it is.
RESULTS = {
    "year": ("out/year/year.nc", "section[aria-label^='One hour'] .plans"),
    "design": ("out/design/summary.json", ".bestRing"),
}
Opener = Callable[..., Any]


@pytest.fixture(scope="module")
def studio(result_folder: Path) -> Iterator[str]:
    process, url = chromium.started(result_folder)
    yield url
    process.terminate()
    process.wait(10)


@pytest.fixture
def opened(browser: Any, studio: str) -> Iterator[Opener]:
    contexts = []

    def open_result(name: str, **how: Any) -> Any:
        context = browser.new_context(viewport=how.pop("size", chromium.SIZE), **how)
        contexts.append(context)
        tab = context.new_page()
        chromium.watched(tab, studio)
        path, there = RESULTS[name]
        tab.goto(f"{studio}#view=%22year%22&theme=%22light%22&year.path=%22{path}%22")
        tab.locator(there).first.wait_for(timeout=40_000)
        tab.locator(".resultList button").first.wait_for(timeout=40_000)
        tab.wait_for_timeout(300)
        tab.evaluate(CHECKS.read_text(encoding="utf-8"))
        return tab

    yield open_result
    for context in contexts:
        context.close()


@pytest.mark.parametrize("name", RESULTS)
def test_an_audit_finds_no_error_in_light_nor_dark(opened: Opener, name: str) -> None:
    tab = opened(name)
    for theme in ("light", "dark"):
        tab.get_by_label("Colours", exact=True).select_option(theme)
        tab.wait_for_function("theme => document.documentElement.dataset.theme === theme", arg=theme)
        assert sniffed(tab) == []
        for check in ("faint", "edgeless", "textless"):
            assert tab.evaluate(f"access.{check}()") == [], (check, theme)
    assert read_out(tab)[0] == []


def test_the_keyboard_reaches_every_control(opened: Opener) -> None:
    tab = opened("year")
    controls = tab.evaluate("access.marked()")
    visited: list[int] = []
    for _ in range(2 * len(controls) + 10):
        tab.keyboard.press("Tab")
        here = tab.evaluate("access.focused()")
        if here is None:
            break
        assert here["seen"], here
        if here["number"] >= 0:
            visited.append(here["number"])
    else:
        pytest.fail(f"Tab never leaves the page: {visited[-20:]}")
    assert [controls[k] for k in range(len(controls)) if k not in visited] == []
    assert visited == sorted(visited), "in the order of the page"


@pytest.mark.parametrize("name", RESULTS)
def test_a_tablet_shows_it_all_with_room_for_fingers(opened: Opener, name: str) -> None:
    tab = opened(name, size=chromium.TABLETS[0], has_touch=True, is_mobile=True)
    for size in (*chromium.TABLETS, {"width": 320, "height": 640}):
        tab.set_viewport_size(size)
        tab.wait_for_timeout(300)
        assert tab.evaluate("access.wide()") == [], size
        if size["width"] > 320:
            assert tab.evaluate("access.small()") == [], size
        chromium.picture(tab, f"tablet-result-{name}-{size['width']}")
