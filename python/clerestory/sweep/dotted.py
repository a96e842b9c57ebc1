"""Dotted paths into the tables of a TOML file: ``glazings.panel.spacing_mm``, ``shoebox.opening[1].sill_m``."""

from __future__ import annotations

import re
from difflib import get_close_matches
from typing import Any

from clerestory.errors import ClerestoryError

_STEP = re.compile(r'(?:"(?P<quoted>[^"]+)"|(?P<plain>[^.\[\]"]+))(?P<places>(?:\[\d+\])*)(?:\.|$)')

Steps = tuple[str | int, ...]


def steps_of(path: str) -> Steps:
    """The names and places of a path.

    Parameters
    ----------
    path : str
        Names between dots, one that holds a dot in double quotes; ``[k]`` after a name is the ``k``-th table of an
        array of tables, counted from 1 as in messages.

    Raises
    ------
    ClerestoryError
        If the path is of another form.
    """
    steps: list[str | int] = []
    position = 0
    while position < len(path):
        match = _STEP.match(path, position)
        if match is None:
            break
        steps.append(match["quoted"] or match["plain"])
        steps += [int(place) for place in re.findall(r"\d+", match["places"])]
        position = match.end()
    if not steps or position < len(path) or path.endswith(".") or 0 in steps:
        raise ClerestoryError(
            f"a parameter's path must be names between dots, places counted from 1 in brackets, got {path!r}; "
            "as in glazings.panel.spacing_mm or shoebox.opening[1].sill_m"
        )
    return tuple(steps)


def put(tables: dict[str, Any], path: str, value: Any) -> None:
    """Sets the value at a path.

    Raises
    ------
    ClerestoryError
        If a table on the way is not there. The last name may be new: a parameter left at its default can be varied.
    """
    *way, last = steps_of(path)
    here: Any = tables
    for step in way:
        here = _step_into(here, step, path)
    if isinstance(last, int):
        _step_into(here, last, path)
        here[last - 1] = value
    elif isinstance(here, dict):
        here[last] = value
    else:
        raise ClerestoryError(f"{path!r} must lead into a table, got {here!r} before {last!r}")


def _step_into(here: Any, step: str | int, path: str) -> Any:
    if isinstance(step, int):
        if isinstance(here, list) and step <= len(here):
            return here[step - 1]
        count = len(here) if isinstance(here, list) else "no array"
        raise ClerestoryError(f"{path!r} must lead to a table that is there, got [{step}] of {count}")
    if isinstance(here, dict) and step in here:
        return here[step]
    known = list(here) if isinstance(here, dict) else []
    close = get_close_matches(step, known, n=1)
    hint = f"; did you mean {close[0]!r}?" if close else f"; there is {', '.join(known) or 'nothing'}"
    raise ClerestoryError(f"{path!r} must lead to a table that is there, got {step!r}{hint}")
