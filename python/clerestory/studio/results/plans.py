"""Plans of a result: values on a grid of sensors, with the room's outline and windows; and sections through it."""

from __future__ import annotations

import json
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.plots.room_plan import GridFrame, grid_frame
from clerestory.rules import one_of
from clerestory.studio.results.metrics import Metric, metric_of, scale_of, values_of
from clerestory.studio.results.shelf import Result

Floats = npt.NDArray[np.float64]

#: Digits of lengths [m] that are drawn.
_DIGITS = 4


def planes_of(result: Result) -> list[dict[str, Any]]:
    """The groups of sensors: their name, how many there are, and whether they are a grid that has a plan."""
    found: list[dict[str, Any]] = result.once("planes", lambda: _planes(result))
    return found


def labels_of(result: Result) -> list[str]:
    """The variants."""
    return [str(label) for label in result.data["variant"].values.tolist()]


def plan(result: Result, *, metric: Any, plane: Any = None) -> dict[str, Any]:
    """A quantity in plan, all variants on one scale."""
    chosen = metric_of(result, metric)
    values, errors = values_of(result, chosen)
    return plan_of(result, chosen, values, errors, plane)


def plan_of(
    result: Result, metric: Metric, values: xr.DataArray, errors: xr.DataArray | None, plane: Any = None
) -> dict[str, Any]:
    """Values of all variants in plan.

    Returns
    -------
    dict
        ``x``, ``y``: where columns and rows lie [m], the window wall of a grid along the facade at y = 0; ``sensors``,
        the place of each cell's sensor in the result (row by row, null for none); for each variant ``values`` and
        ``errors`` likewise; ``outline`` of the surface below and ``windows`` as lines, empty where the file does not
        tell them.
    """
    name = one_of("plane", plane or _first(result), [one["name"] for one in planes_of(result) if one["is_grid"]])
    which = np.flatnonzero(result.data["group"].values == name)
    frame, outline, windows = _frame(result, name, which)
    place = frame.place(_points(result, which))
    row, column = (result.data[one].values[which].astype(int) for one in ("row", "column"))
    shape = (int(row.max()) + 1, int(column.max()) + 1)

    def cells(numbers: Any) -> Floats:
        grid = np.full(shape, np.nan)
        grid[row, column] = numbers
        return grid

    on_plane = values.isel(sensor=which)
    return {
        "label": metric.label,
        "unit": metric.unit,
        "about": metric.about,
        "level": metric.level,
        "plane": name,
        **scale_of(on_plane, metric),
        "x": np.round(np.nanmean(cells(place[:, 0]), axis=0), _DIGITS),
        "y": np.round(np.nanmean(cells(place[:, 1]), axis=1), _DIGITS),
        "outline": outline,
        "windows": windows,
        "sensors": [None if np.isnan(one) else int(one) for one in cells(which).ravel()],
        "variants": [
            {
                "label": label,
                "values": cells(on_plane.values[number]).ravel(),
                "errors": None if errors is None else cells(errors.values[number][which]).ravel(),
                "mean": float(np.nanmean(on_plane.values[number])),
                "least": float(np.nanmin(on_plane.values[number])),
                "most": float(np.nanmax(on_plane.values[number])),
            }
            for number, label in enumerate(labels_of(result))
        ],
    }


def difference(result: Result, *, metric: Any, variant: Any, minus: Any, plane: Any = None) -> dict[str, Any]:
    """One variant less another, with the standard error of two independent computations.

    Notes
    -----
    Variants that were traced with one seed draw the same paths where they can: their difference is then better known
    than this error says.
    """
    chosen = metric_of(result, metric)
    values, errors = values_of(result, chosen)
    labels = labels_of(result)
    a, b = (labels.index(one_of(name, one, labels)) for name, one in (("variant", variant), ("minus", minus)))
    told = plan_of(result, chosen, values, errors, plane)
    one, other = told["variants"][a], told["variants"][b]
    change = one["values"] - other["values"]
    error = None if one["errors"] is None else np.hypot(one["errors"], other["errors"])
    most = float(np.nanmax(np.abs(change))) or 1.0
    shown = {
        "label": f"{labels[a]} − {labels[b]}",
        "values": change,
        "errors": error,
        "mean": float(np.nanmean(change)),
        "least": float(np.nanmin(change)),
        "most": float(np.nanmax(change)),
    }
    return told | {"low": -most, "high": most, "is_logarithmic": False, "level": None, "variants": [shown]}


def section(result: Result, *, metric: Any, plane: Any = None) -> dict[str, Any]:
    """Mean, least and most of each row of sensors against its distance into the room.

    The standard error is that of the mean as if the row's errors went the same way.
    """
    told = plan(result, metric=metric, plane=plane)
    rows, columns = len(told["y"]), len(told["x"])

    def by_row(flat: Any, f: Any) -> list[float]:
        grid = np.asarray(flat).reshape(rows, columns)
        return [float(f(one[np.isfinite(one)])) if np.isfinite(one).any() else math.nan for one in grid]

    return {
        "label": told["label"],
        "unit": told["unit"],
        "level": told["level"],
        "is_logarithmic": told["is_logarithmic"],
        "distance_m": told["y"],
        "variants": [
            {
                "label": one["label"],
                "mean": by_row(one["values"], np.mean),
                "least": by_row(one["values"], np.min),
                "most": by_row(one["values"], np.max),
                "error": None if one["errors"] is None else by_row(one["errors"], np.mean),
            }
            for one in told["variants"]
        ],
    }


def _first(result: Result) -> str:
    name = next((str(one["name"]) for one in planes_of(result) if one["is_grid"]), None)
    if name is None:
        raise ClerestoryError("plane must be a grid of at least 2 by 2 sensors, got none in this result")
    return name


def _planes(result: Result) -> list[dict[str, Any]]:
    groups = result.data["group"].values
    told = []
    for name in dict.fromkeys(groups.tolist()):
        which = np.flatnonzero(groups == name)
        row, column = result.data["row"].values[which], result.data["column"].values[which]
        is_whole = row.dtype.kind in "iuf" and column.dtype.kind in "iuf" and bool((row >= 0).all())
        is_grid = is_whole and min(len(np.unique(row)), len(np.unique(column))) > 1 and float(row.max()) < len(which)
        is_grid = is_grid and bool((column >= 0).all()) and float(column.max()) < len(which)
        told.append({"name": str(name), "count": len(which), "is_grid": is_grid})
    return told


def _points(result: Result, which: Any) -> Floats:
    return np.stack([result.data[f"{axis}_m"].values[which] for axis in "xyz"], axis=1).astype(np.float64)


def _frame(result: Result, name: str, which: Any) -> tuple[GridFrame, list[Any], list[Any]]:
    """The grid's own axes, and outline and windows of the room in them."""
    surfaces, windows = _outlines(result)
    room: Any = SimpleNamespace(
        surfaces=[SimpleNamespace(name=one, outline_m=outline) for one, outline in surfaces.items()]
    )
    places = {
        one: ("sensor", result.data[one].values[which]) for one in ("x_m", "y_m", "z_m", "group", "row", "column")
    }
    frame = grid_frame(xr.DataArray(np.zeros(len(which)), dims="sensor", coords=places), room)
    below = frame.place(np.array(surfaces[name])) if name in surfaces else np.zeros((0, 2))
    return (
        frame,
        np.round(below, _DIGITS).tolist(),
        [
            {"name": one, "points": np.round(frame.place(np.array(outline)), _DIGITS).tolist()}
            for one, outline in windows.items()
        ],
    )


def _outlines(result: Result) -> tuple[dict[str, Any], dict[str, Any]]:
    """Outlines of surfaces and windows that the file tells, those that are none left out."""
    try:
        told = json.loads(result.data.attrs.get("room_outlines", "{}"))
        parts = [told.get(part, {}) for part in ("surfaces", "windows")]
        surfaces, windows = (
            {str(name): np.array(outline, dtype=np.float64) for name, outline in part.items()} for part in parts
        )
    except (ValueError, TypeError, AttributeError, RecursionError):
        return {}, {}
    every = [surfaces, windows]
    kept = [
        {n: o for n, o in part.items() if o.ndim == 2 and o.shape[1] == 3 and np.isfinite(o).all()} for part in every
    ]
    return kept[0], kept[1]
