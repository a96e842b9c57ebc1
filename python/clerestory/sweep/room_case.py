"""A case of kind "room": daylight factor and illuminance at each sensor, and what they come down to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance
from clerestory.room.scene import Room
from clerestory.room.sensors import Sensors
from clerestory.study import Study, run_study, study_of

CHUNK = "sensor_chunk"
"""Table of a task that has a part of the sensors: the first of them, and the first that is no longer of the part."""

DAYLIT_PERCENT = 2.0
"""Daylight factor that `share_of_sensors_at_least_2_percent` counts."""


def evaluate(tables: Mapping[str, Any], *, where: Path = Path(), progress: Any = None) -> xr.Dataset:
    """Daylight in the room of a room file.

    Parameters
    ----------
    tables : mapping
        Of a room file (docs/how-to/room.md), with [calculation], [[sky]] and [[variant]].
    where : Path
    progress : ignored
        So that all kinds are called alike.

    Returns
    -------
    Dataset, dims ("variant", "sensor", "sky")
        `daylight_factor`, its parts and `daylight_factor_standard_error` [%]; `illuminance` and its standard error [lx]
        if there are skies; and the figures of `with_figures` over the sensors.

    Raises
    ------
    ClerestoryError
        If the room is wrong.
    """
    plain = {name: value for name, value in tables.items() if name != CHUNK}
    study = study_of(plain, where="the case", folder=where)
    chunk = tables.get(CHUNK)
    if chunk is not None:
        study = replace(study, rooms={label: part_of(room, *chunk) for label, room in study.rooms.items()})
    return with_figures(_per_sensor(study))


def count_of_sensors(tables: Mapping[str, Any], where: Path) -> int:
    """How many sensors the room of a case has."""
    study = study_of(tables, where="the case", folder=where)
    return max(sum(len(one) for one in room.sensor_points()) for room in study.rooms.values())


def part_of(room: Room, first: int, end: int) -> Room:
    """The room with the sensors ``first`` to ``end`` (excluded) of all of them."""
    kept, start = [], 0
    for one in room.sensor_points():
        low, high = max(first - start, 0), min(end - start, len(one))
        start += len(one)
        if low < high:
            kept.append(
                Sensors(
                    points_m=one.points_m[low:high],
                    normals=one.normals[low:high],
                    name=one.name,
                    row=None if one.row is None else one.row[low:high],
                    column=None if one.column is None else one.column[low:high],
                    area_m2=one.area_m2,
                )
            )
    if not kept:
        raise ClerestoryError(f"{CHUNK} must hold sensors of the room ({start}), got {first} to {end}")
    return replace(room, sensors=tuple(kept))


def joined(parts: list[xr.Dataset]) -> xr.Dataset:
    """The result of a whole grid of sensors from those of its parts, in their order."""
    bare = [part.drop_vars([name for name in part.data_vars if "sensor" not in part[name].dims]) for part in parts]
    whole = xr.concat(bare, dim="sensor", data_vars="all", coords="minimal", compat="override", join="override")
    whole = whole.assign_coords(sensor=np.arange(whole.sizes["sensor"]))
    whole.attrs = parts[0].attrs | {"cpu_seconds": sum(float(part.attrs["cpu_seconds"]) for part in parts)}
    whole.attrs["tasks"] = len(parts)
    whole.attrs["converged"] = min(int(part.attrs["converged"]) for part in parts)
    return with_figures(whole)


def with_figures(found: xr.Dataset) -> xr.Dataset:
    """Adds what the sensors come down to: mean, least, median daylight factor, uniformity, daylit share, mean lux."""
    factor = found.daylight_factor
    mean, least = factor.mean("sensor"), factor.min("sensor")
    figures = {
        "daylight_factor_mean": (mean, "%", "mean daylight factor"),
        "daylight_factor_median": (factor.median("sensor"), "%", "median daylight factor"),
        "daylight_factor_least": (least, "%", "least daylight factor"),
        "uniformity": ((least / mean).where(mean > 0.0), "1", "least over mean daylight factor"),
        "share_of_sensors_at_least_2_percent": (
            (factor >= DAYLIT_PERCENT).mean("sensor"),
            "1",
            "share of sensors with a daylight factor of at least 2 %",
        ),
    }
    if "illuminance" in found:
        figures["illuminance_mean"] = (found.illuminance.mean("sensor"), "lx", "mean illuminance")
        figures["illuminance_least"] = (found.illuminance.min("sensor"), "lx", "least illuminance")
    made = {name: value.assign_attrs(units=unit, long_name=told) for name, (value, unit, told) in figures.items()}
    return found.assign(made)


def _per_sensor(study: Study) -> xr.Dataset:
    findings = run_study(study)
    rows = []
    for found in findings.values():
        factor = found.daylight_factor
        row = {"daylight_factor": factor.total, "daylight_factor_standard_error": factor.total_standard_error}
        row |= {f"daylight_factor_{part}": factor[part] for part in ("direct", "redirected", "interreflected")}
        if found.illuminance is not None:
            row["illuminance"] = found.illuminance.total
            row["illuminance_standard_error"] = found.illuminance.total_standard_error
        rows.append(xr.Dataset(row))
    variant = xr.Variable("variant", list(findings))
    whole = xr.concat(rows, dim=variant, data_vars="all", coords="minimal", compat="override", join="override")
    traced = [found.coefficients.attrs for found in findings.values()]
    whole.attrs = provenance(
        basis=study.calculation.basis,
        seed=study.calculation.seed,
        target_relative_error=study.calculation.target_relative_error,
        cpu_seconds=sum(float(one["cpu_seconds"]) for one in traced),
        converged=min(int(one["converged"]) for one in traced),
        rounds=max(int(one["rounds"]) for one in traced),
    )
    return whole
