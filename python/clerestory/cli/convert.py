"""``clerestory convert``: models and results from and for other programs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from clerestory.cli.mistakes import mistakes_told

if TYPE_CHECKING:
    import xarray as xr


def convert(
    source: Annotated[Path, typer.Argument(help="A Honeybee model (.hbjson), or a result (.nc).")],
    target: Annotated[
        Path,
        typer.Argument(
            help="What to make, by its ending: .toml (a room file), .ill (a year as text), .pts (sensors), .mtx "
            "(coefficients for dctimestep), or a folder without ending (results for Ladybug Tools)."
        ),
    ],
    room: Annotated[str | None, typer.Option(help="Of a model: the one room to take.")] = None,
    form: Annotated[str | None, typer.Option(help=".mtx: float, double or ascii; folder: npy or ill.")] = None,
) -> None:
    """Turn a Honeybee model into a room file, or a result into files that other programs read."""
    with mistakes_told():
        written = _model(source, target, room) if target.suffix.lower() == ".toml" else _result(source, target, form)
        Console().print("written:", *(f"\n  {path}" for path in written), soft_wrap=True, highlight=False)


def _model(source: Path, target: Path, room: str | None) -> list[Path]:
    from clerestory.exchange import read_hbjson
    from clerestory.room.toml_text import write_room

    write_room(read_hbjson(source, room=room), target)
    return [target]


def _result(source: Path, target: Path, form: str | None) -> list[Path]:
    from clerestory.errors import ClerestoryError
    from clerestory.exchange import write_coefficients, write_ill, write_ladybug_results, write_pts

    ways: dict[str, Callable[[xr.Dataset], list[Path]]] = {
        ".ill": lambda found: [write_ill(found, target)],
        ".pts": lambda found: [write_pts(found, target)],
        ".mtx": lambda found: [write_coefficients(found, target, form=form or "float")],
        "": lambda found: write_ladybug_results(found, target, form=form or "npy"),
    }
    ending = target.suffix.lower()
    if ending not in ways:
        raise ClerestoryError(
            f"target must end in .toml, .ill, .pts, .mtx or nothing for a folder, got {str(target)!r}"
        )
    return ways[ending](_read(source))


def _read(source: Path) -> xr.Dataset:
    import xarray as xr

    from clerestory.errors import ClerestoryError

    try:
        with xr.open_dataset(source, engine="netcdf4") as found:
            return found.load()
    except (OSError, ValueError) as cause:
        reason = " ".join(str(cause).split())
        raise ClerestoryError(f"{source} must be a result in NetCDF, got: {reason}") from None
