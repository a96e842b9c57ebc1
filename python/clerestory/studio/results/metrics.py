"""What plans can be drawn of a result: quantities that differ over the sensors, with their words and levels."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.studio.results.shelf import Result

#: Longest dimension beside sensors and variants whose entries are quantities of their own: bands, skies.
_MOST_LABELS = 24
#: Values that span more than this to 1 have a logarithmic scale.
_WIDE = 20.0
#: Daylight factor and illuminance that plans of rooms mark.
_FACTOR_PERCENT, _ENOUGH_LX = 2.0, 300.0

#: Name → label and one sentence of what it counts.
_WORDS = {
    "daylight_autonomy": ("Daylight autonomy", "Share of the hours of use with enough daylight."),
    "continuous_daylight_autonomy": (
        "Continuous daylight autonomy",
        "As daylight autonomy; an hour with half of the light counts for a half.",
    ),
    "useful_daylight_illuminance": ("Useful daylight", "Share of the hours of use in this band of illuminance."),
    "sunlit_hours": ("Hours with direct sun", "Analysis hours in which the sun itself lights the place, blinds open."),
    "annual_light_exposure": ("Annual light exposure", "Light that arrives over the year, blinds as people have them."),
    "glare_prone_hours": ("Hours in the sun's patch", "Hours of use in the direct or redirected sun, blinds open."),
    "daylight_factor": (
        "Daylight factor",
        "Share of the light outside that arrives under the overcast sky.",
    ),
    "illuminance": ("Illuminance", "Light that arrives at the place."),
    "relative_standard_error": (
        "Standard error of the light",
        "Of the year's light at each sensor, relative to it: how sure the computation is.",
    ),
}
#: Order in which they are offered; the rest follows.
_ORDER = (*_WORDS, "")
_UNITS = {"percent": "%", "1": "", "lx h": "lx h", "kWh/m2": "kWh/m² a"}
#: No quantity that one would look for a plan of.
_LEFT_OUT = ("in_use", "normal_x", "normal_y", "normal_z")


@dataclass(frozen=True)
class Metric:
    """A quantity over the sensors.

    Parameters
    ----------
    key : str
        Its variable, and after a bar the entry of the dimension beside sensors and variants.
    label, unit, about : str
    factor : float
        From the file's unit to the one that is shown.
    level : float, optional
        That a contour is drawn at.
    """

    key: str
    label: str
    unit: str
    about: str
    factor: float = 1.0
    level: float | None = None

    @property
    def variable(self) -> str:
        """Its variable."""
        return self.key.partition("|")[0]

    @property
    def entry(self) -> str:
        """The entry of the dimension beside, or nothing."""
        return self.key.partition("|")[2]


def metrics_of(result: Result) -> list[Metric]:
    """The quantities of a result that plans are drawn of."""
    found: list[Metric] = result.once("metrics", lambda: _metrics(result))
    return found


def metric_of(result: Result, key: Any) -> Metric:
    """One of them.

    Raises
    ------
    ClerestoryError
        If there is none of this key.
    """
    known = metrics_of(result)
    for one in known:
        if one.key == key:
            return one
    raise ClerestoryError(f"metric must be one of {', '.join(one.key for one in known)}, got {str(key)[:60]!r}")


def values_of(result: Result, metric: Metric) -> tuple[xr.DataArray, xr.DataArray | None]:
    """Values and standard errors of a quantity, dims ("variant", "sensor"), in the unit that is shown."""

    def taken(name: str) -> xr.DataArray:
        one = result.data[name]
        extra = [dim for dim in one.dims if dim not in ("variant", "sensor")]
        if extra:
            labels = [str(value) for value in result.data[extra[0]].values.tolist()]
            one = one.isel({extra[0]: labels.index(metric.entry)})
        return (one.astype(np.float64) * metric.factor).transpose("variant", "sensor")

    error = f"{metric.variable}_standard_error"
    return taken(metric.variable), taken(error) if error in result.data else None


def scale_of(values: xr.DataArray, metric: Metric) -> dict[str, Any]:
    """Ends of the colour scale that all variants share."""
    numbers = values.values[np.isfinite(values.values)]
    most = float(numbers.max(initial=0.0))
    positive = numbers[numbers > 0.0]
    least = float(positive.min()) if len(positive) else 1.0
    if metric.unit == "%" and most <= 100.0 and metric.variable not in ("daylight_factor", "relative_standard_error"):
        return {"low": 0.0, "high": 100.0, "is_logarithmic": False}
    if metric.unit in ("lx", "%") and metric.variable != "relative_standard_error" and most / least > _WIDE:
        return {"low": least, "high": most, "is_logarithmic": True}
    return {"low": 0.0, "high": most or 1.0, "is_logarithmic": False}


def measures_of(result: Result) -> dict[str, Any]:
    """The thresholds that a year was measured by, as far as its file tells them."""
    try:
        told = json.loads(result.data.attrs.get("measures", "{}"))
    except (ValueError, TypeError, RecursionError):
        return {}
    return told if isinstance(told, dict) else {}


def _metrics(result: Result) -> list[Metric]:
    made: list[Metric] = []
    for name in result.data.data_vars:
        one = result.data[name]
        extra = [str(dim) for dim in one.dims if dim not in ("variant", "sensor")]
        is_error = str(name).endswith("_standard_error") and name != "relative_standard_error"
        if (
            one.dtype.kind not in "fiub"
            or not {"variant", "sensor"} <= set(one.dims)
            or is_error
            or name in _LEFT_OUT
            or len(extra) > 1
        ):
            continue
        if not extra:
            made.append(_metric(result, str(name), ""))
        elif extra[0] in result.data.coords and 0 < result.data.sizes[extra[0]] <= _MOST_LABELS:
            made += [_metric(result, str(name), str(entry)) for entry in result.data[extra[0]].values.tolist()]
    rank = {name: place for place, name in enumerate(_ORDER)}
    return sorted(made, key=lambda one: (rank.get(one.variable, len(rank)), one.variable))


def _metric(result: Result, name: str, entry: str) -> Metric:
    attrs = result.data[name].attrs
    long_name = str(attrs.get("long_name", name.replace("_", " ")))
    label, about = _WORDS.get(name, (long_name[:1].upper() + long_name[1:], ""))
    unit, factor = str(attrs.get("units", "")), 1.0
    if name == "relative_standard_error":
        unit, factor = "%", 100.0
    unit = _UNITS.get(unit, unit)
    detail = long_name.partition(", ")[2]
    if name in ("daylight_autonomy", "continuous_daylight_autonomy") and detail:
        about += f" Enough is {detail}."
    if name == "useful_daylight_illuminance":
        label, about = f"{label}: {entry.replace('-', ' ')}", f"{about} {_band(entry, attrs.get('limits_lx'))}".strip()
    elif entry:
        label = f"{label}: {entry}"
    return Metric(f"{name}|{entry}" if entry else name, label, unit, about, factor, _level(result, name, entry))


def _band(entry: str, limits: Any) -> str:
    if not isinstance(limits, list) or len(limits) != 3:
        return ""
    a, b, c = (f"{limit:g}" for limit in limits)
    return {
        "fell-short": f"Below {a} lx.",
        "supplementary": f"{a} to {b} lx.",
        "autonomous": f"{b} to {c} lx.",
        "exceeded": f"Above {c} lx.",
    }.get(entry, "")


def _level(result: Result, name: str, entry: str) -> float | None:
    measures = measures_of(result)
    level: Any = {
        "daylight_autonomy": measures.get("depth_percent", 50.0),
        "sunlit_hours": measures.get("exposure_limit_h", 250.0),
        "daylight_factor": _FACTOR_PERCENT,
        "illuminance": _ENOUGH_LX if entry else None,
    }.get(name)
    return float(level) if isinstance(level, (int, float)) and math.isfinite(level) else None
