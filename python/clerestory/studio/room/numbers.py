"""Whole numbers of a request."""

from __future__ import annotations

from typing import Any

from clerestory.errors import ClerestoryError


def whole(name: str, value: Any, low: int, high: int) -> int:
    """The value as a whole number of the closed range low..high; JSON may write it as 3.0."""
    is_whole = isinstance(value, (int, float)) and not isinstance(value, bool) and float(value).is_integer()
    if not is_whole or not low <= value <= high:
        raise ClerestoryError(f"{name} must be a whole number of {low}..{high}, got {value!r}")
    return int(value)
