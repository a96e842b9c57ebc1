"""A page that is loaded again goes on with what its studio computes for it."""

import shutil
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from tests.studio import chromium
from tests.year.small import YEAR, write_small

pytestmark = chromium.NEEDED
#: A panel whose BSDF takes minutes.
SLOW = (
    "panel.a.kind=%22laser-cut%22&panel.a.spacing_mm=[3.1,4.7,5.3]&panel.a.thickness_mm=9"
    "&panel.a.cut_width_mm=0.31&panel.a.cut_tilt_deg=7.3"
)


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A studio in a folder with a year that takes hours, and nothing else."""
    folder = tmp_path_factory.mktemp("again").resolve()
    write_small(folder, YEAR.replace("rounds = 4", "rounds = 100000"))
    shutil.copy(folder / "year.toml", folder / "another.toml")
    # a busy machine may take long to load a page again
    with chromium.studio_of(folder, "from clerestory.studio.jobs import calls; calls.ALONE_S = 600.0") as url:
        yield url


#: The jobs of a kind, as the studio lists them.
JOBS = "kind => fetch(`/api/jobs?kind=${kind}`).then(answer => answer.json()).then(told => told.jobs)"


def jobs(tab: Any, kind: str) -> list[dict[str, Any]]:
    """What the studio says of the jobs of a kind."""
    told: list[dict[str, Any]] = tab.evaluate(JOBS, kind)
    return told


def until(is_so: Callable[[], bool], within_s: float = chromium.PATIENCE_S) -> None:
    """Waits until something is so."""
    late = time.monotonic() + within_s
    while not is_so():
        assert time.monotonic() < late
        time.sleep(0.05)


def test_a_year_that_runs_is_found_by_the_page_that_was_loaded_again(page: Any, studio: str) -> None:
    page.get_by_role("tab", name="Year").click()
    page.get_by_label("Year file").select_option("year.toml")
    page.get_by_role("button", name="Run", exact=True).click()
    goes_on = "() => document.querySelector('.runYear progress')?.value > 0"
    page.wait_for_function(goes_on)
    page.reload()
    page.wait_for_function(goes_on)
    assert page.get_by_label("Year file").input_value() == "year.toml"
    page.get_by_text("glass:").first.wait_for()
    assert [one["state"] for one in jobs(page, "year")] == ["running"]
    chromium.picture(page, "studio-year-again")
    # a page of another address finds it too, and that it was stopped is told to one that comes later
    page.goto("about:blank")
    page.goto(f"{studio}#view=%22year%22")
    page.wait_for_function(goes_on)
    page.get_by_role("button", name="Stop").click()
    page.get_by_text("stopped; run it again to go on").wait_for()
    until(lambda: jobs(page, "year")[0]["state"] == "cancelled")
    page.reload()
    page.get_by_text("stopped; run it again to go on").wait_for()
    assert page.get_by_role("button", name="Run", exact=True).is_enabled()
    assert len(jobs(page, "year")) == 1


def test_a_bsdf_that_is_computed_is_gone_on_with(page: Any, studio: str) -> None:
    page.goto(f"{studio}#{SLOW}")
    figure = page.locator("section.figure", has=page.locator("#a-basis"))
    figure.get_by_role("button", name="Compute").click()
    shown = figure.locator(".progress progress")
    shown.wait_for()
    until(lambda: jobs(page, "klems")[0]["followers"] == 1)
    [before] = [one["job"] for one in jobs(page, "klems")]
    page.reload()
    shown.wait_for()
    until(lambda: jobs(page, "klems")[0]["followers"] == 1)
    [now] = jobs(page, "klems")
    assert (now["job"], now["state"]) == (before, "running")
    # its own page alone takes it up: another computes nothing unasked
    other = page.context.browser.new_page()
    other.set_default_timeout(1000.0 * chromium.PATIENCE_S)
    other.goto(f"{studio}#{SLOW}")
    other.locator(".drawing .solid").first.wait_for()
    other.wait_for_timeout(500)
    assert other.locator("section.figure", has=other.locator("#a-basis")).locator("progress").count() == 0
    other.close()
    figure.get_by_role("button", name="Stop").click()
    until(lambda: jobs(page, "klems")[0]["state"] == "cancelled")
