"""One variant of a year study, from its tables to its metrics: what sweeps and designs ask for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance
from clerestory.year.group_light import group_light
from clerestory.year.measure import measured
from clerestory.year.study import YearStudy, year_of
from clerestory.year.window_groups import groups_of

Progress = Callable[[str, float], "bool | None"]
"""Told what is done now and which share of all is done, 0..1; False stops."""


def evaluate(tables: Mapping[str, Any], *, where: Path = Path(), progress: Progress | None = None) -> xr.Dataset:
    """The metrics of a year for one variant.

    Parameters
    ----------
    tables : mapping
        Of a year file (`read_year`), with one variant at most: the room with its own glazings, or with those of its
        one [[variant]].
    where : Path
        The folder that paths in the tables refer to.
    progress : callable, optional

    Returns
    -------
    Dataset
        See `clerestory.year.measure.measured`; the figures that are single numbers have no dimension.

    Raises
    ------
    ClerestoryError
        If the tables are wrong, or hold several variants.
    KeyboardInterrupt
        If it is stopped.
    """
    study = year_of(tables, folder=Path(where))
    given = len(tables.get("variant", []))
    if given > 1:
        raise ClerestoryError(f"tables of a case must have one [[variant]] at most, got {given}; choose one")
    label = list(study.variants)[-1]
    groups = groups_of(study.variants[label], study.blinds)

    def step(place: int) -> Progress:
        def told(what: str, share: float) -> bool | None:
            return None if progress is None else progress(what, (place + share) / len(groups))

        return told

    light = {
        name: group_light(study.variants[label], windows, study.weather, study.calculation, step(place))
        for place, (name, windows) in enumerate(groups.items())
    }
    return with_provenance(measured(study, label, light), study, label)


def with_provenance(found: xr.Dataset, study: YearStudy, label: str) -> xr.Dataset:
    """The result with what it was made from."""
    room = study.variants[label]
    return found.assign_attrs(
        provenance(
            study=study.name,
            variant=label,
            weather=study.weather.source,
            weather_notes=list(study.weather.notes),
            latitude_deg=study.weather.site.latitude_deg,
            longitude_deg=study.weather.site.longitude_deg,
            schedule=study.schedule.description,
            blinds=[f"{one.name}: {one.transmittance:g}" for one in study.blinds],
            glazings=[f"{window.name}: {window.glazing!r}" for window in room.windows],
            ground_reflectance=room.ground_reflectance,
            **{f"calculation_{name}": value for name, value in vars(study.calculation).items()},
        )
    )
