"""The BSDF view in a real browser: files of all sorts, two compared, values read, saved for other programs."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.bsdf.elements import uneven_block, uneven_bsdf, uneven_tree_bsdf
from tests.studio import chromium

from clerestory import Band, Bsdf, read_bsdf

pytestmark = chromium.NEEDED


@pytest.fixture(scope="module")
def studio(folder: Path) -> Iterator[str]:
    uneven_bsdf("klems_half").to_xml(folder / "uneven.xml")
    uneven_tree_bsdf(4).to_xml(folder / "tree4.xml")
    alone = Band(transmission_front=uneven_block(3))
    Bsdf(name="Half known", visible=alone, thickness_mm=2.0).to_dataset().to_netcdf(folder / "part.nc")
    with chromium.studio_of(folder) as url:
        yield url


def opened(browser: Any, studio: str, state: str, size: dict[str, int] = chromium.SIZE) -> Any:
    tab = browser.new_page(viewport=size)
    chromium.watched(tab, studio)
    tab.goto(f'{studio}#view="bsdf"&{state}')
    return tab


def shown(tab: Any, name: str) -> float:
    place = tab.locator(f'[data-bsdf="{name}"][data-value]')
    place.wait_for()
    return float(place.get_attribute("data-value"))


@pytest.mark.parametrize("name", ["blinds", "uneven", "tree4"])
def test_numbers_at_an_incidence_are_those_of_the_blocks(browser: Any, studio: str, folder: Path, name: str) -> None:
    tab = opened(browser, studio, f'bsdf.path="{name}.xml"')
    tab.locator(".disc.picks").wait_for()
    block = read_bsdf(folder / f"{name}.xml").visible.transmission_front
    own = float(block.hemispherical_at([0.0, -0.6427876]))
    assert shown(tab, "a-Transmitted") == pytest.approx(own, abs=2e-4)
    if name == "blinds":
        chromium.picture(tab, "studio-bsdf")
    tab.locator("#side").select_option("back")
    back = read_bsdf(folder / f"{name}.xml").visible.transmission_back
    value = "Number(document.querySelector('[data-bsdf=\"a-Transmitted\"]').dataset.value)"
    tab.wait_for_function(f"own => Math.abs({value} - own) < 2e-4", arg=float(back.hemispherical_at([0.0, -0.6427876])))
    # values are read with the pointer and by keys
    disc = tab.locator("svg.disc:not(.picks)").first
    disc.hover()
    tab.get_by_text(re.compile("from the normal, at .*1/sr")).first.wait_for()
    disc.focus()
    tab.keyboard.press("ArrowRight")
    tab.locator(".readPatch").first.wait_for()
    tab.locator("#scale").select_option("linear")
    tab.close()


def test_what_a_file_does_not_hold_is_said_in_words(browser: Any, studio: str, folder: Path) -> None:
    tab = opened(browser, studio, "bsdf.plane=0")
    tab.locator('.bsdfView input[accept=".xml,.nc"]').set_input_files(folder / "part.nc")
    tab.get_by_text("The file does not hold reflection of the front").wait_for()
    tab.locator("#side").select_option("back")
    tab.get_by_text("must have a block of the back").first.wait_for()
    tab.close()


def test_two_bsdfs_are_compared(browser: Any, studio: str, folder: Path) -> None:
    tab = opened(browser, studio, 'bsdf.path="blinds.xml"&bsdf.compares=true')
    tab.locator("#file-b").select_option("uneven.xml")
    tab.wait_for_function("() => location.hash.includes('uneven.xml')")
    assert shown(tab, "b-Transmitted") != shown(tab, "a-Transmitted")
    tab.wait_for_function(
        "() => document.querySelectorAll('section[aria-label=\"Shares against elevation\"] path.curve').length >= 8"
    )
    chromium.picture(tab, "studio-two-bsdfs")
    tab.reload()
    shown(tab, "b-Transmitted")
    tab.close()


def test_light_is_dragged_and_files_go_out(browser: Any, studio: str, folder: Path, tmp_path: Path) -> None:
    tab = opened(browser, studio, 'bsdf.path="uneven.xml"')
    box = tab.locator("svg.sky .skyRim").bounding_box()
    tab.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    tab.mouse.down()
    tab.mouse.move(box["x"] + box["width"] / 3, box["y"] + box["height"] / 3, steps=3)
    tab.mouse.up()
    tab.wait_for_function("() => Number(document.querySelector('#azimuth').value) > 15")
    figure = tab.locator('section[aria-label="Where the light goes"]')
    figure.get_by_label("Basis of files").select_option("klems_quarter")
    with tab.expect_download() as waiting:
        figure.get_by_label("Save as, BSDF A").select_option("xml")
    path = tmp_path / "again.xml"
    waiting.value.save_as(path)
    again = read_bsdf(path).visible.transmission_front
    own = read_bsdf(folder / "uneven.xml").in_basis("klems_quarter").visible.transmission_front
    assert again.mean() == pytest.approx(own.mean(), abs=1e-5)
    for title in ("Where the light goes", "Cut through the light", "Shares against elevation"):
        for ending in ("PNG", "SVG", "CSV"):
            with tab.expect_download() as waiting:
                tab.locator(f'section[aria-label="{title}"]').get_by_role("button", name=ending).click()
            assert waiting.value.suggested_filename.startswith("bsdf-")
    tab.close()


def test_the_view_fits_a_tablet(browser: Any, studio: str) -> None:
    tab = opened(browser, studio, 'theme="dark"&bsdf.path="blinds.xml"', chromium.TABLETS[0])
    tab.locator(".disc.picks").wait_for()
    wide = tab.evaluate("() => [document.documentElement.scrollWidth, innerWidth]")
    assert wide[0] <= wide[1]
    chromium.picture(tab, "studio-bsdf-tablet")
    tab.close()
