"""Tables of cases: what a sweep computed, what a design tried, what a panel does by direction."""

from __future__ import annotations

from typing import Any

import xarray as xr

from clerestory.studio.results.shelf import Result
from clerestory.sweep.figures import figures_of
from clerestory.year.figures import FIGURES

#: Rows that a page shows; a longer table is told of.
MOST_ROWS = 5000
_ANGLES = ("elevation", "azimuth", "elevation_deg", "azimuth_deg")
#: Shares of a panel that its curves begin with.
_SHARES = ("transmittance_deflected", "transmittance_undeflected", "reflectance", "absorptance")
_UNITS = {"percent": "%", "1": "", "degree": "°", "kWh/m2": "kWh/m² a"}
_ENDINGS = {"_mm": "mm", "_m": "m", "_deg": "°", "_lx": "lx", "_nm": "nm", "_percent": "%", "_h": "h"}


def cases(result: Result) -> dict[str, Any]:
    """The table of a result with what its columns are.

    Returns
    -------
    dict
        ``columns``: ``name``, ``label``, ``unit``, ``role`` ("parameter", "figure" or "note"), ``values``
        (numbers or texts) and, of a figure whose standard error is known, ``errors``; ``rows`` and ``rows_in_all``;
        ``start``: what a page draws first, ``x`` and ``y`` (names) and ``by``; of a design ``front`` (rows, in the
        order of the first objective), ``best`` (row) and ``objectives``.
    """
    told: dict[str, Any] = result.once("cases", lambda: _cases(result))
    return told


def _cases(result: Result) -> dict[str, Any]:
    if result.kind == "sweep":
        return _sweep(result.data)
    if result.kind == "design":
        return _design(result)
    return _panel(result.data)


def _sweep(found: xr.Dataset) -> dict[str, Any]:
    if "row" in found.dims:
        names = [str(name) for name in found.data_vars]
        first = names.index("key")
        parameters = [name for name in names[:first] if name != "case"]
        figures = [name for name in names[first:] if name not in ("key", "status")]
        table = found
    else:
        flat = figures_of(found)
        parameters = [
            str(name)
            for name in found.coords
            if found[name].dims == ("case",) and name not in ("case", "key", "status") and "path" in found[name].attrs
        ]
        figures = sorted((str(name) for name in flat.data_vars if name not in parameters), key=_rank)
        table = flat.assign_coords({name: found[name] for name in (*parameters, "status")})
    columns = [_column(table, name, "parameter") for name in parameters]
    columns += [_column(table, name, "figure") for name in figures if not name.endswith("_standard_error")]
    columns.append(_column(table, "status", "note"))
    varied = [one for one in columns if one["role"] == "parameter" and len(set(map(str, one["values"]))) > 1]
    numbers = [one["name"] for one in varied if one["is_number"]]
    x = numbers[0] if numbers else (varied or columns)[0]["name"]
    by = next((one["name"] for one in varied if one["name"] != x), "")
    y = next((one["name"] for one in columns if one["role"] == "figure"), columns[-1]["name"])
    return _told(columns, {"x": x, "y": [y], "by": by})


def _design(result: Result) -> dict[str, Any]:
    found = result.data
    names = [str(name) for name in found.data_vars]
    known = [one["figure"] for one in result.about.get("objectives", [])]
    between = names[names.index("trial") + 1 : names.index("error")]
    if not known:
        front = sum(str(one) == "True" for one in found["on_front"].values.tolist())
        known = between[-2:] if front > 1 else between[-1:]
    parameters = [name for name in between if name not in known]
    columns = [_column(found, "trial", "note")]
    columns += [_column(found, name, "parameter") for name in parameters]
    columns += [_column(found, name, "figure") for name in known if name in names]
    columns += [_column(found, name, "note") for name in ("stage", "error")]
    on_front = [place for place, one in enumerate(found["on_front"].values.tolist()) if str(one) == "True"]
    first = next((one for one in columns if one["name"] == known[0]), None) if known else None
    if first is not None and first["is_number"]:
        on_front.sort(key=lambda place: first["values"][place])
    trials = found["trial"].values.tolist()
    best = result.about.get("best")
    start = {"x": known[0], "y": known[1:2], "by": ""} if len(known) > 1 else {"x": "trial", "y": known[:1], "by": ""}
    return _told(columns, start) | {
        "front": on_front,
        "best": trials.index(best) if best in trials else (on_front[0] if len(on_front) == 1 else None),
        "objectives": result.about.get("objectives", []),
        "unbeaten": result.about.get("unbeaten", []),
    }


def _panel(found: xr.Dataset) -> dict[str, Any]:
    if "row" not in found.dims:
        keep = [
            name for name in found.data_vars if set(found[name].dims) <= {"elevation", "azimuth"} and found[name].ndim
        ]
        found = found[keep].stack(row=[dim for dim in ("elevation", "azimuth") if dim in found.dims]).reset_index("row")
    names = [*(str(one) for one in found.coords if one != "row"), *(str(one) for one in found.data_vars)]
    angles = [name for name in _ANGLES if name in names]
    columns = [_column(found, name, "parameter") for name in angles]
    figures = [name for name in names if name not in angles and not name.endswith("_standard_error")]
    columns += [_column(found, name, "figure") for name in figures]
    y = [name for name in _SHARES if name in figures] or figures[:1]
    by = next((one["name"] for one in columns[1:2] if one["role"] == "parameter" and len(set(one["values"])) > 1), "")
    return _told(columns, {"x": angles[0], "y": y[:1] if by else y, "by": by})


def _rank(name: str) -> tuple[int, int, str]:
    """Figures of a year in the order of its tables, means before the rest."""
    bare = name.partition(" (")[0]
    place = next((place for place, figure in enumerate(FIGURES) if figure.name == bare), len(FIGURES))
    return place, int("mean" not in bare), name


def _column(table: xr.Dataset, name: str, role: str) -> dict[str, Any]:
    one = table[name]
    is_number = one.dtype.kind in "fiu"
    values = one.values.tolist()
    told: dict[str, Any] = {
        "name": name,
        "label": _label(name, one),
        "unit": _unit(name, one),
        "role": role,
        "is_number": is_number,
        "values": [None if value is None or value != value else value if is_number else str(value) for value in values],
    }
    bare, _, rest = name.partition(" (")
    error = f"{bare}_standard_error" + (f" ({rest}" if rest else "")
    if error in table.variables and table[error].dtype.kind in "fiu":
        told["errors"] = table[error].values.tolist()
    return told


def _label(name: str, one: xr.DataArray) -> str:
    bare, _, rest = name.partition(" (")
    figure = next((figure.label for figure in FIGURES if figure.name == bare), None)
    text = figure or bare.replace("_", " ")
    for ending, unit in _ENDINGS.items():
        if figure is None and bare.endswith(ending) and unit:
            text = bare.removesuffix(ending).replace("_", " ")
    shown = text if figure else text[:1].upper() + text[1:]
    return shown + (f" ({rest}" if rest else "")


def _unit(name: str, one: xr.DataArray) -> str:
    unit = one.attrs.get("units")
    bare = name.partition(" (")[0]
    if isinstance(unit, str):
        return _UNITS.get(unit, unit)
    figure = next((figure.unit for figure in FIGURES if figure.name == bare), None)
    if figure is not None:
        return figure
    if bare.startswith("daylight_factor") or bare.endswith("_percent"):
        return "%"
    if bare.startswith("illuminance"):
        return "lx"
    return next((unit for ending, unit in _ENDINGS.items() if bare.endswith(ending)), "°" if bare in _ANGLES else "")


def _told(columns: list[dict[str, Any]], start: dict[str, Any]) -> dict[str, Any]:
    rows = len(columns[0]["values"]) if columns else 0
    for one in columns:
        for name in ("values", "errors"):
            if name in one:
                one[name] = one[name][:MOST_ROWS]
    return {"columns": columns, "rows": min(rows, MOST_ROWS), "rows_in_all": rows, "start": start}
