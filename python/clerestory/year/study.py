"""A study of a year as one TOML file."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.glazing_table import build, glazing_tables
from clerestory.metrics.lighting_energy import ElectricLighting
from clerestory.metrics.schedule import Schedule
from clerestory.room.scene import Room
from clerestory.room.toml_file import read_toml, room_of
from clerestory.room.toml_table import Table
from clerestory.rules import one_of
from clerestory.site import Site
from clerestory.weather import Weather, read_epw, read_wea
from clerestory.year.calculation import YearCalculation
from clerestory.year.settings import Blinds, Measures
from clerestory.year.window_groups import groups_of

YEAR_TABLES = ("blinds", "calculation", "lighting", "metrics", "room", "schedule", "sky", "title", "variant", "weather")
"""Keys of a year file that are not of the room itself."""

NOT_TAKEN = ("calculation", "sky", "variant")
"""Tables of the file that `room` names which stay there."""

FAR_OFF_DEG = 1.0
"""A [site] farther than this from that of the weather file is a mistake."""


@dataclass(frozen=True, kw_only=True)
class YearStudy:
    """A room with several glazings through a year of weather.

    Parameters
    ----------
    name : str
    variants : mapping of label → Room
    weather : Weather
    schedule : Schedule
        When the room is in use.
    lighting : ElectricLighting, optional
    blinds : tuple of Blinds
    measures : Measures
    calculation : YearCalculation
    text : str
        Of the file, for the report.
    """

    name: str
    variants: Mapping[str, Room]
    weather: Weather
    schedule: Schedule = field(default_factory=Schedule)
    lighting: ElectricLighting | None = None
    blinds: tuple[Blinds, ...] = ()
    measures: Measures = field(default_factory=Measures)
    calculation: YearCalculation = field(default_factory=YearCalculation)
    text: str = ""


def read_year(path: str | os.PathLike[str]) -> YearStudy:
    """The study of a year that a TOML file describes.

    Parameters
    ----------
    path : path-like
        A year file (docs/how-to/year.md): the tables of a room file, or ``room`` with the name of one, and [weather],
        [schedule], [lighting], [[blinds]], [metrics], [calculation] and [[variant]].

    Raises
    ------
    ClerestoryError
        If the file cannot be read, a key is unknown or a value wrong; the message names the table.
    """
    study = year_of(read_toml(path), where=Path(path).name, folder=Path(path).parent)
    text = Path(path).read_text(encoding="utf-8")
    return YearStudy(**{**vars(study), "text": text})


def year_of(tables: Mapping[str, Any], *, where: str = "the study", folder: Path = Path()) -> YearStudy:
    """The study that the tables of a year file describe; files that they name are looked for in ``folder``."""
    tables, room_folder = _with_room_file(dict(tables), where, folder)
    base = room_of(
        {name: table for name, table in tables.items() if name not in YEAR_TABLES}, where=where, folder=room_folder
    )
    weather = _weather(Table(tables.get("weather"), f"[weather] of {where}"), base.site, folder)
    glazing = glazing_tables(Table(tables.get("glazings", {}), f"[glazings] of {where}"), room_folder)
    rooms = {base.name: base}
    for table in Table(tables, where).tables("variant"):
        name = str(table.take("name"))
        if name in rooms:
            raise ClerestoryError(f"{table.where} must have a name of its own, got {name!r}")
        others = {window: glazing(chosen) for window, chosen in table.table("glazing").values.items()}
        table.finish()
        rooms[name] = base.with_glazing(others)
    blinds = tuple(build(Blinds, table) for table in Table(tables, where).tables("blinds"))
    groups_of(base, blinds)
    measures: Measures = build(Measures, Table(tables.get("metrics", {}), f"[metrics] of {where}"))
    groups = [one.name for one in base.sensor_points()]
    for key in ("work_plane", "eyes"):
        if getattr(measures, key) is not None:
            one_of(f"{key} of [metrics] of {where}", getattr(measures, key), groups)
    lighting = tables.get("lighting")
    return YearStudy(
        name=str(tables.get("title", base.name)),
        variants=rooms,
        weather=weather,
        schedule=build(
            Schedule,
            Table({"clock": weather.site.timezone, **tables.get("schedule", {})}, f"[schedule] of {where}"),
        ),
        lighting=None if lighting is None else build(ElectricLighting, Table(lighting, f"[lighting] of {where}")),
        blinds=blinds,
        measures=measures,
        calculation=build(YearCalculation, Table(tables.get("calculation", {}), f"[calculation] of {where}")),
    )


def _with_room_file(tables: dict[str, Any], where: str, folder: Path) -> tuple[dict[str, Any], Path]:
    """The tables with those of the room file beneath them, and the folder that files of the room are in."""
    if "room" not in tables:
        return tables, folder
    named = tables["room"]
    if not isinstance(named, str):
        raise ClerestoryError(f"room of {where} must be the name of a room file, got {named!r}")
    beneath = {name: table for name, table in read_toml(folder / named).items() if name not in NOT_TAKEN}
    return {**beneath, **tables}, (folder / named).parent


def _weather(table: Table, site: Site | None, folder: Path) -> Weather:
    path = folder / str(table.take("file"))
    minutes = table.take("interval_minutes", None)
    if path.suffix.lower() == ".wea":
        table.finish()
        weather = read_wea(path)
    else:
        weather = read_epw(path, **table.rest("timezone"))
    if minutes is not None:
        weather = weather.resampled(minutes)
    if site is not None:
        for name in ("latitude_deg", "longitude_deg"):
            here, there = getattr(site, name), getattr(weather.site, name)
            if abs(here - there) > FAR_OFF_DEG:
                raise ClerestoryError(
                    f"[site] must be where the weather of {path.name} is, got {name} {here:g} for {there:g}; "
                    "leave [site] out or choose another weather file"
                )
    return weather
