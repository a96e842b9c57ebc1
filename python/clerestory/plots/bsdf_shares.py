"""Shares that pass and come back against incidence, of any BSDF."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from clerestory.bsdf import Bsdf
from clerestory.bsdf.completing import words
from clerestory.plots.bsdf_incidence import band_of, travel_xy
from clerestory.plots.style import blank, degrees, line_style, styled
from clerestory.rules import within


def bsdf_shares(bsdf: Bsdf, *, azimuth_deg: float = 0.0, band: str = "visible", title: str | None = None) -> Figure:
    """Hemispherical transmittance and reflectance of both sides against the elevation of incidence.

    Parameters
    ----------
    bsdf : Bsdf
    azimuth_deg : float, -90..90 [degrees], default 0
        Of the incidence about the vertical; 0 is the plane across the cuts of a panel.
    band : {"visible", "solar", "x", "z"}, default "visible"
    title : str, optional

    Returns
    -------
    Figure
        Elevations above 0 are light from above. Matrices are steps, one for each patch.

    Raises
    ------
    ClerestoryError
        If the band is not known, or the azimuth out of its range.
    """
    within("azimuth_deg", azimuth_deg, -90.0, 90.0)
    elevation = np.linspace(-89.0, 89.0, 357)
    points = travel_xy(elevation, azimuth_deg)
    with styled():
        figure = blank()
        axes = figure.add_subplot()
        for number, (direction, block) in enumerate(band_of(bsdf, band)):
            axes.plot(elevation, block.hemispherical_at(points), label=words(direction), **line_style(number))
        axes.set(
            xlim=(-90.0, 90.0),
            xlabel="Elevation of the incident light",
            ylabel=f"Share of the incident power, {band}",
        )
        axes.set_ylim(bottom=0.0)
        degrees(axes.xaxis, 30.0)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2)
        beside = "" if azimuth_deg == 0.0 else f", azimuth {azimuth_deg:g}°"
        axes.set_title(title or f"{bsdf.name}{beside}")
    return figure
