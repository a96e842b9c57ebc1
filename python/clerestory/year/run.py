"""All variants of a year study, each piece kept when it is done, so that a study that was stopped goes on."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import xarray as xr

from clerestory.provenance import provenance
from clerestory.saving import write_whole
from clerestory.sweep.store import Store
from clerestory.year.evaluate import with_provenance
from clerestory.year.group_light import PARTS_OF_LIGHT, Stopped, group_light, key_of_light
from clerestory.year.measure import measured
from clerestory.year.study import YearStudy
from clerestory.year.window_groups import groups_of


@dataclass(frozen=True, kw_only=True)
class State:
    """How far a run is.

    Parameters
    ----------
    variant, what : str
        Which variant and which part of it is being computed.
    done : float, 0..1
        Share of all pieces, those found finished included.
    seconds_left : float
        By the pace so far; NaN while there is none.
    """

    variant: str
    what: str
    done: float
    seconds_left: float


Follow = Callable[[State], "bool | None"]
"""Told how far a run is; False stops it."""


def run_year(study: YearStudy, folder: Path | None = None, follow: Follow = lambda _: None) -> dict[str, xr.Dataset]:
    """Traces and measures every variant of a study.

    Parameters
    ----------
    study : YearStudy
    folder : Path, optional
        Where finished pieces are kept, each in a file that is there whole or not at all. Run again with it, a study
        goes on after the last finished piece; pieces of other inputs or of another program are not taken.
    follow : callable, optional

    Returns
    -------
    dict of label → Dataset
        See `clerestory.year.measure.measured`.

    Raises
    ------
    KeyboardInterrupt
        If ``follow`` says False, or Ctrl-C comes: finished pieces stay.
    """
    store = None if folder is None else store_of(folder)
    plan = pieces_of(study)
    keys = list(dict.fromkeys(key for *_, key in plan))
    known = set() if store is None else store.keys() & set(keys)
    pace = _Pace(total=len(keys), found=len(known), follow=follow)
    held: dict[str, xr.Dataset] = {}
    result: dict[str, xr.Dataset] = {}
    for label, room in study.variants.items():
        light: dict[str, xr.Dataset] = {}
        for which, group, windows, key in plan:
            if which != label:
                continue
            if key not in held:
                if store is not None and key in known:
                    held[key] = store.read(key)
                else:
                    held[key] = group_light(room, windows, study.weather, study.calculation, pace.step(label, group))
                    if store is not None:
                        _keep(store, key, held[key].assign_attrs(provenance(key=key)))
                    pace.finished += 1
            light[group] = held[key]
        if pace.tell(label, "metrics", 0.0) is False:
            raise Stopped
        result[label] = with_provenance(measured(study, label, light), study, label)
    return result


def store_of(folder: Path) -> Store:
    """Where the pieces of a study are kept."""
    return Store(Path(folder) / "pieces")


def pieces_of(study: YearStudy) -> list[tuple[str, str, tuple[str, ...], str]]:
    """What a study is made of: variant, group of windows, their names, and the key that its light is kept by."""
    return [
        (label, group, windows, key_of_light(room, windows, study.weather, study.calculation, [study.text, label]))
        for label, room in study.variants.items()
        for group, windows in groups_of(room, study.blinds).items()
    ]


class _Pace:
    """Counts pieces, and says how long the rest will take."""

    def __init__(self, *, total: int, found: int, follow: Follow) -> None:
        self.total, self.found, self.finished = total, found, 0
        self.follow = follow
        self.started = time.monotonic()

    def tell(self, variant: str, what: str, share: float) -> bool | None:
        computed = self.finished + share
        left = self.total - self.found - computed
        seconds = (time.monotonic() - self.started) / computed * left if computed > 0.0 else float("nan")
        done = (self.found + computed) / self.total
        return self.follow(State(variant=variant, what=what, done=done, seconds_left=seconds))

    def step(self, variant: str, group: str) -> Callable[[str, float], bool | None]:
        return lambda what, share: self.tell(variant, f"{what}, {group}", share)


def _keep(store: Store, key: str, light: xr.Dataset) -> None:
    squeezed: dict[str, Any] = {name: {"zlib": True, "complevel": 1} for name in PARTS_OF_LIGHT}
    write_whole(store.path(key), lambda draft: light.to_netcdf(draft, engine="netcdf4", encoding=squeezed))
