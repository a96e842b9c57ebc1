"""Sampled designs: points that fill the space of several parameters evenly."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.room.toml_table import Table
from clerestory.rules import one_of
from clerestory.sweep.axes import MOST_CASES, Parameter, Values

DESIGNS = ("sobol", "latin-hypercube", "random")
"""Scrambled Sobol points, a Latin hypercube, or independent even points."""


def sampled(parameters: list[Parameter], table: Table | None) -> list[Values]:
    """The rows of a sampled design over the parameters that have bounds.

    Parameters
    ----------
    parameters : list of Parameter
    table : Table, optional
        ``kind`` (default "sobol"), ``n`` points and a ``seed`` (default 0).

    Returns
    -------
    list of dict
        One a point; empty if no parameter is sampled.

    Raises
    ------
    ClerestoryError
        If a parameter has bounds and there is no design, or the other way round; if n or the seed is out of range.

    Notes
    -----
    Sobol points: I. M. Sobol, USSR Computational Mathematics and Mathematical Physics 7(4), 1967, scrambled after
    A. B. Owen; Latin hypercube: M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21(2), 1979.
    """
    free = [one for one in parameters if one.is_sampled]
    if table is None:
        if free:
            raise ClerestoryError(
                f"parameter {free[0].name!r} has low and high: it must come with a [design], got none"
            )
        return []
    if not free:
        raise ClerestoryError(f"{table.where} must come with parameters that have low and high, got none")
    qmc: Any = import_module("scipy.stats").qmc
    kind = one_of(f"kind of {table.where}", table.take("kind", "sobol"), DESIGNS)
    n, seed = table.take("n"), table.take("seed", 0)
    table.finish()
    for name, value, least in (("n", n, 1), ("seed", seed, 0)):
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= MOST_CASES:
            raise ClerestoryError(f"{name} of {table.where} must be a whole number of at least {least}, got {value!r}")
    if kind == "sobol":
        if n & (n - 1):
            raise ClerestoryError(
                f"n of {table.where} must be a power of 2 for Sobol points to be even, got {n}; "
                f"try {1 << (n.bit_length() - 1)} or {1 << n.bit_length()}"
            )
        shares = qmc.Sobol(len(free), scramble=True, seed=seed).random(n)
    elif kind == "latin-hypercube":
        shares = qmc.LatinHypercube(len(free), seed=seed).random(n)
    else:
        import numpy as np

        shares = np.random.default_rng(seed).random((n, len(free)))
    return [{one.name: one.at(float(share)) for one, share in zip(free, row, strict=True)} for row in shares]
