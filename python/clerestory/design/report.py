"""The files that a design leaves: the answer as TOML, the history as table and pictures."""

from __future__ import annotations

import json
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import tomli_w

from clerestory.design.plan import Design
from clerestory.design.run import Found
from clerestory.design.search import Trial
from clerestory.saving import write_text, write_whole
from clerestory.sweep.fingerprint import build


def write_report(design: Design, found: Found, folder: Path) -> list[Path]:
    """Writes what a design found, each file whole or not at all.

    Returns
    -------
    list of Path
        ``best.toml``, the tables of the best case; ``best-panel.toml`` where a panel was screened or is the case;
        ``history.csv`` (and ``screen.csv``), ``summary.json``; ``history.png`` and for two objectives ``pareto.png``.
    """
    best = design.case(found.best, {one.name: found.trials[found.best].values[one.name] for one in design.free})
    written = [write_text(folder / "best.toml", tomli_w.dumps(best.tables))]
    panel = _panel_of(design, best.tables)
    if panel is not None:
        written.append(write_text(folder / "best-panel.toml", tomli_w.dumps(panel)))
    written.append(write_text(folder / "history.csv", _table(design, found)))
    if found.screened:
        rows = [_row(design, trial, ("screen",)) for trial in found.screened]
        written.append(write_text(folder / "screen.csv", str(pd.DataFrame(rows).to_csv(index=False))))
    written.append(write_text(folder / "summary.json", json.dumps(summary(design, found), indent=2) + "\n"))
    for name, figure in _pictures(design, found).items():
        written.append(write_whole(folder / name, partial(_save_figure, figure)))
    return written


def summary(design: Design, found: Found) -> dict[str, Any]:
    """The answer, for JSON."""
    return {
        "design": design.name,
        "kind": design.kind,
        "program": build(),
        "objectives": [{"figure": one.label, "aim": one.aim} for one in design.objectives],
        "best": _told(found.trials[found.best]),
        "front": [_told(found.trials[row]) for row in found.front],
        "compared": {label: _told(trial) for label, trial in found.compared.items()},
        "unbeaten": found.unbeaten,
        "trials": len(found.trials),
        "failed": sum(trial.error is not None for trial in found.trials),
        "screened": len(found.screened),
    }


def _told(trial: Trial) -> dict[str, Any]:
    return {name: value for name, value in asdict(trial).items() if value is not None}


def _table(design: Design, found: Found) -> str:
    rows = [_row(design, trial, tuple(one.label for one in design.objectives)) for trial in found.trials]
    for place, row in enumerate(rows):
        row["on_front"] = place in found.front
        row["stage"] = "search"
    for label, trial in found.compared.items():
        row = _row(design, trial, tuple(one.label for one in design.objectives))
        rows.append(row | {"on_front": False, "stage": label})
    return str(pd.DataFrame(rows).to_csv(index=False, lineterminator="\n"))


def _row(design: Design, trial: Trial, labels: tuple[str, ...]) -> dict[str, Any]:
    figures = trial.figures or (float("nan"),) * len(labels)
    if labels == ("screen",) and design.screen is not None:
        labels = (design.screen.objective.label,)
    return {
        "trial": trial.number,
        **trial.values,
        **dict(zip(labels, figures, strict=True)),
        "error": trial.error or "",
    }


def _panel_of(design: Design, tables: dict[str, Any]) -> dict[str, Any] | None:
    if design.screen is not None:
        chosen = tables["glazings"][design.screen.panel]
    elif design.kind == "panel":
        given = tables["panel"]
        chosen = tables.get("glazings", {}).get(given) if isinstance(given, str) else given
    else:
        return None
    return dict(chosen) if isinstance(chosen, dict) and "kind" in chosen else None


def _pictures(design: Design, found: Found) -> dict[str, Any]:
    from clerestory.plots.design_history import design_history, pareto_front

    columns = len(design.objectives)
    figures = np.array([trial.figures or (np.nan,) * columns for trial in found.trials])
    labels = [one.label for one in design.objectives]
    compared = {label: trial.figures for label, trial in found.compared.items() if trial.error is None}
    from_screen = min(design.screen.best, len(found.trials)) if design.screen is not None else 0
    pictures = {
        "history.png": design_history(
            figures,
            labels=labels,
            signs=[one.sign for one in design.objectives],
            screened=from_screen,
            compared=compared,
            title=design.name,
        )
    }
    if columns == 2:
        pictures["pareto.png"] = pareto_front(
            figures, labels=labels, front=found.front, best=found.best, compared=compared, title=design.name
        )
    return pictures


def _save_figure(figure: Any, draft: Path) -> None:
    figure.savefig(draft)
