"""The results of a study as one Dataset."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance
from clerestory.sweep.fingerprint import build
from clerestory.sweep.plan import Sweep
from clerestory.sweep.store import Store


def gather(sweep: Sweep, folder: str | os.PathLike[str], *, without: Sequence[str] = ("time",)) -> xr.Dataset:
    """The finished results of a study, side by side.

    Parameters
    ----------
    sweep : Sweep
    folder : path-like
        That the study was run in.
    without : sequence of str, default ("time",)
        Dimensions whose variables are left out: a year hour by hour of every case would fill the memory; it stays in
        the files of the cases.

    Returns
    -------
    Dataset, dims ("case", …)
        What each case has, along ``case``; the parameters are coordinates of ``case``, with its `key` and `status`
        ("done", "failed" or "left"). Where a case has fewer sensors than another, or no result, there is NaN. Places of
        sensors that differ between cases have the dimension ``case`` too.

    Raises
    ------
    ClerestoryError
        If no case is finished.
    """
    store = Store(Path(folder))
    finished = store.keys()
    kept = {case.key: None for case in sweep.cases if case.key in finished}
    if not kept:
        raise ClerestoryError(f"{folder} must hold a finished case of {sweep.name}, got none; see its folder failed")
    read = {key: _as_data(store.read(key).drop_dims(without, errors="ignore")) for key in kept}
    status = [_status(store, case.key, finished) for case in sweep.cases]
    done = np.array([place for place, case in enumerate(sweep.cases) if case.key in finished])
    found = [read[sweep.cases[place].key] for place in done]
    whole = xr.concat(
        found,
        dim=xr.Variable("case", done),
        data_vars="all",
        coords="minimal",
        compat="override",
        join="outer",
        combine_attrs="drop_conflicts",
    )
    whole = whole.reindex(case=np.arange(len(sweep.cases)))
    whole = whole.assign_coords(
        {one.name: ("case", _column([row[one.name] for row in sweep.rows])) for one in sweep.parameters}
        | {"key": ("case", [case.key for case in sweep.cases]), "status": ("case", status)}
    )
    for one in sweep.parameters:
        whole[one.name].attrs["path"] = ", ".join(one.paths)
    whole.attrs = {name: value for name, value in whole.attrs.items() if name != "date"} | provenance(
        study=sweep.name, kind=sweep.kind, sources=build()["sources"]
    )
    return _plain_text(whole)


def as_grid(gathered: xr.Dataset, *parameters: str) -> xr.Dataset:
    """The results of a grid with its parameters as dimensions, in place of ``case``.

    Parameters
    ----------
    gathered : Dataset of `gather`
    *parameters : str
        Those that were varied against each other.

    Raises
    ------
    ClerestoryError
        If two cases have the same values of these parameters.
    """
    for name in parameters:
        if name not in gathered.coords or gathered[name].dims != ("case",):
            raise ClerestoryError(f"a parameter must be a coordinate of the cases, got {name!r}")
    rows = list(zip(*(gathered[name].values.tolist() for name in parameters), strict=True))
    if len(set(rows)) < len(rows):
        raise ClerestoryError(
            f"{' and '.join(parameters)} must tell all cases apart, got {len(set(rows))} of {len(rows)}"
        )
    return gathered.set_index(case=list(parameters)).unstack("case")


def write_zarr(gathered: xr.Dataset, path: str | os.PathLike[str]) -> Path:
    """Writes a Dataset as a zarr store: a folder that is put in place when it is whole.

    Raises
    ------
    ClerestoryError
        If the folder cannot be written.
    """
    where = Path(path)
    try:
        where.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=f".{where.name}.", dir=where.parent) as beside:
            draft, old = Path(beside) / "new", Path(beside) / "old"
            _for_zarr(gathered).to_zarr(draft, mode="w", consolidated=False)
            if where.exists():
                os.replace(where, old)
            os.replace(draft, where)
            shutil.rmtree(old, ignore_errors=True)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ClerestoryError(f"{where} must be a place to write to, got: {reason}; choose another path") from None
    return where


def _for_zarr(gathered: xr.Dataset) -> xr.Dataset:
    """Text as text of any length, which every version of zarr specifies."""
    texts = {name: gathered[name].astype(object) for name in gathered.variables if gathered[name].dtype.kind == "U"}
    return gathered.assign_coords({name: texts[name] for name in texts if name in gathered.coords}).assign(
        {name: texts[name] for name in texts if name in gathered.data_vars}
    )


def _as_data(found: xr.Dataset) -> xr.Dataset:
    """Coordinates that are no index may differ between cases: they are data here."""
    return found.drop_encoding().reset_coords([name for name in found.coords if name not in found.dims])


def _status(store: Store, key: str, finished: set[str]) -> str:
    if key in finished:
        return "done"
    return "left" if store.failure(key) is None else "failed"


def _column(values: list[Any]) -> Any:
    if all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in values):
        return np.array(values)
    return np.array([value if isinstance(value, str) else json.dumps(value, default=str) for value in values])


def _plain_text(whole: xr.Dataset) -> xr.Dataset:
    """Text as text of one length, missing text as nothing: what every file format can hold."""
    for name in [*whole.data_vars, *whole.coords]:
        if whole[name].dtype == object:
            values = whole[name].values
            absent = [value is None or (isinstance(value, float) and np.isnan(value)) for value in values.ravel()]
            texts = ["" if gone else str(value) for gone, value in zip(absent, values.ravel(), strict=True)]
            whole[name] = (whole[name].dims, np.array(texts).reshape(values.shape), whole[name].attrs)
    return whole
