"""Panels as plain values and as TOML files, and back."""

from __future__ import annotations

import json
import os
import tomllib
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clerestory.errors import ClerestoryError
from clerestory.medium import Medium
from clerestory.rules import one_of
from clerestory.saving import write_text

if TYPE_CHECKING:
    from clerestory.panels.panel import Panel


def kinds() -> dict[str, type[Panel]]:
    """The kinds of panels by the word for each."""
    from clerestory.panels.extruded import ExtrudedPanel
    from clerestory.panels.laser_cut import LaserCutPanel
    from clerestory.panels.pane import Pane
    from clerestory.panels.prismatic import PrismaticPanel

    return {kind.kind: kind for kind in (LaserCutPanel, PrismaticPanel, Pane, ExtrudedPanel)}


def panel_to_dict(panel: Panel) -> dict[str, Any]:
    """The panel as plain values: its kind, then its arguments; None is left out."""
    written = {name: _plain(value) for name, value in panel.arguments.items() if value is not None}
    return {"kind": panel.kind} | written


@lru_cache(maxsize=256)
def described(panel: Panel) -> str:
    """The panel as JSON."""
    return json.dumps(panel_to_dict(panel))


def panel_from_dict(values: Mapping[str, Any]) -> Panel:
    """The panel of :meth:`Panel.to_dict`'s values.

    Parameters
    ----------
    values : mapping
        ``kind`` is "laser-cut", "prismatic", "pane" or "extruded"; the rest are the arguments of that
        kind. A medium is a name or a table (``Medium.from_dict``).

    Raises
    ------
    ClerestoryError
        If the kind is missing or unknown, a key is unknown (the message names the nearest), or a value breaks a rule.
    """
    known = kinds()
    if "kind" not in values:
        raise ClerestoryError(f"kind must be given, one of {', '.join(known)}, got {sorted(values)}; add it")
    kind = known[one_of("kind", values["kind"], known)]
    names = [name for name in kind.__dataclass_fields__ if kind.__dataclass_fields__[name].init]
    arguments = {}
    for name, value in values.items():
        if name != "kind":
            one_of(f"a key of the {kind.kind} panel", name, names)
            arguments[name] = _read(name, value)
    try:
        return kind(**arguments)
    except TypeError:
        missing = [name for name in names if name not in arguments and _is_needed(kind, name)]
        raise ClerestoryError(f"a {kind.kind} panel must have {' and '.join(missing)}, got none; add it") from None


def write_panel(panel: Panel, path: str | os.PathLike[str]) -> Path:
    """What :meth:`Panel.to_toml` does."""
    import tomli_w

    return write_text(path, tomli_w.dumps(panel_to_dict(panel)))


def read_panel(path: str | os.PathLike[str]) -> Panel:
    """The panel of a TOML file, of whichever kind.

    Parameters
    ----------
    path : path
        As :meth:`Panel.to_toml` writes it: ``kind``, and the arguments of the panel by name.

    Returns
    -------
    LaserCutPanel, PrismaticPanel, Pane or ExtrudedPanel

    Raises
    ------
    ClerestoryError
        If the file cannot be read, is not TOML, names an unknown key or breaks a rule; the message begins
        with the path.
    """
    where = Path(path)
    try:
        values = tomllib.loads(where.read_text(encoding="utf-8"))
    except OSError as error:
        raise ClerestoryError(f"{where} must be a readable file, got: {error.strerror}; check the path") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        reason = " ".join(str(error).split())
        raise ClerestoryError(f"{where} must be a TOML file, got: {reason}; correct it") from None
    try:
        return panel_from_dict(values)
    except ClerestoryError as error:
        raise ClerestoryError(f"{where}: {error}") from None


def _plain(value: Any) -> Any:
    if isinstance(value, Medium):
        written = value.to_dict()
        return written["name"] if set(written) == {"name"} else written
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    return value.to_dict() if hasattr(value, "to_dict") else value


def _read(name: str, value: Any) -> Any:
    if name == "medium":
        return _read_medium(value)
    if name == "media":
        return tuple(_read_medium(item) for item in value) if isinstance(value, list) else value
    return value


def _read_medium(value: Any) -> Any:
    return Medium.from_dict(value) if isinstance(value, Mapping) else value


def _is_needed(kind: type[Panel], name: str) -> bool:
    from dataclasses import MISSING

    declared = kind.__dataclass_fields__[name]
    return declared.default is MISSING and declared.default_factory is MISSING
