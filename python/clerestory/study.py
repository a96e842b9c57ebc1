"""A room file as a study: the room, the glazings to compare, the skies, and how well to compute."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from clerestory.coefficients import Progress, daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.glazing_table import build, glazing_tables
from clerestory.illuminance import daylight_factor, illuminance, sun_illuminance
from clerestory.room.scene import Room
from clerestory.room.toml_file import read_toml, room_of
from clerestory.room.toml_table import Table
from clerestory.site import Site
from clerestory.sky.cie_sky import CieSky
from clerestory.sun import sun_position
from clerestory.sun_coefficients import sun_coefficients
from clerestory.sunlight import direct_normal_illuminance_lx


@dataclass(frozen=True, kw_only=True)
class Calculation:
    """How well to compute: the parameters of `daylight_coefficients`."""

    basis: str = "reinhart577"
    target_relative_error: float | None = 0.02
    rounds: int = 16
    max_rounds: int = 4096
    max_bounces: int | None = None
    seed: int = 0


@dataclass(frozen=True, kw_only=True)
class Study:
    """Rooms to compare under some skies.

    Parameters
    ----------
    rooms : mapping of label → Room
        The same room with other glazings.
    skies : mapping of label → CieSky
    calculation : Calculation
    text : str
        Of the file, which is kept with the results.
    """

    rooms: Mapping[str, Room]
    skies: Mapping[str, CieSky] = field(default_factory=dict)
    calculation: Calculation = Calculation()
    text: str = ""


@dataclass(frozen=True, kw_only=True)
class Findings:
    """What a study found for one room.

    Parameters
    ----------
    coefficients, daylight_factor : Dataset
    illuminance : Dataset, dims ("sky", "sensor") [lx]
        Of the sky and the sun together; absent without skies.
    """

    coefficients: xr.Dataset
    daylight_factor: xr.Dataset
    illuminance: xr.Dataset | None


def read_study(path: str | os.PathLike[str]) -> Study:
    """The study that a room file describes.

    Parameters
    ----------
    path : path-like
        A room file (docs/how-to/room.md). Its table [calculation] holds the parameters of `daylight_coefficients`, its
        tables [[sky]] the parameters of `CieSky` and a name, its tables [[variant]] a name and other glazings by
        window.

    Raises
    ------
    ClerestoryError
        As `read_room`, and for unknown or wrong values in these tables.
    """
    study = study_of(read_toml(path), where=Path(path).name, folder=Path(path).parent)
    return replace(study, text=Path(path).read_text(encoding="utf-8"))


def study_of(tables: Mapping[str, Any], *, where: str = "the study", folder: Path = Path()) -> Study:
    """The study that the tables of a room file describe; files that they name are looked for in ``folder``."""
    tables = dict(tables)
    room = room_of(tables, where=where, folder=folder)
    calculation: Calculation = build(Calculation, Table(tables.get("calculation", {}), f"[calculation] of {where}"))
    glazing = glazing_tables(Table(tables.get("glazings", {}), f"[glazings] of {where}"), folder)
    rooms = {room.name: room}
    for table in Table(tables, where).tables("variant"):
        name = str(table.take("name"))
        if name in rooms:
            raise ClerestoryError(f"{table.where} must have a name of its own, got {name!r}")
        others = {window: glazing(chosen) for window, chosen in table.table("glazing").values.items()}
        table.finish()
        rooms[name] = room.with_glazing(others)
    skies: dict[str, CieSky] = {}
    for table in Table(tables, where).tables("sky"):
        name = str(table.take("name", f"sky {len(skies) + 1}"))
        if name in skies:
            raise ClerestoryError(f"{table.where} must have a name of its own, got {name!r}")
        skies[name] = _sky(table, room.site)
    return Study(rooms=rooms, skies=skies, calculation=calculation)


def run_study(study: Study, progress: Callable[[str], Progress | None] = lambda _: None) -> dict[str, Findings]:
    """Traces every room of a study.

    Parameters
    ----------
    study : Study
    progress : callable, optional
        Label of a room → what follows its progress.

    Returns
    -------
    dict of label → Findings
    """
    found = {}
    how = study.calculation
    for label, room in study.rooms.items():
        coefficients = daylight_coefficients(
            room,
            basis=how.basis,
            target_relative_error=how.target_relative_error,
            rounds=how.rounds,
            max_rounds=how.max_rounds,
            max_bounces=how.max_bounces,
            seed=how.seed,
            progress=progress(label),
        )
        under = [_under(coefficients, room, sky, how) for sky in study.skies.values()]
        found[label] = Findings(
            coefficients=coefficients,
            daylight_factor=daylight_factor(coefficients),
            illuminance=xr.concat(under, dim=xr.Variable("sky", list(study.skies))) if under else None,
        )
    return found


def summary(findings: Mapping[str, Findings]) -> dict[str, Any]:
    """The numbers that a study comes down to, for a table or JSON."""
    result: dict[str, Any] = {}
    for label, found in findings.items():
        factor = found.daylight_factor.total
        error = found.daylight_factor.total_standard_error
        attributes = found.coefficients.attrs
        relative = (error / factor.where(factor > 0.0)).max()
        result[label] = {
            "daylight_factor_percent": {
                "mean": float(factor.mean()),
                "median": float(factor.median()),
                "least": float(factor.min()),
                "most": float(factor.max()),
                "uniformity": float(factor.min() / factor.mean()) if float(factor.mean()) > 0.0 else None,
                "share_of_sensors_at_least_2_percent": float((factor >= 2.0).mean()),
                "worst_relative_standard_error": None if np.isnan(relative) else float(relative),
            },
            "illuminance_lx": {}
            if found.illuminance is None
            else {
                str(sky): {
                    "mean": float(found.illuminance.total.sel(sky=sky).mean()),
                    "least": float(found.illuminance.total.sel(sky=sky).min()),
                    "most": float(found.illuminance.total.sel(sky=sky).max()),
                }
                for sky in found.illuminance["sky"].values
            },
            "sensors": int(factor.sizes["sensor"]),
            "rounds": int(attributes["rounds"]),
            "cpu_seconds": float(attributes["cpu_seconds"]),
            "converged": bool(attributes["converged"]),
            "interrupted": bool(attributes["interrupted"]),
        }
    return result


def _under(coefficients: xr.Dataset, room: Room, sky: CieSky, how: Calculation) -> xr.Dataset:
    lit = illuminance(coefficients, sky)
    if sky.direct_normal_illuminance_lx > 0.0 and sky.sun_altitude_deg is not None:
        sun = sun_coefficients(room, altitude_deg=sky.sun_altitude_deg, azimuth_deg=sky.sun_azimuth_deg, seed=how.seed)
        beam = sun_illuminance(sun, sky.direct_normal_illuminance_lx).isel(sun=0, drop=True)
        attributes = {name: lit[name].attrs for name in lit.data_vars}
        error = np.hypot(lit.total_standard_error, beam.total_standard_error)
        lit = (lit + beam).assign(total_standard_error=error)
        for name, about in attributes.items():
            lit[name].attrs = about
    return lit


def _sky(table: Table, site: Site | None) -> CieSky:
    """A sky from a table: the parameters of CieSky, or the site's sun at a `time` with a `luminous_turbidity`."""
    time = table.take("time", None)
    turbidity = table.take("luminous_turbidity", None)
    if time is not None:
        if site is None:
            raise ClerestoryError(f"{table.where} must have a [site] in the file for its time, got none")
        for key in ("sun_altitude_deg", "sun_azimuth_deg"):
            if key in table.values:
                raise ClerestoryError(f"{table.where} must have a time or {key}, got both")
        sun = sun_position(site, time)
        altitude = float(sun.apparent_altitude_deg[0])
        if altitude <= 0.0:
            raise ClerestoryError(f"time of {table.where} must be by day, got {time} with the sun at {altitude:.1f}°")
        table.values |= {"sun_altitude_deg": altitude, "sun_azimuth_deg": float(sun.azimuth_deg[0])}
    if turbidity is not None:
        if time is None or site is None:
            raise ClerestoryError(f"luminous_turbidity of {table.where} must come with a time")
        lux = direct_normal_illuminance_lx(site, time, luminous_turbidity=turbidity)
        table.values.setdefault("direct_normal_illuminance_lx", float(lux[0]))
    made: CieSky = build(CieSky, table)
    return made
