"""The state of the page from whatever an address or a file holds: the page's own reader, in Node."""

import json
import random
import shutil
import subprocess
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest

STUDIO = Path(__file__).parents[2] / "studio"
NODE = shutil.which("node")

pytestmark = [
    pytest.mark.skipif(NODE is None, reason="no Node.js on this machine"),
    pytest.mark.skipif(
        not (STUDIO / "node_modules" / "esbuild").is_dir(), reason="the page's packages are not installed"
    ),
]
SHAPE: dict[str, Any] = {
    "start": {
        "view": "panel",
        "theme": "auto",
        "panel": {"a": {"kind": "laser-cut", "spacing_mm": 6, "medium": "pmma"}, "compares": False, "elevation": 45},
        "room": {"file": "start", "tables": {}, "eye": [], "hidden": [], "hour": 11},
    },
    "whole": ["room.tables"],
    "free": ["panel.a"],
}
START = SHAPE["start"]


def read(hashes: list[str], trees: list[Any]) -> dict[str, Any]:
    asked = json.dumps({"shape": SHAPE, "hashes": hashes, "trees": trees})
    runner = Path(__file__).with_name("state_text.mjs")
    done = subprocess.run(
        [str(NODE), str(runner), str(STUDIO)], input=asked, capture_output=True, text=True, check=True, encoding="utf-8"
    )
    told: dict[str, Any] = json.loads(done.stdout)
    return told


def put(**values: Any) -> dict[str, Any]:
    state = json.loads(json.dumps(START))
    for path, value in values.items():
        *places, name = path.split("__")
        holder = state
        for place in places:
            holder = holder[place]
        holder[name] = value
    return dict(state)


def said(**pairs: Any) -> str:
    return "#" + "&".join(f"{name.replace('__', '.')}={quote(json.dumps(value))}" for name, value in pairs.items())


def test_an_address_holds_what_differs_and_is_read_again() -> None:
    pane = {"kind": "pane", "thickness_mm": 4, "medium": {"n": 1.5, "absorption_per_mm": 0}}
    states = [
        put(),
        put(view="room", theme="dark", panel__elevation=-12.5, panel__compares=True),
        put(panel__a=pane),
        put(panel__a={"kind": "laser-cut", "spacing_mm": [4, 5.5], "medium": "pmma"}),
        put(room__tables={"shoebox": {"opening": [{"part": [{"glazing": "a&b=c #ä%,"}]}]}}, room__eye=[1, 2.5]),
        put(room__file="häuser/a & b=1.toml", room__hidden=["x", "ü"]),
    ]
    told = read([], states)["trees"]
    for state, one in zip(states, told, strict=True):
        assert one["state"] == state
        assert one["again"] == state, one["hash"]
    assert told[0]["hash"] == "#panel.a.kind=%22laser-cut%22"
    assert "thickness_mm" not in told[0]["hash"]


def test_a_panel_that_is_told_is_told_wholly() -> None:
    told = read([said(panel__a__kind="pane"), said(panel__a__spacing_mm=7)], [])["hashes"]
    assert told[0]["state"]["panel"]["a"] == {"kind": "pane"}
    assert told[1]["state"]["panel"]["a"] == START["panel"]["a"] | {"spacing_mm": 7}


@pytest.mark.parametrize(
    "wrong",
    [
        said(view=7, theme=None, panel=1, room=[1]),
        said(panel__elevation="high", panel__compares=1, room__hour=None),
        said(panel__a="pane", room__tables=[1], room__eye={"x": 1}, room__hidden=[1, "x"]),
        said(panel__a__kind=7),
        said(room__eye=["a"] * 2000),
        said(view="x" * 5000),
        "#room.hour=1e999&panel.elevation=-1e999",
        "#%=%&&==&=1&view&view=&view=%22&a.b.c=1&.=1&..=2&panel..=1",
        "#__proto__.spoilt=1&constructor.prototype.spoilt=1&panel.__proto__.spoilt=1&room.tables.__proto__.spoilt=1",
        "#" + "a." * 3000 + "b=1",
    ],
)
def test_what_cannot_be_is_as_at_the_start(wrong: str) -> None:
    told = read([wrong], [])
    assert told["hashes"][0]["state"] == START
    assert told["spoilt"] is None


def test_chance_makes_no_state_that_is_not_read_again() -> None:
    chance = random.Random(11)
    values: list[Any] = [None, True, 0, -1.5, 1e308, "", "pane", "ä\n\0", [], [1], ["a"], [[1]], {}, {"kind": "pane"}]
    names = ["view", "theme", "panel", "a", "kind", "room", "tables", "eye", "hour", "__proto__", "x"]

    def tree(depth: int) -> Any:
        if depth == 0 or chance.random() < 0.4:
            return chance.choice(values)
        return {chance.choice(names): tree(depth - 1) for _ in range(chance.randrange(4))}

    def text() -> str:
        pieces = [
            "view",
            "panel",
            "a",
            "kind",
            ".",
            "=",
            "&",
            "%22",
            "%",
            "#",
            "{",
            "}",
            "[",
            "1",
            '"',
            "room",
            "\ud83d\ude00",
        ]
        return "#" + "".join(chance.choice(pieces) for _ in range(chance.randrange(30)))

    told = read([text() for _ in range(500)], [tree(4) for _ in range(500)])
    for one in [*told["hashes"], *told["trees"]]:
        assert one["again"] == one["state"], one["hash"]
        assert set(one["state"]) == set(START)
        assert isinstance(one["state"]["panel"]["elevation"], (int, float))
    assert told["spoilt"] is None
