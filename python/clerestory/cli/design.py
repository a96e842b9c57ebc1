"""``clerestory design``: the panel that serves an aim best."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn
from rich.table import Table

from clerestory.cli.mistakes import mistakes_told

if TYPE_CHECKING:
    from clerestory.design import Design, Found
    from clerestory.design.search import Trial

_STAGES = {"screen": "panels alone", "search": "search", "compare": "compared"}


def design(
    file: Annotated[Path, typer.Argument(help="Design (TOML): base, bounds, objectives; docs/how-to/design.md.")],
    out: Annotated[
        Path | None, typer.Option(help="Folder for results; the same again goes on. Default out/NAME of the design.")
    ] = None,
    workers: Annotated[int, typer.Option(help="Processes for the cases of a batch; 0 for this one alone.")] = 0,
    scheduler: Annotated[
        str | None, typer.Option(help="Dask scheduler whose workers to use, such as tcp://10.0.0.1:8786.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the answer as JSON and nothing else.")] = False,
) -> None:
    """Choose spacing, thickness, tilt, angles within bounds so that a figure is best, or two at once.

    Needs the extra "design". The answer depends on the file alone; Ctrl-C keeps what is computed, the same command goes
    on.
    """
    with mistakes_told():
        from clerestory.design import read_design, run_design
        from clerestory.design.report import summary, write_report

        asked = read_design(file)
        folder = out or Path("out") / asked.name
        with Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TimeElapsedColumn(),
            TimeRemainingColumn(),
            console=Console(stderr=True),
            disable=as_json,
            transient=True,
        ) as bars:
            tasks: dict[str, Any] = {}

            def follow(stage: str, done: int, total: int, _trial: Trial) -> None:
                if stage not in tasks:
                    tasks[stage] = bars.add_task(_STAGES[stage], total=total)
                bars.update(tasks[stage], completed=done)

            found = run_design(asked, folder, workers=workers, scheduler=scheduler, progress=follow)
        written = write_report(asked, found, folder)
        if as_json:
            told = {**summary(asked, found), "files": [str(path) for path in written]}
            typer.echo(json.dumps(told, indent=2))
            return
        _told(asked, found, written)


def _told(asked: Design, found: Found, written: list[Path]) -> None:
    console = Console()
    count = f"{len(found.trials)} cases" + (f", after {len(found.screened)} panels alone" if found.screened else "")
    table = Table(title=f"{asked.name}: {count}", title_justify="left")
    table.add_column("")
    for parameter in asked.parameters:
        table.add_column(parameter.name, justify="right")
    for objective in asked.objectives:
        table.add_column(f"{objective.label}, {objective.aim}d", justify="right")
    rows = [("best" if row == found.best else "front", found.trials[row]) for row in found.front[:12]]
    for label, trial in [*rows, *found.compared.items()]:
        values = [_short(trial.values[one.name]) for one in asked.parameters]
        figures = [f"{value:.4g}" for value in trial.figures] or [trial.error or ""] + [""] * (
            len(asked.objectives) - 1
        )
        table.add_row(label, *values, *figures)
    console.print(table)
    for label in found.unbeaten:
        console.print(f"{label} is not beaten: more trials may find better", style="yellow", markup=False)
    failed = sum(trial.error is not None for trial in found.trials)
    if failed:
        console.print(f"{failed} cases could not be computed; history.csv says why", style="yellow")
    console.print("written:", *(f"\n  {path}" for path in written), soft_wrap=True, highlight=False)


def _short(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
