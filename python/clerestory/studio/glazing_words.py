"""A glazing as its result names it, in words."""

from __future__ import annotations

import re

#: Endings of sizes and their units.
_UNITS = {"_mm": " mm", "_deg": "°", "_nm": " nm"}
#: Parts of a description that say nothing to a reader.
_SILENT = ("None", "0", "0.0", "False", "()", "[]")
_CALL = re.compile(r"(?P<kind>[A-Z]\w*)\((?P<parts>.*)\)")


def glazing_words(told: str) -> str:
    """``window 1: LaserCutPanel(spacing_mm=4.0, …)`` as "window 1: laser-cut panel, spacing 4 mm, …".

    Parameters
    ----------
    told : str
        Window and glazing as `clerestory.year` writes them.

    Returns
    -------
    str
        The same text if it has another shape.
    """
    window, between, glazing = told.partition(": ")
    return f"{window}{between}{_described(glazing)}" if between else told


def _described(glazing: str) -> str:
    found = _CALL.fullmatch(glazing.strip())
    if found is None:
        return glazing
    kind = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", found["kind"]).lower().replace("laser cut", "laser-cut")
    words = [kind]
    for name, value in _parts(found["parts"]):
        if value in _SILENT:
            continue
        if name == "layers" and value.startswith("("):
            layers = [_described(one) for _, one in _parts(value[1:-1].rstrip(",")) if one]
            return f"{kind} of {len(layers)}: {' + '.join(layers)}"
        unit = next((unit for ending, unit in _UNITS.items() if name.endswith(ending)), "")
        bare = name.removesuffix(next((ending for ending in _UNITS if name.endswith(ending)), ""))
        medium = re.fullmatch(r"Medium\.named\('(.*)'\)", value)
        plain = medium[1] if medium else re.sub(r"\.0$", "", value.strip("'"))
        words.append(f"{bare.replace('_', ' ')} {plain}{unit}".strip())
    return ", ".join(words)


def _parts(text: str) -> list[tuple[str, str]]:
    """Names and values of a call, commas within brackets left alone."""
    found, depth, start = [], 0, 0
    for place, letter in enumerate(f"{text},"):
        if letter in "([{":
            depth += 1
        elif letter in ")]}":
            depth -= 1
        elif letter == "," and depth == 0:
            part = text[start:place].strip()
            named = re.match(r"([a-z_]\w*)=", part)
            found.append((named[1], part[named.end() :]) if named else ("", part))
            start = place + 1
    return found
