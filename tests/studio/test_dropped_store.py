"""A zarr store that is dropped as a ZIP archive: read without being unpacked, whatever else the archive holds."""

import io
import json
import zipfile
from pathlib import Path
from typing import Any

import pytest
import xarray as xr

from clerestory.studio.results import child as result_child

#: Of texts in stores of version 3, which what a sweep writes has too.
pytestmark = pytest.mark.filterwarnings("ignore:The data type")


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What a sweep leaves, as small as can be."""
    place = tmp_path_factory.mktemp("store") / "results.zarr"
    cases = xr.Dataset(
        {"mean_transmittance": ("case", [0.5, 0.7])},
        {"key": ("case", ["a", "b"]), "status": ("case", ["done", "done"]), "panel.spacing_mm": ("case", [3.0, 4.0])},
        {"study": "two"},
    )
    cases.to_zarr(place, zarr_format=3, consolidated=False)
    return place


def archive(*parts: tuple[str, bytes], packed: int = zipfile.ZIP_DEFLATED) -> bytes:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", packed) as one:
        for name, content in parts:
            one.writestr(name, content)
    return made.getvalue()


def files(store: Path, before: str = "") -> list[tuple[str, bytes]]:
    return [(before + one.relative_to(store).as_posix(), one.read_bytes()) for one in store.rglob("*") if one.is_file()]


def dropped(client: Any, content: bytes, name: str = "results.zarr.zip") -> Any:
    return client.post(f"/api/result?name={name}", content=content)


@pytest.mark.parametrize("before", ["", "results.zarr/", "out/sweep/results.zarr/"])
def test_a_store_in_an_archive_opens_as_its_folder_does(client: Any, store: Path, before: str) -> None:
    answer = dropped(client, archive(*files(store, before)))
    assert answer.status_code == 200, answer.text
    assert (answer.json()["kind"], answer.json()["title"], answer.json()["rows"]) == ("sweep", "two", 2)
    cases = client.post("/api/result/cases", json={"key": answer.json()["key"]}).json()
    columns = {one["name"]: one["values"] for one in cases["columns"]}
    assert columns["mean_transmittance"] == [0.5, 0.7]


@pytest.mark.parametrize("name", ["../climbed.txt", "../../../climbed.txt", "x/../../climbed.txt", "/tmp/climbed.txt"])
def test_names_that_lead_elsewhere_are_refused_and_write_nothing(
    client: Any, store: Path, folder: Path, name: str
) -> None:
    answer = dropped(client, archive(*files(store), (name, b"x")))
    assert answer.status_code == 422, answer.text
    assert "must lie within it" in answer.json()["errors"][0]["message"]
    places = [Path("/tmp"), folder, *folder.parents, Path.cwd(), *Path.cwd().parents]
    assert not [one for one in places if (one / "climbed.txt").exists()]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"PK\x03\x04 and no more", "no ZIP archive"),
        (archive(("readme.txt", b"nothing")), "it holds 0"),
        (archive(("a.zarr/zarr.json", b"{}"), ("b.zarr/zarr.json", b"{}")), "it holds 2"),
        (archive(("zarr.json", b"{")), "zip"),
        # version 2, whose codecs unpickle
        (archive((".zgroup", b'{"zarr_format": 2}'), ("x/.zarray", b"{}")), "it holds 0"),
        (archive(("zarr.json", b'{"zarr_format": 2, "node_type": "group"}')), "zip"),
    ],
)
def test_what_is_no_store_is_refused_in_words(client: Any, content: bytes, words: str) -> None:
    answer = dropped(client, content)
    assert answer.status_code == 422, answer.text
    message = answer.json()["errors"][0]["message"]
    assert message.startswith("results.zarr.zip")
    assert words in message


def test_an_archive_that_unpacks_to_too_much_is_refused(store: Path, tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.setattr(result_child, "MOST_BYTES", 2**20)
    monkeypatch.setattr(result_child, "MOST_ENTRIES", 20)
    file = tmp_path / "bomb.zip"
    file.write_bytes(archive(*files(store), ("zeros", bytes(2**20))))
    assert file.stat().st_size < 10_000
    with pytest.raises(result_child.RefusedError, match="unpacks to 1 MiB"):
        result_child._read(file, False)
    file.write_bytes(archive(*files(store), *((f"c/{number}", b"") for number in range(20))))
    with pytest.raises(result_child.RefusedError, match="20 are most"):
        result_child._read(file, False)


def test_an_array_that_says_it_is_vast_is_refused(client: Any, store: Path) -> None:
    told = json.loads((store / "mean_transmittance" / "zarr.json").read_bytes())
    told["shape"] = [10**9]
    vast = json.dumps(told).encode()
    parts = [(name, vast if name == "mean_transmittance/zarr.json" else content) for name, content in files(store)]
    answer = dropped(client, archive(*parts))
    assert answer.status_code == 422, answer.text
