"""What is varied: parameters over values, ranges or sampled designs, and how they are joined to cases."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.room.toml_table import Table
from clerestory.rules import number, one_of
from clerestory.sweep.dotted import steps_of

MOST_CASES = 1_000_000
"""More than this is a slip of the keyboard."""

Values = dict[str, Any]


@dataclass(frozen=True, kw_only=True)
class Parameter:
    """One thing that is varied.

    Parameters
    ----------
    name : str
        Of the coordinate in the results.
    paths : tuple of str
        Where its value goes; the same value into each.
    values : tuple, optional
        Of a grid or of rows that go together.
    low, high : float, optional
        Bounds of a sampled parameter.
    is_log, is_whole : bool
        Whether a sampled parameter is even in its logarithm, or a whole number.
    of, times, plus : str, float, float
        A tied parameter: its value is ``times`` that of the parameter ``of``, and ``plus``.
    """

    name: str
    paths: tuple[str, ...]
    values: tuple[Any, ...] = ()
    low: float = 0.0
    high: float = 0.0
    is_log: bool = False
    is_whole: bool = False
    of: str | None = None
    times: float = 1.0
    plus: float = 0.0

    @property
    def is_sampled(self) -> bool:
        """Whether its values come from a design."""
        return not self.values and self.of is None

    def at(self, share: float) -> float | int:
        """The value of a sampled parameter at a share 0..1 of its range."""
        if self.is_whole:
            span = round(self.high) - round(self.low) + 1
            return round(self.low) + min(int(share * span), span - 1)
        if self.is_log:
            return float(self.low * (self.high / self.low) ** share)
        return float(self.low + (self.high - self.low) * share)


def read_parameters(tables: Mapping[str, Any], where: str) -> list[Parameter]:
    """The parameters of a study's table ``[parameters]``: path → how to vary it.

    Raises
    ------
    ClerestoryError
        If a parameter has no or several ways to vary, a range that leads nowhere, or the name of another.
    """
    found: list[Parameter] = []
    for path, given in tables.items():
        steps_of(path)
        row = Table(given if isinstance(given, Mapping) else {"values": given}, f"parameter {path!r} of {where}")
        found.append(_parameter(path, row))
    if not found:
        raise ClerestoryError(f"[parameters] of {where} must hold at least one, got none")
    names = [one.name for one in found]
    for name in names:
        if names.count(name) > 1:
            raise ClerestoryError(
                f"parameters of {where} must have names of their own, got {name!r} twice; give one a name = …"
            )
    for one in found:
        if one.of is not None:
            one_of(f"of = … of parameter {one.name!r}", one.of, [name for name in names if name != one.name])
            if next(other for other in found if other.name == one.of).of is not None:
                raise ClerestoryError(f"parameter {one.name!r} must be tied to one that is not tied, got {one.of!r}")
    return found


def _parameter(path: str, row: Table) -> Parameter:
    name = str(row.take("name", steps_of(path)[-1]))
    also = row.take("also", [])
    paths = (path, *([also] if isinstance(also, str) else also))
    for one in paths[1:]:
        steps_of(one)
    ways = [way for way in ("values", "range", "low", "of") if way in row.values]
    if len(ways) != 1:
        raise ClerestoryError(
            f"{row.where} must have one of values, range, low and high, or of, got {' and '.join(ways) or 'none'}"
        )
    if ways == ["values"]:
        values = row.take("values")
        row.finish()
        if not isinstance(values, list) or not values:
            raise ClerestoryError(f"values of {row.where} must be a list of at least one, got {values!r}")
        return Parameter(name=name, paths=paths, values=tuple(values))
    if ways == ["range"]:
        span = Table(row.take("range"), f"range of {row.where}")
        row.finish()
        return Parameter(name=name, paths=paths, values=_range(span))
    if ways == ["of"]:
        of = str(row.take("of"))
        times, plus = (number(f"{key} of {row.where}", row.take(key, usual)) for key, usual in _TIED)
        row.finish()
        return Parameter(name=name, paths=paths, of=of, times=times, plus=plus)
    low, high = (number(f"{key} of {row.where}", row.take(key)) for key in ("low", "high"))
    is_log, is_whole = (bool(row.take(key, False)) for key in ("log", "whole"))
    row.finish()
    if not low < high:
        raise ClerestoryError(f"low of {row.where} must be less than high ({high:g}), got {low:g}")
    if is_log and low <= 0.0:
        raise ClerestoryError(f"low of {row.where} must be greater than 0 for log, got {low:g}")
    return Parameter(name=name, paths=paths, low=low, high=high, is_log=is_log, is_whole=is_whole)


_TIED = (("times", 1.0), ("plus", 0.0))


def _range(span: Table) -> tuple[Any, ...]:
    given = {key: span.take(key) for key in ("start", "stop")}
    step, count = span.take("step", None), span.take("count", None)
    span.finish()
    start, stop = (number(f"{key} of {span.where}", value) for key, value in given.items())
    if (step is None) == (count is None):
        raise ClerestoryError(f"{span.where} must have a step or a count, got {'neither' if step is None else 'both'}")
    if count is not None:
        if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= MOST_CASES:
            raise ClerestoryError(f"count of {span.where} must be a whole number of at least 1, got {count!r}")
        return tuple(np.linspace(start, stop, count).tolist())
    by = number(f"step of {span.where}", step)
    if by == 0.0 or (stop - start) / by < 0.0:
        raise ClerestoryError(f"step of {span.where} must lead from {start:g} to {stop:g}, got {by:g}")
    # a stop that rounding misses by a hair is met
    places = int(np.floor((stop - start) / by * (1 + 1e-12) + 1e-9)) + 1
    if places > MOST_CASES:
        raise ClerestoryError(f"{span.where} must have at most {MOST_CASES} values, got {places}; take a larger step")
    whole = all(isinstance(value, int) for value in (step, *given.values()))
    return tuple(int(start + by * k) if whole else round(start + by * k, 12) for k in range(places))


def join(parameters: list[Parameter], *, how: str, samples: list[Values]) -> list[Values]:
    """The values of each case.

    Parameters
    ----------
    parameters : list of Parameter
    how : "grid" or "zip"
        Every value with every other, or the first of each, the second of each …
    samples : list of dict
        Rows of a sampled design, empty if nothing is sampled; a further axis of the grid, or of the zip.

    Raises
    ------
    ClerestoryError
        If zipped parameters have different numbers of values, or there are too many cases.
    """
    listed = [one for one in parameters if one.values]
    axes: list[list[Values]] = [[{one.name: value} for value in one.values] for one in listed]
    if samples:
        axes.append(samples)
    if how == "zip":
        lengths = {len(axis) for axis in axes}
        if len(lengths) > 1:
            told = ", ".join(f"{one.name}: {len(one.values)}" for one in listed)
            raise ClerestoryError(f"parameters that go together must have one number of values, got {told}")
        rows = [_merged(row) for row in zip(*axes, strict=True)]
    else:
        count = int(np.prod([len(axis) for axis in axes], dtype=float))
        if count > MOST_CASES:
            raise ClerestoryError(f"a study must have at most {MOST_CASES} cases, got {count}; take fewer values")
        rows = [_merged(row) for row in product(*axes)]
    for row in rows:
        for one in parameters:
            if one.of is not None:
                row[one.name] = one.times * number(one.of, row[one.of]) + one.plus
    return [{one.name: row[one.name] for one in parameters} for row in rows]


def _merged(parts: tuple[Values, ...]) -> Values:
    return {name: value for part in parts for name, value in part.items()}
