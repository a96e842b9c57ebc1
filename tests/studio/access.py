"""What everybody needs of a view: to find, reach, read and touch it. Asked of each view in a real browser."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from tests.studio import chromium

CHECKS = Path(__file__).with_name("access_checks.js")
CODE_SNIFFER = Path(__file__).parents[2] / "studio/node_modules/html_codesniffer/build/HTMLCS.js"
#: 1280 px at 400 % (WCAG 1.4.10).
NARROW = {"width": 320, "height": 640}
Opener = Callable[..., Any]


@contextmanager
def opener(browser: Any, studio: str) -> Iterator[Opener]:
    """Opens views in tabs of their own, by address and by what is there once they are; closes them at the end."""
    contexts: list[Any] = []
    wrong: list[list[str]] = []

    def open_view(
        address: str, there: str, *, theme: str = "light", size: dict[str, int] = chromium.SIZE, **how: Any
    ) -> Any:
        context = browser.new_context(viewport=size, **how)
        contexts.append(context)
        tab = context.new_page()
        wrong.append(chromium.watched(tab, studio))
        tab.goto(f"{studio}#{address}&theme=%22{theme}%22")
        tab.locator(there).first.wait_for()
        chromium.is_still(tab)
        tab.evaluate(CHECKS.read_text(encoding="utf-8"))
        return tab

    yield open_view
    for context in contexts:
        context.close()
    assert not any(wrong), f"an error of the page, or a request that leaves the studio: {wrong}"


def audit(tab: Any, name: str) -> None:
    """No error by WCAG 2 AA, nothing faint or without a text, in light and dark."""
    for theme in ("light", "dark"):
        tab.get_by_label("Colours", exact=True).select_option(theme)
        tab.wait_for_function("theme => document.documentElement.dataset.theme === theme", arg=theme)
        chromium.is_still(tab)
        assert _sniffed(tab) == []
        for check in ("faint", "edgeless", "textless"):
            assert tab.evaluate(f"access.{check}()") == [], (check, theme)
        chromium.picture(tab, f"access-{name}-{theme}")


def _sniffed(tab: Any) -> list[str]:
    """The errors that HTML_CodeSniffer finds; none if it is not installed with the page's packages."""
    if not CODE_SNIFFER.is_file():
        return []
    tab.evaluate(f"() => {{ {CODE_SNIFFER.read_text(encoding='utf-8')}\n; window.HTMLCS = HTMLCS; }}")
    found: list[str] = tab.evaluate(
        """() => new Promise((done, fail) => HTMLCS.process("WCAG2AA", document, () => done(HTMLCS.getMessages()
            .filter((one) => one.type === HTMLCS.ERROR)
            .map((one) => `${one.code}: ${one.msg} ${one.element.outerHTML?.slice(0, 120)}`)), fail))"""
    )
    return found


def read_out(tab: Any) -> dict[str, int]:
    """Every control and figure has a name for a reader of screens; how many there are of each role."""
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
    assert nameless == []
    return roles


def walk(tab: Any) -> None:
    """Tab reaches every control in the order of the page, one sees where it is, and it leaves at the end."""
    controls = tab.evaluate("access.marked()")
    assert len(controls) > 5
    visited: list[int] = []
    for _ in range(2 * len(controls) + 10):
        tab.keyboard.press("Tab")
        here = tab.evaluate("access.focused()")
        # a control may go while one is on it, as Stop does when a job is done: the next Tab goes on from there
        there = tab.evaluate("() => [...document.querySelectorAll('[data-tab]')].map((one) => Number(one.dataset.tab))")
        if here is None and not any(number > max(visited, default=-1) for number in there):
            break
        if here is None:
            continue
        assert here["seen"], here
        if here["number"] >= 0:
            visited.append(here["number"])
    else:
        pytest.fail(f"Tab never leaves the page: {visited[-20:]}")
    assert [controls[number] for number in there if number not in visited] == []
    assert visited == sorted(visited), "in the order of the page"


def hold_as_a_tablet(tab: Any, name: str) -> None:
    """Upright and across it shows all, with room for fingers; enlarged it needs no sideways scrolling."""
    for size in (*chromium.TABLETS, NARROW):
        tab.set_viewport_size(size)
        chromium.is_still(tab)
        assert tab.evaluate("access.wide()") == [], size
        if size is not NARROW:
            assert tab.evaluate("access.small()") == [], size
        chromium.picture(tab, f"tablet-{name}-{size['width']}")
