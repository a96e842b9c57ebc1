"""Everybody can use the page: audited in a real browser, by keyboard alone, on a tablet, with a reader of screens."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.studio import chromium

pytestmark = chromium.NEEDED
CHECKS = Path(__file__).with_name("access_checks.js")
CODE_SNIFFER = Path(__file__).parents[2] / "studio/node_modules/html_codesniffer/build/HTMLCS.js"
#: View → its address, and what is there once it is.
VIEWS = {
    "panel": ("view=%22panel%22", ".drawing .solid"),
    "two panels": ("view=%22panel%22&panel.compares=true", '[data-panel="b"] .drawing .solid'),
    "room": ("view=%22room%22", "canvas"),
    "year": ("view=%22year%22", ".yearView"),
    "bsdf": ("view=%22bsdf%22&bsdf.path=%22blinds.xml%22", ".disc.picks"),
}
Opener = Callable[..., Any]


@pytest.fixture
def opened(browser: Any, studio: str) -> Any:
    """Opens views in tabs of their own, which are closed at the end."""
    contexts = []

    def open_view(view: str, *, theme: str = "light", size: dict[str, int] = chromium.SIZE, **how: Any) -> Any:
        context = browser.new_context(viewport=size, **how)
        contexts.append(context)
        tab = context.new_page()
        tab.wrong = chromium.watched(tab, studio)
        address, there = VIEWS[view]
        tab.goto(f"{studio}#{address}&theme=%22{theme}%22")
        tab.locator(there).first.wait_for()
        tab.wait_for_timeout(300)
        tab.evaluate(CHECKS.read_text(encoding="utf-8"))
        return tab

    yield open_view
    wrong = [one for context in contexts for tab in context.pages for one in tab.wrong]
    for context in contexts:
        context.close()
    assert wrong == [], "an error of the page, or a request that leaves the studio"


@pytest.mark.parametrize("view", VIEWS)
def test_an_audit_finds_no_error_in_light_nor_dark(opened: Opener, view: str) -> None:
    tab = opened(view)
    for theme in ("light", "dark"):
        tab.get_by_label("Colours", exact=True).select_option(theme)
        tab.wait_for_function("theme => document.documentElement.dataset.theme === theme", arg=theme)
        assert sniffed(tab) == []
        for check in ("faint", "edgeless", "textless"):
            assert tab.evaluate(f"access.{check}()") == [], (check, theme)
        chromium.picture(tab, f"access-{view.replace(' ', '-')}-{theme}")
    nameless, roles = read_out(tab)
    assert nameless == []
    assert (roles.get("main"), roles.get("banner"), roles.get("tabpanel")) == (1, 1, 1)
    assert roles.get("tab", 0) == 4
    assert roles.get("heading", 0) >= 2
    assert roles.get("status", 0) >= 1, "what changes is read out"


def sniffed(tab: Any) -> list[str]:
    """The errors that HTML_CodeSniffer finds by WCAG 2 AA; none if it is not installed with the page's packages."""
    if not CODE_SNIFFER.is_file():
        return []
    tab.evaluate(f"() => {{ {CODE_SNIFFER.read_text(encoding='utf-8')}\n; window.HTMLCS = HTMLCS; }}")
    found: list[str] = tab.evaluate(
        """() => new Promise((done, fail) => HTMLCS.process("WCAG2AA", document, () => done(HTMLCS.getMessages()
            .filter((one) => one.type === HTMLCS.ERROR)
            .map((one) => `${one.code}: ${one.msg} ${one.element.outerHTML?.slice(0, 120)}`)), fail))"""
    )
    return found


def read_out(tab: Any) -> tuple[list[Any], dict[str, int]]:
    """Controls and figures that a reader of screens has no name for; and how many there are of each role."""
    tree = tab.context.new_cdp_session(tab).send("Accessibility.getFullAXTree")["nodes"]
    roles: dict[str, int] = {}
    nameless = []
    for node in tree:
        role = node.get("role", {}).get("value", "")
        roles[role] = roles.get(role, 0) + 1
        properties = {one["name"]: one["value"].get("value") for one in node.get("properties", [])}
        is_control = properties.get("focusable") and role not in ("RootWebArea", "main", "generic")
        has_name = bool(node.get("name", {}).get("value", "").strip())
        if not node.get("ignored") and not has_name and (is_control or role in ("image", "img", "Canvas", "region")):
            nameless.append((role, node.get("backendDOMNodeId")))
    return nameless, roles


@pytest.mark.parametrize("view", VIEWS)
def test_the_keyboard_reaches_every_control_sees_where_it_is_and_is_never_caught(opened: Opener, view: str) -> None:
    tab = opened(view)
    controls = tab.evaluate("access.marked()")
    assert len(controls) > 5
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
    # some go while one is on the way: Stop, of a job that is done
    still = tab.evaluate("() => [...document.querySelectorAll('[data-tab]')].map((one) => Number(one.dataset.tab))")
    missed = [controls[k] for k in still if k not in visited]
    assert missed == []
    assert visited == sorted(visited), "in the order of the page"


def test_the_first_tab_skips_to_the_view_and_the_address_stays(opened: Opener) -> None:
    tab = opened("panel")
    before = tab.evaluate("() => location.hash")
    tab.keyboard.press("Tab")
    link = tab.locator(".skip")
    assert link.bounding_box()["y"] >= 0
    tab.keyboard.press("Enter")
    assert tab.evaluate("() => document.activeElement.id") == "view"
    assert tab.evaluate("() => location.hash") == before
    # the views are tabs: arrows, Home and End go through them
    tab.get_by_role("tab", name="Panel").focus()
    tab.keyboard.press("End")
    tab.wait_for_function("() => document.activeElement.id === 'tab-bsdf'")
    tab.keyboard.press("Home")
    tab.wait_for_function("() => document.activeElement.id === 'tab-panel'")


@pytest.mark.parametrize("view", VIEWS)
def test_a_tablet_shows_it_all_with_room_for_fingers(opened: Opener, view: str) -> None:
    tab = opened(view, size=chromium.TABLETS[0], has_touch=True, is_mobile=True)
    for size in chromium.TABLETS:
        tab.set_viewport_size(size)
        tab.wait_for_timeout(300)
        assert tab.evaluate("access.wide()") == [], size
        assert tab.evaluate("access.small()") == [], size
        chromium.picture(tab, f"tablet-{view.replace(' ', '-')}-{size['width']}")
    # and 1280 px at 400 % need no sideways scrolling (WCAG 1.4.10)
    tab.set_viewport_size({"width": 320, "height": 640})
    tab.wait_for_timeout(300)
    assert tab.evaluate("access.wide()") == []
    chromium.picture(tab, f"narrow-{view.replace(' ', '-')}")


@pytest.mark.parametrize("view", VIEWS)
def test_what_the_system_asks_for_is_kept_no_motion_and_its_own_colours(opened: Opener, view: str) -> None:
    tab = opened(view, reduced_motion="reduce", forced_colors="active")
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


def test_results_are_read_out(opened: Opener) -> None:
    tab = opened("room")
    tab.wait_for_function("() => /[0-9]/.test(document.querySelector('main [role=status]')?.textContent ?? '')")
