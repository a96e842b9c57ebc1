"""The files that a study leaves: coefficients, tables and figures."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from clerestory.room.plan_outline import plan_attributes
from clerestory.saving import table_text, write_whole
from clerestory.study import Findings, Study, summary
from clerestory.sun_coefficients import sun_coefficients

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CEILING_SPACING_M = 0.1
"""Of the grid on which the redirected sun is drawn."""


def write_report(study: Study, findings: Mapping[str, Findings], folder: str | os.PathLike[str]) -> list[Path]:
    """Writes what a study found, each file whole or not at all.

    Parameters
    ----------
    study : Study
    findings : mapping of label → Findings
    folder : path-like
        Made if it is not there.

    Returns
    -------
    list of Path
        `summary.json`; for each room `…-coefficients.nc`, `…-illuminance.nc`, `…-daylight-factor.csv` and a plan; a
        section that compares the rooms; a dome for each sky; the redirected sun on a ceiling that has some.
    """
    target = Path(folder)
    written: list[Path] = []

    def put(name: str, write: Callable[[Path], object]) -> None:
        written.append(write_whole(target / name, write))

    numbers = json.dumps(summary(findings), indent=2) + "\n"
    put("summary.json", partial(Path.write_text, data=numbers, encoding="utf-8"))
    for label, found in findings.items():
        stem = _stem(label)
        made_from = {"variant": label, **plan_attributes(study.rooms[label], study.text)}
        put(f"{stem}-coefficients.nc", partial(_save, found.coefficients.assign_attrs(made_from)))
        put(f"{stem}-daylight-factor.csv", partial(_table, found.daylight_factor.assign_attrs(variant=label)))
        if found.illuminance is not None:
            put(f"{stem}-illuminance.nc", partial(_save, found.illuminance.assign_attrs(made_from)))
    for name, figure in _figures(study, findings):
        put(name, figure.savefig)
    return written


def _figures(study: Study, findings: Mapping[str, Findings]) -> list[tuple[str, Figure]]:
    from clerestory.plots.room_ceiling import room_ceiling
    from clerestory.plots.room_plan import room_plan
    from clerestory.plots.room_section import room_section
    from clerestory.plots.sky_dome import sky_dome

    made: list[tuple[str, Figure]] = []
    grids = {label: _first_grid(found.daylight_factor) for label, found in findings.items()}
    drawn = {label: grid for label, grid in grids.items() if grid is not None}
    for label, grid in drawn.items():
        figure = room_plan(grid.total, room=study.rooms[label], title=f"Daylight factor\n{label}")
        made.append((f"{_stem(label)}-plan.png", figure))
    if drawn:
        curves = {label: grid.total for label, grid in drawn.items()}
        errors = {label: grid.total_standard_error for label, grid in drawn.items()}
        room = next(iter(study.rooms.values()))
        made.append(("section.png", room_section(curves, room=room, standard_errors=errors, threshold=2.0)))
    for sky_name, sky in study.skies.items():
        made.append((f"sky-{_stem(sky_name)}.png", sky_dome(sky, title=f"{sky_name}: {sky.description}")))
        lit = {
            label: sensors.total
            for label, found in findings.items()
            if found.illuminance is not None
            and (sensors := _first_grid(found.illuminance.sel(sky=sky_name, drop=True))) is not None
        }
        if lit:
            room = next(iter(study.rooms.values()))
            made.append((f"section-{_stem(sky_name)}.png", room_section(lit, room=room, title=f"{sky_name}")))
    for label, room in study.rooms.items():
        suns = {
            name: sky
            for name, sky in study.skies.items()
            if sky.direct_normal_illuminance_lx > 0.0 and sky.sun_altitude_deg is not None
        }
        overhead = _ceiling_grid(study, label)
        if not suns or overhead is None:
            continue
        sun = sun_coefficients(
            room,
            overhead,
            altitude_deg=[sky.sun_altitude_deg for sky in suns.values()],
            azimuth_deg=[sky.sun_azimuth_deg for sky in suns.values()],
            seed=study.calculation.seed,
        )
        normal = xr.DataArray([sky.direct_normal_illuminance_lx for sky in suns.values()], dims="sun")
        redirected = (sun.redirected * normal).assign_attrs(units="lx")
        if float(redirected.max()) > 0.0:
            figure = room_ceiling(
                redirected, room=room, labels=list(suns), title=f"Redirected sun on the ceiling: {label}"
            )
            made.append((f"{_stem(label)}-ceiling.png", figure))
    return made


def _ceiling_grid(study: Study, label: str) -> Any:
    from clerestory.room.sensors import SensorGrid
    from clerestory.room.window import normal_of

    surface = next((one for one in study.rooms[label].surfaces if one.name == "ceiling"), None)
    if surface is None:
        return None
    corners = np.array(surface.outline_m)
    longest = float(np.ptp(corners, axis=0).max())
    return SensorGrid(
        surface="ceiling",
        spacing_m=max(CEILING_SPACING_M, longest / 80.0),
        height_m=0.0,
        flip=bool(normal_of(corners)[2] > 0.0),
    )


def _first_grid(table: xr.Dataset) -> xr.Dataset | None:
    """The sensors of the first group that is a grid of at least 2 by 2."""
    for group in dict.fromkeys(table["group"].values.tolist()):
        one: xr.Dataset = table.isel(sensor=np.flatnonzero(table["group"].values == group))
        if min(len(np.unique(one["row"])), len(np.unique(one["column"]))) > 1:
            return one
    return None


def _save(table: xr.Dataset, path: Path) -> None:
    squeezed = {name: {"zlib": True, "complevel": 4} for name in table.data_vars if table[name].size > 10_000}
    table.to_netcdf(path, encoding=squeezed)


def _table(table: xr.Dataset, path: Path) -> None:
    path.write_text(table_text(table), encoding="utf-8", newline="\n")


def _stem(label: str) -> str:
    """A label as part of a file's name."""
    return re.sub(r"[^\w]+", "-", label.lower()).strip("-") or "room"
