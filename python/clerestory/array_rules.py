"""Rules that arrays and tables of a user must keep, each broken one told as name, rule, value and way out."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sized
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clerestory.errors import ClerestoryError


def numbers(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """``value`` as an array of floats, or an error that names the argument."""
    try:
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise ClerestoryError(f"{name} must be a number or an array of numbers, got {value!r}; convert it") from None


def within(
    name: str, value: ArrayLike, low: float, high: float = np.inf, *, way_out: str, open_low: bool = False
) -> NDArray[np.float64]:
    """``value`` as an array whose every element is finite and in [low, high], or (low, high] if ``open_low``."""
    array = numbers(name, value)
    above = array > low if open_low else array >= low
    wrong = ~(above & (array <= high) & np.isfinite(array))
    if wrong.any():
        first = float(array[wrong].flat[0])
        least = f"greater than {low:g}" if open_low else f"at least {low:g}"
        rule = f"finite and {least}" if high == np.inf else f"{least} and at most {high:g}"
        raise ClerestoryError(f"{name} must be {rule}, got {first:g}; {way_out}")
    return array


def vector(name: str, value: ArrayLike) -> tuple[float, ...]:
    """``value`` as a tuple of floats."""
    array = numbers(name, value)
    if array.ndim != 1:
        raise ClerestoryError(f"{name} must have one dimension, got {array.ndim}; give a list of numbers")
    return tuple(array.tolist())


def same_length(name: str, values: Sized, others: Sized) -> None:
    """Raises unless there are as many ``values`` as ``others``."""
    if len(values) != len(others):
        raise ClerestoryError(f"{name} must have {len(others)} values, got {len(values)}; give one for each")


def wavelength_range(range_nm: ArrayLike | None) -> tuple[float, float] | None:
    """``range_nm`` as a pair of floats, or None."""
    if range_nm is None:
        return None
    ends = vector("wavelength_range_nm", range_nm)
    if len(ends) != 2:
        raise ClerestoryError(f"wavelength_range_nm must be two wavelengths, got {len(ends)}; give first and last")
    return ends[0], ends[1]


def known_keys(name: str, values: Mapping[str, Any], known: Collection[str], needed: Collection[str] = ()) -> None:
    """Raises unless every key is known and none is missing."""
    if unknown := sorted(set(values) - set(known)):
        raise ClerestoryError(f"keys of {name} must be among {sorted(known)}, got {unknown[0]!r}; correct or remove it")
    if missing := sorted(set(needed) - set(values)):
        raise ClerestoryError(f"keys of {name} must include {missing[0]!r}, got {sorted(values)}; add it")
