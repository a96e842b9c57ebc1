"""The figure of the race: error against CPU time."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from clerestory.plots.style import COLOURS, DASHES, blank, styled

if TYPE_CHECKING:
    from room_race import Point

_FOLDER = Path(__file__).parents[2] / "docs" / "images" / "benchmarks"
_MARKS = ("o", "s", "^", "D")


def draw(programs: dict[str, list[Point]], panel: list[Point]) -> None:
    """Writes room.svg and room.png: the daylight factor on the left, the coefficients on the right."""
    curves = {**programs, "Clerestory, panel above": panel}
    with styled():
        figure = blank(10.0, 4.4)
        left, right = figure.subplots(1, 2)
        for (name, points), colour, dash, mark in zip(curves.items(), COLOURS, DASHES, _MARKS, strict=False):
            for axes, field in ((left, "factor_error"), (right, "coefficient_error")):
                rows = sorted((point.cpu_seconds, 100.0 * getattr(point, field)) for point in points)
                axes.plot(*zip(*rows, strict=True), mark, ls=dash, color=colour, label=name, markersize=4.5)
        left.axhline(2.0, color="#8a929b", lw=0.8)
        right.axhline(5.0, color="#8a929b", lw=0.8)
        left.set(title="Daylight factor", ylabel="rms error [%]", xlabel="CPU time [s]")
        right.set(title="145 coefficients", ylabel="CV(RMSE) [%]", xlabel="CPU time [s]")
        for axes in (left, right):
            axes.set(xscale="log", yscale="log")
        left.legend()
        _FOLDER.mkdir(parents=True, exist_ok=True)
        figure.savefig(_FOLDER / "room.svg", metadata={"Date": None})
        figure.savefig(_FOLDER / "room.png", dpi=110)
