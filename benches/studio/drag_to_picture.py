"""How long from a move of the hand to the picture of it, for docs/benchmarks.md: ``drag_to_picture.py [word]``.

A real browser drags the slider of the sun's elevation in the Panel view. Time runs from the event of the move (as the
browser stamps it) to the frame in which the section has the beams of that elevation.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
import time
from pathlib import Path
from typing import Any
from urllib.parse import quote

from playwright.sync_api import sync_playwright

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "benches" / "peers")]
from benchmark_page import machine, put_section  # noqa: E402
from tests.studio import chromium  # noqa: E402

HEADING = "## From drag to picture"
#: The time that a picture is to come within [ms].
AIM_MS = 50.0
PANELS: dict[str, dict[str, Any]] = {
    "ideal cuts": {"kind": "laser-cut", "spacing_mm": 6, "thickness_mm": 6, "medium": "pmma"},
    "cuts of 0.3 mm": {
        "kind": "laser-cut",
        "spacing_mm": 6,
        "thickness_mm": 6,
        "cut_width_mm": 0.3,
        "medium": "pmma",
    },
    "prisms of 45° and 45°": {
        "kind": "prismatic",
        "pitch_mm": 4,
        "lower_deg": 45,
        "upper_deg": 45,
        "base_mm": 3,
        "ridges": "front",
        "medium": "pmma",
    },
}
#: No graphics card, and none imitated: an imitated one draws far slower than the processor itself.
FLAGS = ["--no-sandbox", "--disable-gpu"]
SINGLE_MOVES = 60
DRAG_S = 4.0
TEXT = f"""Milliseconds from a move of the sun's slider to the frame that shows its beams, in Chromium without a
graphics card, studio and browser on the same cores; the aim is {AIM_MS:.0f}. *One move* waits for its picture before
the next: *ask* is from the event to the question, *answer* from there to the answer (the studio's part and the way to
and fro), *draw* until the page is changed, *frame* until that is shown. *A drag* moves for {DRAG_S:.0f} s without end:
moves that were overtaken are never asked for."""
PARTS = {"ask": ("moved", "asked"), "answer": ("asked", "got"), "draw": ("got", "drawn"), "frame": ("drawn", "shown")}


def state_of(panel: dict[str, Any]) -> str:
    """The address of the Panel view with this panel."""
    told = {"view": "panel", "panel.a": panel, "panel.elevation": 0}
    return "&".join(f"{name}={quote(json.dumps(value))}" for name, value in told.items())


class Slider:
    """The slider of the sun's elevation, under the mouse."""

    def __init__(self, page: Any) -> None:
        self.page = page
        box = page.locator("#elevation").bounding_box()
        self.left, self.wide, self.y = box["x"] + 8, box["width"] - 16, box["y"] + 0.5 * box["height"]
        page.mouse.move(self.left + 0.5 * self.wide, self.y)
        page.mouse.down()

    def move(self, share: float) -> None:
        self.page.mouse.move(self.left + share * self.wide, self.y)


def one_by_one(page: Any, slider: Slider) -> list[dict[str, float]]:
    """A picture of each of some moves, the hand at rest between them."""
    page.evaluate("() => void drag.taken()")
    for k in range(SINGLE_MOVES):
        page.evaluate("() => { window.coming = drag.next(); }")
        slider.move(0.45 + 0.4 * ((0.618034 * (k + 1)) % 1.0))
        page.evaluate("() => Promise.race([coming, new Promise((done) => setTimeout(done, 3000))])")
        time.sleep(0.05)
    taken: list[dict[str, float]] = page.evaluate("() => drag.taken()")
    return [one for one in taken if one.get("moved") is not None]


def without_end(page: Any, slider: Slider) -> tuple[list[dict[str, float]], float]:
    """The pictures while the hand goes to and fro, and the seconds that it did."""
    page.evaluate("() => void drag.taken()")
    begun, turn = time.perf_counter(), 0
    while time.perf_counter() < begun + DRAG_S:
        turn += 1
        slider.move(0.45 + 0.4 * abs((turn / 75.0) % 2.0 - 1.0))
    took = time.perf_counter() - begun
    page.wait_for_timeout(300)
    taken: list[dict[str, float]] = page.evaluate("() => drag.taken()")
    return [one for one in taken if one.get("moved") is not None], took


def part(pictures: list[dict[str, float]], begin: str, end: str, share: float = 0.5) -> float:
    """A quantile of the milliseconds between two moments."""
    times = sorted(one[end] - one[begin] for one in pictures)
    return times[min(len(times) - 1, int(share * len(times)))]


def row(page: Any, url: str, name: str, panel: dict[str, Any]) -> str:
    """The row of one panel."""
    page.goto("about:blank")
    page.goto(f"{url}#{state_of(panel)}")
    page.locator(".drawing .solid").first.wait_for()
    # the curves of the panel are computed once, before anybody drags
    page.wait_for_function("() => document.querySelectorAll('.drawing .dot').length >= 3", timeout=120_000)
    page.wait_for_timeout(1000)
    slider = Slider(page)
    one_by_one(page, slider)
    single = one_by_one(page, slider)
    many, took = without_end(page, slider)
    page.mouse.up()
    cells = [part(single, *ends) for ends in PARTS.values()]
    for pictures in (single, many):
        cells += [part(pictures, "moved", "shown"), part(pictures, "moved", "shown", 0.95)]
    told = " | ".join(f"{cell:.0f}" if cell >= 10 else f"{cell:.1f}" for cell in cells)
    is_quick = max(cells[5], cells[7]) < AIM_MS
    return f"| {name} | {told} | {len(many) / took:.0f} | {'yes' if is_quick else 'no'} |"


def section(only: list[str]) -> str:
    """The section of docs/benchmarks.md."""
    where, rows = machine(), []
    folder = ROOT / "out" / "drag"
    folder.mkdir(parents=True, exist_ok=True)
    process, url = chromium.started(folder)
    try:
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
            page = browser.new_page(viewport=chromium.SIZE)
            page.add_init_script(Path(__file__).with_suffix(".js").read_text(encoding="utf-8"))
            for name, panel in PANELS.items():
                if not only or any(one in name for one in only):
                    rows.append(row(page, url, name, panel))
                    print(rows[-1], flush=True)
            browser.close()
    finally:
        process.terminate()
        process.wait(10)
    head = [
        f"| panel | {' | '.join(PARTS)} | one move: median | 95 % | a drag: median | 95 % | pictures a second "
        f"| 95 % under {AIM_MS:.0f} |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    return "\n".join([HEADING, "", f"On {where}{ahead()}.", "", TEXT, "", *head, *rows, ""])


def ahead() -> str:
    """Whether this was measured ahead of whatever else the machine did."""
    scheduler = getattr(os, "sched_getscheduler", None)
    return ", ahead of all that" if scheduler and scheduler(0) in (os.SCHED_FIFO, os.SCHED_RR) else ""


def main() -> None:
    """Puts the section into the page in the place of the last one; asked for some panels only, prints them."""
    only = sys.argv[1:]
    if shutil.which("chromium") is None:
        print("no chromium on this machine to drag in")
        return
    made = section(only)
    if not only:
        put_section(HEADING, made)


if __name__ == "__main__":
    main()
