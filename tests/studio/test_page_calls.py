"""The page's state as a file, and files that are opened without saying what they are."""

import tomllib
from pathlib import Path
from typing import Any

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
STATE: dict[str, Any] = {
    "view": "panel",
    "theme": "dark",
    "panel": {
        "a": {"kind": "laser-cut", "spacing_mm": [4, 5.5], "thickness_mm": 6, "medium": "pmma"},
        "compares": False,
        "elevation": 45.5,
    },
    "room": {"tables": {"shoebox": {"opening": [{"part": [{"glazing": "glass", "height_m": 0.6}]}]}}, "hour": 11},
    "bsdf": {"path": "ä \"quoted\" 'name'\n.xml", "key": ""},
}


def test_the_state_of_a_page_goes_out_as_toml_and_comes_back(client: Any) -> None:
    text = client.post("/api/page/toml", json={"state": STATE}).json()["text"]
    tables = tomllib.loads(text)
    assert tables["kind"] == "studio-page"
    assert tables["version"]
    assert client.post("/api/page/read", json={"text": text}).json()["state"] == STATE
    # as an editor of another system saves it
    assert client.post("/api/page/read", json={"text": text.replace("\n", "\r\n")}).json()["state"] == STATE
    opened = client.post("/api/open", json={"text": text}).json()
    assert (opened["kind"], opened["view"], opened["tables"]) == ("page", "panel", STATE)
    # what is null is left to its default
    nulls = {"view": "panel", "panel": {"a": {"kind": "pane", "medium": None}}}
    text = client.post("/api/page/toml", json={"state": nulls}).json()["text"]
    assert client.post("/api/page/read", json={"text": text}).json()["state"]["panel"] == {"a": {"kind": "pane"}}


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("view = ", "text"),
        ('view = "panel"', "text"),
        ('kind = "pane"\nthickness_mm = 4.0', "text"),
        ('kind = "studio-page"', "view"),
        ('kind = "studio-page"\nview = 7', "view"),
        ('kind = "studio-page"\nview = "panel"\ntheme = "pink"', "theme"),
        ('kind = "studio-page"\nview = "panel"\nroom = 1', "room"),
        ('kind = "studio-page"\nview = "panel"\n[cellar]', "cellar"),
    ],
)
def test_what_is_no_state_of_a_page_is_refused_in_words(client: Any, text: str, field: str) -> None:
    answer = client.post("/api/page/read", json={"text": text})
    assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, field), answer.text


@pytest.mark.parametrize(
    ("text", "kind", "view"),
    [
        ('kind = "laser-cut"\nspacing_mm = 4.0\nthickness_mm = 6.0', "panel", "panel"),
        ((EXAMPLES / "classroom/classroom.toml").read_text(encoding="utf-8"), "room", "room"),
        ((EXAMPLES / "classroom/year.toml").read_text(encoding="utf-8"), "year", "room"),
        ('kind = "room"\nbase = "classroom.toml"\n[parameters]\n"shoebox.depth_m" = [4, 5]', "sweep", None),
        ('kind = "panel"\n[parameters]\nx = {low = 1, high = 2}\n[[objective]]\nfigure = "x"', "design", None),
    ],
)
def test_a_toml_is_known_by_what_it_holds(client: Any, text: str, kind: str, view: str | None) -> None:
    opened = client.post("/api/open", json={"text": text}).json()
    assert (opened["kind"], opened["view"]) == (kind, view)
    assert bool(opened["tells"]) == (kind in ("year", "sweep", "design"))


def test_a_toml_of_the_folder_is_opened_and_none_outside(client: Any, folder: Path) -> None:
    (folder / "pane.toml").write_text('kind = "pane"\nthickness_mm = 4.0\nmade = 2024-01-02\n')
    (folder / "bytes.toml").write_bytes(b"\xff\xfe\x00")
    (folder.parent / "outside.toml").write_text('secret = "word"')
    try:
        answer = client.post("/api/open", json={"path": "pane.toml"})
        assert "'made'" in answer.json()["errors"][0]["message"], "a date is told as text, not a fault"
        (folder / "pane.toml").write_text('kind = "pane"\nthickness_mm = 4.0\n')
        opened = client.post("/api/open", json={"path": "pane.toml"}).json()
        assert (opened["kind"], opened["path"]) == ("panel", "pane.toml")
        for path in ("bytes.toml", "../outside.toml", str(folder.parent / "outside.toml"), "none.toml", "."):
            answer = client.post("/api/open", json={"path": path})
            assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, "path"), path
            assert "word" not in answer.text
    finally:
        for name in ("pane.toml", "bytes.toml"):
            (folder / name).unlink()


def test_what_is_nothing_of_the_project_is_refused_in_words(client: Any) -> None:
    for asked in (
        {"text": ""},
        {"text": "a = 1"},
        {"text": "a = nan"},
        {"text": "[[["},
        {"text": 'kind = "curtain"'},
        {"text": 'kind = "pane"\nthickness_mm = -4'},
        {"text": f"x = {'[' * 60}{']' * 60}"},
        {},
        {"text": "a = 1", "path": "a.toml"},
    ):
        answer = client.post("/api/open", json=asked)
        assert answer.status_code == 422, asked
        assert answer.json()["errors"][0]["message"]
