"""A design from its file to its answer: panels alone first, then the room, and the rule to compare with."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import numpy as np
import numpy.typing as npt

from clerestory.design.objective import Objective, balanced, front
from clerestory.design.plan import Design
from clerestory.design.search import Trial, load_optuna, search
from clerestory.errors import ClerestoryError
from clerestory.sweep.axes import Parameter, Values
from clerestory.sweep.cluster import on_cluster
from clerestory.sweep.local import in_processes, in_this_process
from clerestory.sweep.plan import Case
from clerestory.sweep.store import Store
from clerestory.sweep.work import Task

Progress = Callable[[str, int, int, Trial], object]
"""Called after each trial with the stage ("screen", "search" or "compare"), trials done, trials in all, and it."""

APART = 0.05
"""Panels that go on to the room differ by at least this share of a parameter's range."""


@dataclass(frozen=True, kw_only=True)
class Found:
    """What a design came to.

    Parameters
    ----------
    screened : list of Trial
        Panels by themselves; empty without a screen.
    trials : list of Trial
    compared : dict of label → Trial
        Edmonds' tilt and no tilt, all else as in the best; empty without ``[edmonds]``.
    unbeaten : list of str
        Labels of ``compared`` that the trials do not beat: a sign that more trials are needed.
    front : list of int
        Places in ``trials`` of those that no other beats: one without ties for one objective.
    best : int
        The best, or of a front the one nearest to the best of both.
    """

    screened: list[Trial] = field(repr=False)
    trials: list[Trial] = field(repr=False)
    compared: dict[str, Trial]
    unbeaten: list[str]
    front: list[int]
    best: int


def run_design(
    design: Design,
    folder: str | os.PathLike[str],
    *,
    workers: int = 0,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Found:
    """Searches for the best values of a design's parameters.

    Parameters
    ----------
    design : Design
    folder : path-like
        Where the results of cases are kept; the same folder again goes on where it stopped.
    workers : int, default 0
        Processes for the cases of a batch; 0 for this one alone.
    scheduler : str, optional
        Address of a Dask scheduler whose workers are used instead.
    progress : callable, optional

    Returns
    -------
    Found

    Raises
    ------
    ClerestoryError
        If the extra ``design`` is not installed, no case can be computed, or an objective is no figure of the cases.

    Notes
    -----
    The result depends on the file alone: not on how many processes computed it, nor on how often it was stopped.
    """
    load_optuna()
    store = Store(Path(folder))
    store.tidy()
    evaluation = partial(_evaluated, store=store, workers=workers, scheduler=scheduler)
    screened: list[Trial] = []
    first: list[Values] = []
    if design.screen is not None:
        aims = (design.screen.objective,)
        screened = search(
            design.of_panel,
            aims,
            partial(
                evaluation,
                case_of=design.screen_case,
                objectives=aims,
                told=partial(_tell, progress, "screen", design.screen.trials),
            ),
            trials=design.screen.trials,
            batch=design.batch,
            seed=design.seed,
            sampler="tpe",
        )
        first = _best_apart(design, screened)
    rule = design.edmonds_tilt_deg
    if design.tilt is not None and rule is not None:
        # the rule and an upright panel are answers too: the search knows them from the start
        middle = {one.name: one.values[0] if one.values else one.at(0.5) for one in design.free}
        first += [middle | (first[0] if first else {}) | {design.tilt: tilt} for tilt in (rule, 0.0)]
        first = [values for values in first if design.holds(values)]
    in_the_room = partial(evaluation, case_of=design.case, objectives=design.objectives)
    trials = search(
        design.free,
        design.objectives,
        partial(in_the_room, told=partial(_tell, progress, "search", design.trials)),
        trials=design.trials,
        batch=design.batch,
        seed=design.seed,
        sampler=design.sampler,
        first=first,
    )
    values, signs = _matrix(trials, len(design.objectives)), [one.sign for one in design.objectives]
    rows = front(values, signs)
    if not rows:
        told = next(trial.error for trial in trials if trial.error is not None)
        raise ClerestoryError(f"{design.name} must have a case that can be computed, got {len(trials)} failed: {told}")
    best = balanced(values, rows, signs)
    compared: dict[str, Trial] = {}
    if design.tilt is not None and rule is not None:
        free = {one.name: trials[best].values[one.name] for one in design.free}
        labels = {f"Edmonds' rule, {-rule:g}° outwards": rule, "no tilt": 0.0}
        asked = [(len(trials) + k, free | {design.tilt: tilt}) for k, tilt in enumerate(labels.values())]
        done = in_the_room(asked, told=partial(_tell, progress, "compare", len(asked)))
        compared = dict(zip(labels, done, strict=True))
    both = _matrix([trials[row] for row in rows] + list(compared.values()), len(design.objectives))
    new = [place - len(rows) for place in front(both, signs) if place >= len(rows)]
    unbeaten = [list(compared)[place] for place in sorted(new)]
    return Found(screened=screened, trials=trials, compared=compared, unbeaten=unbeaten, front=rows, best=best)


def _evaluated(
    asked: list[tuple[int, Values]],
    *,
    case_of: Callable[[int, Values], Case],
    objectives: tuple[Objective, ...],
    store: Store,
    workers: int,
    scheduler: str | None,
    told: Callable[[Trial], object],
) -> list[Trial]:
    cases = [case_of(number, values) for number, values in asked]
    where = {case.key: case for case in cases if not store.path(case.key).exists()}
    errors: dict[str, str] = {}
    for key in list(where):
        failure = store.failure(key)
        if failure is not None:
            # what broke a rule breaks it again
            errors[key] = str(failure["error"])
            del where[key]
    if where:
        tasks = [_task(case) for case in where.values()]
        if scheduler is not None:
            outcomes = on_cluster(tasks, scheduler)
        else:
            outcomes = in_processes(tasks, min(workers, len(tasks))) if workers else in_this_process(tasks)
        for outcome in outcomes:
            if outcome.content is not None:
                store.put(outcome.key, outcome.content)
            else:
                errors[outcome.key] = str(outcome.error)
                if outcome.details is None:
                    store.fail(outcome.key, {"values": where[outcome.key].values, "error": outcome.error})
    made = []
    for case in cases:
        error = errors.get(case.key)
        figures = () if error is not None else _figures(store, case.key, objectives)
        made.append(Trial(number=case.number, values=case.values, figures=figures, error=error, key=case.key))
        told(made[-1])
    return made


def _figures(store: Store, key: str, objectives: tuple[Objective, ...]) -> tuple[float, ...]:
    found = store.read(key)
    return tuple(one.of(found) for one in objectives)


def _task(case: Case) -> Task:
    return Task(key=case.key, kind=case.kind, tables=case.tables, files=case.files, where=str(case.where.resolve()))


def _tell(progress: Progress | None, stage: str, total: int, trial: Trial) -> None:
    if progress is not None:
        progress(stage, trial.number + 1 if stage != "compare" else total, total, trial)


def _matrix(trials: list[Trial], columns: int) -> npt.NDArray[np.float64]:
    return np.array([trial.figures or (np.nan,) * columns for trial in trials], dtype=np.float64)


def _best_apart(design: Design, screened: list[Trial]) -> list[Values]:
    """The best panels, each apart from those before it: neighbours would tell the room the same."""
    assert design.screen is not None
    sign = design.screen.objective.sign
    ranked = sorted((trial for trial in screened if trial.error is None), key=lambda trial: -sign * trial.figures[0])
    kept: list[Trial] = []
    for trial in ranked:
        if all(_distance(design.of_panel, trial.values, other.values) >= APART for other in kept):
            kept.append(trial)
        if len(kept) == design.screen.best:
            break
    names = [one.name for one in design.of_panel]
    return [{name: trial.values[name] for name in names} for trial in kept]


def _distance(parameters: tuple[Parameter, ...], one: Values, other: Values) -> float:
    """Largest difference of a parameter, as a share of its range."""
    shares = []
    for parameter in parameters:
        a, b = one[parameter.name], other[parameter.name]
        if parameter.values:
            shares.append(0.0 if a == b else 1.0)
        elif parameter.is_log:
            shares.append(abs(float(np.log(a / b))) / float(np.log(parameter.high / parameter.low)))
        else:
            shares.append(abs(a - b) / (parameter.high - parameter.low))
    return max(shares)
