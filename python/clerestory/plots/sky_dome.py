"""The sky seen from below: its patches, their luminance, and the sun."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from clerestory.errors import ClerestoryError
from clerestory.plots.style import HAIR, INK, blank, styled
from clerestory.sky.basis import sky_basis
from clerestory.sky.cie_sky import CieSky
from clerestory.sky.perez_sky import PerezSky

_ARC_DEG = 2.0
"""Longest step along a patch's curved edge."""


def sky_dome(
    sky: CieSky | PerezSky | xr.DataArray,
    *,
    basis: str = "reinhart577",
    sun: tuple[float, float] | None = None,
    title: str | None = None,
) -> Figure:
    """Luminance of the patches of a sky, the zenith in the middle, north up and east to the right as on a map.

    Parameters
    ----------
    sky : CieSky, PerezSky, or DataArray with dims ("patch",) and the attribute `basis` [cd/m²]
    basis : str, default "reinhart577"
        For a CieSky or a PerezSky.
    sun : (altitude_deg, azimuth_deg), optional
        Default the sky's own.
    title : str, optional

    Returns
    -------
    Figure
        Distance from the middle is the zenith angle. The scale is logarithmic where the luminances span over 30 to 1.

    Raises
    ------
    ClerestoryError
        If the luminances do not say their basis or have other patches than it.
    """
    if isinstance(sky, (CieSky, PerezSky)):
        if sun is None and sky.sun_altitude_deg is not None and sky.sun_altitude_deg >= 0.0:
            sun = (sky.sun_altitude_deg, sky.sun_azimuth_deg)
        sky = sky.matrix(basis)
    name = sky.attrs.get("basis")
    if name is None or sky.dims != ("patch",) or sky.size != len(sky_basis(name)):
        raise ClerestoryError(
            f"sky must hold one luminance a patch and the attribute basis, got dims {dict(sky.sizes)} of {name!r}"
        )
    luminance = sky.values[:-1]
    with styled():
        figure = blank(6.2, 5.4)
        axes = figure.add_subplot()
        positive = luminance[luminance > 0.0]
        wide = len(positive) > 0 and positive.max() / positive.min() > 30.0
        norm = LogNorm(positive.min(), positive.max()) if wide else Normalize(0.0, float(luminance.max()) or 1.0)
        patches = PolyCollection(
            [_outline(*bounds) for bounds in np.asarray(sky_basis(name).bounds)[:-1]],
            array=luminance,
            cmap="cividis",
            norm=norm,
            edgecolors="face" if len(luminance) > 1200 else (1, 1, 1, 0.35),
            linewidths=0.35,
        )
        axes.add_collection(patches)
        if sun is not None:
            x, y = _project(np.radians(sun[0]), np.radians(sun[1]))
            axes.plot(x, y, marker="o", markersize=11, markerfacecolor="#E69F00", markeredgecolor=INK, linestyle="none")
            side = 1.0 if x < 40.0 else -1.0
            label = axes.annotate(
                f"sun {sun[0]:.0f}° high",
                (x, y),
                (11 * side, 0),
                textcoords="offset points",
                va="center",
                ha="left" if side > 0 else "right",
                color="white",
                fontweight="bold",
            )
            label.set_path_effects([withStroke(linewidth=2.0, foreground=INK)])
        for altitude in (30.0, 60.0):
            ring = np.radians(np.arange(0.0, 361.0, 2.0))
            radius = 90.0 - altitude
            axes.plot(radius * np.sin(ring), radius * np.cos(ring), color=HAIR, linewidth=0.6, alpha=0.7)
            axes.annotate(f"{altitude:.0f}°", (0.0, 90.0 - altitude), color=HAIR, fontsize=8, ha="center", va="bottom")
        for word, (x, y) in {"N": (0, 97), "E": (97, 0), "S": (0, -97), "W": (-97, 0)}.items():
            axes.text(x, y, word, ha="center", va="center", fontweight="bold")
        axes.set(xlim=(-103, 103), ylim=(-103, 103), aspect="equal")
        axes.axis("off")
        bar = figure.colorbar(patches, ax=axes, shrink=0.8, aspect=30)
        bar.ax.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")
        bar.set_label("Mean luminance of the patch [cd/m²]")
        bar.outline.set_visible(False)
        axes.set_title(title or str(sky.attrs.get("long_name", "Sky")).replace("mean luminance, ", ""))
    return figure


def _project(altitude: float, azimuth: float) -> tuple[float, float]:
    zenith_angle = 90.0 - np.degrees(altitude)
    return float(zenith_angle * np.sin(azimuth)), float(zenith_angle * np.cos(azimuth))


def _outline(low: float, high: float, start: float, end: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    steps = max(2, int(np.ceil(np.degrees(end - start) / _ARC_DEG)) + 1)
    azimuth = np.linspace(start, end, steps)
    outer, inner = 90.0 - np.degrees(low), 90.0 - np.degrees(high)
    edge = np.stack([np.sin(azimuth), np.cos(azimuth)], axis=1)
    return np.concatenate([outer * edge, inner * edge[::-1]])
