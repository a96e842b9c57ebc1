"""A real browser on a real studio: what every test of the page begins with."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

PAGE = Path(__file__).parents[2] / "python/clerestory/studio/page/index.html"
PATH = shutil.which("chromium")
#: WebGL without a graphics card: slow, and the same everywhere.
FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
#: Marks of a module that looks at the page.
NEEDED = [
    pytest.mark.skipif(PATH is None, reason="no chromium on this machine to look at the page with"),
    pytest.mark.skipif(not PAGE.is_file(), reason="the page is not built: Node.js was not there"),
]
SIZE = {"width": 1360, "height": 900}
#: A small screen held upright, one held across.
TABLETS = ({"width": 820, "height": 1180}, {"width": 1024, "height": 768})


def started(folder: Path, port: int = 0) -> tuple[subprocess.Popen[str], str]:
    """A studio in a process of its own, and its address."""
    command = [sys.executable, "-c", "from clerestory.cli import app; app()", "studio", "--no-open"]
    process = subprocess.Popen(
        [*command, "--port", str(port), "--folder", str(folder)], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    found = re.search(r"http://\S+", process.stdout.readline())
    assert found, "the studio did not start"
    return process, found[0]


def watched(tab: Any, url: str) -> list[str]:
    """What goes wrong in a tab from now on: errors of the page, and requests that leave the studio."""
    wrong: list[str] = []
    tab.set_default_timeout(45_000)
    tab.on("pageerror", lambda error: wrong.append(str(error)))
    tab.on("request", lambda one: None if one.url.startswith((url, "data:", "blob:")) else wrong.append(one.url))
    return wrong


def picture(tab: Any, name: str, *, is_whole: bool = True) -> None:
    """Keeps a picture of the page as NAME.png in the folder CLERESTORY_PICTURES, if there is one."""
    if kept := os.environ.get("CLERESTORY_PICTURES"):
        Path(kept).mkdir(parents=True, exist_ok=True)
        tab.screenshot(path=str(Path(kept) / f"{name}.png"), full_page=is_whole)
