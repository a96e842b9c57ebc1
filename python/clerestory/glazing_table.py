"""Glazings as tables of a TOML file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, fields, replace
from functools import cache
from pathlib import Path
from typing import Any

from clerestory.bsdf.bsdf import Bsdf
from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass, Glazing, Open, PlainTransmittance, Slab, Stack, TregenzaSharples
from clerestory.layers.gap import Gap
from clerestory.panels.panel import Panel
from clerestory.panels.writing import kinds as panel_kinds
from clerestory.panels.writing import panel_from_dict, panel_to_dict, read_panel
from clerestory.room.toml_table import Table
from clerestory.rules import one_of

KINDS: dict[str, type[Any]] = {
    "open": Open,
    "plain": PlainTransmittance,
    "glass": Glass,
    "tregenza-sharples": TregenzaSharples,
    "slab": Slab,
    "stack": Stack,
}
"""The word after ``kind =`` and what it makes."""


def glazing_tables(tables: Table, folder: Path) -> Callable[[Any], Glazing]:
    """The glazings of a file by name, each made once.

    Parameters
    ----------
    tables : Table
        Name → table.
    folder : Path
        Where files that the tables name are looked for.
    """

    begun: list[str] = []

    @cache
    def named(name: str) -> Glazing:
        one_of(f"glazing of {tables.where}", name, tables.values)
        if name in begun:
            raise ClerestoryError(f"layers of [{name}] in {tables.where} must not hold {name!r} itself")
        begun.append(name)
        try:
            return read_glazing(Table(tables.values[name], f"[{name}] in {tables.where}"), named, folder)
        finally:
            begun.remove(name)

    def looked_up(name: Any) -> Glazing:
        if not isinstance(name, str):
            raise ClerestoryError(f"glazing must be a name of {tables.where}, got {name!r}")
        return named(name)

    return looked_up


def read_glazing(table: Table, named: Callable[[Any], Glazing], folder: Path) -> Glazing:
    """The glazing that a table describes.

    Parameters
    ----------
    table : Table
        With ``kind`` and the parameters of that kind, or with the ``file`` of a panel; ``layers`` of a stack
        are names of other glazings, and between them tables of gaps.
    named : callable
        Name → glazing.

    Raises
    ------
    ClerestoryError
        If the kind is unknown, or a parameter is unknown, missing or out of range.
    """
    if table.values.get("kind") == "bsdf":
        return _read_bsdf(table, folder)
    if "file" in table.values:
        path = folder / str(table.take("file"))
        table.finish()
        return read_panel(path)
    panels = panel_kinds()
    word = one_of(f"kind of {table.where}", table.take("kind"), (*KINDS, "bsdf", *panels))
    if word in panels:
        try:
            return panel_from_dict({"kind": word, **table.values})
        except ClerestoryError as cause:
            raise ClerestoryError(f"{table.where}: {cause}") from cause
    kind = KINDS[word]
    if kind is Stack:
        layers = table.take("layers")
        table.finish()
        if not isinstance(layers, list):
            raise ClerestoryError(
                f"layers of {table.where} must list names of glazings, and gaps as tables, got {layers!r}"
            )
        for layer in layers:
            if not isinstance(layer, (dict, str)):
                raise ClerestoryError(f"layers of {table.where} must be names of glazings, got {layer!r}")
        return Stack(tuple(_gap(layer, table.where) if isinstance(layer, dict) else named(layer) for layer in layers))
    made: Glazing = build(kind, table)
    return made


def _gap(values: dict[str, Any], where: str) -> Gap:
    gap: Gap = build(Gap, Table(values, f"a gap among the layers of {where}"))
    return gap


def _layer(layer: Glazing | Gap, name_of: Callable[[Glazing], str]) -> str | dict[str, Any]:
    return {"width_mm": layer.width_mm, "gas": layer.gas} if isinstance(layer, Gap) else name_of(layer)


def _read_bsdf(table: Table, folder: Path) -> Glazing:
    """The BSDF of a file, which keeps how the table names it."""
    from clerestory.bsdf.reading import read_bsdf

    table.take("kind")
    name, blurred = table.take("file"), table.take("blurred", False)
    table.finish()
    if not isinstance(name, str) or not isinstance(blurred, bool):
        raise ClerestoryError(f"{table.where} must have a path as file and true or false as blurred")
    bsdf = read_bsdf(folder / name)
    bsdf = replace(bsdf, attrs=bsdf.attrs | {"file": name})
    return bsdf.blurred() if blurred else bsdf


def build(kind: type[Any], table: Table) -> Any:
    """A dataclass from a table whose keys are its parameters."""
    parameters = fields(kind)
    values = table.rest(*(parameter.name for parameter in parameters))
    for parameter in parameters:
        required = parameter.default is MISSING and parameter.default_factory is MISSING
        if required and parameter.name not in values:
            table.take(parameter.name)
    try:
        return kind(**values)
    except ClerestoryError as cause:
        raise ClerestoryError(f"{table.where}: {cause}") from cause


def write_glazing(glazing: Glazing, name_of: Callable[[Glazing], str]) -> dict[str, Any]:
    """The table that describes a glazing.

    Raises
    ------
    ClerestoryError
        If it is of a kind that has no table.
    """
    if isinstance(glazing, Panel):
        return panel_to_dict(glazing)
    if isinstance(glazing, Bsdf):
        if "file" not in glazing.attrs:
            raise ClerestoryError(
                f"the BSDF {glazing.name!r} must be in a file to be written as TOML; write it, then use read_bsdf's"
            )
        return {"kind": "bsdf", "file": glazing.attrs["file"]}
    word = next((word for word, kind in KINDS.items() if type(glazing) is kind), None)
    if word is None:
        raise ClerestoryError(f"glazing must be one of {', '.join(KINDS)} to be written as TOML, got {glazing!r}")
    if isinstance(glazing, Stack):
        return {"kind": word, "layers": [_layer(layer, name_of) for layer in glazing.layers]}
    values = {parameter.name: getattr(glazing, parameter.name) for parameter in fields(glazing)}  # type: ignore[arg-type]
    return {"kind": word, **{name: value for name, value in values.items() if value is not None}}
