"""The folder of an annual daylight study as Ladybug Tools lays it out."""

from __future__ import annotations

import json
import os
import re
from functools import partial
from pathlib import Path

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.exchange.annual_ill import illuminance_of
from clerestory.exchange.clock_times import hours_of_year, interval_h, local_times
from clerestory.exchange.points_file import write_pts
from clerestory.rules import one_of
from clerestory.saving import write_text, write_whole

STATIC = "__static_apertures__/default"
"""Where the light through apertures without states is."""


def write_ladybug_results(annual: xr.Dataset, folder: str | os.PathLike[str], *, form: str = "npy") -> list[Path]:
    """Writes a year of illuminance as the results of Ladybug Tools' recipe *annual daylight*.

    Parameters
    ----------
    annual : Dataset of `annual_illuminance`, dims ("sensor", "time") [lx]
        `total`, and `sun_direct` where it is there; sensors in groups.
    folder : path-like
        Of the results; made if need be.
    form : "npy" or "ill", default "npy"
        ``npy``, as recipes of today write and read: ``__static_apertures__/default/total`` and ``…/direct``, an array
        of sensors by sun-up hours for each grid. ``ill``, as older ones: text of the same shape, `GRID.ill`, in the
        folder itself.

    Returns
    -------
    list of Path
        With ``grids_info.json``, ``sun-up-hours.txt`` (hours of the year at which the intervals begin and any sensor
        is lit), ``study_info.json``, ``grid_states.json`` and a ``.pts`` file for each grid.

    Raises
    ------
    ClerestoryError
        If variables are missing, a time falls on 29 February, or a file cannot be written.

    Notes
    -----
    `direct` is the light of the sun that no diffuse surface has met: `sun_direct` and `sun_redirected` together.
    """
    one_of("form", form, ("npy", "ill"))
    target = Path(folder)
    total = illuminance_of(annual, "total")
    suns = [illuminance_of(annual, name) for name in ("sun_direct", "sun_redirected") if name in annual]
    direct = np.sum(suns, axis=0) if suns else None
    times = local_times(annual)
    step = interval_h(times)
    # the formats name an interval by its beginning; an hour is as good as its third decimal of a minute
    begins = np.round(hours_of_year(times) - step / 2.0, 6)
    if (begins < -1e-9).any() or len(np.unique(begins)) < len(begins):
        raise ClerestoryError("times must be the middles of intervals within one year, got some twice or before it")
    lit = total.max(axis=0) > 0.0
    order = np.flatnonzero(lit)[np.argsort(begins[lit], kind="stable")]
    if not order.size:
        raise ClerestoryError("total must be above 0 in at least one interval, got a year without light")
    groups = annual["group"].values.astype(str) if "group" in annual.coords else np.full(len(total), "sensors")
    names = file_names(list(dict.fromkeys(groups.tolist())))

    written: list[Path] = []
    info = []
    for group, name in names.items():
        own = groups == group
        info.append(
            {
                "count": int(own.sum()),
                "name": group,
                "identifier": name,
                "group": "",
                "full_id": name,
                "light_path": [["__static_apertures__"]],
            }
        )
        parts = {"total": total} if direct is None else {"total": total, "direct": direct}
        for part, values in parts.items():
            rows = values[own][:, order].astype(np.float32)
            if form == "npy":
                place = target / STATIC / part / f"{name}.npy"
                written.append(write_whole(place, partial(_save_array, rows)))
            elif part == "total":
                text = "".join("\t".join(f"{value:.7e}" for value in row) + "\n" for row in rows.tolist())
                written.append(write_text(target / f"{name}.ill", text))
        if "x_m" in annual.coords:
            written.append(write_pts(annual.isel(sensor=np.flatnonzero(own)), target / "grid" / f"{name}.pts"))
    # JSON last: a reader that finds it finds the rest
    per_hour = round(1.0 / step) if step <= 1.0 else 1
    hours = {"timestep": per_hour, "study_hours": np.sort(begins).tolist()}
    text = "".join(f"{hour!r}\n" for hour in begins[order].tolist())
    written.append(write_text(target / "sun-up-hours.txt", text))
    written.append(write_text(target / "study_info.json", json.dumps(hours) + "\n"))
    written.append(write_text(target / "grid_states.json", "{}\n"))
    written.append(write_text(target / "grids_info.json", json.dumps(info, indent=2) + "\n"))
    return written


def _save_array(rows: np.ndarray[tuple[int, int], np.dtype[np.float32]], draft: Path) -> None:
    with draft.open("wb") as file:
        np.save(file, rows, allow_pickle=False)


def file_names(groups: list[str]) -> dict[str, str]:
    """Names of groups as names of files that every system takes, each of its own."""
    names: dict[str, str] = {}
    for group in groups:
        stem = re.sub(r"[^A-Za-z0-9_-]+", "_", group).strip("_") or "grid"
        taken = set(names.values())
        names[group] = next(
            name for k in range(1, len(groups) + 1) if (name := stem if k == 1 else f"{stem}_{k}") not in taken
        )
    return names
