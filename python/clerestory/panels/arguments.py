"""Arguments of panels: numbers that are numbers, sequences that repeat, media that are media."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.medium import Medium
from clerestory.rules import number


def repeating(name: str, value: Any) -> float | tuple[float, ...]:
    """A number, or a sequence of numbers as a tuple."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, Sequence) and not isinstance(value, str):
        if not value:
            raise ClerestoryError(
                f"{name} must have at least one value, got an empty sequence; give a number or a list"
            )
        return tuple(number(f"{name}[{place}]", item) for place, item in enumerate(value))
    return number(name, value)


def sequence(value: float | Sequence[float]) -> list[float]:
    """What :func:`repeating` returns, as a list."""
    return list(value) if isinstance(value, Sequence) else [value]


def medium(name: str, value: Any) -> Medium:
    """A medium, given as one or by the name of one."""
    if isinstance(value, str):
        return Medium.named(value)
    if not isinstance(value, Medium):
        raise ClerestoryError(f"{name} must be a Medium or the name of one, got {value!r}; try Medium(n=1.49)")
    return value
