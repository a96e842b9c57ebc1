"""TOML that comes in: its tables, and what it is for."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from datetime import date, time
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.panels.writing import kinds as panel_kinds
from clerestory.studio.doors.requests import bounded
from clerestory.studio.doors.shapes import MisshapenError

#: ``kind`` of the file that holds the state of a page.
PAGE = "studio-page"
#: What a TOML file may be.
KINDS = ("page", "panel", "room", "year", "sweep", "design")
_ROOM = {"shoebox", "surface", "window", "mesh", "radiance", "interface", "sensors", "obstruction"}
_YEAR = {"weather", "schedule", "blinds", "lighting"}


def kind_of(tables: Mapping[str, Any]) -> str:
    """Which of the project's files the tables are.

    Parameters
    ----------
    tables : mapping
        Of a TOML file.

    Returns
    -------
    {"page", "panel", "room", "year", "sweep", "design"}

    Raises
    ------
    ClerestoryError
        If it is none of them; the message says what was found.
    """
    kind = tables.get("kind")
    if kind == PAGE:
        return "page"
    if "parameters" in tables:
        return "design" if "objective" in tables else "sweep"
    if isinstance(kind, str) and kind in panel_kinds():
        return "panel"
    if _YEAR & set(tables):
        return "year"
    if _ROOM & set(tables):
        return "room"
    found = ", ".join(sorted(map(str, tables))[:8]) or "nothing"
    raise ClerestoryError(
        "text must be the TOML of a page, a panel, a room, a year, a sweep or a design, "
        f"got one that holds {found[:200]}: see docs/how-to/studio.md"
    )


def toml_of(text: str) -> dict[str, Any]:
    """The tables of a TOML file's text, dates as text.

    Raises
    ------
    ClerestoryError
        If it is none, the message says where; or nests or lists more than a request may.
    """
    try:
        tables: dict[str, Any] = _plain(tomllib.loads(text.replace("\r\n", "\n")))
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise MisshapenError("text", f"text must be that of a TOML file: {error}") from None
    bounded(tables)
    return tables


def _plain(value: Any) -> Any:
    """Dates and times as the text that the file has."""
    if isinstance(value, (date, time)):
        return value.isoformat()
    if isinstance(value, dict):
        return {name: _plain(one) for name, one in value.items()}
    return [_plain(one) for one in value] if isinstance(value, list) else value
