"""The page in a real browser: views opened, sliders moved, numbers compared with the API, the server restarted.

CLERESTORY_PICTURES=folder keeps the pictures of docs/how-to/studio.md there.
"""

import re
from pathlib import Path
from typing import Any

from tests.studio import chromium

from clerestory import panel_from_dict, read_bsdf

BLINDS = Path(__file__).parents[1] / "data/bsdf/blinds_tensortree3.xml"

pytestmark = chromium.NEEDED
LCP = {"kind": "laser-cut", "spacing_mm": 6, "thickness_mm": 6, "medium": "pmma"}


def shown(page: Any, name: str, panel: str = "a") -> float:
    """A share as the page got it."""
    place = page.locator(f'[data-panel="{panel}"] [data-number="{name}"]')
    return float(place.get_attribute("data-value") or "nan")


def settled(page: Any, name: str, value: float, panel: str = "a") -> None:
    """Waits until the page shows a share."""
    place = f'[data-panel="{panel}"] [data-number="{name}"]'
    page.wait_for_function(
        "([place, value]) => Math.abs(Number(document.querySelector(place)?.dataset.value || NaN) - value) < 1e-5",
        arg=[place, value],
    )


def share(panel: dict[str, Any], elevation: float, name: str) -> float:
    return float(panel_from_dict(panel).angular(elevation_deg=elevation)[name].squeeze())


def test_sliders_move_the_light_and_numbers_are_the_apis(page: Any) -> None:
    settled(page, "transmittance_deflected", share(LCP, 45.0, "transmittance_deflected"))
    page.locator("#a-spacing_mm").fill("4")
    settled(page, "transmittance_deflected", share(LCP | {"spacing_mm": 4}, 45.0, "transmittance_deflected"))
    page.locator("#elevation").fill("30")
    settled(page, "transmittance", share(LCP | {"spacing_mm": 4}, 30.0, "transmittance"))
    # the bar always fills
    widths = page.locator("svg.energy rect").evaluate_all("all => all.map(one => Number(one.getAttribute('width')))")
    assert sum(widths) == 1000
    # the section is there, to scale, with light in it
    assert page.locator(".drawing .solid").count() > 0
    assert page.locator('.drawing path[fill^="rgb"]').count() > 4


def test_the_sun_is_dragged_and_moved_by_keys(page: Any) -> None:
    settled(page, "transmittance", share(LCP, 45.0, "transmittance"))
    sun = page.get_by_role("slider", name=re.compile("^Sun: drag"))
    box = sun.locator("circle.disc").bounding_box()
    page.mouse.move(box["x"] + 8, box["y"] + 8)
    page.mouse.down()
    page.mouse.move(box["x"] + 8, box["y"] + 160, steps=8)
    page.mouse.up()
    page.wait_for_function("() => Number(document.querySelector('#elevation').value) < 40")
    chromium.is_drawn(page)
    elevation = float(page.locator("#elevation").input_value())
    settled(page, "transmittance", share(LCP, elevation, "transmittance"))
    sun.focus()
    page.keyboard.press("ArrowUp")
    page.wait_for_function(
        f"() => Math.abs(Number(document.querySelector('#elevation').value) - {elevation + 1}) < 0.26"
    )


def test_a_mistake_is_told_beside_its_field_and_the_picture_stays(page: Any) -> None:
    settled(page, "transmittance", share(LCP, 45.0, "transmittance"))
    page.get_by_label("Cut width, mm").fill("7")
    fault = page.locator("#a-cut_width_mm-wrong")
    fault.wait_for()
    assert "must be smaller than spacing_mm" in fault.inner_text()
    assert page.locator(".drawing .solid").count() > 0
    page.get_by_label("Cut width, mm").fill("0")
    fault.wait_for(state="detached")


def test_a_link_reproduces_the_page_and_two_tabs_do_not_disturb_one_another(
    page: Any, browser: Any, studio: str
) -> None:
    page.locator("#a-kind").select_option("prismatic")
    page.locator("#a-upper_deg").fill("60")
    prism = {"kind": "prismatic", "pitch_mm": 4, "lower_deg": 45, "upper_deg": 60, "base_mm": 3, "medium": "pmma"}
    settled(page, "transmittance", share(prism, 45.0, "transmittance"))
    page.wait_for_function("() => location.hash.includes('upper_deg')")
    other = browser.new_page()
    chromium.watched(other, studio)
    other.goto(page.url)
    settled(other, "transmittance", share(prism, 45.0, "transmittance"))
    other.locator("#elevation").fill("20")
    settled(other, "transmittance", share(prism, 20.0, "transmittance"))
    page.reload()
    settled(page, "transmittance", share(prism, 45.0, "transmittance"))
    assert page.locator("#a-upper_deg").input_value() == "60"
    other.close()


def test_two_panels_stand_side_by_side_with_curves_and_a_klems_disc(page: Any) -> None:
    page.get_by_label("Compare two panels").check()
    prism = {"kind": "prismatic", "pitch_mm": 4, "lower_deg": 45, "upper_deg": 80, "base_mm": 3, "medium": "pmma"}
    settled(page, "transmittance", share(prism, 45.0, "transmittance"), panel="b")
    page.wait_for_function(
        "() => document.querySelectorAll('section[aria-label=\"Deflection against elevation\"] .dot').length === 6"
    )
    page.get_by_label("Compare two panels").uncheck()
    klems = page.locator('section[aria-label="BSDF in the Klems basis"]')
    klems.get_by_role("button", name="Compute").click()
    klems.locator('[data-whole="true"] .disc').first.wait_for()


def test_files_go_out_and_come_in(page: Any, tmp_path: Path) -> None:
    settled(page, "transmittance", share(LCP, 45.0, "transmittance"))
    figure = page.locator('section[aria-label="Section, to scale"]')
    for name, begins in (("PNG", b"\x89PNG"), ("SVG", b"<svg"), ("CSV", b"power,side")):
        with page.expect_download() as waiting:
            figure.get_by_role("button", name=name).click()
        assert Path(waiting.value.path()).read_bytes().startswith(begins), name
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Save TOML", exact=True).click()
    assert 'kind = "laser-cut"' in Path(waiting.value.path()).read_text()
    file = tmp_path / "mine.toml"
    file.write_text('kind = "pane"\nthickness_mm = 9.0\nmedium = "bk7"\n')
    page.locator('input[accept=".toml"]').set_input_files(file)
    settled(page, "transmittance", share({"kind": "pane", "thickness_mm": 9.0, "medium": "bk7"}, 45.0, "transmittance"))
    file.write_text("kind = 7")
    page.locator('input[accept=".toml"]').set_input_files(file)
    page.get_by_text("This file was not opened").wait_for()


def test_a_bsdf_is_dropped_looked_at_and_a_bad_one_refused_in_words(page: Any, tmp_path: Path) -> None:
    page.get_by_role("tab", name="BSDF").click()
    page.locator('input[accept=".xml,.nc"]').set_input_files(BLINDS)
    page.get_by_role("heading", name=read_bsdf(BLINDS).name, exact=True).wait_for()
    page.locator(".disc.picks").wait_for()
    mean = read_bsdf(BLINDS).visible.transmission_front.mean()
    assert page.get_by_text(f"{mean:.4f}").count() > 0
    page.locator(".disc.picks").focus()
    page.keyboard.press("ArrowUp")
    page.wait_for_function("() => Number(document.querySelector('#elevation').value) !== 40")
    bad = tmp_path / "bad.xml"
    bad.write_text("<WindowElement><Optical></Optical></WindowElement>")
    page.locator('input[accept=".xml,.nc"]').set_input_files(bad)
    fault = page.get_by_role("alert")
    fault.wait_for()
    assert "bad.xml" in fault.inner_text()
    assert page.get_by_text("Drop an XML file of anybody").count() == 1
    # a file of the folder stands in the link, and so does the dark page
    page.locator("#file").select_option("blinds.xml")
    page.get_by_label("Colours").select_option("dark")
    page.wait_for_function("() => location.hash.includes('blinds.xml') && location.hash.includes('dark')")
    page.reload()
    page.locator(".disc.picks").wait_for()
    assert page.locator("html").get_attribute("data-theme") == "dark"


def test_a_page_whose_studio_was_killed_says_so_and_goes_on_when_it_is_back(browser: Any, folder: Path) -> None:
    port = chromium.port_to_keep()
    process, url = chromium.started(folder, port)
    tab = browser.new_page()
    chromium.watched(tab, url)
    tab.goto(url)
    settled(tab, "transmittance", share(LCP, 45.0, "transmittance"))
    process.kill()
    process.wait()
    tab.locator("#elevation").fill("25")
    tab.get_by_text("The studio does not answer").first.wait_for()
    process, _ = chromium.started(folder, port)
    settled(tab, "transmittance", share(LCP, 25.0, "transmittance"))
    tab.wait_for_function("() => !document.querySelector('main').innerText.includes('The studio does not answer')")
    tab.close()
    chromium.ended(process)
