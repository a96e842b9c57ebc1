"""The command ``clerestory``: the Python API by the same names, results in files."""

import typer

from clerestory.cli.bsdf import bsdf
from clerestory.cli.convert import convert
from clerestory.cli.design import design
from clerestory.cli.doctor import doctor
from clerestory.cli.one_line import OneLineGroup
from clerestory.cli.panel import panel
from clerestory.cli.room import room
from clerestory.cli.studio import studio
from clerestory.cli.sweep import sweep
from clerestory.cli.weather import weather
from clerestory.cli.year import year

app = typer.Typer(
    cls=OneLineGroup,
    name="clerestory",
    help="Design, characterise and simulate windows that redirect light.",
    no_args_is_help=True,
    add_completion=True,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.add_typer(panel, name="panel")
app.add_typer(bsdf, name="bsdf")
app.command("room")(room)
app.command("sweep")(sweep)
app.command("design")(design)
app.command("studio")(studio)
app.command("convert")(convert)
app.command("weather")(weather)
app.command("year")(year)
app.command("doctor")(doctor)

__all__ = ["app"]
