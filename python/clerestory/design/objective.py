"""What a design is for: a figure of a case, as large or as small as can be."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.room.toml_table import Table
from clerestory.rules import one_of

AIMS = ("maximise", "minimise")
REDUCTIONS = ("mean", "min", "max", "median")


@dataclass(frozen=True, kw_only=True)
class Objective:
    """A figure to maximise or minimise.

    Parameters
    ----------
    figure : str
        A variable of the results of a case.
    aim : "maximise" or "minimise", default "maximise"
    select : mapping of dimension → label
        Where to look: ``{ variant = "panel", sky = "overcast" }``.
    reduce : "mean", "min", "max" or "median", default "mean"
        What is made of the dimensions that are left.
    """

    figure: str
    aim: str = "maximise"
    select: Mapping[str, Any] = field(default_factory=dict)
    reduce: str = "mean"

    @property
    def label(self) -> str:
        """For tables and axes."""
        where = ", ".join(str(value) for value in self.select.values())
        return f"{self.figure} ({where})" if where else self.figure

    @property
    def sign(self) -> float:
        """1 if more is better, else -1."""
        return 1.0 if self.aim == "maximise" else -1.0

    def of(self, found: xr.Dataset) -> float:
        """The figure of a case.

        Raises
        ------
        ClerestoryError
            If the results have no such figure, or it is nothing there.
        """
        numeric = [str(name) for name in found.data_vars if found[name].dtype.kind in "fiub"]
        one_of("figure", self.figure, numeric)
        values = found[self.figure]
        for dim, label in self.select.items():
            one_of(f"select of {self.figure!r}", dim, [str(one) for one in values.dims])
            known = values[dim].values.tolist() if dim in values.coords else list(range(values.sizes[dim]))
            if label not in known:
                raise ClerestoryError(f"{dim} of {self.figure!r} must be one of {known}, got {label!r}")
            values = values.isel({dim: known.index(label)})
        value = float(getattr(values, self.reduce)())
        if not np.isfinite(value):
            raise ClerestoryError(f"{self.label} must be a number, got {value}")
        return value


def read_objective(table: Table) -> Objective:
    """An objective from a table ``[[objective]]``."""
    made = Objective(
        figure=str(table.take("figure")),
        aim=one_of(f"aim of {table.where}", table.take("aim", "maximise"), AIMS),
        select=table.table("select").values,
        reduce=one_of(f"reduce of {table.where}", table.take("reduce", "mean"), REDUCTIONS),
    )
    table.finish()
    return made


def front(values: np.ndarray[tuple[int, int], np.dtype[np.float64]], signs: list[float]) -> list[int]:
    """Rows that no other row beats in one figure without losing in another, in the order of the first figure.

    Parameters
    ----------
    values : ndarray, shape (rows, figures)
        Rows with NaN are no candidates.
    signs : list of 1 or -1
        Whether more or less is better.
    """
    better = values * np.asarray(signs)
    rows = [int(row) for row in np.flatnonzero(np.isfinite(values).all(axis=1))]
    kept: list[int] = []
    for row in rows:
        others = better[[other for other in rows if other != row]]
        beaten = ((others >= better[row]).all(axis=1) & (others > better[row]).any(axis=1)).any()
        first = next(one for one in rows if (better[one] == better[row]).all())
        if not beaten and first == row:
            kept.append(row)
    return sorted(kept, key=lambda row: -better[row, 0])


def balanced(values: np.ndarray[tuple[int, int], np.dtype[np.float64]], rows: list[int], signs: list[float]) -> int:
    """Of the rows of a front, the one nearest to the best of each figure, each measured by its span on the front."""
    better = values[rows] * np.asarray(signs)
    span = np.ptp(better, axis=0)
    short = (better.max(axis=0) - better) / np.where(span > 0.0, span, 1.0)
    return rows[int(np.argmin(np.hypot.reduce(short, axis=1)))]
