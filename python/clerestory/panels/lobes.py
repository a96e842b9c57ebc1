"""Every beam that leaves a panel, as a Dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from clerestory.panels.incidence import SIDES, angles, incident_directions, leaving_angles
from clerestory.panels.optics import exact_optics
from clerestory.panels.writing import described
from clerestory.provenance import provenance
from clerestory.rules import number, one_of

if TYPE_CHECKING:
    from clerestory.panels.panel import Panel


def lobes(
    panel: Panel,
    *,
    elevation_deg: float,
    azimuth_deg: float,
    side: str,
    wavelength_nm: float | None,
    polarisation: str,
    tolerance: float,
    arc_chords: int,
) -> xr.Dataset:
    """What :meth:`Panel.lobes` returns."""
    elevation = angles("elevation_deg", number("elevation_deg", elevation_deg))
    azimuth = angles("azimuth_deg", number("azimuth_deg", azimuth_deg))
    one_of("side", side, SIDES)
    wavelength = None if wavelength_nm is None else number("wavelength_nm", wavelength_nm)
    optics, at = exact_optics(
        panel, wavelength_nm=wavelength, polarisation=polarisation, tolerance=tolerance, arc_chords=arc_chords
    )
    incident = incident_directions(elevation, azimuth, side)
    directions, stokes, total_reflections, (absorbed, residual, displaced, walked), pieces = optics.lobes(incident)
    # a way that carries nothing is no lobe
    is_lit = stokes[:, 0] > 0.0
    directions, stokes, total_reflections = directions[is_lit], stokes[is_lit], total_reflections[is_lit]
    leaves_at_elevation, leaves_at_azimuth = leaving_angles(directions)
    variables = {
        "direction": (("lobe", "axis"), directions, {"long_name": "direction of travel", "units": "1"}),
        "power": ("lobe", stokes[:, 0], {"long_name": "share of the incident power", "units": "1"}),
        "side": ("lobe", np.where(directions[:, 2] > 0.0, "back", "front"), {"long_name": "side it leaves by"}),
        "total_reflections": (
            "lobe",
            total_reflections,
            {"long_name": "fewest total internal reflections on any way", "units": "1"},
        ),
        "elevation_deg": (
            "lobe",
            leaves_at_elevation,
            {"long_name": "elevation at which it travels, above 0 upwards", "units": "degree"},
        ),
        "azimuth_deg": (
            "lobe",
            leaves_at_azimuth,
            {"long_name": "azimuth at which it travels, above 0 towards +x", "units": "degree"},
        ),
    }
    if polarisation == "resolved":
        variables["stokes"] = (
            ("lobe", "parameter"),
            stokes,
            {"long_name": "Stokes vector about the reference axes of the direction", "units": "1"},
        )
    coordinates = {"axis": ["x", "y", "z"]}
    if polarisation == "resolved":
        coordinates["parameter"] = ["S0", "S1", "S2", "S3"]
    attributes = provenance(
        absorbed=absorbed,
        residual=residual,
        displaced=displaced,
        walked=walked,
        pieces=pieces,
        panel=described(panel),
        method="exact",
        elevation_deg=float(elevation[0]),
        azimuth_deg=float(azimuth[0]),
        side=side,
        polarisation=polarisation,
        tolerance=tolerance,
        wavelength_nm=list(at.wavelength_nm),
        wavelength_weights=list(at.weights),
        arc_chords=None if panel.native_profile.is_straight else arc_chords,
    )
    return xr.Dataset(variables, coordinates, attributes)
