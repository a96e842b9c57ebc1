"""Opens a result: one of the studio's folder with what lies beside it, or one that was dropped."""

from __future__ import annotations

import hashlib
import json
import re
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.illuminance import daylight_factor
from clerestory.studio.doors.folder import inside
from clerestory.studio.results.kinds import kind_of
from clerestory.studio.results.reader import Reader
from clerestory.studio.results.shelf import Result, ResultShelf, signature

#: Largest summary, and largest file of the folder.
_MOST_SUMMARY, _MOST_FILE = 8 * 2**20, 2**30
#: What places a sensor.
PLACES = ("x_m", "y_m", "z_m", "group", "row", "column")


def open_content(shelf: ResultShelf, reader: Reader, content: bytes, name: str) -> str:
    """Keeps a result whose file was dropped; returns its key.

    Raises
    ------
    ClerestoryError
        If it is no result; the message begins with the name of the file.
    """
    shown = re.sub(r"[^\w.() -]", "_", Path(name.replace("\\", "/")).name)[-100:] or "file"
    key = f"file-{hashlib.sha256(content).hexdigest()[:20]}"
    if shelf.find(key) is not None:
        return key
    ending = Path(shown).suffix.lower()
    if ending == ".json":
        return shelf.put(key, _of_summary_alone(content, shown))
    if ending not in (".nc", ".csv", ".zip"):
        raise ClerestoryError(
            f"{shown} must be a NetCDF, CSV or JSON file of a result, or a results.zarr: the folder, or a ZIP archive "
            "of it"
        )
    with tempfile.TemporaryDirectory(prefix="clerestory-") as place:
        path = Path(place) / f"dropped{ending}"
        path.write_bytes(content)
        found = reader.read(path, shown)
    return shelf.put(key, settled(found, shown, ""))


def open_path(shelf: ResultShelf, reader: Reader, folder: Path, asked: Any) -> str:
    """Keeps a result of the studio's folder; returns its key.

    Raises
    ------
    ClerestoryError
        If the path leads outside, or to no result.
    """
    path = inside(folder, asked)
    name = path.relative_to(folder).as_posix()
    if path.is_dir():
        if not (path / "zarr.json").is_file():
            raise ClerestoryError(f"path must be a file or a zarr store (version 3), got the folder {name!r}")
        if any(not one.resolve().is_relative_to(folder) for one in path.rglob("*") if one.is_symlink()):
            raise ClerestoryError(f"path must be a store within the studio's folder, got links out of it in {name!r}")
    elif path.stat().st_size > _MOST_FILE:
        raise ClerestoryError(f"path must be a file of at most {_MOST_FILE // 2**20} MiB, got {name!r}")
    key = f"path-{hashlib.sha256(signature(path).encode()).hexdigest()[:20]}"
    if shelf.find(key) is not None:
        return key
    if path.suffix.lower() == ".json":
        return shelf.put(key, _of_summary(reader, path, name))
    found = reader.read(path, path.name)
    result = settled(found, path.name, name)
    if result.kind == "design" and (path.parent / "summary.json").is_file():
        result.about.update(_objectives(_json((path.parent / "summary.json").read_bytes(), "summary.json")))
    return shelf.put(key, result)


def settled(found: xr.Dataset, name: str, path: str) -> Result:
    """A result whose years and rooms all have the dimension "variant"."""
    kind = kind_of(found, name)
    if kind in ("sweep", "design", "panel"):
        return Result(kind, name, path, found)
    if kind == "factor":
        found = found.rename_dims(row="sensor") if "row" not in found else _rows_as_sensors(found)
    _placed(found, name)
    label = str(found.attrs.get("variant") or found.attrs.get("room") or found.attrs.get("study") or name)
    if kind == "year":
        data = found if "variant" in found.dims else _with_variant(found, label)
        return Result("year", name, path, data)
    if kind == "room":
        return Result("room", name, path, found if "variant" in found.dims else _with_variant(found, label))
    light = daylight_factor(found) if kind == "coefficients" else found
    quantity = "illuminance" if kind == "illuminance" else "daylight_factor"
    kept = {quantity: light["total"], f"{quantity}_standard_error": light["total_standard_error"]}
    data = _with_variant(xr.Dataset(kept).assign_attrs(found.attrs), label)
    return Result("room", name, path, data)


def _rows_as_sensors(found: xr.Dataset) -> xr.Dataset:
    """A table of sensors, whose own rows and columns are those of their grid."""
    columns: dict[str, Any] = {str(one): ("sensor", found[one].values, {}) for one in found.variables}
    attrs = {"units": "percent", "long_name": "daylight factor, total"}
    places = {one: columns[one] for one in PLACES if one in columns}
    values = {one: ("sensor", columns[one][1], attrs) for one in ("total", "total_standard_error") if one in columns}
    return xr.Dataset(values, places, found.attrs)


def _placed(found: xr.Dataset, name: str) -> None:
    for one in PLACES:
        if one not in found.variables or found[one].dims != ("sensor",):
            raise ClerestoryError(f"{name} must say where its sensors are, got no {one} of each sensor")
    if found.sizes["sensor"] == 0:
        raise ClerestoryError(f"{name} must have a sensor, got none")


def _with_variant(found: xr.Dataset, label: str) -> xr.Dataset:
    keep = [one for one in found.data_vars if one not in PLACES]
    wide = {one: found[one].expand_dims(variant=[label]) for one in keep}
    return xr.Dataset(wide, attrs=found.attrs)


def _json(content: bytes, name: str) -> dict[str, Any]:
    if len(content) > _MOST_SUMMARY:
        raise ClerestoryError(f"{name} must hold at most {_MOST_SUMMARY // 2**20} MiB, got more")
    try:
        told = json.loads(content)
    except (ValueError, RecursionError):
        raise ClerestoryError(f"{name} must be JSON, got something else") from None
    if not isinstance(told, dict):
        raise ClerestoryError(f"{name} must be the summary of a study, got {type(told).__name__}")
    return told


def _summary_kind(told: Mapping[str, Any], name: str) -> str:
    if isinstance(told.get("objectives"), list) and "design" in told:
        return "design"
    if "study" in told and "cases" in told:
        return "sweep"
    if told and all(isinstance(one, dict) and "daylight_factor_percent" in one for one in told.values()):
        return "room"
    raise ClerestoryError(f"{name} is no summary of a room, sweep or design that this project wrote")


def _of_summary_alone(content: bytes, name: str) -> Result:
    beside = {
        "design": "history.csv",
        "sweep": "results.csv",
        "room": "…-illuminance.nc or …-coefficients.nc",
    }[_summary_kind(_json(content, name), name)]
    raise ClerestoryError(f"{name} is the summary alone: drop {beside} of the same folder, which holds the results")


def _of_summary(reader: Reader, path: Path, name: str) -> Result:
    told = _json(path.read_bytes(), path.name)
    kind = _summary_kind(told, path.name)
    if kind == "design":
        found = reader.read(_beside(path, "history.csv"), "history.csv")
        result = settled(found, path.name, name)
        result.about.update(_objectives(told))
        return result
    if kind == "sweep":
        store = path.parent / "results.zarr"
        beside = store if store.is_dir() else _beside(path, "results.csv")
        return settled(reader.read(beside, beside.name), path.name, name)
    return _rooms(reader, path, name, list(told))


def _rooms(reader: Reader, path: Path, name: str, labels: list[str]) -> Result:
    """All rooms of a study, side by side."""
    whole: list[xr.Dataset] = []
    for label in labels:
        stem = re.sub(r"[^\w]+", "-", label.lower()).strip("-") or "room"
        parts = [
            settled(reader.read(one, one.name), one.name, name).data.assign_coords(variant=[label])
            for one in (path.parent / f"{stem}-coefficients.nc", path.parent / f"{stem}-illuminance.nc")
            if one.is_file()
        ]
        if parts:
            whole.append(xr.merge(parts, compat="override", join="exact", combine_attrs="drop_conflicts"))
    if not whole:
        raise ClerestoryError(f"{path.name} must lie beside the files of its rooms, got none of them")
    data = xr.concat(
        whole, "variant", combine_attrs="drop_conflicts", join="exact", coords="minimal", compat="override"
    )
    return Result("room", path.name, name, data)


def _beside(path: Path, name: str) -> Path:
    one = path.parent / name
    if not one.is_file() or one.is_symlink():
        raise ClerestoryError(f"{path.name} must lie beside {name}, got no such file")
    return one


def _objectives(told: Mapping[str, Any]) -> dict[str, Any]:
    kept = [
        {"figure": str(one.get("figure")), "aim": str(one.get("aim"))}
        for one in told.get("objectives", [])
        if isinstance(one, dict)
    ]
    best = told.get("best")
    number = best.get("number") if isinstance(best, dict) else None
    program = told.get("program")
    return {
        "title": str(told.get("design", "")),
        "objectives": kept[:2],
        "best": number if isinstance(number, int) else None,
        "unbeaten": [str(one) for one in told.get("unbeaten", []) if isinstance(one, str)],
        "program": {str(k): str(v) for k, v in program.items()} if isinstance(program, dict) else {},
    }
