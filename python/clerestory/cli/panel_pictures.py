"""The pictures of an answer about a panel, each as PNG and SVG."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from clerestory.cli.question import Question
from clerestory.compare import Comparison
from clerestory.panels import Panel
from clerestory.saving import write_whole

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


def pictures(
    out: Path, panel: Panel, table: xr.Dataset, comparisons: dict[str, Comparison], question: Question
) -> list[Path]:
    """Draws and writes them: radial diagram, section with its beams, a cloud for each quantity compared."""
    from clerestory import plots
    from clerestory.panels.section_beams import section_beams

    written = []
    # the diagram has one azimuth and one wavelength: the first
    plain = table.isel({name: slice(0, 1) for name in table.dims if name != "elevation"})
    if table.sizes["elevation"] > 1:
        written += save_figure(plots.radial(plain), out / "radial")
    beams = section_beams(panel, elevation_deg=question.section, side=question.side)
    written += save_figure(plots.section(panel, beams), out / "section")
    for name, comparison in comparisons.items():
        quantity = name.replace("_", ", ").capitalize()
        written += save_figure(plots.regression(comparison, quantity=quantity), out / f"regression_{name}")
    return written


def save_figure(figure: Figure, path: Path) -> list[Path]:
    """Writes a figure as PNG and SVG beside one another."""
    return [
        write_whole(path.with_suffix(ending), lambda draft: figure.savefig(draft, dpi=200))
        for ending in (".png", ".svg")
    ]
