"""The light of a year as files of other programs, variant by variant."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from pathlib import Path

import xarray as xr

from clerestory.coefficients import daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.exchange import (
    write_coefficients,
    write_ill,
    write_ladybug_results,
    write_matrix,
    write_pts,
)
from clerestory.exchange.ladybug_results import file_names
from clerestory.rules import one_of
from clerestory.year.group_light import PARTS_OF_LIGHT, Stopped
from clerestory.year.run import pieces_of, store_of
from clerestory.year.study import YearStudy

EXPORTS = {
    "ill": "the year as text, month, day, hour and a column for each sensor, as Daysim writes it",
    "mtx": "the year as a matrix of Radiance's, sensors by intervals [lx]",
    "pts": "the sensors in the same order, for rtrace",
    "ladybug": "the results folder of Ladybug Tools' annual daylight",
    "coefficients": "daylight coefficients for dctimestep, traced once more",
}
"""Forms of an export, and what each is."""


def export_year(study: YearStudy, folder: str | os.PathLike[str], forms: Iterable[str]) -> list[Path]:
    """Writes the light of each variant of a year that was run, blinds open, for other programs.

    Parameters
    ----------
    study : YearStudy
    folder : path-like
        That of `run_year`, with its finished pieces.
    forms : iterable of str
        Of `EXPORTS`.

    Returns
    -------
    list of Path
        In ``folder/export``, for each variant a folder of its name: ``year.ill``, ``year.mtx``, ``year.pts``, the
        folder ``ladybug`` and ``coefficients.mtx``, as asked.

    Raises
    ------
    ClerestoryError
        If a form is unknown, pieces are missing, or a time or a basis has no place in a format.
    KeyboardInterrupt
        If Ctrl-C comes while coefficients are traced.
    """
    asked = checked_exports(study, forms)
    names = file_names(list(study.variants))
    written: list[Path] = []
    for label in study.variants:
        place = Path(folder) / "export" / names[label]
        light = light_of(study, folder, label)
        for form in asked:
            written += _written(study, label, light, form, place)
    return written


def checked_exports(study: YearStudy, forms: Iterable[str]) -> list[str]:
    """The forms, each once, if the study can be written in them; to be asked before any work."""
    asked = list(dict.fromkeys(one_of("export", form, EXPORTS) for form in forms))
    basis = study.calculation.basis
    if "coefficients" in asked and not basis.startswith(("tregenza", "reinhart")):
        raise ClerestoryError(
            f"basis must be tregenza145 or a reinhart basis for coefficients that Radiance reads, got {basis!r}"
        )
    return asked


def light_of(study: YearStudy, folder: str | os.PathLike[str], label: str) -> xr.Dataset:
    """Illuminance of every interval in one variant, blinds open, from the pieces that `run_year` kept.

    Parameters
    ----------
    study : YearStudy
    folder : path-like
        That of `run_year`.
    label : str
        Of the variant.

    Returns
    -------
    Dataset
        `total` and its parts as in `annual_illuminance`, dims ("sensor", "time") [lx].

    Raises
    ------
    ClerestoryError
        If a piece is missing.
    """
    store = store_of(Path(folder))
    keys = [key for which, _, _, key in pieces_of(study) if which == label]
    missing = set(keys) - store.keys()
    if missing:
        raise ClerestoryError(f"{store.folder} must hold all light of {label!r}, got no {min(missing)}: run the year")
    groups = [store.read(key) for key in keys]
    together = xr.Dataset({part: sum(one[part] for one in groups) for part in PARTS_OF_LIGHT})
    for part in PARTS_OF_LIGHT:
        together[part].attrs = dict(groups[0][part].attrs)
    return together


def _written(study: YearStudy, label: str, light: xr.Dataset, form: str, place: Path) -> list[Path]:
    ways: dict[str, Callable[[], list[Path]]] = {
        "ill": lambda: [write_ill(light, place / "year.ill")],
        "mtx": lambda: [_matrix(light, place / "year.mtx")],
        "pts": lambda: [write_pts(light, place / "year.pts")],
        "ladybug": lambda: write_ladybug_results(light, place / "ladybug"),
        "coefficients": lambda: [_coefficients(study, label, place / "coefficients.mtx")],
    }
    return ways[form]()


def _matrix(light: xr.Dataset, path: Path) -> Path:
    values = light["total"].transpose("sensor", "time").values
    return write_matrix(values, path, note="illuminance [lx], sensors by intervals of the year")


def _coefficients(study: YearStudy, label: str, path: Path) -> Path:
    how = study.calculation
    found = daylight_coefficients(
        study.variants[label],
        basis=how.basis,
        rounds=how.rounds,
        nodes=how.nodes,
        window_samples=how.window_samples,
        max_bounces=how.max_bounces,
        seed=how.seed,
    )
    if found.attrs["interrupted"]:
        raise Stopped
    return write_coefficients(found, path)
