"""Colours of dispersion: where each wavelength leaves, in its own colour."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from xarray import Dataset

from clerestory.errors import ClerestoryError
from clerestory.plots.style import FAINT, INK, blank, degrees, heading, note, styled
from clerestory.spectrum import srgb_of_wavelength

#: Directions further apart than this belong to different beams.
_GAP_DEG = 5.0
_COLUMNS = ("elevation_deg", "power", "side")


@dataclass(frozen=True)
class _Point:
    """One lobe at one wavelength."""

    wavelength_nm: float
    elevation_deg: float
    power: float
    side: str


def dispersion(
    lobes: Mapping[float, Dataset], *, most_beams: int = 4, least_power: float = 0.01, title: str | None = None
) -> Figure:
    """Elevation at which each wavelength leaves, one panel of the figure a beam, all to the same scale.

    Parameters
    ----------
    lobes : mapping from wavelength [nm] to Dataset
        Each of ``panel.lobes(..., wavelength_nm=wavelength)``, the same incidence.
    most_beams : int, default 4
        The strongest are drawn.
    least_power : float, default 0.01
        Share of the incident power below which a beam is left out.
    title : str, optional

    Returns
    -------
    Figure
        Areas of the dots are in proportion to the power.

    Raises
    ------
    ClerestoryError
        If no beam is as strong as ``least_power``.
    """
    points = [
        _Point(wavelength, float(elevation), float(power), str(side))
        for wavelength, table in lobes.items()
        for elevation, power, side in zip(
            *(table[name].values for name in ("elevation_deg", "power", "side")), strict=True
        )
    ]
    beams = [beam for beam in _beams(points) if _strength(beam) >= least_power]
    if not beams:
        raise ClerestoryError(f"least_power must leave a beam to draw, got {least_power:g}; choose a smaller share")
    beams = sorted(sorted(beams, key=_strength)[-most_beams:], key=lambda beam: (beam[0].side, beam[0].elevation_deg))
    spans = [np.ptp([p.elevation_deg for p in beam]) for beam in beams]
    half = max(0.6 * max(spans), 0.25)
    with styled():
        figure = blank(max(4.0, 1.6 + 2.0 * len(beams)), 4.2)
        all_axes = figure.subplots(1, len(beams), sharey=True, squeeze=False)[0]
        for axes, beam in zip(all_axes, beams, strict=True):
            elevation, wavelength, power = np.array([[p.elevation_deg, p.wavelength_nm, p.power] for p in beam]).T
            colours = srgb_of_wavelength(wavelength)
            order = np.argsort(wavelength)
            axes.plot(elevation[order], wavelength[order], color=FAINT, linewidth=1.0, zorder=1)
            axes.scatter(
                elevation, wavelength, s=8.0 + 260.0 * power, c=colours, edgecolors=INK, linewidths=0.4, zorder=2
            )
            middle = 0.5 * (elevation.min() + elevation.max())
            axes.set_xlim(middle - half, middle + half)
            degrees(axes.xaxis, _tick_step(2.0 * half))
            axes.set_title(f"{_strength(beam):.1%}", pad=16)
            note(axes, f"of the power, by the {beam[0].side}")
        all_axes[0].set_ylabel("Wavelength [nm]")
        figure.supxlabel("Elevation of the light that leaves", fontsize=10)
        heading(figure, title or "Dispersion")
    return figure


def _beams(points: list[_Point]) -> list[list[_Point]]:
    """Points of one side whose elevations follow each other closely."""
    beams: list[list[_Point]] = []
    for point in sorted(points, key=lambda p: (p.side, p.elevation_deg)):
        last = beams[-1][-1] if beams else None
        if last and last.side == point.side and point.elevation_deg - last.elevation_deg < _GAP_DEG:
            beams[-1].append(point)
        else:
            beams.append([point])
    return beams


def _strength(beam: list[_Point]) -> float:
    """Mean power of a beam over its wavelengths."""
    return sum(p.power for p in beam) / len({p.wavelength_nm for p in beam})


def _tick_step(span: float) -> float:
    """A round step that puts two or three ticks on the axis."""
    rough = span / 3.0
    power = 10.0 ** np.floor(np.log10(rough))
    return float(next(k * power for k in (1.0, 2.0, 5.0, 10.0) if k * power >= rough))
