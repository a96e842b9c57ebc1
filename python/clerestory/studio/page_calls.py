"""The page's state as a file, and files that are opened without saying what they are."""

from __future__ import annotations

from typing import Any

import tomli_w
from starlette.requests import Request

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.panels import panel_from_dict
from clerestory.studio.doors.fields import Field
from clerestory.studio.doors.folder import inside
from clerestory.studio.doors.requests import Asked, call
from clerestory.studio.doors.shapes import TABLE, TEXT, MisshapenError, Shape, fit, maybe, record, word
from clerestory.studio.toml_kinds import KINDS, PAGE, kind_of, toml_of

#: The state of a page: the view that is open, and a table for each view. What is in a table is the page's own, which
#: takes of it what it knows; the panels, rooms and incidences in it are checked when they are asked about.
STATE: Shape = record(
    {"view": TEXT},
    also={"theme": word("auto", "light", "dark"), "panel": TABLE, "room": TABLE, "year": TABLE, "bsdf": TABLE},
)
#: The view that opens a file; the year's runs what lies in the folder, and of any other the room is shown.
_VIEWS = {"panel": "panel", "room": "room", "year": "room"}
_TELLS = {
    "year": "The study of a year: its room is shown. To run it, put its file into the studio's folder and choose it "
    "under Year.",
    "sweep": "A study of many cases: run it with `clerestory sweep FILE`, then open its results under Year.",
    "design": "A search for a design: run it with `clerestory design FILE`, then open its results under Year.",
}


def to_toml(_: Request, asked: Asked) -> dict[str, Any]:
    """The state of the page as the text of a file, which `page/read` and `open` read."""
    tables = {"kind": PAGE, "version": _native.__version__, **_told(asked["state"])}
    return {"text": tomli_w.dumps(tables)}


def from_toml(_: Request, asked: Asked) -> dict[str, Any]:
    """The state of the page from the text of its file."""
    return {"state": state_of(toml_of(asked["text"]))}


def opened(request: Request, asked: Asked) -> dict[str, Any]:
    """What a TOML file is, by its `text` or its `path` in the studio's folder, and which view opens it."""
    path = asked.get("path")
    if ("text" in asked) == (path is not None):
        raise MisshapenError("text", "text or path must be given, one of them")
    text = asked["text"] if path is None else _text(request, path)
    tables = toml_of(text)
    kind = kind_of(tables)
    if kind == "page":
        tables = state_of(tables)
    elif kind == "panel":
        tables = panel_from_dict(tables).to_dict()
    is_study = kind == "year" and path is not None
    return {
        "kind": kind,
        "view": tables["view"] if kind == "page" else "year" if is_study else _VIEWS.get(kind),
        "tables": tables,
        "path": path,
        "tells": None if is_study else _TELLS.get(kind),
    }


def state_of(tables: dict[str, Any]) -> dict[str, Any]:
    """The state that a page's file holds.

    Raises
    ------
    ClerestoryError
        If it is no such file, or has not its shape.
    """
    if tables.get("kind") != PAGE:
        raise MisshapenError("text", f'text must be the TOML of a page, with kind = "{PAGE}"; open others with Open')
    state = {name: value for name, value in tables.items() if name not in ("kind", "version")}
    fit("state", state, STATE)
    return state


def _text(request: Request, path: str) -> str:
    folder, limit = request.app.state.settings.folder, request.app.state.settings.most_request_bytes
    found = inside(folder, path)
    if not found.is_file() or found.stat().st_size > limit:
        raise ClerestoryError(f"path must be a file of at most {limit} bytes, got {path!r}")
    try:
        return found.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        raise ClerestoryError(f"path must be a TOML file in UTF-8, got {path!r}") from None


def _told(value: Any) -> Any:
    """What TOML can say: what is null is left out."""
    if isinstance(value, dict):
        return {name: _told(one) for name, one in value.items() if one is not None}
    if isinstance(value, list):
        return [_told(one) for one in value if one is not None]
    return value


_FILE = 'kind = "studio-page"\nversion = "0.1.0"\nview = "panel"\n'
ROUTES = [
    call(
        "/api/page/toml",
        to_toml,
        {
            "state": Field(
                STATE, "State of the page, as its address holds it", example={"view": "panel", "theme": "auto"}
            )
        },
        gives=record({"text": TEXT}),
    ),
    call(
        "/api/page/read",
        from_toml,
        {"text": Field(TEXT, "Text of a page's TOML file", example=_FILE)},
        gives=record({"state": STATE}),
    ),
    call(
        "/api/open",
        opened,
        {
            "text": Field(TEXT, "Text of a TOML file", None, example=_FILE),
            "path": Field(TEXT, "Path of a TOML file in the studio's folder, with / between names", None),
        },
        gives=record(
            {
                "kind": word(*KINDS),
                "view": maybe(TEXT),
                "tables": TABLE,
                "path": maybe(TEXT),
                "tells": maybe(TEXT),
            }
        ),
    ),
]
