"""A studio to ask, without a network and without its page."""

import shutil
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.studio import chromium

from clerestory.studio.app import make_app
from clerestory.studio.settings import Settings

with warnings.catch_warnings():
    # it tells of a package to come
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

# its assertions tell what they met, as those of a test do
pytest.register_assert_rewrite("tests.studio.access")

BLINDS = Path(__file__).parents[1] / "data" / "bsdf" / "blinds_tensortree3.xml"


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a BSDF in it and a secret beside it."""
    place = tmp_path_factory.mktemp("studio")
    (place / "secret.xml").write_text("<secret/>")
    own = place / "own"
    own.mkdir()
    shutil.copy(BLINDS, own / "blinds.xml")
    return own


@pytest.fixture(scope="session")
def client(folder: Path) -> Iterator[TestClient]:
    """The page's side of a studio."""
    with TestClient(make_app(Settings(folder=folder, workers=1)), base_url="http://127.0.0.1:8765") as one:
        yield one


@pytest.fixture(scope="session")
def result_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a result of each kind (tests/studio/results.py)."""
    pytest.importorskip("optuna")
    from tests.studio.results import write_results

    place = tmp_path_factory.mktemp("results").resolve()
    write_results(place)
    return place


@pytest.fixture(scope="session")
def studio(folder: Path) -> Iterator[str]:
    """The address of a studio in a process of its own."""
    with chromium.studio_of(folder) as url:
        yield url


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    """Debian's Chromium. Of a module alone: while it is there, no test can run an event loop of its own."""
    sync_api = pytest.importorskip("playwright.sync_api")
    with sync_api.sync_playwright() as playwright:
        one = playwright.chromium.launch(
            executable_path=chromium.PATH, args=chromium.FLAGS, timeout=1000.0 * chromium.PATIENCE_S
        )
        yield one
        one.close()


@pytest.fixture
def page(browser: Any, studio: str) -> Iterator[Any]:
    """An empty tab that fails the test on any error in the page, and on any request that leaves the studio."""
    tab = browser.new_page(viewport=chromium.SIZE)
    wrong = chromium.watched(tab, studio)
    tab.goto(studio)
    yield tab
    tab.close()
    assert not wrong


@pytest.fixture(scope="session")
def room_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with rooms, a year and its weather."""
    own = tmp_path_factory.mktemp("rooms") / "own"
    shutil.copytree(Path(__file__).parents[2] / "examples" / "classroom", own)
    (own / "sub").mkdir()
    (own / "sub" / "named.toml").write_text('room = "../classroom.toml"\n[weather]\nfile = "none.epw"\n')
    return own


@pytest.fixture(scope="session")
def rooms(room_folder: Path) -> Iterator[TestClient]:
    """A studio in that folder."""
    with TestClient(make_app(Settings(folder=room_folder, workers=1)), base_url="http://127.0.0.1:8765") as one:
        yield one
