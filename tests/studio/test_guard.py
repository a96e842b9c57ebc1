"""Who may ask the studio, and how much."""

import warnings
from collections.abc import Iterator
from pathlib import Path

import pytest

from clerestory import ClerestoryError
from clerestory.studio.app import make_app
from clerestory.studio.settings import Settings

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient


def test_a_foreign_host_is_refused(client: TestClient) -> None:
    # a name of somebody else's that resolves to this machine: DNS rebinding
    for host in ("evil.example", "evil.example:8765", "127.0.0.1.evil.example", "", "[::1"):
        assert client.post("/api/about", json={}, headers={"host": host}).status_code == 403, host
    for host in ("127.0.0.1:8765", "localhost:8765", "LOCALHOST", "[::1]:8765"):
        assert client.post("/api/about", json={}, headers={"host": host}).status_code == 200, host


def test_a_foreign_origin_is_refused(client: TestClient) -> None:
    for origin in ("http://evil.example", "null", "http://127.0.0.1:9999", "file://"):
        assert client.post("/api/about", json={}, headers={"origin": origin}).status_code == 403, origin
    assert client.post("/api/about", json={}, headers={"origin": "http://127.0.0.1:8765"}).status_code == 200
    assert client.post("/api/about", json={}, headers={"sec-fetch-site": "cross-site"}).status_code == 403


@pytest.fixture
def guarded(tmp_path: Path) -> Iterator[TestClient]:
    settings = Settings(folder=tmp_path, host="0.0.0.0", token="a-long-token-of-ours")
    with TestClient(make_app(settings), base_url="http://192.0.2.7:8765") as one:
        yield one


def test_other_hosts_need_a_token(guarded: TestClient) -> None:
    assert guarded.post("/api/about", json={}).status_code == 401
    assert guarded.get("/").status_code == 401
    for wrong in ("Bearer a-long-token-of-our", "Bearer ", "Basic a-long-token-of-ours", "Bearer a-long-token-of-öurs"):
        assert guarded.post("/api/about", json={}, headers={"authorization": wrong.encode()}).status_code == 401
    right = {"authorization": "Bearer a-long-token-of-ours"}
    assert guarded.post("/api/about", json={}, headers=right).status_code == 200


def test_the_address_with_the_token_opens_the_page_and_keeps_it_out_of_the_history(guarded: TestClient) -> None:
    assert guarded.get("/?token=wrong-token-here").status_code == 401
    answer = guarded.get("/?token=a-long-token-of-ours&x=1", follow_redirects=False)
    assert (answer.status_code, answer.headers["location"]) == (303, "/?x=1")
    cookie = answer.headers["set-cookie"].lower()
    assert "httponly" in cookie
    assert "samesite=strict" in cookie
    assert guarded.post("/api/about", json={}).status_code == 200


def test_a_token_is_made_for_other_hosts_alone(tmp_path: Path) -> None:
    assert Settings(folder=tmp_path).token is None
    assert Settings(folder=tmp_path, host="::1").token is None
    made = Settings(folder=tmp_path, host="0.0.0.0")
    assert len(made.token or "") >= 24
    assert made.token in made.url()
    for wrong in ({"port": 70000}, {"token": "short"}, {"folder": tmp_path / "none"}):
        with pytest.raises(ClerestoryError, match=next(iter(wrong))):
            Settings(**({"folder": tmp_path} | wrong))


def test_what_is_too_large_is_refused_before_it_is_kept(client: TestClient) -> None:
    most = client.app.state.settings.most_request_bytes
    assert client.post("/api/panel/read", content=b"x" * (most + 1)).status_code == 413

    def without_length() -> Iterator[bytes]:
        for _ in range(most // 65536 + 2):
            yield b"x" * 65536

    assert client.post("/api/panel/read", content=without_length()).status_code == 413


def test_answers_load_nothing_from_elsewhere(client: TestClient) -> None:
    headers = client.post("/api/about", json={}).headers
    assert "default-src 'self'" in headers["content-security-policy"]
    assert "frame-ancestors 'none'" in headers["content-security-policy"]
    assert headers["x-content-type-options"] == "nosniff"


def test_no_file_outside_the_folder_is_opened(client: TestClient, folder: Path) -> None:
    (folder / "link.xml").unlink(missing_ok=True)
    (folder / "link.xml").symlink_to(folder.parent / "secret.xml")
    paths = ["../secret.xml", str(folder.parent / "secret.xml"), "link.xml", "x/../../secret.xml", "..\\secret.xml"]
    paths += ["C:secret.xml", "nothing.xml", "", "a\0b", "~/secret.xml", "/etc/passwd", ".", 7, None, "x" * 5000]
    for path in paths:
        answer = client.post("/api/bsdf/open", json={"path": path})
        assert answer.status_code == 422, path
        assert answer.json()["errors"][0]["field"] == "path", path
        assert "secret/" not in answer.text
    listed = client.post("/api/about", json={}).json()["files"]
    (folder / "link.xml").unlink()
    # other tests put files into the folder too, but none of them leads out of it
    assert {"path": "blinds.xml", "kind": "bsdf"} in listed
    assert not any("link" in one["path"] or "secret" in one["path"] for one in listed)


def test_what_is_no_request_is_refused_in_words(client: TestClient) -> None:
    deep = "[" * 100_000
    for content in (
        b"",
        b"{",
        b"[]",
        b"7",
        deep.encode(),
        b'{"panel": NaN}',
        b"\xff\xfe",
        b'{"a":' * 20 + b"1" + b"}" * 20,
    ):
        answer = client.post("/api/panel/lobes", content=content)
        assert answer.status_code == 422, content[:20]
        assert answer.json()["errors"][0]["message"]
    assert client.get("/api/none").status_code == 404
    assert client.get("/api/panel/lobes").status_code == 405
    assert client.post("/api/panel/lobes", json={"panel": {}, "elevatoin_deg": 3}).status_code == 422
