"""`clerestory weather`: what a weather file holds, and what was put right in it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.table import Table

from clerestory.cli.mistakes import mistakes_told

if TYPE_CHECKING:
    from clerestory.weather import Weather


def weather(
    file: Annotated[Path, typer.Argument(help="Weather file: .epw or .wea.")],
    out: Annotated[
        Path | None, typer.Option(help="Folder for carpets of the irradiances and the clearest and dullest sky (PNG).")
    ] = None,
    timezone: Annotated[
        str | None,
        typer.Option(help="Wall clock of the site, such as America/New_York; default the file's offset."),
    ] = None,
    max_gap_hours: Annotated[
        float, typer.Option(help="Longest gap, in hours of daylight, that is filled in instead of refused.")
    ] = 3.0,
    minutes: Annotated[
        float | None, typer.Option(help="Interpolate to intervals of so many minutes; energy is kept.")
    ] = None,
    wea: Annotated[Path | None, typer.Option(help="Also write a WEA file, as Radiance reads.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the summary as JSON and nothing else.")] = False,
) -> None:
    """Site, hours, sums and sunshine of a weather file, and notes on what was mended in it."""
    with mistakes_told():
        _run(file, out, timezone, max_gap_hours, minutes, wea, as_json)


def _run(
    file: Path,
    out: Path | None,
    timezone: str | None,
    max_gap_hours: float,
    minutes: float | None,
    wea: Path | None,
    as_json: bool,
) -> None:
    from clerestory.errors import ClerestoryError
    from clerestory.weather import read_epw, read_wea
    from clerestory.weather.summary import summary

    if file.suffix.lower() == ".wea":
        if timezone is not None:
            raise ClerestoryError("timezone must be left out for a WEA file, which has its own; read an EPW instead")
        found = read_wea(file, max_gap_hours=max_gap_hours)
    else:
        found = read_epw(file, timezone=timezone, max_gap_hours=max_gap_hours)
    if minutes is not None:
        found = found.resampled(minutes)
    written = [] if out is None else _draw(found, out)
    if wea is not None:
        written.append(found.to_wea(wea))
    numbers = summary(found)
    if as_json:
        typer.echo(json.dumps({**numbers, "files": [str(path) for path in written]}, indent=2, ensure_ascii=False))
        return
    console = Console()
    console.print(_table(numbers))
    for note in numbers["notes"]:
        console.print(f"note: {note}", markup=False, soft_wrap=True, highlight=False)
    if written:
        console.print("written:", *(f"\n  {path}" for path in written), soft_wrap=True, highlight=False)


def _draw(found: Weather, out: Path) -> list[Path]:
    import numpy as np

    from clerestory.plots import sky_dome, weather_carpet
    from clerestory.saving import write_whole
    from clerestory.weather.light import light_of

    figures = {"weather.png": weather_carpet(found)}
    light = light_of(found)
    # skies of a sun that is well up, the clearest and the dullest
    high = np.flatnonzero((found.sun.apparent_altitude_deg.values > 20.0) & (light.diffuse_horizontal_lx > 0.0))
    if len(high):
        clearness = light.conditions.clearness[high]
        for name, row in (("clearest", high[np.argmax(clearness)]), ("dullest", high[np.argmin(clearness)])):
            sky, when = found.sky(found.times[row]), found.times[row]
            title = f"{name.capitalize()}: {when.day} {when:%B %H:%M}, clearness {light.conditions.clearness[row]:.2f}"
            figures[f"sky-{name}.png"] = sky_dome(sky, title=title)
    return [write_whole(out / name, figure.savefig) for name, figure in figures.items()]


def _table(numbers: dict[str, Any]) -> Table:
    site = numbers["site"]
    table = Table(title=numbers["source"], title_justify="left", show_header=False)
    table.add_column()
    table.add_column(justify="right")
    east, north = site["longitude_deg"], site["latitude_deg"]
    rows = {
        "latitude": f"{abs(north):g}° {'north' if north >= 0 else 'south'}",
        "longitude": f"{abs(east):g}° {'east' if east >= 0 else 'west'}",
        "elevation": f"{site['elevation_m']:g} m",
        "clock": site["timezone"],
        "intervals": f"{numbers['intervals']} of {numbers['interval_minutes']:g} min",
        "from, middle of the interval": numbers["first"],
        "to": numbers["last"],
        "direct normal": f"{numbers['direct_normal_kwh_m2']:.0f} kWh/m²",
        "diffuse horizontal": f"{numbers['diffuse_horizontal_kwh_m2']:.0f} kWh/m²",
        "global horizontal": f"{numbers['global_horizontal_kwh_m2']:.0f} kWh/m²",
        "global horizontal, light": f"{numbers['global_horizontal_klx_h'] / 1e3:.1f} Mlx h",
        "daylit": f"{numbers['daylit_hours']:.0f} h",
        "sunshine, above 120 W/m²": f"{numbers['sunshine_hours']:.0f} h",
        "overcast, intermediate, clear": " / ".join(
            f"{numbers[f'{kind}_hours']:.0f}" for kind in ("overcast", "intermediate", "clear")
        )
        + " h",
        "greatest direct, diffuse": f"{numbers['greatest_direct_normal_w_m2']:.0f} / "
        f"{numbers['greatest_diffuse_horizontal_w_m2']:.0f} W/m²",
    }
    for name, value in rows.items():
        table.add_row(name, value)
    return table
