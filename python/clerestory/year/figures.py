"""The figures that a year comes down to: what they are called, in what order, how they are read."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import xarray as xr

from clerestory.metrics.daylight_provision import LEVELS


@dataclass(frozen=True)
class Figure:
    """One figure of a variant.

    Parameters
    ----------
    name : str
        Of the variable.
    label : str
    unit : str
        As it is written.
    digits : int
        After the point.
    about : str
        One sentence: what it counts.
    """

    name: str
    label: str
    unit: str
    digits: int
    about: str


FIGURES = (
    Figure("mean_daylight_factor", "Daylight factor, mean", "%", 2, "Of the work plane under the overcast sky."),
    Figure("mean_daylight_autonomy", "Daylight autonomy, mean", "%", 1, "Hours of use with enough daylight."),
    Figure(
        "mean_continuous_daylight_autonomy",
        "Continuous daylight autonomy, mean",
        "%",
        1,
        "As above; an hour with half of the light counts for a half.",
    ),
    Figure("mean_useful_fell_short", "Useful daylight: fell short", "%", 1, "Hours of use below the first limit."),
    Figure("mean_useful_supplementary", "Useful daylight: supplementary", "%", 1, "Between the first two limits."),
    Figure("mean_useful_autonomous", "Useful daylight: autonomous", "%", 1, "Between the second limit and the third."),
    Figure("mean_useful_exceeded", "Useful daylight: exceeded", "%", 1, "Beyond the third."),
    Figure(
        "spatial_daylight_autonomy",
        "sDA",
        "%",
        1,
        "Part of the work plane with enough daylight in half of the analysis hours, blinds as people have them.",
    ),
    Figure("spatial_daylight_autonomy_without_blinds", "sDA without blinds", "%", 1, "The same with no blinds closed."),
    Figure(
        "annual_sunlight_exposure",
        "ASE",
        "%",
        1,
        "Part of the work plane that has direct sun for too many of the analysis hours, blinds open.",
    ),
    Figure(
        "useful_depth",
        "Useful depth",
        "m",
        2,
        "From the window wall, how deep enough light reaches in half of the hours.",
    ),
    Figure(
        "en17037_level", "EN 17037 level", "", 0, "0 none, 1 minimum, 2 medium, 3 high: target and minimum together."
    ),
    Figure(
        "en17037_target_illuminance",
        "EN 17037: half of the room has",
        "lx",
        0,
        "In half of the 4380 daylit hours; 300, 500, 750 lx are the levels.",
    ),
    Figure(
        "en17037_minimum_illuminance",
        "EN 17037: 95 % of the room has",
        "lx",
        0,
        "Likewise; 100, 300, 500 lx are the levels.",
    ),
    Figure("mean_illuminance_in_use", "Illuminance in use, mean", "lx", 0, "Of the work plane over the hours of use."),
    Figure("annual_uniformity", "Uniformity, median", "", 3, "Least over mean of the work plane, median of the hours."),
    Figure(
        "sun_patch_hours",
        "Hours in the sun's patch",
        "h",
        0,
        "Hours of use in which the direct or the redirected sun reaches at least one sensor, blinds open.",
    ),
    Figure(
        "redirected_sun_patch_hours",
        "Hours in the redirected sun's patch",
        "h",
        0,
        "Those in which light that the panel has turned is enough by itself.",
    ),
    Figure("lighting_used", "Electric lighting", "kWh/m² a", 2, "Of dimmed lamps over the hours of use."),
    Figure(
        "lighting_saved", "Electricity saved by daylight", "kWh/m² a", 2, "Against the same lamps without daylight."
    ),
    Figure("lighting_saved_percent", "Share of it", "%", 1, "Of what the lamps would use without daylight."),
)
"""In the order of the tables."""


def value_of(found: xr.Dataset, figure: Figure) -> tuple[float, float] | None:
    """A figure of one variant and its standard error (NaN where it has none); None if it was not asked for."""
    if figure.name not in found:
        return None
    error = found.get(f"{figure.name}_standard_error")
    return float(found[figure.name]), math.nan if error is None else float(error)


def text_of(found: xr.Dataset, figure: Figure) -> str:
    """A figure as it is read: the value, and ± its standard error where that would show."""
    pair = value_of(found, figure)
    if pair is None:
        return "–"
    value, error = pair
    if math.isnan(value):
        return "–"
    if figure.name == "en17037_level":
        return LEVELS[int(value)]
    written = f"{value:.{figure.digits}f}"
    if figure.name == "useful_depth" and found[figure.name].attrs.get("at_least"):
        written = f"≥ {written}"
    shows = not math.isnan(error) and round(error, figure.digits) > 0.0
    return f"{written} ± {error:.{figure.digits}f}" if shows else written


def asked_for(results: Mapping[str, xr.Dataset]) -> list[Figure]:
    """The figures that at least one variant has."""
    return [figure for figure in FIGURES if any(figure.name in found for found in results.values())]
