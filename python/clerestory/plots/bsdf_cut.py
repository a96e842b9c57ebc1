"""A cut through the light that a BSDF sends out, in a plane through the normal."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from clerestory.bsdf import Bsdf
from clerestory.plots.bsdf_incidence import Side, incidence_words, picked
from clerestory.plots.style import FAINT, INK, blank, line_style, styled
from clerestory.rules import within

#: Decades that are drawn below the largest value.
_DECADES = 4


def bsdf_cut(
    bsdf: Bsdf,
    *,
    elevation_deg: float = 40.0,
    azimuth_deg: float = 0.0,
    side: Side = "front",
    band: str = "visible",
    plane_deg: float = 0.0,
    title: str | None = None,
) -> Figure:
    """Light of one incidence in a plane through the normal, outside on the left and the room on the right.

    Parameters
    ----------
    bsdf : Bsdf
    elevation_deg, azimuth_deg : float, -90..90 [degrees]
        Where the light comes from, as of :meth:`Panel.lobes`.
    side : {"front", "back"}, default "front"
    band : {"visible", "solar", "x", "z"}, default "visible"
    plane_deg : float, -90..90 [degrees], default 0
        How far the plane is turned from the vertical about the normal, towards +x at its upper end.
    title : str, optional

    Returns
    -------
    Figure
        Polar: the angle is that of the outgoing direction, the radius the BSDF [1/sr] over four decades.

    Raises
    ------
    ClerestoryError
        If the band or the side is not known, or an angle is out of its range.
    """
    blocks, point = picked(bsdf, band, side, elevation_deg, azimuth_deg)
    tilt = np.radians(within("plane_deg", plane_deg, -90.0, 90.0))
    along = np.array([np.sin(tilt), np.cos(tilt)])
    angle = np.radians(np.linspace(-89.9, 89.9, 1440))
    values = {word: block.at(point, np.sin(angle)[:, None] * along) for word, block in blocks.items()}
    most = max(float(value.max()) for value in values.values())
    outer = np.ceil(np.log10(most) * 2.0) / 2.0 if most > 0.0 else 0.0
    with styled():
        figure = blank(6.4, 5.2)
        axes: Any = figure.add_subplot(projection="polar")
        for number, (word, value) in enumerate(values.items()):
            into_room = (side == "front") == (word == "Transmitted")
            turn = angle if into_room else np.pi - angle
            with np.errstate(divide="ignore"):
                radius = np.maximum(np.log10(value), outer - _DECADES)
            axes.plot(turn, radius, label=word, **line_style(number))
            axes.fill(
                np.concatenate([turn, turn[::-1]]),
                np.concatenate([radius, np.full_like(radius, outer - _DECADES)]),
                color=line_style(number)["color"],
                alpha=0.12,
                linewidth=0.0,
            )
        # the way the light comes in, drawn on the side it comes from
        elevation = np.arcsin(float(np.clip(-point @ along, -1.0, 1.0)))
        come = np.pi - elevation if side == "front" else elevation
        axes.annotate(
            "",
            (come, outer - _DECADES),
            (come, outer),
            arrowprops={"arrowstyle": "->", "color": "#E69F00", "linewidth": 1.8},
        )
        ticks = np.arange(np.ceil(outer - _DECADES + 0.25), outer + 1e-9)
        axes.set(ylim=(outer - _DECADES, outer), yticks=ticks)
        axes.set_yticklabels([f"{10.0**tick:g}" for tick in ticks], color=FAINT, fontsize=8)
        axes.set_rlabel_position(97.0)
        axes.set_thetagrids(
            np.arange(0, 360, 30),
            ["0°", "30°", "60°", "90°", "60°", "30°", "0°", "−30°", "−60°", "−90°", "−60°", "−30°"],
        )
        axes.legend(loc="upper left", bbox_to_anchor=(-0.25, 1.08))
        for x, word in ((0.02, "outside"), (0.98, "room")):
            axes.annotate(word, (x, 0.02), xycoords="axes fraction", ha="center", color=INK, fontweight="bold")
        axes.annotate("BSDF [1/sr]", (0.5, -0.1), xycoords="axes fraction", ha="center", color=FAINT)
        plane = "vertical plane" if plane_deg == 0.0 else f"plane turned {plane_deg:g}°"
        axes.set_title(
            title or f"{bsdf.name}, {plane}\n{incidence_words(elevation_deg, azimuth_deg, side)}", loc="left", pad=14
        )
    return figure
