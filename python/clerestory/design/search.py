"""The search: trial after trial, each chosen from what the earlier ones found."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from clerestory.design.objective import Objective
from clerestory.errors import ClerestoryError
from clerestory.sweep.axes import Parameter, Values


@dataclass(frozen=True, kw_only=True)
class Trial:
    """One set of values, and what it came to.

    Parameters
    ----------
    number : int
    values : dict of parameter → value
        Tied ones included.
    figures : tuple of float
        One for each objective, empty if the case failed.
    error : str or None
    key : str
        Hash of the case.
    """

    number: int
    values: Values
    figures: tuple[float, ...] = ()
    error: str | None = None
    key: str = ""


SEEDS_APART = 1009
"""Between the seeds of one batch and the next; Sobol points are one sequence."""

Evaluate = Callable[[list[tuple[int, Values]]], list[Trial]]
"""Numbers and chosen values → trials, in the same order."""


def search(
    parameters: tuple[Parameter, ...],
    objectives: tuple[Objective, ...],
    evaluate: Evaluate,
    *,
    trials: int,
    batch: int,
    seed: int,
    sampler: str,
    first: list[Values] | None = None,
) -> list[Trial]:
    """Tries values of the parameters until there are so many trials.

    Parameters
    ----------
    parameters : tuple of Parameter
        With bounds or values.
    objectives : tuple of Objective
    evaluate : callable
    trials, batch, seed, sampler
        As of `Design`.
    first : list of dict, optional
        Values to begin with; parameters that they leave out are chosen.

    Returns
    -------
    list of Trial

    Raises
    ------
    ClerestoryError
        If the extra ``design`` is not installed.

    Notes
    -----
    The choice of a batch has a seed of its own and rests on the trials before it alone. So a search that was stopped
    makes the same choices when it runs again, and takes from its store what it had computed: it is resumed by being
    repeated. TPE: J. Bergstra et al., NeurIPS 2011; NSGA-II: K. Deb et al., IEEE Transactions on Evolutionary
    Computation 6(2), 2002.
    """
    optuna = load_optuna()
    spaces = {one.name: _space(optuna, one) for one in parameters}
    made: list[Trial] = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
        study = optuna.create_study(
            directions=["maximize" if one.aim == "maximise" else "minimize" for one in objectives],
            sampler=_sampler(optuna, sampler, seed, batch),
        )
        for values in first or []:
            study.enqueue_trial({name: value for name, value in values.items() if name in spaces})
        while len(made) < trials:
            if sampler != "sobol":
                study.sampler = _sampler(optuna, sampler, seed + SEEDS_APART * len(made), batch)
            asked = [study.ask(spaces) for _ in range(min(batch, trials - len(made)))]
            chosen = [{name: _rounded(value) for name, value in one.params.items()} for one in asked]
            found = evaluate([(one.number, values) for one, values in zip(asked, chosen, strict=True)])
            for one, trial in zip(asked, found, strict=True):
                if trial.error is None:
                    study.tell(one, list(trial.figures))
                else:
                    study.tell(one, state=optuna.trial.TrialState.FAIL)
            made += found
    return made


def load_optuna() -> Any:
    """The optimiser.

    Raises
    ------
    ClerestoryError
        If it is not installed.
    """
    try:
        optuna = import_module("optuna")
    except ImportError:
        raise ClerestoryError(
            "clerestory design needs the extra design, got no package optuna; pip install 'clerestory[design]'"
        ) from None
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    return optuna


def _space(optuna: Any, one: Parameter) -> Any:
    kinds = optuna.distributions
    if one.values:
        for value in one.values:
            if not isinstance(value, (int, float, str, bool)):
                raise ClerestoryError(f"values of parameter {one.name!r} must be numbers or words, got {value!r}")
        return kinds.CategoricalDistribution(list(one.values))
    if one.is_whole:
        return kinds.IntDistribution(round(one.low), round(one.high), log=one.is_log)
    return kinds.FloatDistribution(one.low, one.high, log=one.is_log)


def _sampler(optuna: Any, sampler: str, seed: int, batch: int) -> Any:
    if sampler == "tpe":
        return optuna.samplers.TPESampler(seed=seed, constant_liar=batch > 1)
    if sampler == "nsga2":
        return optuna.samplers.NSGAIISampler(seed=seed, population_size=24)
    if sampler == "sobol":
        return optuna.samplers.QMCSampler(qmc_type="sobol", scramble=True, seed=seed, warn_independent_sampling=False)
    return optuna.samplers.RandomSampler(seed=seed)


def _rounded(value: Any) -> Any:
    """Six digits are more than a workshop needs, and can be read."""
    return float(f"{value:.6g}") if isinstance(value, float) else value
