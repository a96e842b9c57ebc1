"""The strips of light that one broad beam becomes within and around a panel's section, to draw them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from clerestory.array_rules import vector
from clerestory.errors import ClerestoryError
from clerestory.panels.incidence import SIDES, angles, incident_directions
from clerestory.panels.optics import ARC_CHORDS, TOLERANCE, exact_optics
from clerestory.rules import number, one_of

if TYPE_CHECKING:
    from clerestory.panels.incidence import Side
    from clerestory.panels.panel import Panel


def section_beams(
    panel: Panel,
    *,
    elevation_deg: float,
    azimuth_deg: float = 0.0,
    side: Side = "front",
    slice_mm: tuple[float, float] | None = None,
    least_power: float = 0.005,
    wavelength_nm: float | None = None,
    arc_chords: int = ARC_CHORDS,
) -> xr.Dataset:
    """Every strip of light between two surfaces, as a polygon of the section.

    Parameters
    ----------
    panel : Panel
    elevation_deg, azimuth_deg, side, wavelength_nm, arc_chords
        As of :meth:`Panel.lobes`; of several wavelengths the first is drawn.
    slice_mm : tuple of two floats, increasing [mm]
        Heights between which light is let in, on the outermost plane of the panel; by default one period.
    least_power : float, above 0 and below 1, default 0.005
        Share of the slice's light below which a strip is not followed.

    Returns
    -------
    Dataset over ``strip``
        ``corners`` (strip, corner, axis) [mm]: the two ends where the strip begins, then the same rays where it ends,
        in reverse; ``power`` [0..1 of the light let in] where the strip begins, after what was absorbed on the way;
        ``medium`` it runs in, 0 the air; ``total_reflections`` so far. The first strip is the light that arrives.
        Light is unpolarised again at every surface and, dimmed, evenly spread again.

    Raises
    ------
    ClerestoryError
        If an argument is out of its range.
    """
    corners, power, medium, total_reflections, about = strips(
        panel,
        elevation_deg=elevation_deg,
        azimuth_deg=azimuth_deg,
        side=side,
        slice_mm=slice_mm,
        least_power=least_power,
        wavelength_nm=wavelength_nm,
        arc_chords=arc_chords,
    )
    return xr.Dataset(
        {
            "corners": (("strip", "corner", "axis"), corners, {"long_name": "corners of the strip", "units": "mm"}),
            "power": ("strip", power, {"long_name": "share of the light let in", "units": "1"}),
            "medium": ("strip", medium, {"long_name": "medium it runs in"}),
            "total_reflections": (
                "strip",
                total_reflections,
                {"long_name": "total internal reflections so far"},
            ),
        },
        {"axis": ["z", "y"]},
        about,
    )


def strips(
    panel: Panel,
    *,
    elevation_deg: float,
    azimuth_deg: float = 0.0,
    side: Side = "front",
    slice_mm: tuple[float, float] | None = None,
    least_power: float = 0.005,
    wavelength_nm: float | None = None,
    arc_chords: int = ARC_CHORDS,
) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
    """What :func:`section_beams` holds, as arrays: corners, powers, media, total reflections, and its attributes."""
    elevation = angles("elevation_deg", number("elevation_deg", elevation_deg))
    azimuth = angles("azimuth_deg", number("azimuth_deg", azimuth_deg))
    one_of("side", side, SIDES)
    heights = vector("slice_mm", (0.0, panel.native_profile.pitch_mm) if slice_mm is None else slice_mm)
    if len(heights) != 2 or not heights[0] < heights[1]:
        raise ClerestoryError(f"slice_mm must be two increasing heights, got {slice_mm!r}; give (low, high)")
    if not 0.0 < number("least_power", least_power) < 1.0:
        raise ClerestoryError(f"least_power must be above 0 and below 1, got {least_power:g}; 0.005 serves drawings")
    optics, _ = exact_optics(
        panel, wavelength_nm=wavelength_nm, polarisation="averaged", tolerance=TOLERANCE, arc_chords=arc_chords
    )
    incident = incident_directions(elevation, azimuth, side)
    corners, power, medium, total_reflections = optics.section_beams(
        incident, y_range_mm=(heights[0], heights[1]), least_power=least_power
    )
    about = {"elevation_deg": float(elevation[0]), "azimuth_deg": float(azimuth[0]), "side": side, "slice_mm": heights}
    return (
        corners,
        np.array(power),
        np.frombuffer(bytes(medium), dtype=np.uint8),
        np.array(total_reflections, dtype=np.int64),
        about,
    )
