"""What was dropped on a page is kept by its browser, and given to a studio that does not hold it any more."""

import os
import shutil
import time
from pathlib import Path
from typing import Any

import pytest
import xarray as xr
from tests.studio import chromium
from tests.studio.conftest import BLINDS

from clerestory import panel_from_dict
from clerestory.saving import save

pytestmark = chromium.NEEDED


def test_what_was_dropped_is_shown_again_by_a_studio_that_was_killed(browser: Any, tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    dropped = tmp_path / "own glass.xml"
    shutil.copy(BLINDS, dropped)
    panel = panel_from_dict({"kind": "laser-cut", "spacing_mm": 4.0, "thickness_mm": 6.0})
    result = save(panel.angular(elevation_deg=[0, 20, 40, 60]), tmp_path / "angular.nc")
    process, url = chromium.started(empty, chromium.port_to_keep())
    context = browser.new_context(viewport=chromium.SIZE)
    tab, other = context.new_page(), context.new_page()
    wrong = [chromium.watched(tab, url), chromium.watched(other, url)]
    context.set_default_timeout(1000.0 * chromium.PATIENCE_S)
    tab.goto(f"{url}#view=%22bsdf%22")
    tab.locator('.bsdfView input[type="file"]').first.set_input_files(dropped)
    tab.locator(".disc.picks").wait_for()
    value = "() => document.querySelector('[data-bsdf=\"a-Transmitted\"]').dataset.value"
    before = tab.evaluate(value)
    other.goto(f"{url}#view=%22year%22")
    other.locator('.yearView input[type="file"]').set_input_files(result)
    other.get_by_role("heading", name="Panel, laser-cut").wait_for()
    rows = other.locator("[data-row]").count()

    process.kill()
    process.wait(chromium.PATIENCE_S)
    process, again = chromium.started(empty, int(url.rstrip("/").rsplit(":", 1)[1]))
    assert again == url
    # pages that are loaded again
    tab.reload()
    tab.locator(".disc.picks").wait_for()
    assert tab.evaluate(value) == before
    other.reload()
    other.get_by_role("heading", name="Panel, laser-cut").wait_for()
    assert other.locator("[data-row]").count() == rows > 0

    process.kill()
    process.wait(chromium.PATIENCE_S)
    process, again = chromium.started(empty, int(url.rstrip("/").rsplit(":", 1)[1]))
    # one that stays and asks what the studio does not know any more
    tab.bring_to_front()
    tab.locator("#elevation").fill("20")
    moved = f"before => ({value})() && ({value})() !== before"
    tab.wait_for_function(moved, arg=before)
    assert not os.listdir(empty)
    # a browser that it was not dropped on has nothing to give
    stranger = browser.new_page(viewport=chromium.SIZE)
    link = tab.evaluate("() => location.href")
    process.kill()
    process.wait(chromium.PATIENCE_S)
    process, again = chromium.started(empty, int(url.rstrip("/").rsplit(":", 1)[1]))
    stranger.goto(link)
    stranger.get_by_text("open the file again").first.wait_for()
    stranger.close()
    context.close()
    chromium.ended(process)
    assert wrong == [[], []]


#: Names of what the browser keeps, the oldest first; and a way to keep what only looks like a file.
KEPT = """() => new Promise(done => {
    const opening = indexedDB.open('clerestory');
    // the page has not made it yet
    opening.onupgradeneeded = () => opening.transaction.abort();
    opening.onerror = () => done([]);
    opening.onsuccess = () => {
        const asked = opening.result.transaction('files').objectStore('files').index('at').getAll();
        asked.onsuccess = () => done(asked.result.map(one => one.path.split('=')[1]));
    };
})"""
KEEP = """([name, size, ago]) => new Promise(done => {
    const opening = indexedDB.open('clerestory');
    opening.onsuccess = () => {
        const files = opening.result.transaction('files', 'readwrite').objectStore('files');
        files.put({key: name, path: `/api/result?name=${name}`, file: {size}, at: Date.now() - ago}).onsuccess = done;
    };
})"""


def test_the_browser_keeps_a_few_files_for_a_while(browser: Any, studio: str, tmp_path: Path) -> None:
    panel = panel_from_dict({"kind": "laser-cut", "spacing_mm": 4.0, "thickness_mm": 6.0})
    text = save(panel.angular(elevation_deg=[0, 20]), tmp_path / "angular.csv").read_text()
    context = browser.new_context(viewport=chromium.SIZE)
    tab = context.new_page()
    tab.set_default_timeout(1000.0 * chromium.PATIENCE_S)
    tab.goto(f"{studio}#view=%22year%22")

    def drop(name: str) -> list[str]:
        (tmp_path / name).write_text(f"# called: {name}\n{text}")
        tab.locator('.yearView input[type="file"]').set_input_files(tmp_path / name)
        late = time.monotonic() + chromium.PATIENCE_S
        while (names := tab.evaluate(KEPT))[-1:] != [name]:
            assert time.monotonic() < late, names
            time.sleep(0.05)
        return list(names)

    assert drop("first.csv") == ["first.csv"]
    for number in range(30):
        tab.evaluate(KEEP, [f"{number}.csv", 1000, 60_000 + 10_000 * number])
    # 24 are kept, the newest of all; the one that has just come is one of them
    assert drop("second.csv") == [*(f"{number}.csv" for number in reversed(range(22))), "first.csv", "second.csv"]
    for name, size, ago in (("large.csv", 200 * 2**20, 50), ("old.csv", 1000, 31 * 86_400_000)):
        tab.evaluate(KEEP, [name, size, ago])
    tab.evaluate(KEEP, ["larger.csv", 100 * 2**20, 20])
    # of 300 MiB what has just come stays, and what else has room in 256 MiB; not what is a month old
    kept = ["first.csv", "second.csv", "larger.csv", "third.csv"]
    assert drop("third.csv") == [*(f"{number}.csv" for number in reversed(range(20))), *kept]
    context.close()


@pytest.mark.filterwarnings("ignore:The data type")
def test_a_store_that_is_dropped_as_a_folder_opens(browser: Any, studio: str, tmp_path: Path) -> None:
    cases = xr.Dataset(
        {"mean_transmittance": ("case", [0.5, 0.7])},
        {"key": ("case", ["a", "b"]), "status": ("case", ["done", "done"]), "panel.spacing_mm": ("case", [3.0, 4.0])},
        {"study": "Two cases"},
    )
    cases.to_zarr(tmp_path / "results.zarr", zarr_format=3, consolidated=False)
    context = browser.new_context(viewport=chromium.SIZE)
    tab = context.new_page()
    wrong = chromium.watched(tab, studio)
    context.set_default_timeout(1000.0 * chromium.PATIENCE_S)
    mouse = context.new_cdp_session(tab)

    def drop(folder: Path) -> None:
        for kind in ("dragEnter", "dragOver", "drop"):
            data = {"items": [], "files": [str(folder)], "dragOperationsMask": 1}
            mouse.send("Input.dispatchDragEvent", {"type": kind, "x": 700, "y": 400, "data": data})

    # on the view that opens it, and on another
    for view in ("year", "bsdf"):
        tab.goto("about:blank")
        tab.goto(f"{studio}#view=%22{view}%22")
        tab.locator("main fieldset, main .dropPlace").first.wait_for()
        drop(tmp_path / "results.zarr")
        tab.get_by_role("heading", name="Two cases").wait_for()
        assert tab.locator("[data-row]").count() == 2
    (tmp_path / "empty").mkdir()
    drop(tmp_path / "empty")
    tab.locator(".fault").filter(has_text="must hold one zarr store").first.wait_for()
    context.close()
    assert not wrong
