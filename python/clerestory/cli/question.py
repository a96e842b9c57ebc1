"""What one asks of a panel on the command line: the options that all kinds of panels share."""

import functools
import inspect
from collections.abc import Callable
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Annotated, Any, Literal, get_type_hints

import typer

from clerestory.cli.angle_list import number_list
from clerestory.panels.optics import ARC_CHORDS, TOLERANCE
from clerestory.panels.panel import RAYS

_LIGHT, _WORK, _RESULTS = "Light", "Method", "Results"


@dataclass(frozen=True, kw_only=True)
class Question:
    """Where light comes from, how to follow it, and where results go: one field an option."""

    elevation: Annotated[
        str,
        typer.Option(
            help="Elevations of incidence in degrees, above 0 from above: start:stop:step (stop counts) or a,b,c.",
            rich_help_panel=_LIGHT,
        ),
    ] = "0:85:5"
    azimuth: Annotated[
        str, typer.Option(help="Azimuths about the panel's y axis in degrees, likewise.", rich_help_panel=_LIGHT)
    ] = "0"
    side: Annotated[
        Literal["front", "back"],
        typer.Option(help="Side that the light meets; front is outside.", rich_help_panel=_LIGHT),
    ] = "front"
    wavelength_nm: Annotated[
        str | None,
        typer.Option(
            help="Wavelengths in nm, likewise; without, daylight as the eye weighs it.", rich_help_panel=_LIGHT
        ),
    ] = None
    polarisation: Annotated[
        Literal["resolved", "averaged"],
        typer.Option(help="Follow s and p apart, or make light unpolarised again at each hit.", rich_help_panel=_LIGHT),
    ] = "resolved"
    method: Annotated[
        Literal["exact", "monte_carlo"],
        typer.Option(help="Exact beams, or rays with standard errors (rough cuts need rays).", rich_help_panel=_WORK),
    ] = "exact"
    rays: Annotated[int, typer.Option(help="Rays for each direction.", rich_help_panel=_WORK)] = RAYS
    seed: Annotated[int, typer.Option(help="Of the random numbers.", rich_help_panel=_WORK)] = 0
    tolerance: Annotated[
        float, typer.Option(help="Share of the power that exact beams may leave unfollowed.", rich_help_panel=_WORK)
    ] = TOLERANCE
    arc_chords: Annotated[
        int, typer.Option(help="Straight facets for an arc, exact method.", rich_help_panel=_WORK)
    ] = ARC_CHORDS
    measured: Annotated[
        Path | None,
        typer.Option(
            help="CSV of measured values to compare with (elevation_deg, transmittance …).", rich_help_panel=_RESULTS
        ),
    ] = None
    out: Annotated[
        Path | None,
        typer.Option(help="Folder for NetCDF, CSV, pictures and the panel's file.", rich_help_panel=_RESULTS),
    ] = None
    section: Annotated[
        float, typer.Option(help="Elevation of the section that is drawn into --out.", rich_help_panel=_RESULTS)
    ] = 50.0
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the results as JSON and nothing else.", rich_help_panel=_RESULTS)
    ] = False

    def arguments(self) -> dict[str, Any]:
        """What :meth:`Panel.angular` is asked."""
        wavelengths = None if self.wavelength_nm is None else number_list("--wavelength-nm", self.wavelength_nm)
        return {
            "elevation_deg": number_list("--elevation", self.elevation),
            "azimuth_deg": number_list("--azimuth", self.azimuth),
            "side": self.side,
            "method": self.method,
            "rays": self.rays,
            "seed": self.seed,
            # one wavelength is no dimension
            "wavelength_nm": wavelengths[0] if wavelengths is not None and len(wavelengths) == 1 else wavelengths,
            "polarisation": self.polarisation,
            "tolerance": self.tolerance,
            "arc_chords": self.arc_chords,
        }


def asked(command: Callable[..., None]) -> Callable[..., None]:
    """Gives a command the options of :class:`Question` in place of its argument ``question``."""
    hints = get_type_hints(Question, include_extras=True)
    shared = {
        field.name: inspect.Parameter(
            field.name, inspect.Parameter.KEYWORD_ONLY, default=field.default, annotation=hints[field.name]
        )
        for field in fields(Question)
    }
    own_hints = get_type_hints(command, include_extras=True)
    own = [
        parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY, annotation=own_hints[name])
        for name, parameter in inspect.signature(command).parameters.items()
        if name != "question"
    ]

    @functools.wraps(command)
    def with_options(**options: Any) -> None:
        question = Question(**{name: options.pop(name) for name in shared})
        command(question=question, **options)

    parameters = [*own, *shared.values()]
    with_options.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    with_options.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    del with_options.__wrapped__
    return with_options
