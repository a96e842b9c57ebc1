"""Everybody can use the page: audited in a real browser, by keyboard alone, on a tablet, with a reader of screens."""

from collections.abc import Iterator
from typing import Any

import pytest
from tests.studio import access, chromium

pytestmark = chromium.NEEDED
#: View → its address, and what is there once it is. A room of which little is asked is soon still.
VIEWS = {
    "panel": ("view=%22panel%22", ".drawing .solid"),
    "two panels": ("view=%22panel%22&panel.compares=true", '[data-panel="b"] .drawing .solid'),
    "room": ("view=%22room%22&room.error=0.2", ".roomProgress[data-whole=true]"),
    "year": ("view=%22year%22", ".yearView"),
    "bsdf": ("view=%22bsdf%22&bsdf.path=%22blinds.xml%22", ".disc.picks"),
}


@pytest.fixture
def opened(browser: Any, studio: str) -> Iterator[access.Opener]:
    with access.opener(browser, studio) as open_view:
        yield open_view


@pytest.mark.parametrize("view", VIEWS)
def test_an_audit_finds_no_error_in_light_nor_dark(opened: access.Opener, view: str) -> None:
    tab = opened(*VIEWS[view])
    access.audit(tab, view.replace(" ", "-"))
    roles = access.read_out(tab)
    assert (roles.get("main"), roles.get("banner"), roles.get("tabpanel")) == (1, 1, 1)
    assert roles.get("tab", 0) == 4
    assert roles.get("heading", 0) >= 2
    assert roles.get("status", 0) >= 1, "what changes is read out"


@pytest.mark.parametrize("view", VIEWS)
def test_the_keyboard_reaches_every_control_sees_where_it_is_and_is_never_caught(
    opened: access.Opener, view: str
) -> None:
    access.walk(opened(*VIEWS[view]))


def test_the_first_tab_skips_to_the_view_and_the_address_stays(opened: access.Opener) -> None:
    tab = opened(*VIEWS["panel"])
    before = tab.evaluate("() => location.hash")
    tab.keyboard.press("Tab")
    tab.wait_for_function("() => document.querySelector('.skip').getBoundingClientRect().top >= 0")
    tab.keyboard.press("Enter")
    tab.wait_for_function("() => document.activeElement.id === 'view'")
    assert tab.evaluate("() => location.hash") == before
    # the views are tabs: arrows, Home and End go through them
    tab.get_by_role("tab", name="Panel").focus()
    tab.keyboard.press("End")
    tab.wait_for_function("() => document.activeElement.id === 'tab-bsdf'")
    tab.keyboard.press("Home")
    tab.wait_for_function("() => document.activeElement.id === 'tab-panel'")


@pytest.mark.parametrize("view", VIEWS)
def test_a_tablet_shows_it_all_with_room_for_fingers(opened: access.Opener, view: str) -> None:
    tab = opened(*VIEWS[view], size=chromium.TABLETS[0], has_touch=True, is_mobile=True)
    access.hold_as_a_tablet(tab, view.replace(" ", "-"))


@pytest.mark.parametrize("view", VIEWS)
def test_what_the_system_asks_for_is_kept_no_motion_and_its_own_colours(opened: access.Opener, view: str) -> None:
    tab = opened(*VIEWS[view], reduced_motion="reduce", forced_colors="active")
    assert tab.evaluate("access.moving()") == []
    # what is chosen differs by more than a colour that is taken away
    chosen, other = (
        tab.locator(f'[role="tab"][aria-selected="{is_chosen}"]').first.evaluate(
            "one => { const s = getComputedStyle(one); return [s.backgroundColor, s.color, s.borderBottomColor] }"
        )
        for is_chosen in ("true", "false")
    )
    assert chosen != other
    chromium.picture(tab, f"forced-{view.replace(' ', '-')}")


def test_results_are_read_out(opened: access.Opener) -> None:
    tab = opened(*VIEWS["room"])
    tab.wait_for_function("() => /[0-9]/.test(document.querySelector('main [role=status]')?.textContent ?? '')")
