"""The section of a panel drawn to scale, with the beams that one slice of sunlight becomes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap, LogNorm
from matplotlib.figure import Figure
from xarray import Dataset

from clerestory.plots.section_outline import outline
from clerestory.plots.style import FAINT, INK, blank, heading, styled

if TYPE_CHECKING:
    from clerestory._native import Profile
    from clerestory.panels.panel import Panel

SOLID = "#dbe7ef"
CUT = "#33475b"
#: Pale to deep, ever darker: read without telling hues apart.
LIGHT = LinearSegmentedColormap.from_list("light", ["#fff6d8", "#ffe08a", "#ffbf2e", "#f58a00", "#d65a00"])
#: Share below which a beam that leaves has no label.
_LEAST_LABEL = 0.02
_PLATE = {"boxstyle": "round,pad=0.2", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}


def section(
    panel: Panel, beams: Dataset | None = None, *, periods: float | None = None, title: str | None = None
) -> Figure:
    """A panel cut open, to scale, with beams coloured by their power.

    Parameters
    ----------
    panel : Panel
    beams : Dataset, optional
        Of :func:`~clerestory.panels.section_beams.section_beams`. Without them the section alone is drawn.
    periods : float, greater than 0, optional
        How many periods high the drawing is; by default as many as show the beams on both sides.
    title : str, optional

    Returns
    -------
    Figure
        The outside to the left, the room to the right, thickness and period in mm. The colour of a beam tells its
        share of the light let in, its width is to scale.
    """
    profile = panel.native_profile
    front, back = profile.depth_range_mm
    pitch, depth = profile.pitch_mm, back - front
    height = periods * pitch if periods else max(2.6 * depth, 3.2 * pitch)
    middle = 0.5 * pitch
    if beams is not None:
        strong = beams["corners"].values[beams["power"].values >= 0.05]
        inside = strong[1:, :2].reshape(-1, 2)
        # the light wanders up or down within: keep its entry and its exits in the picture
        middle = 0.5 * float(inside[:, 1].min() + inside[:, 1].max())
        height = height if periods else max(height, 1.6 * float(np.ptp(inside[:, 1])))
    low, high = middle - 0.5 * height, middle + 0.5 * height
    margin = 0.62 * height if beams is not None else 0.2 * height
    left, right = front - margin, back + margin
    with styled():
        figure = blank(min(8.5, (1.6 if beams is not None else 0.6) + 4.6 * (right - left) / height), 5.6)
        axes = figure.add_subplot()
        _draw_panel(axes, profile, low, high)
        if beams is not None:
            shades = _draw_beams(axes, beams, (front, back), 2.0 * (right - left + height))
            bar = figure.colorbar(shades, ax=axes, shrink=0.6, pad=0.03, aspect=26)
            bar.set_label("Share of the light let in")
            shares = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0]
            bar.set_ticks(shares, labels=[f"{100 * share:g} %" for share in shares])
            bar.ax.minorticks_off()
            _label_leaving(axes, beams, (front, back), (left, right), (low, high))
        _frame(axes, profile, (left, right), (low, high))
        heading(figure, title or _title(beams))
    return figure


def _title(beams: Dataset | None) -> str:
    if beams is None:
        return "Section"
    return f"Section with light from {beams.attrs['elevation_deg']:g}°".replace("-", "−")


def _draw_panel(axes: Axes, profile: Profile, low: float, high: float) -> None:
    shape = outline(profile, low, high)
    axes.add_collection(PolyCollection(shape.solids, facecolors=SOLID, edgecolors=SOLID, linewidths=0.4, zorder=1))
    axes.add_collection(LineCollection(shape.surfaces, colors=CUT, linewidths=0.9, zorder=4))
    axes.add_collection(LineCollection(shape.films, colors=CUT, linewidths=1.3, zorder=4))


def _leaves(beams: Dataset, across: tuple[float, float]) -> Any:
    """Which strips end outside the panel."""
    ends = beams["corners"].values[:, 2:, 0]
    slack = 1e-9 * (across[1] - across[0])
    leaves = ((ends > across[1] + slack) | (ends < across[0] - slack)).all(axis=1)
    # the first is the light that arrives
    return leaves & (np.arange(len(ends)) > 0)


def _draw_beams(axes: Axes, beams: Dataset, across: tuple[float, float], reach: float) -> PolyCollection:
    corners, power = beams["corners"].values.copy(), beams["power"].values
    leaves = _leaves(beams, across)
    # light that has left goes on to the edge of the drawing, and light that arrives comes from there
    for near, far in ((0, 3), (1, 2)):
        way = corners[:, far] - corners[:, near]
        way *= reach / np.linalg.norm(way, axis=1, keepdims=True).clip(1e-300)
        corners[leaves, far] = corners[leaves, near] + way[leaves]
        corners[0, near] = corners[0, far] - way[0]
    order = np.argsort(power, kind="stable")
    shades = PolyCollection(
        list(corners[order]),
        array=power[order],
        cmap=LIGHT,
        norm=LogNorm(0.01, 1.0),
        edgecolors="none",
        alpha=0.8,
        zorder=3,
    )
    axes.add_collection(shades)
    return shades


def _label_leaving(
    axes: Axes, beams: Dataset, across: tuple[float, float], wide: tuple[float, float], up: tuple[float, float]
) -> None:
    """The share of each direction that leaves, at the edge of the drawing where its strongest strip ends."""
    corners, power = beams["corners"].values, beams["power"].values
    chosen = np.flatnonzero(_leaves(beams, across))
    way = corners[chosen, 3] - corners[chosen, 0]
    slope = np.round(np.degrees(np.arctan2(way[:, 1], way[:, 0])), 3)
    for angle in np.unique(slope):
        strips = chosen[slope == angle]
        total = power[strips].sum()
        if total < _LEAST_LABEL:
            continue
        strongest = strips[np.argmax(power[strips])]
        start = corners[strongest, :2].mean(axis=0)
        d = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        # where it meets the frame, and a little back
        to_side = (wide[int(d[0] > 0)] - start[0]) / d[0]
        to_top = (up[int(d[1] > 0)] - start[1]) / d[1] if d[1] else np.inf
        at = start + 0.86 * min(to_side, to_top) * d
        axes.text(
            float(at[0]),
            float(at[1]),
            f"{100 * total:.0f} %",
            ha="center",
            va="center",
            fontsize=9,
            zorder=6,
            bbox=_PLATE,
        )


def _frame(axes: Axes, profile: Profile, across: tuple[float, float], up: tuple[float, float]) -> None:
    """No axes but two dimensions in mm: the thickness below, one period beside."""
    front, back = profile.depth_range_mm
    (left, right), (low, high) = across, up
    size = high - low
    foot = low - 0.05 * size
    axes.set(aspect="equal", xlim=(left, right), ylim=(low - 0.13 * size, high + 0.06 * size))
    axes.set_axis_off()
    clip = mpl.patches.Rectangle((left, low), right - left, size, transform=axes.transData)
    for artist in axes.collections:
        artist.set_clip_path(clip)
    arrow = {"arrowstyle": "<|-|>", "color": INK, "linewidth": 0.8, "shrinkA": 0.0, "shrinkB": 0.0, "mutation_scale": 7}
    axes.annotate("", (front, foot), (back, foot), arrowprops=arrow)
    axes.text(0.5 * (front + back), foot - 0.015 * size, f"{back - front:.3g} mm", ha="center", va="top", fontsize=9)
    beside = back + 0.05 * size
    base = profile.pitch_mm * np.ceil(low / profile.pitch_mm)
    axes.annotate("", (beside, base), (beside, base + profile.pitch_mm), arrowprops=arrow)
    axes.text(
        beside + 0.02 * size,
        base + 0.5 * profile.pitch_mm,
        f"{profile.pitch_mm:.3g} mm",
        va="center",
        fontsize=9,
        bbox=_PLATE,
        zorder=7,
    )
    axes.text(left, high + 0.02 * size, "outside", color=FAINT, ha="left", va="bottom")
    axes.text(right, high + 0.02 * size, "room", color=FAINT, ha="right", va="bottom")
