"""``clerestory sweep``: the cases of a study, one after another or on many machines."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from clerestory.cli.mistakes import mistakes_told

if TYPE_CHECKING:
    from clerestory.sweep import Sweep, Tally

SHOWN = 20
"""Rows of a table on the screen; the rest is in files."""


def sweep(
    file: Annotated[Path, typer.Argument(help="Study (TOML): kind, base, parameters; docs/how-to/sweep.md.")],
    out: Annotated[
        Path | None, typer.Option(help="Folder for results; the same again goes on. Default out/NAME of the study.")
    ] = None,
    workers: Annotated[
        int | None, typer.Option(help="Processes on this machine; default one a processor, 0 for none but this one.")
    ] = None,
    scheduler: Annotated[
        str | None, typer.Option(help="Dask scheduler whose workers to use, such as tcp://10.0.0.1:8786.")
    ] = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="List the cases and what is done, compute nothing.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print the summary as JSON and nothing else.")] = False,
) -> None:
    """Compute a panel, a room or a year for many values of its parameters.

    Each case is kept as soon as it is done: Ctrl-C keeps what is there, the same command again goes on. A case that
    fails stops no other; exit code 1 says that one did.
    """
    with mistakes_told():
        from clerestory.sweep import read_sweep

        study = read_sweep(file)
        folder = out or Path("out") / study.name
        if dry_run:
            _listed(study, folder, as_json)
            return
        _run(study, folder, workers, scheduler, as_json)


def _run(study: Sweep, folder: Path, workers: int | None, scheduler: str | None, as_json: bool) -> None:
    from clerestory.saving import save
    from clerestory.sweep import gather, run_sweep
    from clerestory.sweep.figures import figures_of
    from clerestory.sweep.gather import write_zarr

    with Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        TextColumn("{task.fields[state]}"),
        console=Console(stderr=True),
        disable=as_json,
        transient=True,
    ) as bars:
        bar = bars.add_task(study.name, total=None, state="")

        def follow(tally: Tally) -> None:
            failed = f", {tally.failed} failed" if tally.failed else ""
            state = f"{_duration(tally.seconds_left())} to go{failed}"
            bars.update(bar, total=tally.tasks, completed=tally.tasks_done, state=state)

        tally = run_sweep(study, folder, workers=workers, scheduler=scheduler, progress=follow)
    written: list[Path] = []
    if tally.done_before + tally.computed:
        found = gather(study, folder)
        figures = figures_of(found)
        written = [write_zarr(found, folder / "results.zarr"), save(figures, folder / "results.csv")]
    if as_json:
        told = {**asdict(tally), "left": tally.left, "files": [str(path) for path in written]}
        typer.echo(json.dumps(told, indent=2, default=str))
    else:
        _told(study, tally, written, folder)
    if tally.interrupted:
        raise typer.Exit(130)
    if tally.failed:
        raise typer.Exit(1)


def _told(study: Sweep, tally: Tally, written: list[Path], folder: Path) -> None:
    console = Console()
    console.print(
        f"{study.name}: {tally.cases} cases, {tally.computed} computed in {_duration(tally.seconds)}, "
        f"{tally.done_before} done before, {tally.failed} failed, {tally.left} left",
        highlight=False,
    )
    for failure in tally.failures[:SHOWN]:
        values = ", ".join(f"{name} = {value}" for name, value in failure["values"].items())
        text = f"failed: case {failure['case']} ({values}): {failure['error']}"
        console.print(text, style="yellow", markup=False, soft_wrap=True)
    if tally.failed > SHOWN:
        console.print(f"… and {tally.failed - SHOWN} more, in {folder / 'failed'}", style="yellow", markup=False)
    if tally.interrupted:
        console.print("stopped: what is done is kept, the same command goes on", style="yellow")
    console.print("written:", *(f"\n  {path}" for path in written), soft_wrap=True, highlight=False)


def _listed(study: Sweep, folder: Path, as_json: bool) -> None:
    from clerestory.sweep.store import Store

    finished = Store(folder).keys()
    if as_json:
        rows = [
            {"case": case.number, "key": case.key, "values": case.values, "done": case.key in finished}
            for case in study.cases
        ]
        typer.echo(json.dumps({"study": study.name, "kind": study.kind, "cases": rows}, indent=2, default=str))
        return
    table = Table(title=f"{study.name}: {len(study.cases)} cases of kind {study.kind}", title_justify="left")
    for heading in ("case", *(one.name for one in study.parameters), "done"):
        table.add_column(heading, justify="right")
    for case in study.cases[:SHOWN]:
        values = (_short(case.values[one.name]) for one in study.parameters)
        table.add_row(str(case.number), *values, "yes" if case.key in finished else "no")
    console = Console()
    console.print(table)
    if len(study.cases) > SHOWN:
        console.print(f"… and {len(study.cases) - SHOWN} more; --json lists them all")


def _short(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def _duration(seconds: float | None) -> str:
    if seconds is None:
        return "–"
    whole = round(seconds)
    if whole < 90:
        return f"{seconds:.1f} s" if seconds < 10.0 else f"{whole} s"
    return f"{whole // 60} min" if whole < 5400 else f"{whole / 3600:.1f} h"
