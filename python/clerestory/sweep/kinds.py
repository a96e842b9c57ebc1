"""What can be computed for a case: each kind one function from tables to a Dataset."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import xarray as xr

KINDS = ("panel", "room", "year")
"""The words for them."""


def evaluate(kind: str, tables: Mapping[str, Any], *, where: Path) -> xr.Dataset:
    """The result of one case.

    Parameters
    ----------
    kind : "panel", "room" or "year"
    tables : mapping
        Of a TOML file of that kind.
    where : Path
        The folder that paths in the tables refer to.

    Raises
    ------
    ClerestoryError
        If the tables are wrong.
    """
    return _function(kind)(tables, where=where)


def _function(kind: str) -> Callable[..., xr.Dataset]:
    if kind == "panel":
        from clerestory.sweep.panel_case import evaluate as of_panel

        return of_panel
    if kind == "room":
        from clerestory.sweep.room_case import evaluate as of_room

        return of_room
    from importlib import import_module

    of_year: Callable[..., xr.Dataset] = import_module("clerestory.year").evaluate
    return of_year
