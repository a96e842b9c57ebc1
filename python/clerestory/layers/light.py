"""Where light goes that meets a stack: beams, shares and what each layer absorbs, as Datasets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from clerestory import _native
from clerestory.layers.optics import layer_name, refuse_rough, stack_described, stack_optics
from clerestory.panels.angular import LONG_NAMES
from clerestory.panels.incidence import SIDES, angles, incident_directions, leaving_angles
from clerestory.panels.wavelengths import asked_wavelengths
from clerestory.provenance import provenance
from clerestory.rules import number, one_of

if TYPE_CHECKING:
    from clerestory.glazing import Stack

Floats = NDArray[np.float64]

LAYER = {"long_name": "layer, counted from the outside"}
ABSORPTANCE = "share of the power that each layer absorbs"


def stack_lobes(
    stack: Stack,
    *,
    elevation_deg: float,
    azimuth_deg: float,
    side: str,
    wavelength_nm: float | None,
    polarisation: str,
    tolerance: float,
) -> xr.Dataset:
    """What :meth:`Stack.lobes` returns."""
    elevation = angles("elevation_deg", number("elevation_deg", elevation_deg))
    azimuth = angles("azimuth_deg", number("azimuth_deg", azimuth_deg))
    one_of("side", side, SIDES)
    refuse_rough(stack)
    wavelength = None if wavelength_nm is None else number("wavelength_nm", wavelength_nm)
    optics, at = stack_optics(stack, wavelength_nm=wavelength, polarisation=polarisation, tolerance=tolerance)
    directions, stokes, total_reflections, absorptance, (residual, walked, walked_error) = optics.lobes(
        incident_directions(elevation, azimuth, side)
    )
    # strongest first; a way that carries nothing is no lobe
    order = np.argsort(-stokes[:, 0], kind="stable")
    order = order[stokes[order, 0] > 0.0]
    directions, stokes, total_reflections = directions[order], stokes[order], total_reflections[order]
    leaves_at_elevation, leaves_at_azimuth = leaving_angles(directions)
    is_resolved = polarisation == "resolved"
    shares: dict[str, Any] = {
        "direction": (("lobe", "axis"), directions, {"long_name": "direction of travel", "units": "1"}),
        "power": ("lobe", stokes[:, 0], {"long_name": "share of the incident power", "units": "1"}),
        "side": ("lobe", np.where(directions[:, 2] > 0.0, "back", "front"), {"long_name": "side it leaves by"}),
        "total_reflections": (
            "lobe",
            total_reflections,
            {"long_name": "fewest total internal reflections on any way", "units": "1"},
        ),
        "elevation_deg": ("lobe", leaves_at_elevation, {"long_name": "elevation of travel", "units": "degree"}),
        "azimuth_deg": ("lobe", leaves_at_azimuth, {"long_name": "azimuth of travel", "units": "degree"}),
        "layer_absorptance": ("layer", absorptance, {"long_name": ABSORPTANCE, "units": "1"}),
    }
    coordinates: dict[str, Any] = {"axis": ["x", "y", "z"], **layer_coordinates(stack)}
    if is_resolved:
        attributes = {"long_name": "Stokes vector about the reference axes of the direction", "units": "1"}
        shares["stokes"] = (("lobe", "parameter"), stokes, attributes)
        coordinates["parameter"] = ["S0", "S1", "S2", "S3"]
    attributes = provenance(
        absorbed=float(absorptance.sum()),
        residual=residual,
        walked=walked,
        walked_standard_error=walked_error,
        layers=stack_described(stack),
        elevation_deg=float(elevation[0]),
        azimuth_deg=float(azimuth[0]),
        side=side,
        polarisation=polarisation,
        tolerance=tolerance,
        wavelength_nm=list(at.wavelength_nm),
        wavelength_weights=list(at.weights),
    )
    return xr.Dataset(shares, coordinates, attributes)


def stack_angular(
    stack: Stack,
    *,
    elevation_deg: ArrayLike,
    azimuth_deg: ArrayLike,
    side: str,
    wavelength_nm: ArrayLike | None,
    polarisation: str,
    tolerance: float,
) -> xr.Dataset:
    """What :meth:`Stack.angular` returns."""
    elevation, azimuth = angles("elevation_deg", elevation_deg), angles("azimuth_deg", azimuth_deg)
    wavelengths = asked_wavelengths(wavelength_nm)
    one_of("side", side, SIDES)
    refuse_rough(stack)
    asked = [None] if wavelengths is None else [float(w) for w in wavelengths.ravel()]
    compiled = [stack_optics(stack, wavelength_nm=w, polarisation=polarisation, tolerance=tolerance) for w in asked]
    incident = incident_directions(elevation[:, None], azimuth, side).reshape(-1, 3)
    # (wavelength, incident, share) to (share, elevation, azimuth, wavelength)
    columns = np.array([one.shares(incident) for one, _ in compiled]).transpose(2, 1, 0)
    columns = columns.reshape(-1, len(elevation), len(azimuth), len(compiled))
    is_list = wavelengths is not None and wavelengths.ndim == 1
    dims = ("elevation", "azimuth", "wavelength") if is_list else ("elevation", "azimuth")
    columns = columns if is_list else columns[..., 0]
    coordinates: dict[str, Any] = {
        "elevation": ("elevation", elevation, {"long_name": "elevation, above 0 from above", "units": "degree"}),
        "azimuth": ("azimuth", azimuth, {"long_name": "azimuth about the panel's y axis", "units": "degree"}),
        **layer_coordinates(stack),
    }
    if wavelengths is not None:
        attributes = {"long_name": "wavelength in vacuum", "units": "nm"}
        coordinates["wavelength"] = (("wavelength",) if is_list else (), wavelengths, attributes)
    photopic = compiled[0][1] if wavelengths is None else None
    attributes = provenance(
        layers=stack_described(stack),
        side=side,
        polarisation=polarisation,
        tolerance=tolerance,
        wavelength_nm=list(photopic.wavelength_nm) if photopic else None,
        wavelength_weights=list(photopic.weights) if photopic else None,
    )
    return xr.Dataset(share_variables(dims, columns), coordinates, attributes)


def share_variables(dims: tuple[str, ...], columns: Floats) -> dict[str, Any]:
    """Named variables of the columns of the compiled stack's table of shares, shape (share, …)."""
    names = _native.Stack.SHARES
    table = dict(zip(names, columns, strict=False))
    layers = columns[len(names) :]
    table["absorptance"] = layers.sum(axis=0)
    table["transmittance_undeflected"] = table["transmittance"] - table["transmittance_deflected"]
    order = ("transmittance", "reflectance", "absorptance", "transmittance_deflected", "transmittance_undeflected")
    variables: dict[str, Any] = {
        name: (dims, table[name], {"long_name": LONG_NAMES[name], "units": "1"}) for name in (*order, "residual")
    }
    variables["layer_absorptance"] = (("layer", *dims), layers, {"long_name": ABSORPTANCE, "units": "1"})
    return variables


def layer_coordinates(stack: Stack) -> dict[str, Any]:
    """Number and kind of each layer."""
    names = [layer_name(layer) for layer in stack.glazings]
    return {
        "layer": ("layer", np.arange(1, len(names) + 1), LAYER),
        "layer_kind": ("layer", names, {"long_name": "what the layer is"}),
    }
