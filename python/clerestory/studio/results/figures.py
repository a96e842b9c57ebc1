"""The figures that variants come down to, side by side: values, standard errors, and which is best."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from clerestory.studio.results.metrics import metrics_of, values_of
from clerestory.studio.results.shelf import Result
from clerestory.year.figures import FIGURES, text_of, value_of

#: Figures of which more is better, and of which less is.
_MORE = (
    "mean_daylight_factor",
    "mean_daylight_autonomy",
    "mean_continuous_daylight_autonomy",
    "mean_useful_autonomous",
    "spatial_daylight_autonomy",
    "spatial_daylight_autonomy_without_blinds",
    "useful_depth",
    "en17037_level",
    "en17037_target_illuminance",
    "en17037_minimum_illuminance",
    "annual_uniformity",
    "lighting_saved",
    "lighting_saved_percent",
)
_LESS = (
    "mean_useful_fell_short",
    "mean_useful_exceeded",
    "annual_sunlight_exposure",
    "sun_patch_hours",
    "redirected_sun_patch_hours",
    "lighting_used",
)
#: Figures on one axis from 0 to 100 %.
_DOTS = (
    "mean_daylight_autonomy",
    "mean_continuous_daylight_autonomy",
    "mean_useful_autonomous",
    "mean_useful_exceeded",
    "spatial_daylight_autonomy",
    "spatial_daylight_autonomy_without_blinds",
    "annual_sunlight_exposure",
    "lighting_saved_percent",
)
#: Standard errors apart that two variants must be to be told apart.
_APART = 2.0


def figures_of_result(result: Result) -> list[dict[str, Any]]:
    """One row a figure: name, label, unit, about, and of each variant the value, standard error and text.

    ``best`` lists the variants that are best; empty where no sense is better or errors do not tell them apart.
    """
    rows: list[dict[str, Any]] = result.once(
        "figures", lambda: _year(result) if result.kind == "year" else _room(result)
    )
    return rows


def _year(result: Result) -> list[dict[str, Any]]:
    rows = []
    for figure in FIGURES:
        if figure.name not in result.data or result.data[figure.name].dims != ("variant",):
            continue
        cells = []
        for place in range(result.data.sizes["variant"]):
            one = result.data.isel(variant=place)
            pair = value_of(one, figure)
            value, error = pair if pair is not None else (math.nan, math.nan)
            cells.append({"value": value, "error": error, "text": text_of(one, figure)})
        sense = 1 if figure.name in _MORE else -1 if figure.name in _LESS else 0
        rows.append(
            {
                "name": figure.name,
                "label": figure.label,
                "unit": figure.unit,
                "about": figure.about,
                "sense": sense,
                "is_share": figure.name in _DOTS,
                "cells": cells,
                "best": _best(cells, sense),
            }
        )
    return rows


def _room(result: Result) -> list[dict[str, Any]]:
    rows = []
    for metric in metrics_of(result):
        if metric.variable not in ("daylight_factor", "illuminance"):
            continue
        values, errors = values_of(result, metric)
        error = None if errors is None else errors.mean("sensor").values
        told = [
            (
                "mean",
                "mean",
                values.mean("sensor").values,
                error,
                "Of all sensors; the error as if all went the same way.",
            ),
            ("median", "median", values.median("sensor").values, None, "Half of the sensors have more."),
            ("least", "least", values.min("sensor").values, None, "Of the darkest sensor."),
            ("most", "most", values.max("sensor").values, None, "Of the brightest sensor."),
        ]
        digits = 2 if metric.unit == "%" else 0
        for word, label, found, unsure, about in told:
            cells = [
                _cell(float(value), math.nan if unsure is None else float(unsure[place]), digits)
                for place, value in enumerate(found)
            ]
            rows.append(_row(f"{metric.key}.{word}", f"{metric.label}, {label}", metric.unit, about, 0, cells))
        mean = np.where(values.mean("sensor") > 0.0, values.mean("sensor"), np.nan)
        even = [_cell(float(value), math.nan, 3) for value in values.min("sensor").values / mean]
        rows.append(_row(f"{metric.key}.even", f"{metric.label}, uniformity", "", "Least over mean.", 1, even))
        if metric.level is not None:
            share = 100.0 * (values >= metric.level).mean("sensor")
            label = f"{metric.label}, at least {metric.level:g} {metric.unit}"
            cells = [_cell(float(value), math.nan, 1) for value in share]
            rows.append(_row(f"{metric.key}.enough", label, "%", "Part of the sensors.", 1, cells, is_share=True))
    return rows


def _row(
    name: str, label: str, unit: str, about: str, sense: int, cells: list[dict[str, Any]], is_share: bool = False
) -> dict[str, Any]:
    return {
        "name": name,
        "label": label,
        "unit": unit,
        "about": about,
        "sense": sense,
        "is_share": is_share,
        "cells": cells,
        "best": _best(cells, sense),
    }


def _cell(value: float, error: float, digits: int) -> dict[str, Any]:
    if math.isnan(value):
        return {"value": value, "error": error, "text": "–"}
    shows = not math.isnan(error) and round(error, digits) > 0.0
    text = f"{value:.{digits}f}" + (f" ± {error:.{digits}f}" if shows else "")
    return {"value": value, "error": error, "text": text}


def _best(cells: list[dict[str, Any]], sense: int) -> list[int]:
    """Variants that are best, and those that their errors do not tell from it; none if that is all."""
    known = [place for place, cell in enumerate(cells) if math.isfinite(cell["value"])]
    if sense == 0 or len(known) < 2:
        return []
    first = max(known, key=lambda place: sense * cells[place]["value"])
    top = cells[first]

    def is_as_good(cell: dict[str, Any]) -> bool:
        errors = [0.0 if math.isnan(one["error"]) else one["error"] for one in (top, cell)]
        return bool(abs(top["value"] - cell["value"]) <= _APART * math.hypot(*errors) + 1e-9 * abs(top["value"]))

    as_good = [place for place in known if is_as_good(cells[place])]
    return [] if len(as_good) == len(known) else as_good
