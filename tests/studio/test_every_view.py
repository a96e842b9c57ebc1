"""Every view at once: the studio killed and started again, two tabs of one studio, no request that leaves it."""

from pathlib import Path
from typing import Any

import pytest
from tests.studio import chromium

pytestmark = chromium.NEEDED
#: View → what the address says of it, a change of that, and what is there once it is answered.
VIEWS = {
    "panel": ("", "&panel.elevation=25", ".drawing .solid"),
    "room": ("", "&room.minute=600", ".stageTitle"),
    "year": ("", "&year.path=%22none.nc%22", ".yearView"),
    "bsdf": ("&bsdf.path=%22blinds.xml%22", "&bsdf.elevation=25", ".disc.picks"),
}
BLINDS = "bsdf.path=%22blinds.xml%22"
GONE = "The studio does not answer"


def test_every_view_says_that_its_studio_was_killed_and_goes_on_when_it_is_back(browser: Any, folder: Path) -> None:
    port = chromium.port_to_keep()
    process, url = chromium.started(folder, port)
    context = browser.new_context(viewport=chromium.SIZE)
    tabs: dict[str, Any] = {}
    wrong = []
    for view, (address, _, there) in VIEWS.items():
        tab = tabs[view] = context.new_page()
        wrong.append(chromium.watched(tab, url))
        tab.goto(f"{url}#view=%22{view}%22{address}")
        tab.locator(there).first.wait_for()
    process.kill()
    process.wait()
    for view, (_, change, _) in VIEWS.items():
        tabs[view].bring_to_front()
        tabs[view].evaluate("change => { location.hash += change }", change)
        tabs[view].get_by_text(GONE).first.wait_for()
        assert tabs[view].locator("main").inner_text().strip(), "what was there stays"
    process, again = chromium.started(folder, port)
    assert again == url
    for view, tab in tabs.items():
        tab.bring_to_front()
        tab.wait_for_function("gone => !document.querySelector('main').innerText.includes(gone)", arg=GONE)
        tab.locator(VIEWS[view][2]).first.wait_for()
    context.close()
    chromium.ended(process)
    assert wrong == [[]] * len(VIEWS), "an error of the page, or a request that leaves the studio"


@pytest.mark.parametrize(
    ("view", "one", "two", "place"),
    [
        ("panel", "panel.elevation=20", "panel.elevation=50", "#elevation"),
        ("room", "room.minute=540", "room.minute=720", ".time input"),
        (
            "bsdf",
            "bsdf.path=%22blinds.xml%22&bsdf.elevation=20",
            "bsdf.path=%22blinds.xml%22&bsdf.elevation=50",
            "#elevation",
        ),
    ],
)
def test_two_tabs_do_not_disturb_one_another(
    browser: Any, studio: str, view: str, one: str, two: str, place: str
) -> None:
    context = browser.new_context(viewport=chromium.SIZE)
    tabs = []
    for told in (one, two):
        tab = context.new_page()
        wrong = chromium.watched(tab, studio)
        tab.goto(f"{studio}#view=%22{view}%22&{told}")
        tab.locator(place).first.wait_for()
        tabs.append((tab, told, wrong))
    for tab, told, wrong in tabs:
        tab.reload()
        tab.wait_for_function(
            "([place, value]) => document.querySelector(place)?.value === value", arg=[place, told.rsplit("=", 1)[1]]
        )
        assert wrong == []
    context.close()
