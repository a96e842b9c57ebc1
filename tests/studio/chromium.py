"""A real browser on a real studio: what every test of the page begins with, and how it waits.

Nothing here waits for a time: the machine may be busy, and a job of the studio lets everybody else go first.
"""

import os
import random
import re
import shutil
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import pytest

PAGE = Path(__file__).parents[2] / "python/clerestory/studio/page/index.html"
PATH = shutil.which("chromium")
#: WebGL without a graphics card, the same everywhere; all but WebGL is drawn by the processor itself, which is faster.
FLAGS = [
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-rasterization",
    "--disable-gpu-compositing",
]
#: Marks of a module that looks at the page.
NEEDED = [
    pytest.mark.skipif(PATH is None, reason="no chromium on this machine to look at the page with"),
    pytest.mark.skipif(not PAGE.is_file(), reason="the page is not built: Node.js was not there"),
]
SIZE = {"width": 1360, "height": 900}
#: A small screen held upright, one held across.
TABLETS = ({"width": 820, "height": 1180}, {"width": 1024, "height": 768})
#: After which what is waited for will not come [s].
PATIENCE_S = 240.0

#: Counts the questions that are not wholly answered yet.
_COUNT = """() => {
    const ask = window.fetch;
    const less = () => { window.asking--; };
    window.asking = 0;
    window.fetch = async (...words) => {
        window.asking++;
        try {
            const answer = await ask(...words);
            answer.clone().arrayBuffer().then(less, less);
            return answer;
        } catch (fault) {
            less();
            throw fault;
        }
    };
}"""
#: No job runs and no question is open; nothing changes for ten pictures of the screen, nor for longer than the page
#: waits before it begins with what was changed last (350 ms) and says so (700 ms).
_IS_STILL = """() => new Promise((done) => {
    const works = () => [...document.querySelectorAll("progress")].some((one) => !one.closest("[data-whole=true]"));
    const isBusy = () => window.asking > 0 || works();
    if (isBusy()) return done(false);
    let pictures = 0, hasChanged = false;
    const seen = new MutationObserver(() => { hasChanged = true; });
    seen.observe(document.body, { subtree: true, childList: true, attributes: true, characterData: true });
    const began = performance.now();
    const next = () => {
        if (!hasChanged && (++pictures < 10 || performance.now() < began + 1000)) return requestAnimationFrame(next);
        seen.disconnect();
        done(!hasChanged && !isBusy());
    };
    requestAnimationFrame(next);
})"""


def started(folder: Path, port: int = 0, before: str = "pass") -> tuple[subprocess.Popen[str], str]:
    """A studio in a process of its own, and its address; ``before`` is done there first."""
    command = [sys.executable, "-c", f"{before}; from clerestory.cli import app; app()", "studio", "--no-open"]
    process = subprocess.Popen(
        [*command, "--port", str(port), "--folder", str(folder)], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    found = re.search(r"http://\S+", process.stdout.readline())
    assert found, "the studio did not start"
    return process, found[0]


def ended(process: subprocess.Popen[str]) -> None:
    """Ends a studio, by force if need be."""
    process.terminate()
    try:
        process.wait(PATIENCE_S)
    finally:
        process.kill()


@contextmanager
def studio_of(folder: Path, before: str = "pass") -> Iterator[str]:
    """The address of a studio that is there meanwhile."""
    process, url = started(folder, before=before)
    try:
        yield url
    finally:
        ended(process)


def port_to_keep() -> int:
    """A free port that the system gives nobody by itself, for a studio that is to come back to it."""
    while True:
        port = random.SystemRandom().randrange(20_000, 30_000)
        with closing(socket.socket()) as one:
            if one.connect_ex(("127.0.0.1", port)) != 0:
                return port


def watched(tab: Any, url: str) -> list[str]:
    """What goes wrong in a tab from now on: errors of the page, and requests that leave the studio."""
    wrong: list[str] = []
    tab.set_default_timeout(1000.0 * PATIENCE_S)
    tab.add_init_script(f"({_COUNT})()")
    tab.on("pageerror", lambda error: wrong.append(str(error)))
    tab.on("request", lambda one: None if one.url.startswith((url, "data:", "blob:")) else wrong.append(one.url))
    return wrong


def is_drawn(tab: Any) -> None:
    """Waits until the page has answered what was done to it last: two pictures of the screen."""
    tab.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")


def is_still(tab: Any) -> None:
    """Waits until everything that was asked for is computed and drawn."""
    tab.wait_for_function(_IS_STILL)


def picture(tab: Any, name: str, *, is_whole: bool = True) -> None:
    """Keeps a picture of the page as NAME.png in the folder CLERESTORY_PICTURES, if there is one."""
    if kept := os.environ.get("CLERESTORY_PICTURES"):
        Path(kept).mkdir(parents=True, exist_ok=True)
        tab.screenshot(path=str(Path(kept) / f"{name}.png"), full_page=is_whole)
