"""`clerestory room`: daylight in the room of a file."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console
from rich.table import Table

from clerestory.cli.mistakes import mistakes_told
from clerestory.cli.stated_progress import stated_progress


def room(
    file: Annotated[Path, typer.Argument(help="Room file (TOML): scene, sensors, skies, glazings to compare.")],
    out: Annotated[Path, typer.Option(help="Folder for NetCDF, CSV and PNG files; made if need be.")] = Path("out"),
    basis: Annotated[
        str | None, typer.Option(help="Sky basis, instead of the file's: tregenza145, reinhart577 …")
    ] = None,
    target_relative_error: Annotated[
        float | None, typer.Option(help="Standard error to reach at every sensor, instead of the file's: 0.02 is 2 %.")
    ] = None,
    seed: Annotated[int | None, typer.Option(help="Of the random numbers, instead of the file's.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the summary as JSON and nothing else.")] = False,
) -> None:
    """Daylight coefficients, daylight factor and illuminance in a room.

    Ctrl-C ends the tracing early and keeps what is there so far.
    """
    with mistakes_told():
        _run(file, out, basis, target_relative_error, seed, as_json, Console(stderr=True))


def _run(
    file: Path,
    out: Path,
    basis: str | None,
    target_relative_error: float | None,
    seed: int | None,
    as_json: bool,
    errors: Console,
) -> None:
    import warnings
    from dataclasses import replace

    from clerestory.study import read_study, run_study, summary
    from clerestory.study_report import write_report

    study = read_study(file)
    asked = {"basis": basis, "target_relative_error": target_relative_error, "seed": seed}
    changed: dict[str, Any] = {name: value for name, value in asked.items() if value is not None}
    study = replace(study, calculation=replace(study.calculation, **changed))
    with (
        warnings.catch_warnings(record=True) as told,
        stated_progress(errors, hidden=as_json) as bars,
    ):
        warnings.simplefilter("always")

        def follow(label: str) -> Any:
            task = bars.add_task(label, total=None, state="")

            def step(done: int, expected: int, worst: float, seconds: float) -> None:
                left = seconds / done * (expected - done) if done else float("nan")
                state = f"round {done} of about {expected}, worst error {100.0 * worst:.1f} %, {left:.0f} s to go"
                bars.update(task, completed=done, total=max(expected, done), state=state)

            return step

        findings = run_study(study, follow)
        written = write_report(study, findings, out)
    for warning in told:
        if issubclass(warning.category, UserWarning):
            errors.print(f"clerestory: warning: {warning.message}", style="yellow", markup=False, soft_wrap=True)
    numbers = summary(findings)
    if as_json:
        typer.echo(json.dumps({"rooms": numbers, "files": [str(path) for path in written]}, indent=2))
        return
    console = Console()
    console.print(_factors(numbers))
    if study.skies:
        console.print(_levels(numbers, list(study.skies)))
    for label, row in numbers.items():
        if row["interrupted"]:
            console.print(f"{label}: interrupted, the results are those of {row['rounds']} rounds", style="yellow")
        elif not row["converged"]:
            console.print(f"{label}: the target was not reached in {row['rounds']} rounds", style="yellow")
    console.print("written:", *(f"\n  {path}" for path in written), soft_wrap=True, highlight=False)


def _factors(numbers: dict[str, Any]) -> Table:
    table = Table(title="Daylight factor in %", title_justify="left")
    for heading in ("", "mean", "least", "most", "min/mean", "≥ 2 %", "error ≤", "CPU"):
        table.add_column(heading, justify="left" if heading == "" else "right")
    for label, row in numbers.items():
        factor = row["daylight_factor_percent"]
        error, even = factor["worst_relative_standard_error"], factor["uniformity"]
        table.add_row(
            label,
            *(f"{factor[name]:.2f}" for name in ("mean", "least", "most")),
            "–" if even is None else f"{even:.2f}",
            f"{100.0 * factor['share_of_sensors_at_least_2_percent']:.0f} %",
            "–" if error is None else f"{100.0 * error:.1f} %",
            f"{row['cpu_seconds']:.1f} s",
        )
    return table


def _levels(numbers: dict[str, Any], skies: list[str]) -> Table:
    table = Table(title="Illuminance in lx: mean (least–most)", title_justify="left")
    table.add_column("")
    for sky in skies:
        table.add_column(sky, justify="right")
    for label, row in numbers.items():
        cells = [row["illuminance_lx"][sky] for sky in skies]
        table.add_row(label, *(f"{cell['mean']:.0f} ({cell['least']:.0f}–{cell['most']:.0f})" for cell in cells))
    return table
