"""The report in a real browser: it needs nothing from elsewhere, shows its pictures, and says what the NetCDF says."""

import math
import shutil

import pytest
import xarray as xr
from tests.year.small import write_small

from clerestory.year import read_year, run_year, write_year

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)

#: After which what is waited for will not come, on however busy a machine [ms].
PATIENCE_MS = 240_000.0

pytestmark = pytest.mark.skipif(BROWSER is None, reason="no Chromium on this machine (Debian: apt install chromium)")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("report")
    study = read_year(write_small(place))
    write_year(study, run_year(study), place / "out")
    return place / "out"


@pytest.fixture(scope="module")
def browser():
    with sync_api.sync_playwright() as playwright:
        # without a sandbox it runs as root too, as in a container
        running = playwright.chromium.launch(executable_path=BROWSER, args=["--no-sandbox"], timeout=PATIENCE_MS)
        yield running
        running.close()


def opened(browser, folder, **how):
    """The report in a tab, with what it asked for and what it complained of."""
    page = browser.new_page(**how)
    page.set_default_timeout(PATIENCE_MS)
    page.asked, page.said = [], []
    page.on("request", lambda request: page.asked.append(request.url))
    page.on("console", lambda message: page.said.append(message.text))
    page.on("pageerror", lambda error: page.said.append(str(error)))
    page.goto((folder / "report.html").as_uri(), wait_until="load")
    return page


@pytest.fixture
def page(browser, folder):
    page = opened(browser, folder)
    yield page
    page.close()


def test_nothing_is_asked_of_the_network(page, folder):
    outside = [url for url in page.asked if not url.startswith(("data:", (folder / "report.html").as_uri()))]
    assert page.asked
    assert not outside
    assert not page.said


def test_every_picture_decodes_and_has_words(page):
    pictures = page.locator("img")
    assert pictures.count() >= 8
    broken = page.evaluate(
        "async () => (await Promise.all([...document.images].map("
        "i => i.decode().then(() => i.naturalWidth > 50, () => false)))).filter(ok => !ok).length"
    )
    assert broken == 0
    words = page.evaluate("[...document.images].map(i => i.alt.length)")
    assert min(words) > 40
    assert page.locator("figure").count() == page.locator("figcaption").count() == pictures.count()


def test_the_table_says_what_the_netcdf_says(page, folder):
    cells = page.evaluate("[...document.querySelectorAll('#figures td')].map(c => ({...c.dataset, text: c.innerText}))")
    with xr.open_dataset(folder / "year.nc") as kept:
        for cell in cells:
            value = float(kept[cell["metric"]].sel(variant=cell["variant"]))
            assert float(cell["value"]) == pytest.approx(value, rel=1e-12)
            shown = cell["text"].removeprefix("≥ ").split(" ± ")[0]
            if cell["metric"] == "en17037_level":
                assert shown == ("none", "minimum", "medium", "high")[int(value)]
            else:
                digits = len(shown.partition(".")[2])
                assert math.isclose(float(shown), value, abs_tol=0.5001 * 10.0**-digits)
    assert len(cells) == 3 * len({cell["metric"] for cell in cells}) >= 3 * 18


def test_headings_captions_and_language(page):
    assert page.locator("html").get_attribute("lang") == "en"
    assert page.locator("h1").count() == 1
    assert page.locator("table caption").count() == page.locator("table").count()
    assert page.locator("th[scope]").count() == page.locator("th").count()
    links = page.evaluate("[...document.querySelectorAll('nav a')].filter(a => !document.querySelector(a.hash)).length")
    assert links == 0


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_ink_stands_out_from_the_page(browser, folder, scheme):
    page = opened(browser, folder, color_scheme=scheme)
    colours = page.evaluate("(s => [s.color, s.backgroundColor])(getComputedStyle(document.body))")
    page.close()

    def luminance(colour):
        parts = [int(part) / 255 for part in colour.removeprefix("rgb(").removesuffix(")").split(",")]
        linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    bright, dark = sorted(map(luminance, colours), reverse=True)
    # WCAG 2.2, 1.4.6
    assert (bright + 0.05) / (dark + 0.05) >= 7.0
    assert (luminance(colours[1]) < 0.1) == (scheme == "dark")


def test_a_narrow_screen_needs_no_sideways_scrolling(browser, folder):
    page = opened(browser, folder, viewport={"width": 390, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.close()


def test_it_prints(page, folder):
    page.emulate_media(media="print", color_scheme="dark")
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    assert not page.locator("nav").is_visible()
    printed = page.pdf(format="A4", path=folder / "report.pdf")
    assert printed.startswith(b"%PDF")
    assert 3 <= printed.count(b"/Type /Page\n") + printed.count(b"/Type /Page ") + printed.count(b"/Type/Page/") <= 30
