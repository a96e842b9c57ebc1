"""Rules a value must keep, each broken one told as name, rule and value."""

from __future__ import annotations

import math
from collections.abc import Iterable
from difflib import get_close_matches
from typing import Any

import numpy as np
import numpy.typing as npt

from clerestory.errors import ClerestoryError

Points = npt.NDArray[np.float64]


def number(name: str, value: Any) -> float:
    """The value as a finite float."""
    if isinstance(value, (bool, str)) or value is None:
        raise ClerestoryError(f"{name} must be a number, got {value!r}")
    try:
        result = float(value)
    except (TypeError, ValueError) as cause:
        raise ClerestoryError(f"{name} must be a number, got {value!r}") from cause
    if not math.isfinite(result):
        raise ClerestoryError(f"{name} must be finite, got {value!r}")
    return result


def within(name: str, value: Any, low: float, high: float) -> float:
    """The value as a float of the closed range low..high."""
    result = number(name, value)
    if not low <= result <= high:
        raise ClerestoryError(f"{name} must lie in {low:g}..{high:g}, got {result:g}")
    return result


def positive(name: str, value: Any) -> float:
    """The value as a float above zero."""
    result = number(name, value)
    if result <= 0.0:
        raise ClerestoryError(f"{name} must be greater than 0, got {result:g}")
    return result


def not_negative(name: str, value: Any) -> float:
    """The value as a float of at least zero."""
    result = number(name, value)
    if result < 0.0:
        raise ClerestoryError(f"{name} must not be negative, got {result:g}")
    return result


def one_of(name: str, value: Any, choices: Iterable[str]) -> str:
    """The value, one of a few words."""
    known = list(choices)
    if value not in known:
        close = get_close_matches(str(value), known, n=1)
        hint = f"; did you mean {close[0]!r}?" if close else ""
        raise ClerestoryError(f"{name} must be one of {', '.join(known)}, got {value!r}{hint}")
    return str(value)


def points(name: str, value: Any, *, columns: int = 3) -> Points:
    """The value as finite points, shape (n, columns)."""
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError) as cause:
        raise ClerestoryError(f"{name} must be a list of points of {columns} numbers, got {value!r}") from cause
    if array.ndim != 2 or array.shape[1] != columns:
        raise ClerestoryError(f"{name} must be a list of points of {columns} numbers, got shape {array.shape}")
    if not np.isfinite(array).all():
        row = int(np.argmax(~np.isfinite(array).all(axis=1)))
        raise ClerestoryError(f"{name} must be finite, got {array[row].tolist()} at point {row}")
    return array


def vector(name: str, value: Any) -> tuple[float, float, float]:
    """The value as a unit vector of three components."""
    array = points(name, [value])[0]
    length = float(np.linalg.norm(array))
    if length == 0.0:
        raise ClerestoryError(f"{name} must have a length, got {array.tolist()}")
    x, y, z = (array / length).tolist()
    return (x, y, z)
