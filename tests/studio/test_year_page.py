"""The Year view in a real browser: results opened, read, clicked, refused; a year run and stopped.

CLERESTORY_PICTURES=folder keeps pictures there; CLERESTORY_CLASSROOM=folder names one that holds the classroom's files
and results (examples/classroom, `clerestory year … --out out/classroom`), which the pictures of the how-to show.
"""

import json
import os
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from tests.studio import chromium

pytestmark = chromium.NEEDED
YEAR = "out/year/year.nc"


@pytest.fixture(scope="module")
def own(result_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of this module's own, as it runs years in it."""
    place = tmp_path_factory.mktemp("page") / "project"
    shutil.copytree(result_folder, place, ignore=shutil.ignore_patterns("again*", "pieces"))
    return place


@pytest.fixture(scope="module")
def studio(own: Path) -> Iterator[str]:
    with chromium.studio_of(own) as url:
        yield url


@pytest.fixture(scope="module")
def year(own: Path) -> xr.Dataset:
    with xr.open_dataset(own / YEAR) as found:
        return found.load()


def opened(page: Any, url: str, path: str, heading: str, **state: Any) -> None:
    said = {"view": "year", "theme": state.pop("theme", "auto"), "year.path": path}
    said |= {f"year.{name}": value for name, value in state.items()}
    page.goto("about:blank")
    page.goto(f"{url}#" + "&".join(f"{name}={quote(json.dumps(value))}" for name, value in said.items()))
    page.get_by_role("heading", name=heading, exact=True).wait_for()


def shown(page: Any, figure: str, variant: int) -> float:
    cell = page.locator(f'[data-figure="{figure}"] td').nth(variant)
    return float(cell.get_attribute("data-value"))


def test_a_year_of_the_list_opens_with_the_numbers_of_its_file(page: Any, year: xr.Dataset) -> None:
    page.get_by_role("tab", name="Year").click()
    page.get_by_text("No result is open").wait_for()
    page.get_by_role("button", name=re.compile("Small room")).first.click()
    page.get_by_role("heading", name="Small room").wait_for()
    for figure in ("mean_daylight_factor", "mean_daylight_autonomy", "spatial_daylight_autonomy", "lighting_saved"):
        for variant in range(3):
            assert shown(page, figure, variant) == pytest.approx(float(year[figure][variant]), rel=1e-9), figure
    assert page.locator('[data-figure="mean_daylight_factor"] td.best').count() >= 1
    # a variant less is a column less
    page.get_by_role("checkbox", name="dark").uncheck()
    page.wait_for_function("() => document.querySelectorAll('[data-figure=mean_daylight_factor] td').length === 2")
    page.wait_for_function("() => location.hash.includes('hidden')")


def test_plans_are_read_by_pointer_and_keys(page: Any, studio: str, year: xr.Dataset) -> None:
    opened(page, studio, YEAR, "Small room")
    page.get_by_label("Quantity").select_option("sunlit_hours")
    figure = page.locator('section.figure[aria-label="Hours with direct sun"]')
    figure.wait_for()
    plans = figure.locator("svg.plans")
    assert plans.locator("rect").count() > 3 * 15
    plans.focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    read = figure.locator(".readout")
    figure.get_by_text("x 1.50 m").wait_for()
    # the second sensor of the first row by the window
    at = int(np.flatnonzero((year["row"].values == 0) & (year["column"].values == 1))[0])
    numbers = re.findall(r": ([\d.]+)", read.inner_text())
    assert [float(one) for one in numbers] == pytest.approx(year["sunlit_hours"].values[:, at], abs=0.06)
    page.keyboard.press("Enter")
    page.wait_for_function(f"() => location.hash.includes('year.sensor={at}')")
    page.get_by_role("heading", name="Hours of the year: x 1.50 m, y 0.50 m").wait_for()
    # a difference is the other's less this one's
    page.get_by_label("View").select_option("difference")
    figure = page.locator('section.figure[aria-label="Hours with direct sun: panel above less glass"]')
    figure.wait_for()
    with page.expect_download() as waiting:
        figure.get_by_role("button", name="CSV").click()
    table = pd.read_csv(waiting.value.path())
    change = year["sunlit_hours"].sel(variant="panel above") - year["sunlit_hours"].sel(variant="glass")
    assert sorted(table.iloc[:, 2]) == pytest.approx(sorted(change.values))


def test_an_hour_of_the_carpet_is_shown_in_plan(page: Any, studio: str, year: xr.Dataset) -> None:
    opened(page, studio, YEAR, "Small room")
    carpets = page.locator("svg.carpets")
    carpets.scroll_into_view_if_needed()
    image = carpets.locator("image").first.bounding_box()
    # the middle of the first of three days, half past twelve
    page.mouse.click(image["x"] + image["width"] / 6, image["y"] + image["height"] * (1 - 12.5 / 24))
    page.wait_for_function("() => location.hash.includes('year.day')")
    day = str(year["local_time"].values[0])[:10]
    stamp = pd.Timestamp(day)
    figure = page.locator("section.figure").filter(
        has=page.get_by_role("heading", name=re.compile("^One hour: .*12:30"))
    )
    figure.wait_for()
    assert str(stamp.day) in figure.get_by_role("heading").inner_text()
    with page.expect_download() as waiting:
        figure.get_by_role("button", name="CSV").click()
    table = pd.read_csv(waiting.value.path())
    place = int(np.flatnonzero(pd.DatetimeIndex(year["local_time"].values).hour == 12)[0])
    assert sorted(table["glass [lx]"]) == pytest.approx(sorted(year["illuminance"].values[0, :, place]), rel=1e-6)
    # keys walk on from there
    carpets.focus()
    page.keyboard.press("ArrowUp")
    page.get_by_role("heading", name=re.compile("^One hour: .*13:30")).wait_for()
    page.keyboard.press("ArrowRight")
    page.get_by_role("heading", name=re.compile(f"^One day: .* {stamp.day + 1} ")).wait_for()
    read = page.locator("section.figure:has(svg.carpets) .readout").inner_text()
    light = float(year["mean_illuminance"].values[0, place + 25])
    assert float(re.search(r"glass: ([\d.]+)", read)[1]) == pytest.approx(light, rel=2e-2)
    page.get_by_label("Hours of use only").check()
    page.wait_for_function("() => location.hash.includes('onlyUse=true')")
    for name, begins in (("PNG", b"\x89PNG"), ("SVG", b"<svg")):
        with page.expect_download() as waiting:
            page.locator("section.figure:has(svg.carpets)").get_by_role("button", name=name).click()
        assert Path(waiting.value.path()).read_bytes().startswith(begins), name


def test_rooms_sweeps_designs_and_panels_open_too(page: Any, studio: str, own: Path) -> None:
    opened(page, studio, "out/room/summary.json", "room", metric="illuminance|overcast")
    page.locator('section.figure[aria-label="Illuminance: overcast"] svg.plans').wait_for()
    assert page.get_by_role("button", name="Open in Room view").count() == 1
    opened(page, studio, "out/sweep/results.zarr", "spacings")
    page.locator("[data-row]").first.wait_for()
    done = pd.read_csv(own / "out/sweep/results.csv", comment="#")["status"].eq("done").sum()
    assert page.locator("[data-row]").count() == done
    page.get_by_label("Up").select_option("mean_reflectance")
    page.get_by_role("heading", name=re.compile("^Mean reflectance")).wait_for()
    opened(page, studio, "out/design/summary.json", "band")
    page.locator(".bestRing").first.wait_for()
    front = len(json.loads((own / "out/design/summary.json").read_text())["front"])
    assert page.locator("tr.onFront").count() == front
    opened(page, studio, "out/panel/angular.nc", "Panel, laser-cut")
    page.wait_for_function("() => document.querySelectorAll('[data-row]').length === 16")


def test_a_bad_file_is_refused_in_words_and_a_good_one_dropped(page: Any, own: Path, tmp_path: Path) -> None:
    page.get_by_role("tab", name="Year").click()
    bad = tmp_path / "bad.nc"
    bad.write_bytes((own / YEAR).read_bytes()[:20_000])
    chooser = page.locator('.yearView input[type="file"]')
    chooser.set_input_files(bad)
    fault = page.locator(".yearView .fault").first
    fault.wait_for()
    assert "bad.nc" in fault.inner_text()
    assert page.get_by_text("No result is open").count() == 1
    chooser.set_input_files(own / YEAR)
    page.get_by_role("heading", name="Small room", exact=True).wait_for()
    assert fault.count() == 0


def test_a_year_is_run_from_the_page_and_stopped(page: Any, own: Path) -> None:
    text = (own / "year.toml").read_text()
    # hours of work
    (own / "long.toml").write_text(text.replace("rounds = 4", "rounds = 100000").replace("Small room", "Long run"))
    page.get_by_role("tab", name="Year").click()
    page.get_by_label("Year file").select_option("long.toml")
    run = page.get_by_role("button", name="Run", exact=True)
    run.click()
    page.wait_for_function("() => document.querySelector('.runYear progress')?.value > 0")
    # other views do not end it
    page.get_by_role("tab", name="Panel").click()
    page.get_by_role("tab", name="Year").click()
    page.get_by_role("button", name="Stop").click()
    page.get_by_text("stopped; run it again to go on").wait_for()
    assert not (own / "out/long/year.nc").exists()
    page.get_by_role("button", name="Run", exact=True, disabled=False).wait_for()


def test_pictures_of_the_classroom(browser: Any) -> None:
    classroom, kept = os.environ.get("CLERESTORY_CLASSROOM"), os.environ.get("CLERESTORY_PICTURES")
    if not classroom or not kept:
        pytest.skip("CLERESTORY_CLASSROOM and CLERESTORY_PICTURES are not set")
    with chromium.studio_of(Path(classroom)) as url:
        tab = browser.new_page(viewport=chromium.SIZE)
        chromium.watched(tab, url)
        for theme, ending in (("light", ""), ("dark", "-dark")):
            opened(tab, url, "out/classroom/year.nc", "Classroom in Miami", theme=theme)
            for name in (".carpets", "section[aria-label^='One hour'] .plans", "section[aria-label^='Month']"):
                tab.locator(name).first.wait_for()
            cut = tab.locator("section[aria-label='Hours of the year']").bounding_box()["y"] - 8
            clip = {"x": 0, "y": 0, "width": 1360, "height": cut}
            tab.screenshot(path=f"{kept}/studio-year{ending}.png", full_page=True, clip=clip)
            # the side beside the hours is empty
            high = tab.evaluate("document.documentElement.scrollHeight") - cut
            clip = {"x": 288, "y": cut, "width": 1072, "height": high}
            tab.screenshot(path=f"{kept}/studio-hours{ending}.png", full_page=True, clip=clip)
        tab.close()
        tab = browser.new_page(viewport=chromium.SIZE)
        opened(tab, url, "out/design/summary.json", "design")
        tab.locator(".bestRing").first.wait_for()
        chromium.picture(tab, "studio-design")
        tab.close()
