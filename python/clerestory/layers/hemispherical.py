"""What a stack does to light that comes evenly from a whole hemisphere."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from clerestory.layers.light import layer_coordinates, share_variables
from clerestory.layers.optics import refuse_rough, stack_described, stack_optics
from clerestory.panels.incidence import SIDES
from clerestory.panels.optics import whole
from clerestory.provenance import provenance
from clerestory.rules import number, one_of

if TYPE_CHECKING:
    from clerestory.glazing import Stack

Floats = NDArray[np.float64]


def diffuse_directions(side: str, rings: int, azimuths: int) -> tuple[Floats, Floats]:
    """Directions of incidence and weights of a uniform hemisphere as a plane receives it.

    Returns
    -------
    directions : ndarray, shape (rings * azimuths, 3)
    weights : ndarray, shape (rings * azimuths,)
        Their sum is 1.

    Notes
    -----
    Gauss-Legendre in cos θ, of which shares are smooth to the grazing end, and evenly spaced azimuths
    (theory/layers.md, eq. 7).
    """
    node, weight = np.polynomial.legendre.leggauss(rings)
    c = 0.5 * (node + 1.0)
    ring_weight = c * weight
    turn = 2.0 * np.pi * (np.arange(azimuths) + 0.5) / azimuths
    sine, cosine = np.sqrt(1.0 - c * c)[:, None], c[:, None]
    z = cosine if side == "front" else -cosine
    directions = np.stack(np.broadcast_arrays(sine * np.cos(turn), sine * np.sin(turn), z), axis=-1).reshape(-1, 3)
    return directions, np.repeat(ring_weight / azimuths, azimuths)


def stack_hemispherical(
    stack: Stack,
    *,
    side: str,
    wavelength_nm: float | None,
    polarisation: str,
    tolerance: float,
    rings: int,
    azimuths: int,
) -> xr.Dataset:
    """What :meth:`Stack.hemispherical` returns."""
    one_of("side", side, SIDES)
    rings, azimuths = whole("rings", rings, 1), whole("azimuths", azimuths, 1)
    refuse_rough(stack)
    wavelength = None if wavelength_nm is None else number("wavelength_nm", wavelength_nm)
    optics, at = stack_optics(stack, wavelength_nm=wavelength, polarisation=polarisation, tolerance=tolerance)
    directions, weights = diffuse_directions(side, rings, azimuths)
    columns = np.asarray(weights @ optics.shares(directions))
    attributes = provenance(
        layers=stack_described(stack),
        side=side,
        polarisation=polarisation,
        tolerance=tolerance,
        rings=rings,
        azimuths=azimuths,
        wavelength_nm=list(at.wavelength_nm),
        wavelength_weights=list(at.weights),
    )
    return xr.Dataset(share_variables((), columns), layer_coordinates(stack), attributes)
