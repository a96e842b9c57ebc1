"""A study as one TOML file: what kind, from which base, which parameters, how they are joined."""

from __future__ import annotations

import copy
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.room.toml_file import read_toml
from clerestory.room.toml_table import Table
from clerestory.rules import one_of
from clerestory.sweep.axes import Parameter, Values, join, read_parameters
from clerestory.sweep.design_points import sampled
from clerestory.sweep.dotted import put
from clerestory.sweep.fingerprint import files_of, key_of
from clerestory.sweep.kinds import KINDS


@dataclass(frozen=True, kw_only=True)
class Case:
    """One variant of a study.

    Parameters
    ----------
    number : int
        From 0, in the order of the study.
    values : dict of parameter → value
    kind : str
    tables : dict
        Its inputs, complete.
    files : dict of path → digest
        The files that they name.
    key : str
        The hash of all that and of the program: the name of its result.
    where : Path
        The folder that paths in the tables refer to.
    """

    number: int
    values: Values
    kind: str
    tables: dict[str, Any] = field(repr=False)
    files: dict[str, str] = field(repr=False)
    key: str
    where: Path = Path()


@dataclass(frozen=True, kw_only=True)
class Sweep:
    """A parameter study.

    Parameters
    ----------
    kind : "panel", "room" or "year"
        What is computed for each case.
    base : dict
        Tables of that kind.
    parameters : sequence of Parameter
    rows : sequence of dict
        Parameter → value, one row a case.
    where : Path
        The folder that paths in the tables refer to.
    name : str
    sensors_per_task : int, optional
        A case with more sensors than this is split among several tasks; kind "room" alone.
    """

    kind: str
    base: dict[str, Any] = field(repr=False)
    parameters: tuple[Parameter, ...]
    rows: tuple[Values, ...] = field(repr=False)
    where: Path = Path()
    name: str = "study"
    sensors_per_task: int | None = None

    @cached_property
    def cases(self) -> tuple[Case, ...]:
        """Every case with its hash.

        Raises
        ------
        ClerestoryError
            If a parameter's path leads to no table.
        """
        return tuple(self._case(number, row) for number, row in enumerate(self.rows))

    def _case(self, number: int, values: Values) -> Case:
        tables = copy.deepcopy(self.base)
        for one in self.parameters:
            for path in one.paths:
                put(tables, path, copy.deepcopy(values[one.name]))
        case = case_of(number, values, self.kind, tables, self.where)
        if self.sensors_per_task is None:
            return case
        # other random numbers: another result, though the same within its errors
        split = tables | {"sensors_per_task": self.sensors_per_task}
        return replace(case, key=key_of(self.kind, split, case.files))


def case_of(number: int, values: Values, kind: str, tables: dict[str, Any], where: Path) -> Case:
    """A case with its files and its hash."""
    files = files_of(tables, where)
    key = key_of(kind, tables, files)
    return Case(number=number, values=values, kind=kind, tables=tables, files=files, key=key, where=where)


def read_sweep(path: str | os.PathLike[str]) -> Sweep:
    """The study that a TOML file describes.

    Parameters
    ----------
    path : path-like
        With ``kind`` ("panel", "room" or "year"); ``base``, tables of that kind or the name of a file beside it that
        holds them, and the one ``variant`` of it to keep; ``[parameters]``, dotted path → values; for sampled
        parameters a ``[design]``; ``join`` ("grid" or "zip"); docs/how-to/sweep.md.

    Raises
    ------
    ClerestoryError
        If it cannot be read, holds an unknown key or lacks one, or a parameter cannot be varied as it says.
    """
    file = Path(path)
    return sweep_of(read_toml(file), where=file.parent, name=file.name)


def sweep_of(tables: Mapping[str, Any], *, where: Path = Path(), name: str = "the study") -> Sweep:
    """The study that the tables of a TOML file describe; paths in them refer to the folder ``where``."""
    top = Table(dict(tables), name)
    kind = one_of(f"kind of {name}", top.take("kind"), KINDS)
    base, folder = read_base(top.take("base"), where, top.take("variant", None))
    parameters = read_parameters(top.table("parameters").values, name)
    how = one_of(f"join of {name}", top.take("join", "grid"), ("grid", "zip"))
    design = top.take("design", None)
    chunk = top.take("sensors_per_task", None)
    title = str(top.take("name", Path(name).stem))
    top.finish()
    if chunk is not None:
        if kind != "room":
            raise ClerestoryError(f"sensors_per_task of {name} must come with kind room, got {kind}; leave it out")
        if isinstance(chunk, bool) or not isinstance(chunk, int) or chunk < 1:
            raise ClerestoryError(f"sensors_per_task of {name} must be a whole number of at least 1, got {chunk!r}")
    samples = sampled(parameters, None if design is None else Table(design, f"[design] of {name}"))
    rows = tuple(join(parameters, how=how, samples=samples))
    sweep = Sweep(
        kind=kind,
        base=base,
        parameters=tuple(parameters),
        rows=rows,
        where=folder,
        name=title,
        sensors_per_task=chunk,
    )
    # a path that leads nowhere is told before any work
    for one in parameters:
        tables_of_first = copy.deepcopy(base)
        for place in one.paths:
            put(tables_of_first, place, rows[0][one.name])
    return sweep


def read_base(base: Any, where: Path, variant: Any = None) -> tuple[dict[str, Any], Path]:
    """Tables given in place or as the name of a file, and the folder that their own paths refer to.

    Parameters
    ----------
    base : mapping or str
    where : Path
        The folder of the file that says so.
    variant : str, optional
        The one [[variant]] of the base to keep; "" for none.
    """
    if isinstance(base, str):
        path = where / base
        tables, folder = read_toml(path), path.parent
    elif isinstance(base, Mapping):
        tables, folder = dict(base), where
    else:
        raise ClerestoryError(f"base must be tables or the name of a file, got {base!r}")
    if variant is not None:
        rows = {str(row.get("name", "")): row for row in tables.get("variant", []) if isinstance(row, Mapping)}
        one_of("variant", variant, ("", *rows))
        tables["variant"] = [rows[variant]] if variant else []
    return tables, folder
