"""Everybody can use an opened result: audited in a real browser, by keyboard alone, on a tablet."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.studio import access, chromium

pytestmark = chromium.NEEDED
#: What is opened, and what is there once it is.
RESULTS = {
    "year": ("out/year/year.nc", "section[aria-label^='One hour'] .plans"),
    "design": ("out/design/summary.json", ".bestRing"),
}


@pytest.fixture(scope="module")
def studio(result_folder: Path) -> Iterator[str]:
    with chromium.studio_of(result_folder) as url:
        yield url


@pytest.fixture
def opened(browser: Any, studio: str) -> Iterator[access.Opener]:
    with access.opener(browser, studio) as open_view:

        def open_result(name: str, **how: Any) -> Any:
            path, there = RESULTS[name]
            tab = open_view(f"view=%22year%22&year.path=%22{path}%22", there, **how)
            tab.locator(".resultList button").first.wait_for()
            chromium.is_still(tab)
            return tab

        yield open_result


@pytest.mark.parametrize("name", RESULTS)
def test_an_audit_finds_no_error_in_light_nor_dark(opened: access.Opener, name: str) -> None:
    tab = opened(name)
    access.audit(tab, f"result-{name}")
    access.read_out(tab)


def test_the_keyboard_reaches_every_control(opened: access.Opener) -> None:
    access.walk(opened("year"))


@pytest.mark.parametrize("name", RESULTS)
def test_a_tablet_shows_it_all_with_room_for_fingers(opened: access.Opener, name: str) -> None:
    tab = opened(name, size=chromium.TABLETS[0], has_touch=True, is_mobile=True)
    access.hold_as_a_tablet(tab, f"result-{name}")
