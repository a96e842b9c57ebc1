"""``clerestory bsdf``: files of what a window element does to light, checked, told, turned and drawn."""

from __future__ import annotations

import json
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from clerestory.cli.mistakes import mistakes_told

if TYPE_CHECKING:
    from clerestory.bsdf import Bsdf

bsdf = typer.Typer(
    help="BSDF files (LBNL XML, NetCDF): make them of panels, check, describe, convert and draw them.",
    no_args_is_help=True,
)

File = Annotated[Path, typer.Argument(help="LBNL XML, or NetCDF as written here.", metavar="FILE")]
Json = Annotated[bool, typer.Option("--json", help="Print the results as JSON and nothing else.")]
Basis = Annotated[
    Literal["klems_full", "klems_half", "klems_quarter"] | None,
    typer.Option(help="Klems basis of the result; matrices keep theirs and trees stay trees without."),
]
Direction = Annotated[
    Literal["transmission_front", "transmission_back", "reflection_front", "reflection_back"],
    typer.Option(help="Which block; front is the outside."),
]


@bsdf.command("check")
def check(file: File, as_json: Json = False) -> None:
    """What may be wrong with a file, in plain words; exit code 1 if something is."""
    with mistakes_told(), _warnings_told(as_json):
        findings = _read(file, strict=False).check()
        if as_json:
            print(json.dumps([vars(finding) for finding in findings], indent=2))
        else:
            for finding in findings:
                print(finding)
            if not findings:
                print("nothing found: energy, reciprocity and sides are as they should be")
    if any(finding.severity == "error" for finding in findings):
        raise typer.Exit(1)


@bsdf.command("info")
def info(file: File, as_json: Json = False) -> None:
    """What a file holds: product, bands, bases, and the shares of light that pass and come back."""
    from clerestory.bsdf.summary import lines, summary

    with mistakes_told(), _warnings_told(as_json):
        found = _read(file)
        print(json.dumps(summary(found), indent=2) if as_json else "\n".join(lines(found)))


@bsdf.command("convert")
def convert(
    file: File,
    out: Annotated[
        Path, typer.Argument(help="To write: .xml, .nc, .mtx (Radiance), .epJSON or .idf (EnergyPlus).", metavar="OUT")
    ],
    basis: Basis = None,
    name: Annotated[str | None, typer.Option(help="Of the product, instead of the file's.")] = None,
    manufacturer: Annotated[str | None, typer.Option(help="Likewise.")] = None,
    thickness_mm: Annotated[float | None, typer.Option(help="Likewise; XML and EnergyPlus must have one.")] = None,
    band: Annotated[Literal["visible", "solar", "x", "z"], typer.Option(help="For .mtx.")] = "visible",
    direction: Direction = "transmission_front",
    as_json: Json = False,
) -> None:
    """Write a file in another format, basis or name."""
    from dataclasses import replace

    from clerestory.bsdf.writing import write_bsdf

    with mistakes_told(), _warnings_told(as_json):
        found = _read(file)
        changed = {"name": name, "manufacturer": manufacturer, "thickness_mm": thickness_mm}
        given: dict[str, Any] = {key: value for key, value in changed.items() if value is not None}
        found = replace(found, **given)
        written = write_bsdf(found if basis is None else found.in_basis(basis), out, band=band, direction=direction)
        print(json.dumps({"written": str(written)}) if as_json else f"written: {written}")


@bsdf.command("make")
def make(
    panel: Annotated[
        Path, typer.Argument(help="Of a panel, as written by clerestory panel --out.", metavar="PANEL.toml")
    ],
    out: Annotated[Path, typer.Option(help="To write: .xml, .nc, .mtx, .epJSON or .idf.")],
    basis: Basis = None,
    rank: Annotated[int | None, typer.Option(help="3 or 4: tensor trees instead of matrices.")] = None,
    log2_resolution: Annotated[int | None, typer.Option(help="Finest cells of trees: 5 is 2^5 a side.")] = None,
    name: Annotated[str | None, typer.Option(help="Of the product.")] = None,
    manufacturer: Annotated[str | None, typer.Option(help="Of the product.")] = None,
    as_json: Json = False,
) -> None:
    """The BSDF of a panel, as a file that Radiance, WINDOW and EnergyPlus read."""
    from dataclasses import replace

    from clerestory.bsdf.summary import lines, summary
    from clerestory.bsdf.writing import write_bsdf
    from clerestory.panels import read_panel

    with mistakes_told(), _warnings_told(as_json):
        asked: dict[str, Any] = {"basis": basis, "rank": rank, "log2_resolution": log2_resolution}
        made = read_panel(panel).bsdf(**{key: value for key, value in asked.items() if value is not None})
        called: dict[str, Any] = {"name": name, "manufacturer": manufacturer}
        made = replace(made, **{key: value for key, value in called.items() if value})
        written = write_bsdf(made, out)
        if as_json:
            print(json.dumps({**summary(made), "written": str(written)}, indent=2))
        else:
            print("\n".join([*lines(made), f"written: {written}"]))


@bsdf.command("plot")
def plot(
    file: File,
    out: Annotated[Path, typer.Option(help="Folder for PNG and SVG files; made if need be.")] = Path("out"),
    elevation: Annotated[
        float, typer.Option(help="Where the light of the first two pictures comes from: degrees above the normal.")
    ] = 40.0,
    azimuth: Annotated[float, typer.Option(help="Likewise: degrees about the vertical, above 0 from the left.")] = 0.0,
    band: Annotated[Literal["visible", "solar", "x", "z"], typer.Option(help="Which band.")] = "visible",
    side: Annotated[
        Literal["front", "back"], typer.Option(help="Side that the light meets; front is outside.")
    ] = "front",
    as_json: Json = False,
) -> None:
    """Draw a file: the light of one incidence on discs and in a plane, and shares against incidence."""
    from clerestory import plots
    from clerestory.cli.panel_pictures import save_figure

    with mistakes_told(), _warnings_told(as_json):
        found = _read(file)
        at: dict[str, Any] = {"elevation_deg": elevation, "azimuth_deg": azimuth, "band": band, "side": side}
        written = [
            *save_figure(plots.bsdf_discs(found, **at), out / "bsdf_discs"),
            *save_figure(plots.bsdf_cut(found, **at), out / "bsdf_cut"),
            *save_figure(plots.bsdf_shares(found, band=band), out / "bsdf_shares"),
        ]
        if as_json:
            print(json.dumps({"written": [str(path) for path in written]}, indent=2))
        else:
            print("\n".join(f"written: {path}" for path in written))


def _read(file: Path, *, strict: bool = True) -> Bsdf:
    from clerestory.bsdf.reading import read_bsdf

    return read_bsdf(file, strict=strict)


@contextmanager
def _warnings_told(quiet: bool) -> Iterator[None]:
    """What a file does not say, in lines on standard error."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        yield
    for warning in told:
        if issubclass(warning.category, UserWarning) and not quiet:
            print(f"clerestory: warning: {' '.join(str(warning.message).split())}", file=sys.stderr)
