"""``clerestory panel``: what a panel does to light, from its sizes or its file."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, Literal

import typer
from typer.core import TyperGroup

from clerestory.cli.angle_list import number_list
from clerestory.cli.mistakes import mistakes_told
from clerestory.cli.question import Question, asked
from clerestory.errors import ClerestoryError
from clerestory.medium import Medium, medium_names
from clerestory.panels import LaserCutPanel, Pane, Panel, PrismaticPanel, read_panel
from clerestory.rules import one_of

_FILE = "FILE.toml"
_SIZES = "Panel"


class KindOrFile(TyperGroup):
    """A group in which a word that is no command is the file of a panel."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """The command of the first word, or the one that reads files."""
        if args and args[0] not in self.commands:
            args = [_FILE, *args]
        return super().resolve_command(ctx, args)


panel = typer.Typer(
    cls=KindOrFile,
    help="Where a panel sends light: angular tables, pictures, comparison with measurements.",
    no_args_is_help=True,
)

MediumWord = Annotated[
    str | None,
    typer.Option(
        help=f"{', '.join(medium_names())}, or an index of refraction. [default: as in the API]",
        rich_help_panel=_SIZES,
        show_default=False,
    ),
]
Absorption = Annotated[
    float | None, typer.Option(help="Absorption per mm, instead of the medium's.", rich_help_panel=_SIZES)
]


@panel.command("laser-cut")
@asked
def laser_cut(
    question: Question,
    spacing_mm: Annotated[str, typer.Option(help="From cut to cut; a,b,c repeats.", rich_help_panel=_SIZES)],
    thickness_mm: Annotated[float, typer.Option(help="Of the sheet.", rich_help_panel=_SIZES)],
    cut_width_mm: Annotated[float, typer.Option(help="Of the kerf; 0 is ideal.", rich_help_panel=_SIZES)] = 0.0,
    cut_tilt_deg: Annotated[
        str, typer.Option(help="Above 0 if cuts rise towards the room; a,b,c repeats.", rich_help_panel=_SIZES)
    ] = "0",
    cut_depth_mm: Annotated[
        str | None, typer.Option(help="From the front; without, right through; a,b,c repeats.", rich_help_panel=_SIZES)
    ] = None,
    cut_radius_mm: Annotated[
        float | None, typer.Option(help="Of curved cuts, above 0 if they bulge up.", rich_help_panel=_SIZES)
    ] = None,
    cut_slope_deg: Annotated[
        float, typer.Option(help="Root-mean-square tilt of rippled cuts.", rich_help_panel=_SIZES)
    ] = 0.0,
    cut_diffuse: Annotated[
        float, typer.Option(help="Share that cuts reflect diffusely.", rich_help_panel=_SIZES)
    ] = 0.0,
    medium: MediumWord = None,
    absorption_per_mm: Absorption = None,
) -> None:
    """A clear sheet with fine horizontal cuts."""
    _answer(
        lambda: LaserCutPanel(
            spacing_mm=_repeating("--spacing-mm", spacing_mm),
            thickness_mm=thickness_mm,
            cut_width_mm=cut_width_mm,
            cut_tilt_deg=_repeating("--cut-tilt-deg", cut_tilt_deg),
            cut_depth_mm=None if cut_depth_mm is None else _repeating("--cut-depth-mm", cut_depth_mm),
            cut_radius_mm=cut_radius_mm,
            cut_slope_deg=cut_slope_deg,
            cut_diffuse=cut_diffuse,
            **_medium(LaserCutPanel, medium, absorption_per_mm),
        ),
        question,
    )


@panel.command("prismatic")
@asked
def prismatic(
    question: Question,
    pitch_mm: Annotated[float, typer.Option(help="From ridge to ridge.", rich_help_panel=_SIZES)],
    lower_deg: Annotated[
        float, typer.Option(help="Between the sheet and the facet below the ridge.", rich_help_panel=_SIZES)
    ],
    upper_deg: Annotated[float, typer.Option(help="Likewise above the ridge.", rich_help_panel=_SIZES)],
    base_mm: Annotated[float, typer.Option(help="Solid sheet under the ridges.", rich_help_panel=_SIZES)],
    ridges: Annotated[
        Literal["front", "back"], typer.Option(help="Side that carries the ridges.", rich_help_panel=_SIZES)
    ] = "front",
    medium: MediumWord = None,
    absorption_per_mm: Absorption = None,
) -> None:
    """A clear sheet with horizontal ridges on one side."""
    _answer(
        lambda: PrismaticPanel(
            pitch_mm=pitch_mm,
            lower_deg=lower_deg,
            upper_deg=upper_deg,
            base_mm=base_mm,
            ridges=ridges,
            **_medium(PrismaticPanel, medium, absorption_per_mm),
        ),
        question,
    )


@panel.command("pane")
@asked
def pane(
    question: Question,
    thickness_mm: Annotated[float, typer.Option(help="Between the faces.", rich_help_panel=_SIZES)],
    medium: MediumWord = None,
    absorption_per_mm: Absorption = None,
) -> None:
    """A plane-parallel sheet."""
    _answer(lambda: Pane(thickness_mm=thickness_mm, **_medium(Pane, medium, absorption_per_mm)), question)


@panel.command(_FILE)
@asked
def of_file(
    question: Question,
    file: Annotated[Path, typer.Argument(help="As written by --out or Panel.to_toml.", metavar="FILE.toml")],
) -> None:
    """The panel of a file, of whichever kind."""

    def read() -> Panel:
        if not file.suffix and not file.exists():
            one_of("panel", str(file), ("laser-cut", "prismatic", "pane", _FILE))
        return read_panel(file)

    _answer(read, question)


def _answer(make: Callable[[], Panel], question: Question) -> None:
    from clerestory.cli.panel_report import report

    with mistakes_told():
        report(make(), question)


def _repeating(name: str, text: str) -> float | list[float]:
    numbers = number_list(name, text)
    return numbers[0] if len(numbers) == 1 else numbers


def _medium(kind: type[Any], word: str | None, absorption_per_mm: float | None) -> dict[str, Medium]:
    """The argument ``medium``, if the command line says anything of it."""
    if word is None and absorption_per_mm is None:
        return {}
    if word is None:
        medium = kind.__dataclass_fields__["medium"].default
    elif word in medium_names():
        medium = Medium.named(word)
    else:
        try:
            medium = Medium(n=float(word))
        except ClerestoryError:
            raise
        except ValueError:
            medium = Medium.named(word)
    return {"medium": medium if absorption_per_mm is None else medium.with_absorption(absorption_per_mm)}
