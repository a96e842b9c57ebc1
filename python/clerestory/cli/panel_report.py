"""The answer to a question about a panel: a table on the screen, or files in a folder."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from clerestory.cli.panel_pictures import pictures
from clerestory.cli.question import Question
from clerestory.compare import Comparison, compare
from clerestory.measured import QUANTITIES, read_measured
from clerestory.panels import Panel
from clerestory.panels.angular import angular
from clerestory.saving import save, write_text

if TYPE_CHECKING:
    import xarray as xr


def report(panel: Panel, question: Question) -> None:
    """Solves, compares, writes and prints what was asked."""
    arguments = question.arguments()
    measured = None if question.measured is None else read_measured(question.measured)
    table = _solved(panel, arguments, question)
    comparisons = {} if measured is None else _compared(panel, arguments, question, measured)
    written = [] if question.out is None else _written(question.out, panel, table, comparisons, question)
    if question.as_json:
        print(json.dumps(_json(panel, table, comparisons, written)))
    else:
        _print(table, comparisons, written)


def _solved(panel: Panel, arguments: dict[str, Any], question: Question) -> xr.Dataset:
    """The table, with a bar on standard error while it takes long."""
    if question.as_json or not sys.stderr.isatty():
        return angular(panel, **arguments)
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bars:
        task = bars.add_task("directions", total=None)
        return angular(panel, **arguments, progress=lambda done, total: bars.update(task, completed=done, total=total))


def _compared(
    panel: Panel, arguments: dict[str, Any], question: Question, measured: xr.Dataset
) -> dict[str, Comparison]:
    """The panel at the very angles that were measured, against the measurement."""
    at = {
        "elevation_deg": np.unique(measured["elevation_deg"].values),
        "azimuth_deg": np.unique(measured["azimuth_deg"].values),
    }
    return compare(_solved(panel, arguments | at, question), measured)


def _written(
    out: Path, panel: Panel, table: xr.Dataset, comparisons: dict[str, Comparison], question: Question
) -> list[Path]:
    written = [
        panel.to_toml(out / "panel.toml"),
        save(table, out / "angular.nc"),
        save(table, out / "angular.csv"),
    ]
    if comparisons:
        numbers = {name: comparison.to_dict() for name, comparison in comparisons.items()}
        written.append(write_text(out / "comparison.json", json.dumps(numbers, indent=2) + "\n"))
    return written + pictures(out, panel, table, comparisons, question)


def _json(panel: Panel, table: xr.Dataset, comparisons: dict[str, Comparison], written: list[Path]) -> dict[str, Any]:
    return {
        "panel": panel.to_dict(),
        "dims": list(map(str, table[QUANTITIES[0]].dims)),
        "coordinates": {str(name): values.values.tolist() for name, values in table.coords.items()},
        "variables": {str(name): values.values.tolist() for name, values in table.data_vars.items()},
        "attributes": table.attrs,
        "comparison": {name: comparison.to_dict() for name, comparison in comparisons.items()},
        "written": [str(path) for path in written],
    }


#: Quantities as the screen has room for them (NOTATION.md).
_HEADINGS = {
    "transmittance": "T",
    "reflectance": "R",
    "absorptance": "A",
    "transmittance_deflected": "T deflected",
    "transmittance_undeflected": "T undeflected",
}
#: Longest table that is printed whole.
_MOST_ROWS = 60


def _print(table: xr.Dataset, comparisons: dict[str, Comparison], written: list[Path]) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console(highlight=False)
    if not written:
        console.print(_rows(table))
    if comparisons:
        shown = Table("against the measurement", "n", "R²", "slope", "rms", "largest", "at", box=None)
        for c in comparisons.values():
            shown.add_row(
                c.quantity,
                str(c.n),
                f"{c.r_squared:.4f}",
                f"{c.slope:.4f}",
                f"{c.rms:.4f}",
                f"{c.largest_difference:+.4f}",
                f"{c.largest_at_elevation_deg:g}°",
            )
        console.print(shown)
    for path in written:
        console.print(f"wrote {path}", soft_wrap=True, markup=False)


def _rows(table: xr.Dataset) -> Any:
    from rich.table import Table

    quantities = [name for name in QUANTITIES if name in table]
    frame = table.to_dataframe().reset_index()
    angles = [name for name in ("elevation", "azimuth", "wavelength") if name in table.dims and table.sizes[name] > 1]
    angles = angles or ["elevation"]
    shown = Table(*angles, *(_HEADINGS.get(name, name) for name in quantities), box=None)
    for column in shown.columns:
        column.justify = "right"
    for _, row in frame.head(_MOST_ROWS).iterrows():
        numbers = [_with_error(row, name) for name in quantities]
        shown.add_row(*(f"{row[name]:g}" for name in angles), *numbers)
    if len(frame) > _MOST_ROWS:
        shown.caption = f"{len(frame) - _MOST_ROWS} more rows: write them with --out"
    return shown


def _with_error(row: Any, name: str) -> str:
    error = row.get(f"{name}_standard_error")
    return f"{row[name]:.4f}" if error is None else f"{row[name]:.4f} ± {error:.4f}"
