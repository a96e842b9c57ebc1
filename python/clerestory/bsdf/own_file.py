"""A BSDF as a Dataset and as NetCDF, the exact element beside its tables."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from clerestory.bsdf.band import DIRECTIONS, Band, Block
from clerestory.bsdf.bsdf import BANDS, Bsdf
from clerestory.bsdf.completing import words
from clerestory.bsdf.klems import KlemsBasis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.tree_block import TreeBlock
from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance

if TYPE_CHECKING:
    from clerestory.glazing import Glazing

#: What marks a Dataset as ours.
_KIND = "clerestory BSDF"


def to_dataset(bsdf: Bsdf) -> xr.Dataset:
    """What :meth:`Bsdf.to_dataset` returns."""
    variables: dict[str, xr.DataArray] = {}
    bases: dict[str, dict[str, Any]] = {}
    for band, blocks in bsdf.bands:
        for direction, block in blocks:
            name = f"{band}_{direction}"
            label = {"long_name": f"{words(direction)}, {band}", "units": "sr-1"}
            if isinstance(block, TreeBlock):
                variables[name] = xr.DataArray(
                    block.preorder, dims=f"{name}_entry", attrs={**label, "rank": block.rank}
                )
                continue
            for basis in (block.incident, block.outgoing):
                bases[basis.name] = {"theta_deg": list(basis.theta_deg), "counts": list(basis.counts)}
            dims = (f"outgoing {block.outgoing.name}", f"incident {block.incident.name}")
            variables[name] = xr.DataArray(block.values, dims=dims, attrs=label)
            if block.standard_error is not None:
                about = {"long_name": f"standard error of {label['long_name']}", "units": "sr-1"}
                variables[f"{name}_standard_error"] = xr.DataArray(block.standard_error, dims=dims, attrs=about)
    attributes = provenance(
        kind=_KIND,
        name=bsdf.name,
        manufacturer=bsdf.manufacturer,
        thickness_mm=bsdf.thickness_mm,
        bases=bases or None,
        exact=None if bsdf.exact is None else _written(bsdf.exact),
        about=bsdf.attrs or None,
    )
    return xr.Dataset(variables, attrs=attributes)


def of_dataset(dataset: xr.Dataset) -> Bsdf:
    """What :meth:`Bsdf.from_dataset` returns."""
    attrs = dataset.attrs
    if attrs.get("kind") != _KIND:
        raise ClerestoryError(
            f"attribute kind must be {_KIND!r}, got {attrs.get('kind')!r}; it is no BSDF written here"
        )
    try:
        bases = {
            name: KlemsBasis(name, tuple(rings["theta_deg"]), tuple(rings["counts"]))
            for name, rings in json.loads(attrs.get("bases", "{}")).items()
        }
        bands: dict[str, Any] = {}
        for band in BANDS:
            blocks = {
                direction: _block(dataset, f"{band}_{direction}", bases)
                for direction in DIRECTIONS
                if f"{band}_{direction}" in dataset
            }
            if blocks:
                bands[band] = Band(**blocks)
        known: dict[str, Any] = {
            name: attrs[name] for name in ("name", "manufacturer", "thickness_mm") if name in attrs
        }
        exact = _read(attrs["exact"]) if "exact" in attrs else None
        return Bsdf(**known, **bands, exact=exact, attrs=json.loads(attrs.get("about", "{}")))
    except ClerestoryError:
        raise
    except (KeyError, TypeError, ValueError, AttributeError) as cause:
        raise ClerestoryError(f"the dataset must hold a whole BSDF, got: {cause!r}") from cause


def read_netcdf(path: str | os.PathLike[str]) -> Bsdf:
    """The BSDF of a NetCDF file that :func:`clerestory.save` wrote.

    Raises
    ------
    ClerestoryError
        If it is no such file.
    """
    where = Path(path)
    try:
        dataset = xr.load_dataset(where, engine="netcdf4")
    except (OSError, ValueError, RuntimeError) as error:
        raise ClerestoryError(f"{where} must be a NetCDF file to read, got: {error}") from None
    try:
        return of_dataset(dataset)
    except ClerestoryError as cause:
        raise ClerestoryError(f"{where}: {cause}") from None


def _block(dataset: xr.Dataset, name: str, bases: dict[str, KlemsBasis]) -> Block:
    variable = dataset[name]
    if "rank" in variable.attrs:
        return TreeBlock(int(variable.attrs["rank"]), variable.to_numpy())
    outgoing, incident = (str(dim).split(" ", 1)[1] for dim in variable.dims)
    error = dataset.get(f"{name}_standard_error")
    return KlemsBlock(
        variable.to_numpy(), bases[incident], bases[outgoing], None if error is None else np.asarray(error.to_numpy())
    )


def _written(exact: Glazing) -> dict[str, Any] | None:
    """The exact element as tables of a room file: its name and whatever it is made of; None if it has no table."""
    from clerestory.glazing_table import write_glazing

    tables: dict[str, Any] = {}

    def named(glazing: Glazing) -> str:
        name = f"glazing {len(tables)}"
        tables[name] = None
        tables[name] = write_glazing(glazing, named)
        return name

    try:
        first = named(exact)
        json.dumps(tables)
    except (ClerestoryError, TypeError):
        return None
    return {"glazing": first, "glazings": tables}


def _read(text: str) -> Glazing:
    from clerestory.glazing_table import glazing_tables
    from clerestory.room.toml_table import Table

    written = json.loads(text)
    return glazing_tables(Table(written["glazings"], "exact"), Path())(written["glazing"])
