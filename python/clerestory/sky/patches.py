"""Mean luminance of each patch of a sky."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
import numpy.typing as npt
from numpy.polynomial.legendre import leggauss

from clerestory.sky.basis import sky_basis
from clerestory.sky.cie import Array

_ROUND = np.pi / 3
"""A patch wider than this in azimuth, such as the zenith cap, is cut into sectors of at most this width."""


@lru_cache(maxsize=4)
def patch_nodes(basis: str, order: int) -> tuple[Array, Array, npt.NDArray[np.int64]]:
    """Directions, weights and bounds of a quadrature over every sky patch.

    Returns
    -------
    directions : ndarray, shape (n, 3)
    weights : ndarray, shape (n,)
        Summing to 1 within each patch.
    starts : ndarray of int, shape (patches,)
        Where each patch begins; the last ends with the arrays. The ground is left out.
    """
    bounds = np.asarray(sky_basis(basis).bounds)[:-1]
    nodes, weights = leggauss(order)
    nodes, weights = (1.0 + nodes) / 2.0, weights / 2.0
    sectors = np.ceil((bounds[:, 3] - bounds[:, 2]) / _ROUND - 1e-9).astype(int)
    owner = np.repeat(np.arange(len(bounds)), sectors)
    sector = np.arange(len(owner)) - np.repeat(np.cumsum(sectors) - sectors, sectors)
    width = ((bounds[:, 3] - bounds[:, 2]) / sectors)[owner]
    low, high = np.sin(bounds[owner, 0]), np.sin(bounds[owner, 1])
    # equal steps of sin γ are equal solid angles
    sine = (low[:, None] + (high - low)[:, None] * nodes)[:, :, None]
    azimuth = (bounds[owner, 2] + sector * width)[:, None, None] + (width[:, None] * nodes)[:, None, :]
    sine, azimuth = np.broadcast_arrays(sine, azimuth)
    cosine = np.sqrt(1.0 - sine**2)
    directions = np.stack([cosine * np.sin(azimuth), cosine * np.cos(azimuth), sine], axis=-1).reshape(-1, 3)
    share = np.outer(weights, weights)[None] / sectors[owner][:, None, None]
    starts = (np.cumsum(sectors) - sectors) * order**2
    return directions, share.ravel(), starts


def patch_means(luminance: Callable[[Array], Array], *, basis: str, order: int = 6) -> Array:
    r"""Mean of a luminance over each sky patch.

    Parameters
    ----------
    luminance : callable
        Unit vectors of shape (n, 3) in the upper hemisphere → luminances of shape (n,).
    basis : str
        Name of a sky basis.
    order : int, default 6
        Gauss-Legendre points each way in a patch.

    Returns
    -------
    ndarray, shape (patches,)
        Of the sky patches; the ground is left out.

    Notes
    -----
    :math:`L_p = \Omega_p^{-1} \int_p L\, d\omega` (theory/sky.md, eq. 6), not the value at the centre: the sum of
    L_p Ω_p is the integral of the sky.
    """
    directions, weights, starts = patch_nodes(basis, order)
    return np.asarray(np.add.reduceat(luminance(directions) * weights, starts))
