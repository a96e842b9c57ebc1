"""Shapes of what is asked and answered: fragments of JSON Schema, and whether a value has one."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.rules import one_of

#: A fragment of JSON Schema (2020-12). Only the words that `fit` reads may stand in what is asked for.
Shape = dict[str, Any]

NUMBER: Shape = {"type": "number"}
INTEGER: Shape = {"type": "integer"}
TEXT: Shape = {"type": "string"}
FLAG: Shape = {"type": "boolean"}
#: A table of any names, which a dataclass of the API checks.
TABLE: Shape = {"type": "object"}
ANYTHING: Shape = {}

_WORDS = {
    "number": "a number",
    "integer": "a whole number",
    "string": "text",
    "boolean": "true or false",
    "object": "a table",
    "array": "a list",
    "null": "null",
}
#: Characters of a wrong value that its message repeats.
_SHOWN = 80


def word(*words: str) -> Shape:
    """One of a few words."""
    return {"type": "string", "enum": list(words)}


def maybe(shape: Shape) -> Shape:
    """The shape, or null."""
    return {"anyOf": [shape, {"type": "null"}]}


def listed(shape: Shape, *, least: int | None = None, most: int | None = None) -> Shape:
    """A list of what has the shape, of ``least`` to ``most`` entries."""
    bounds = {name: value for name, value in (("minItems", least), ("maxItems", most)) if value is not None}
    return {"type": "array", "items": shape, **bounds}


def record(shapes: Mapping[str, Shape], *, also: Mapping[str, Shape] | None = None) -> Shape:
    """A table of these names and no others; those of ``also`` may be missing."""
    extra = also or {}
    required = {"required": list(shapes)} if shapes else {}
    return {"type": "object", "properties": {**shapes, **extra}, **required, "additionalProperties": False}


def named(shape: Shape) -> Shape:
    """A table of any names, whose values have the shape."""
    return {"type": "object", "additionalProperties": shape}


class MisshapenError(ClerestoryError):
    """A field that has not the shape that was declared."""

    def __init__(self, field: str, message: str) -> None:
        super().__init__(message)
        self.field = field


def fit(name: str, value: Any, shape: Shape) -> None:
    """Checks a value against a shape.

    Parameters
    ----------
    name : str
        Of the field, which an error begins with.
    value : any
        As JSON has it.
    shape : Shape
        Of ``type``, ``enum``, ``anyOf``, ``items``, ``minItems``, ``maxItems``, ``properties``, ``required`` and
        ``additionalProperties``.

    Raises
    ------
    MisshapenError
        That names the field, or the entry of a table within it.
    """
    if "anyOf" in shape:
        _fit_any(name, value, shape["anyOf"])
        return
    kind = shape.get("type")
    if kind is not None and not _is(kind, value):
        raise MisshapenError(name, f"{name} must be {in_words(shape)}, got {shown(value)}")
    if "enum" in shape:
        try:
            one_of(name, value, shape["enum"])
        except ClerestoryError as error:
            raise MisshapenError(name, str(error)) from None
    if isinstance(value, list):
        _fit_list(name, value, shape)
    elif isinstance(value, dict):
        _fit_table(name, value, shape)


def _fit_any(name: str, value: Any, shapes: list[Shape]) -> None:
    """One that fits is enough; one of the same type says best what is wrong."""
    wrong = None
    for shape in shapes:
        try:
            fit(name, value, shape)
        except MisshapenError as error:
            if wrong is None and _is(shape.get("type", "null"), value):
                wrong = error
        else:
            return
    raise wrong or MisshapenError(name, f"{name} must be {in_words({'anyOf': shapes})}, got {shown(value)}")


def _fit_list(name: str, value: list[Any], shape: Shape) -> None:
    least, most = shape.get("minItems", 0), shape.get("maxItems")
    if len(value) < least or (most is not None and len(value) > most):
        how_many = f"{least} or more" if most is None else f"{least}" if least == most else f"{least} to {most}"
        raise MisshapenError(name, f"{name} must have {how_many} entries, got {len(value)}")
    for place, one in enumerate(value):
        try:
            fit(f"{name}[{place}]", one, shape.get("items", ANYTHING))
        except MisshapenError as error:
            field = name if error.field == f"{name}[{place}]" else error.field
            raise MisshapenError(field, str(error)) from None


def _fit_table(name: str, value: dict[str, Any], shape: Shape) -> None:
    shapes, others = shape.get("properties", {}), shape.get("additionalProperties", ANYTHING)
    for key in shape.get("required", ()):
        if key not in value:
            raise MisshapenError(key, f"{key} must be given, got {shown(sorted(value))}; add it")
    for key, one in value.items():
        if key in shapes:
            fit(key, one, shapes[key])
        elif others is False:
            try:
                one_of(f"a field of {name}" if name else "a field", key, shapes)
            except ClerestoryError as error:
                raise MisshapenError(key, str(error)) from None
        else:
            fit(key, one, others)


def _is(kind: str, value: Any) -> bool:
    """Whether a value is of a type of JSON, where 1.0 is a whole number and true is no number."""
    if kind in ("number", "integer"):
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        return is_number and (kind == "number" or value == int(value))
    kinds = {"string": str, "boolean": bool, "object": dict, "array": list, "null": type(None)}
    return isinstance(value, kinds[kind])


def in_words(shape: Shape) -> str:
    """A shape as a message names it: "a number or a list"."""
    if "anyOf" in shape:
        return " or ".join(dict.fromkeys(in_words(one) for one in shape["anyOf"]))
    return _WORDS.get(shape.get("type", ""), "something else")


def shown(value: Any) -> str:
    """A wrong value as its message repeats it: whole if it is short."""
    text = json.dumps(value, ensure_ascii=False) if isinstance(value, (dict, list, bool)) else repr(value)
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}…"
