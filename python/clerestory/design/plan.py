"""A design as one TOML file: what may vary, what for, how to search."""

from __future__ import annotations

import copy
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from clerestory.design.objective import Objective, read_objective
from clerestory.errors import ClerestoryError
from clerestory.glass import edmonds_panel_tilt_deg
from clerestory.room.toml_file import read_toml
from clerestory.room.toml_table import Table
from clerestory.rules import one_of, within
from clerestory.sweep.axes import Parameter, Values, read_parameters
from clerestory.sweep.dotted import put
from clerestory.sweep.kinds import KINDS
from clerestory.sweep.plan import Case, case_of, read_base

SAMPLERS = ("tpe", "nsga2", "sobol", "random")
"""Tree-structured Parzen estimators, a genetic algorithm for fronts, Sobol points, independent points."""


@dataclass(frozen=True, kw_only=True)
class Screen:
    """The first stage: many panels by themselves, the best of which go on to the room.

    Parameters
    ----------
    panel : str
        Name of the glazing that is designed.
    objective : Objective
        A figure of kind "panel".
    light : mapping
        The table ``light`` of kind "panel".
    trials, best : int
        Panels tried, and how many of them go on.
    """

    panel: str
    objective: Objective
    light: Mapping[str, Any]
    trials: int
    best: int


@dataclass(frozen=True, kw_only=True)
class Design:
    """What may vary within bounds, and what for.

    Parameters
    ----------
    kind : "panel", "room" or "year"
    base : dict
    parameters : tuple of Parameter
        With bounds or a list of values, or tied.
    objectives : tuple of one or two Objective
    trials, batch, seed : int
        How many cases, how many of them are chosen at once, and the seed of the choice.
    sampler : str
    screen : Screen, optional
    tilt : str, optional
        The parameter that is the panel's tilt in its opening; it is compared with Edmonds' rule.
    sun_altitude_deg : float, optional
        Of the sun that Edmonds' rule is for.
    where : Path
    name : str
    """

    kind: str
    base: dict[str, Any] = field(repr=False)
    parameters: tuple[Parameter, ...]
    objectives: tuple[Objective, ...]
    trials: int
    batch: int = 1
    seed: int = 0
    sampler: str = "tpe"
    screen: Screen | None = None
    tilt: str | None = None
    sun_altitude_deg: float | None = None
    where: Path = Path()
    name: str = "design"

    @property
    def free(self) -> tuple[Parameter, ...]:
        """The parameters that are chosen, the tied ones left out."""
        return tuple(one for one in self.parameters if one.of is None)

    @property
    def of_panel(self) -> tuple[Parameter, ...]:
        """The free parameters that the screen can vary: those of its panel, and the tilt."""
        if self.screen is None:
            return ()
        names = (f"glazings.{self.screen.panel}.", f'glazings."{self.screen.panel}".')
        return tuple(one for one in self.free if one.paths[0].startswith(names) or one.name == self.tilt)

    @property
    def edmonds_tilt_deg(self) -> float | None:
        """The panel's tilt by Edmonds' rule, for the design's sun.

        Notes
        -----
        An awning swings its lower edge outwards by the rule's tilt (theory/glass.md, eq. 11); a part of a window counts
        its tilt inwards, so the sign turns.
        """
        if self.sun_altitude_deg is None:
            return None
        return -float(edmonds_panel_tilt_deg(self.sun_altitude_deg))

    def holds(self, values: Values) -> bool:
        """Whether values lie within the bounds of their parameters."""
        return all(
            values[one.name] in one.values if one.values else one.low <= values[one.name] <= one.high
            for one in self.free
            if one.name in values
        )

    def completed(self, chosen: Values) -> Values:
        """Values of all parameters, the tied ones from those that are chosen."""
        values = dict(chosen)
        for one in self.parameters:
            if one.of is not None and one.of in values:
                values[one.name] = one.times * float(values[one.of]) + one.plus
        return values

    def case(self, number: int, chosen: Values) -> Case:
        """The case of some values of the free parameters."""
        values = self.completed(chosen)
        tables = copy.deepcopy(self.base)
        for one in self.parameters:
            for path in one.paths:
                put(tables, path, values[one.name])
        return case_of(number, values, self.kind, tables, self.where)

    def screen_case(self, number: int, chosen: Values) -> Case:
        """The panel alone with some values of its parameters, the others as in the base."""
        assert self.screen is not None
        values = self.completed(chosen)
        tables: dict[str, Any] = {"glazings": copy.deepcopy(self.base.get("glazings", {})), "panel": self.screen.panel}
        light = dict(self.screen.light)
        for one in self.parameters:
            if one.name in values:
                if one.name == self.tilt:
                    light["tilt_deg"] = values[one.name]
                for path in one.paths:
                    if path.startswith("glazings."):
                        put(tables, path, values[one.name])
        return case_of(number, values, "panel", tables | {"light": light}, self.where)


def read_design(path: str | os.PathLike[str]) -> Design:
    """The design that a TOML file describes.

    Parameters
    ----------
    path : path-like
        ``kind`` and ``base`` as of a study (docs/how-to/sweep.md); ``[parameters]`` with ``low`` and ``high`` or
        ``values``; one or two ``[[objective]]``; ``[search]``; perhaps ``[screen]`` and ``[edmonds]``
        (docs/how-to/design.md).

    Raises
    ------
    ClerestoryError
        If it cannot be read, holds an unknown key or lacks one, or a parameter's path leads nowhere.
    """
    file = Path(path)
    return design_of(read_toml(file), where=file.parent, name=file.name)


def design_of(tables: Mapping[str, Any], *, where: Path = Path(), name: str = "the design") -> Design:
    """The design that the tables of a TOML file describe; paths in them refer to the folder ``where``."""
    top = Table(dict(tables), name)
    kind = one_of(f"kind of {name}", top.take("kind"), KINDS)
    base, folder = read_base(top.take("base"), where, top.take("variant", None))
    parameters = read_parameters(top.table("parameters").values, name)
    rows = top.tables("objective")
    if len(rows) not in (1, 2):
        raise ClerestoryError(f"{name} must have one [[objective]] or two for a front, got {len(rows)}")
    objectives = tuple(read_objective(row) for row in rows)
    search = top.table("search")
    trials, batch = _count(search, "trials", 50), _count(search, "batch", 1)
    seed = _count(search, "seed", 0, least=0)
    sampler = one_of(f"sampler of {search.where}", search.take("sampler", "tpe"), SAMPLERS)
    search.finish()
    edmonds = top.take("edmonds", None)
    tilt, altitude = _edmonds(edmonds, parameters, name)
    screen = top.take("screen", None)
    title = str(top.take("name", Path(name).stem))
    top.finish()
    design = Design(
        kind=kind,
        base=base,
        parameters=tuple(parameters),
        objectives=objectives,
        trials=trials,
        batch=batch,
        seed=seed,
        sampler=sampler,
        screen=None if screen is None else _screen(Table(screen, f"[screen] of {name}"), kind, base),
        tilt=tilt,
        sun_altitude_deg=altitude,
        where=folder,
        name=title,
    )
    if not design.free:
        raise ClerestoryError(f"{name} must have a parameter with low and high or values, got none")
    design.case(0, {one.name: one.values[0] if one.values else one.at(0.5) for one in design.free})
    if design.screen is not None and not design.of_panel:
        raise ClerestoryError(f"[screen] of {name} must have parameters of {design.screen.panel!r} to vary, got none")
    return design


def _screen(table: Table, kind: str, base: Mapping[str, Any]) -> Screen:
    if kind == "panel":
        raise ClerestoryError(f"{table.where} must come before a room or a year, got kind panel; leave it out")
    panel = one_of(f"panel of {table.where}", table.take("panel"), base.get("glazings", {}))
    figure = Table({"figure": table.take("figure", "mean_band_transmittance")}, table.where)
    figure.values |= {"aim": table.take("aim", "maximise")}
    trials, best = _count(table, "trials", 200), _count(table, "best", 8)
    light = table.table("light").values
    table.finish()
    return Screen(panel=panel, objective=read_objective(figure), light=light, trials=trials, best=best)


def _edmonds(given: Any, parameters: list[Parameter], name: str) -> tuple[str | None, float | None]:
    if given is None:
        return None, None
    table = Table(given, f"[edmonds] of {name}")
    tilt = one_of(f"tilt of {table.where}", table.take("tilt"), [one.name for one in parameters if one.of is None])
    altitude = within(f"sun_altitude_deg of {table.where}", table.take("sun_altitude_deg"), 0.0, 90.0)
    table.finish()
    return tilt, altitude


def _count(table: Table, name: str, usual: int, least: int = 1) -> int:
    value = table.take(name, usual)
    if isinstance(value, bool) or not isinstance(value, int) or value < least:
        raise ClerestoryError(f"{name} of {table.where} must be a whole number of at least {least}, got {value!r}")
    return int(value)
