"""A studio to ask, without a network and without its page."""

import shutil
import warnings
from collections.abc import Iterator
from pathlib import Path

import pytest

from clerestory.studio.app import make_app
from clerestory.studio.settings import Settings

with warnings.catch_warnings():
    # it tells of a package to come
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

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
