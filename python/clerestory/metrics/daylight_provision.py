"""The levels of daylight provision of the European standard."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import xarray as xr

from clerestory.metrics.counted import counted_hours

LEVELS = ("none", "minimum", "medium", "high")

TARGETS_LX = {"minimum": (300.0, 100.0), "medium": (500.0, 300.0), "high": (750.0, 500.0)}
"""Target and minimum target illuminance of each level [lx]; EN 17037:2018, table A.1."""

TARGET_SENSORS, MINIMUM_SENSORS, HOURS = 0.5, 0.95, 0.5
"""Shares of the space that must have target and minimum target, and of the daylit hours; EN 17037:2018, table A.1."""


def daylight_provision(illuminance: xr.DataArray, *, daylit: xr.DataArray) -> xr.Dataset:
    r"""Level of daylight provision by EN 17037, from illuminances through the year.

    Parameters
    ----------
    illuminance : DataArray, dims ("sensor", "time") [lx]
        Each sensor stands for the same area. The standard leaves out a band of 0.5 m along the walls.
    daylit : DataArray of bool, dims ("time",)
        The 4380 hours of `daylit_hours`.

    Returns
    -------
    Dataset without dimensions
        `level` 0 none, 1 minimum, 2 medium, 3 high; `target_illuminance` [lx], which half of the space has in half of
        the daylit hours, and `minimum_illuminance` [lx], which 95 % of the space has; `target_level` and
        `minimum_level`, reached by each of them alone.

    Raises
    ------
    ClerestoryError
        If no hour is daylit, or the times differ.

    Notes
    -----
    theory/metrics.md, eqs. 9-10; EN 17037:2018+A1:2021, annex A, by its second method. The level needs the same
    hours for no two sensors: each sensor has its own half of the daylit hours.
    """
    lit = counted_hours(illuminance, daylit)
    half_of_hours = _reached(lit.transpose("time", "sensor").values, HOURS)
    found = {
        "target": float(_reached(half_of_hours, TARGET_SENSORS)),
        "minimum": float(_reached(half_of_hours, MINIMUM_SENSORS)),
    }
    levels = {
        name: sum(found[name] >= TARGETS_LX[level][which] for level in LEVELS[1:])
        for which, name in enumerate(("target", "minimum"))
    }
    result = xr.Dataset({f"{name}_illuminance": ((), value) for name, value in found.items()})
    for name, share in (("target", TARGET_SENSORS), ("minimum", MINIMUM_SENSORS)):
        about = f"illuminance that {100 * share:g} % of the space has in half of the daylit hours"
        result[f"{name}_illuminance"].attrs = {"units": "lx", "long_name": about}
        result[f"{name}_level"] = ((), levels[name], _about_level(f"EN 17037 level of the {name} illuminance"))
    result["level"] = ((), min(levels.values()), _about_level("EN 17037 level of daylight provision"))
    return result


def _reached(values: npt.NDArray[np.float64], share: float) -> npt.NDArray[np.float64]:
    """The value that so much of the first axis reaches or passes."""
    place = math.ceil(share * len(values) - 1e-9) - 1
    return np.asarray(-np.partition(-values, place, axis=0)[place])


def _about_level(name: str) -> dict[str, str]:
    return {"units": "1", "long_name": name, "flag_meanings": " ".join(LEVELS)}
