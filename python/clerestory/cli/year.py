"""`clerestory year`: a room with several glazings through a year of weather."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console
from rich.table import Table

from clerestory.cli.mistakes import mistakes_told
from clerestory.cli.stated_progress import stated_progress


def year(
    file: Annotated[Path, typer.Argument(help="Year file (TOML): weather, room, glazings to compare, schedule.")],
    out: Annotated[
        Path, typer.Option(help="Folder for NetCDF, CSV and the report; finished pieces are kept in it.")
    ] = Path("out"),
    seed: Annotated[int | None, typer.Option(help="Of the random numbers, instead of the file's.")] = None,
    suns: Annotated[
        str | None, typer.Option(help="Places of the sun, instead of the file's: exact, troplux5221 …")
    ] = None,
    export: Annotated[
        list[str] | None,
        typer.Option(
            help="Also write the light of each variant, blinds open, into OUT/export for other programs: ill, mtx, "
            "pts, ladybug, coefficients. Can be given several times."
        ),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the figures as JSON and nothing else.")] = False,
) -> None:
    """Daylight of a year: metrics of each variant, compared in one report.

    Ctrl-C stops; what is finished is kept, and the same command goes on from there.
    """
    with mistakes_told():
        _run(file, out, seed, suns, export or [], as_json, Console(stderr=True))


def _run(
    file: Path, out: Path, seed: int | None, suns: str | None, export: list[str], as_json: bool, errors: Console
) -> None:
    import warnings
    from dataclasses import replace

    from clerestory.year import State, export_year, read_year, run_year, write_year
    from clerestory.year.compared import table_rows
    from clerestory.year.export import checked_exports

    study = read_year(file)
    changed: dict[str, Any] = {k: v for k, v in {"seed": seed, "suns": suns}.items() if v is not None}
    study = replace(study, calculation=replace(study.calculation, **changed))
    exports = checked_exports(study, export)
    done = 0.0
    with (
        warnings.catch_warnings(record=True) as told,
        stated_progress(errors, hidden=as_json) as bars,
    ):
        warnings.simplefilter("always")
        task = bars.add_task(study.name, total=1.0, state="")

        def follow(state: State) -> None:
            nonlocal done
            done = state.done
            left = "" if state.seconds_left != state.seconds_left else f", {state.seconds_left:.0f} s to go"
            bars.update(task, completed=state.done, state=f"{state.variant}: {state.what}{left}")

        try:
            results = run_year(study, out, follow)
            bars.update(task, state="pictures and report")
            written = write_year(study, results, out)
            if exports:
                bars.update(task, state="files for other programs")
                written += export_year(study, out, exports)
        except KeyboardInterrupt:
            bars.stop()
            errors.print(
                f"clerestory: stopped with {100 * done:.0f} % done; finished pieces are in {out}, "
                "the same command goes on",
                markup=False,
                soft_wrap=True,
            )
            raise typer.Exit(130) from None
    for warning in told:
        if issubclass(warning.category, UserWarning):
            errors.print(f"clerestory: warning: {warning.message}", style="yellow", markup=False, soft_wrap=True)
    if as_json:
        typer.echo(json.dumps({"figures": table_rows(results), "files": [str(path) for path in written]}, indent=2))
        return
    console = Console()
    console.print(_table(study.name, results))
    console.print("written:", *(f"\n  {path}" for path in written), soft_wrap=True, highlight=False)


def _table(name: str, results: dict[str, Any]) -> Table:
    from clerestory.year.figures import asked_for, text_of

    table = Table(title=f"{name}: a year of daylight", title_justify="left")
    table.add_column("")
    for label in results:
        table.add_column(label, justify="right")
    for figure in asked_for(results):
        unit = f" [{figure.unit}]" if figure.unit else ""
        # brackets are markup to the console
        table.add_row(f"{figure.label}{unit}".replace("[", r"\["), *(text_of(one, figure) for one in results.values()))
    return table
