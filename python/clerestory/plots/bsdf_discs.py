"""Where a BSDF sends the light of one incidence, on discs of directions."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from clerestory.bsdf import Bsdf, KlemsBlock, klems_basis
from clerestory.bsdf.cells import outgoing_cells, patch_outline
from clerestory.plots.bsdf_incidence import Floats, Side, incidence_words, picked
from clerestory.plots.style import FAINT, HAIR, INK, blank, heading, styled

#: Values less than this share of the largest are drawn as the least.
_SPAN = 1e-4
_MARK = "#D55E00"


def bsdf_discs(
    bsdf: Bsdf,
    *,
    elevation_deg: float = 40.0,
    azimuth_deg: float = 0.0,
    side: Side = "front",
    band: str = "visible",
    title: str | None = None,
) -> Figure:
    """The incident patch picked on one disc, and where its light goes on the others.

    Parameters
    ----------
    bsdf : Bsdf
        Of matrices or trees.
    elevation_deg, azimuth_deg : float, -90..90 [degrees]
        Where the light comes from, as of :meth:`Panel.lobes`.
    side : {"front", "back"}, default "front"
        That it meets; front is the outside.
    band : {"visible", "solar", "x", "z"}, default "visible"
    title : str, optional

    Returns
    -------
    Figure
        Discs of (x, y) directions of travel as seen from the room, the normal in the middle and 90° at the rim. On the
        left the share of each incidence that passes, with the picked one outlined; then the light that passes and the
        light that comes back [1/sr], in logarithmic colour; white is none.

    Raises
    ------
    ClerestoryError
        If the band or the side is not known.
    """
    blocks, point = picked(bsdf, band, side, elevation_deg, azimuth_deg)
    cells = {word: outgoing_cells(block, point) for word, block in blocks.items()}
    with styled():
        figure = blank(3.6 * (1 + len(cells)) + 1.2, 4.3)
        axes = figure.subplots(1, 1 + len(cells), squeeze=False)[0]
        first, block = next(iter(blocks.items()))
        basis = block.incident if isinstance(block, KlemsBlock) else klems_basis("klems_full")
        outlines = [_spread(patch_outline(basis, patch)) for patch in range(len(basis))]
        shares = block.hemispherical_at(basis.centre)
        patches = PolyCollection(
            outlines,
            array=shares,
            cmap="cividis",
            norm=Normalize(0.0, max(1e-9, float(shares.max()))),
            edgecolors="face",
        )
        axes[0].add_collection(patches)
        here = outlines[int(basis.find(point[0], point[1]))]
        axes[0].add_collection(PolyCollection([here], facecolors="none", edgecolors=_MARK, linewidths=2.0))
        _dress(axes[0], f"Comes along: {first.lower()} share")
        _bar(figure, axes[0], patches, "Share of the incident power")
        every = np.concatenate([values for _, values in cells.values()])
        most = float(every.max())
        least = max(_SPAN * most, float(every[every > 0.0].min())) if most > 0.0 else 0.0
        scale: PolyCollection | None = None
        for place, (word, (outlines, values)) in zip(axes[1:], cells.items(), strict=True):
            drawn = _light(place, [_spread(outline) for outline in outlines], values, (least, most))
            x, y = _spread(point[None])[0]
            place.plot(x, y, marker="+", markersize=10, color=_MARK, markeredgewidth=1.8, linestyle="none")
            _dress(place, f"{word}: leaves along")
            scale = drawn if drawn is not None else scale
            if place is axes[-1] and scale is not None:
                _bar(figure, place, scale, "BSDF [1/sr]")
        heading(figure, title or f"{bsdf.name}: {incidence_words(elevation_deg, azimuth_deg, side)}")
    return figure


def _spread(xy: Floats) -> Floats:
    """(x, y) of directions with their angle from the normal as distance from the middle [degrees]."""
    sine = np.hypot(xy[:, 0], xy[:, 1])
    angle = np.degrees(np.arcsin(np.minimum(sine, 1.0)))
    return np.asarray(xy * np.where(sine > 0.0, angle / np.where(sine > 0.0, sine, 1.0), 1.0)[:, None])


def _light(axes: Axes, outlines: list[Floats], values: Floats, span: tuple[float, float]) -> PolyCollection | None:
    lit = values > 0.0
    if not lit.any():
        axes.text(0.0, 0.0, "no light", ha="center", va="center", color=FAINT)
        return None
    least, most = span
    drawn = PolyCollection(
        [outline for outline, bright in zip(outlines, lit, strict=True) if bright],
        array=np.maximum(values[lit], least),
        cmap="cividis",
        norm=LogNorm(min(least, 0.5 * most), most),
        edgecolors="face",
        linewidths=0.2,
    )
    axes.add_collection(drawn)
    return drawn


def _dress(axes: Axes, title: str) -> None:
    turn = np.radians(np.arange(0.0, 361.0, 2.0))
    for angle in (30.0, 60.0, 90.0):
        width = 1.0 if angle == 90.0 else 0.6
        axes.plot(angle * np.cos(turn), angle * np.sin(turn), color=FAINT if angle == 90.0 else HAIR, linewidth=width)
        if angle < 90.0:
            # beside the vertical plane, in which panels send their light
            x, y = angle * np.cos(np.radians(35.0)), angle * np.sin(np.radians(35.0))
            label = axes.text(x, y, f"{angle:.0f}°", color=INK, fontsize=7.5, ha="center", va="center")
            label.set_path_effects([withStroke(linewidth=1.8, foreground="white")])
    axes.annotate("up", (0.0, 92.0), ha="center", va="bottom", color=INK, fontsize=8.5)
    axes.annotate("right", (92.0, 0.0), ha="left", va="center", color=INK, fontsize=8.5, rotation=-90)
    axes.set(xlim=(-101, 101), ylim=(-97, 103), aspect="equal")
    axes.axis("off")
    axes.set_title(title, fontsize=10)


def _bar(figure: Figure, axes: Axes, drawn: PolyCollection, label: str) -> None:
    bar = figure.colorbar(drawn, ax=axes, shrink=0.75, aspect=25)
    bar.set_label(label)
    bar.outline.set_visible(False)
