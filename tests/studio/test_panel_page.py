"""The panel's page in a real browser: every kind, rough cuts, drawings, both sides, BSDFs with the time left, files."""

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest
from tests.studio import chromium

from clerestory import panel_from_dict, read_bsdf

pytestmark = chromium.NEEDED

PANELS: dict[str, dict[str, Any]] = {
    "partial": {"kind": "laser-cut", "spacing_mm": 6, "thickness_mm": 6, "medium": "pmma", "cut_depth_mm": 4},
    "uneven": {"kind": "laser-cut", "spacing_mm": [4, 5, 7.5], "thickness_mm": 6, "medium": "pmma"},
}


@pytest.fixture(scope="module")
def studio(folder: Path) -> Iterator[str]:
    (folder / "bar.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0,0 H6 V-3 H0 Z"/></svg>')
    with chromium.studio_of(folder) as url:
        yield url


def settled(page: Any, name: str, value: float, panel: str = "a", within: float = 1e-5) -> None:
    """Waits until the page shows a share."""
    page.wait_for_function(
        "([place, value, within]) => "
        "Math.abs(Number(document.querySelector(place)?.dataset.value || NaN) - value) < within",
        arg=[f'[data-panel="{panel}"] [data-number="{name}"]', value, within],
    )


def share(panel: dict[str, Any], name: str = "transmittance", **at: Any) -> float:
    table = panel_from_dict(panel).angular(**{"elevation_deg": 45.0} | at)
    return float(table[name].squeeze())


def figure(page: Any, title: str) -> Any:
    return page.locator(f'section[aria-label="{title}"]')


def test_optional_sizes_and_lists_are_set_by_hand_and_told_beside_their_field(page: Any) -> None:
    page.get_by_text("Partial and curved cuts").click()
    page.locator("#a-cut_depth_mm").click()
    settled(page, "transmittance_deflected", share(PANELS["partial"], "transmittance_deflected"))
    page.get_by_role("button", name="off").click()
    page.get_by_role("button", name="Spacing D: several").click()
    page.locator("#a-spacing_mm").fill("4, 5 7.5")
    settled(page, "transmittance_deflected", share(PANELS["uneven"], "transmittance_deflected"))
    # half a list changes nothing, a wrong one is told
    page.locator("#a-spacing_mm").fill("4 -5")
    fault = page.locator("#a-spacing_mm-wrong")
    fault.wait_for()
    assert "spacing_mm" in fault.inner_text()
    page.wait_for_function("() => decodeURIComponent(location.hash).includes('[4,-5]')")
    page.reload()
    page.locator("#a-spacing_mm").wait_for()
    assert page.locator("#a-spacing_mm").input_value() == "4 -5"


def test_one_click_starts_from_a_published_panel(page: Any) -> None:
    page.get_by_role("button", name=re.compile("Start from Laser-cut.* 0.5")).click()
    published = {"kind": "laser-cut", "spacing_mm": 3.0, "thickness_mm": 6.0, "medium": {"n": 1.49}}
    settled(page, "transmittance_deflected", share(published, "transmittance_deflected"))
    assert page.locator("#a-medium").input_value() == "own"
    assert page.locator("#a-medium-n").input_value() == "1.49"
    page.wait_for_function("() => location.hash.includes('medium')")
    page.reload()
    settled(page, "transmittance_deflected", share(published, "transmittance_deflected"))


def test_the_sky_is_dragged_in_both_directions_and_moved_by_keys(page: Any) -> None:
    sun = page.get_by_role("slider", name=re.compile("^Sky seen"))
    box = page.locator("svg.sky .skyRim").bounding_box()
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.move(*middle)
    page.mouse.down()
    # to the right as seen from the room the azimuth is below 0
    page.mouse.move(middle[0] + box["width"] / 6, middle[1] - box["height"] / 6, steps=4)
    page.mouse.up()
    page.wait_for_function("() => Number(document.querySelector('#azimuth').value) < -20")
    chromium.is_drawn(page)
    at = {f"{name}_deg": float(page.locator(f"#{name}").input_value()) for name in ("elevation", "azimuth")}
    assert at["elevation_deg"] > 20
    lcp = {"kind": "laser-cut", "spacing_mm": 6, "thickness_mm": 6}
    settled(page, "transmittance", share(lcp, **at))
    sun.focus()
    page.keyboard.press("ArrowLeft")
    page.wait_for_function(f"() => Number(document.querySelector('#azimuth').value) > {at['azimuth_deg']}")
    assert "azimuth" in sun.get_attribute("aria-valuetext")


def test_light_from_the_room_is_as_the_api_says(page: Any) -> None:
    prism = {"kind": "prismatic", "pitch_mm": 4, "lower_deg": 45, "upper_deg": 45, "base_mm": 3, "medium": "pmma"}
    page.get_by_role("button", name="Start from Prism 45°/45°").click()
    page.locator("#side").select_option("back")
    settled(page, "transmittance", share(prism, side="back"))
    # the sun stands on the right of the section
    page.wait_for_function(
        "() => Number(document.querySelector('[data-panel=\"a\"] .sun .disc').getAttribute('cx')) > 320"
    )


def test_rough_cuts_show_shares_with_standard_errors_and_where_their_light_goes(page: Any) -> None:
    page.get_by_text("Rough and hazy cuts").click()
    page.locator("#a-cut_slope_deg").fill("3")
    rough = {"kind": "laser-cut", "spacing_mm": 6, "thickness_mm": 6, "cut_slope_deg": 3.0}
    own = share(rough, "transmittance_deflected", method="monte_carlo", rays=400_000, seed=5)
    settled(page, "transmittance_deflected", own, within=0.003)
    number = page.locator('[data-panel="a"] [data-number="transmittance_deflected"]')
    page.wait_for_function(
        "() => { const e = Number(document.querySelector('[data-number=transmittance_deflected]').dataset.error);"
        " return e > 0 && e < 4e-4 }"
    )
    assert abs(float(number.get_attribute("data-value")) - own) < 6.0 * 6e-4
    page.get_by_text("Drawn as if the cuts were smooth").wait_for()
    assert page.locator("dd small").first.inner_text().strip().startswith("±")
    page.locator("#radial").select_option("to")
    page.wait_for_function("() => document.querySelectorAll('[data-goes] path[fill-opacity]').length > 20")
    with page.expect_download() as waiting:
        figure(page, "Radial diagram").get_by_role("button", name="CSV").click()
    table = Path(waiting.value.path()).read_text().splitlines()
    assert table[0] == "elevation_low_deg,elevation_high_deg,front_share,back_share"
    assert sum(float(row.split(",")[3]) for row in table[1:]) == pytest.approx(
        share(rough, method="monte_carlo"), abs=0.02
    )
    # what has no answer says so in words
    dispersion = figure(page, "Dispersion")
    dispersion.get_by_role("button", name="Compute").click()
    dispersion.get_by_role("alert").wait_for()
    assert "no beams" in dispersion.get_by_role("alert").inner_text()
    chromium.picture(page, "studio-rough")


def test_a_panel_is_drawn_and_one_of_a_file_stays_editable(page: Any, tmp_path: Path) -> None:
    page.locator("#a-kind").select_option("drawn")
    page.locator("#a-points").fill("0,0 6,0 6,3 0,3")
    page.locator('[aria-label="Pitch, mm"]').fill("3")
    bars = {"kind": "laser-cut", "spacing_mm": 3, "thickness_mm": 6}
    settled(page, "transmittance_deflected", share(bars, "transmittance_deflected"))
    page.locator("#a-source").select_option("file")
    page.locator("#a-file").select_option("bar.svg")
    settled(page, "transmittance_deflected", share(bars, "transmittance_deflected"))
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Save TOML").click()
    text = Path(waiting.value.path()).read_text()
    assert tomllib.loads(text)["kind"] == "extruded"
    file = tmp_path / "drawn.toml"
    file.write_text(text)
    page.locator('.panelView input[accept=".toml"]').set_input_files(file)
    facets = page.locator("#a-facets")
    facets.wait_for()
    assert len(facets.input_value().splitlines()) == 3
    thinner = facets.input_value().replace("6 ", "4 ")
    facets.fill(thinner)
    settled(page, "transmittance_deflected", share(bars | {"thickness_mm": 4}, "transmittance_deflected"))
    facets.fill("0 0 1 x")
    page.locator("#a-facets-wrong").wait_for()


def test_two_panels_are_swapped_copied_opened_and_subtracted(page: Any, tmp_path: Path) -> None:
    page.get_by_label("Compare two panels").check()
    prism = {"kind": "prismatic", "pitch_mm": 4, "lower_deg": 45, "upper_deg": 80, "base_mm": 3, "medium": "pmma"}
    lcp = {"kind": "laser-cut", "spacing_mm": 6, "thickness_mm": 6, "medium": "pmma"}
    settled(page, "transmittance", share(prism), panel="b")
    settled(page, "transmittance", share(lcp))
    told = page.locator('[data-difference="transmittance"]')
    by = 100.0 * (share(prism) - share(lcp))
    assert told.inner_text().replace("−", "-").split()[0] == f"{by:+.1f}"
    page.get_by_role("button", name="Swap A and B").click()
    settled(page, "transmittance", share(prism))
    file = tmp_path / "b.toml"
    file.write_text('kind = "pane"\nthickness_mm = 9.0\nmedium = "bk7"\n')
    page.locator('label:has-text("Open TOML into B") input').set_input_files(file)
    settled(page, "transmittance", share({"kind": "pane", "thickness_mm": 9.0, "medium": "bk7"}), panel="b")
    page.get_by_role("button", name="Copy A to B").click()
    settled(page, "transmittance", share(prism), panel="b")
    assert told.inner_text().strip() in ("+0.0", "−0.0")
    curves = figure(page, "Deflection against elevation").locator("path.curve")
    curves.nth(10).wait_for(state="attached")
    chromium.picture(page, "studio-two-panels")


def test_a_slow_bsdf_shows_discs_at_once_with_the_time_left_and_ends_at_once(page: Any) -> None:
    # such cuts take minutes
    page.evaluate(
        "() => { location.hash = 'panel.a.kind=%22laser-cut%22&panel.a.spacing_mm=[3.1,4.7,5.3]&panel.a.thickness_mm=9"
        "&panel.a.cut_width_mm=0.31&panel.a.cut_tilt_deg=7.3' }"
    )
    page.wait_for_function("() => document.querySelector('#a-spacing_mm')?.value.includes('5.3')")
    klems = figure(page, "BSDF in the Klems basis")
    klems.get_by_role("button", name="Compute").click()
    klems.locator('[data-whole="false"] .disc').first.wait_for()
    klems.get_by_text(re.compile("% ?, about .* left")).wait_for()
    klems.get_by_role("button", name="Stop").click()
    klems.get_by_text("stopped").wait_for()
    # what there is stays, and light is chosen on the first disc
    klems.locator(".disc.picks").focus()
    page.keyboard.press("ArrowUp")
    page.wait_for_function("() => Number(document.querySelector('#elevation').value) !== 45")


def test_a_bsdf_of_a_panel_goes_out_as_files_of_other_programs(page: Any, tmp_path: Path) -> None:
    klems = figure(page, "BSDF in the Klems basis")
    page.locator("#a-basis").select_option("klems_quarter")
    klems.get_by_role("button", name="Compute").click()
    klems.locator('[data-whole="true"] .disc').first.wait_for()
    page.locator("#a-band").select_option("solar")
    for label, ending in (("XML (WINDOW, Radiance)", "xml"), ("EnergyPlus IDF", "idf"), ("Matrix (Radiance)", "mtx")):
        with page.expect_download() as waiting:
            klems.get_by_label("Save", exact=True).select_option(label=label)
        assert waiting.value.suggested_filename == f"panel-a.{ending}"
        if ending == "xml":
            path = tmp_path / "panel.xml"
            waiting.value.save_as(path)
            found = read_bsdf(path).visible.transmission_front
            own = panel_from_dict({"kind": "laser-cut", "spacing_mm": 6, "thickness_mm": 6}).bsdf("klems_quarter")
            assert found.mean() == pytest.approx(own.visible.transmission_front.mean(), abs=1e-5)


def test_every_figure_saves_as_files_that_stand_alone(page: Any) -> None:
    for title in ("BSDF in the Klems basis", "Dispersion"):
        figure(page, title).get_by_role("button", name="Compute").click()
    figure(page, "BSDF in the Klems basis").locator('[data-whole="true"]').wait_for()
    figure(page, "Dispersion").locator("circle").first.wait_for()
    page.wait_for_function(
        "() => document.querySelectorAll('section[aria-label=\"Deflection against elevation\"] .dot').length === 3"
    )
    chromium.picture(page, "studio-panel")
    for title, name in (
        ("Section, to scale", "section-a"),
        ("Deflection against elevation", "deflection"),
        ("Radial diagram", "radial"),
        ("Dispersion", "dispersion-a"),
        ("BSDF in the Klems basis", "klems-a"),
    ):
        for ending in ("PNG", "SVG", "CSV"):
            with page.expect_download() as waiting:
                figure(page, title).get_by_role("button", name=ending).click()
            assert waiting.value.suggested_filename.startswith(name), (title, ending)
            content = Path(waiting.value.path()).read_bytes()
            if ending == "PNG":
                assert content.startswith(b"\x89PNG")
            elif ending == "SVG":
                root = ET.fromstring(content)
                words = [one for one in root.iter("{http://www.w3.org/2000/svg}text") if one.text]
                assert words
                assert all("font-family" in one.attrib and "fill" in one.attrib for one in words)
                assert root[0].get("fill", "").startswith("#")
                assert b"var(" not in content
            else:
                assert len(content.decode().splitlines()) > 2, title


def test_the_page_is_as_it_should_be_on_a_tablet_and_in_the_dark(browser: Any, studio: str) -> None:
    for size, theme, name in ((chromium.TABLETS[0], "light", "tablet"), (chromium.SIZE, "dark", "dark")):
        tab = browser.new_page(viewport=size)
        chromium.watched(tab, studio)
        tab.goto(f'{studio}#theme="{theme}"&panel.a.kind="laser-cut"&panel.a.cut_radius_mm=14')
        tab.locator('[data-panel="a"] .sun').wait_for()
        wide = tab.evaluate("() => [document.documentElement.scrollWidth, innerWidth]")
        assert wide[0] <= wide[1]
        chromium.picture(tab, f"studio-panel-{name}")
        tab.close()
