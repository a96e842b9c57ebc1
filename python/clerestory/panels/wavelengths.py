"""Which wavelengths a question is answered at, and what each of them counts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clerestory.errors import ClerestoryError
from clerestory.medium import Medium
from clerestory.panels.incidence import finite
from clerestory.spectrum import photopic_quadrature

Floats = NDArray[np.float64]

#: Nodes of the photopic quadrature.
PHOTOPIC_NODES = 5


@dataclass(frozen=True, slots=True)
class Samples:
    """Wavelengths and weights, and the media at each of them.

    ``n`` and ``absorption_per_mm`` have shape (wavelength, medium); ``wavelength_nm`` is empty where none matters.
    """

    wavelength_nm: tuple[float, ...]
    weights: tuple[float, ...]
    n: Floats
    absorption_per_mm: Floats


def samples(media: Sequence[Medium], wavelength_nm: float | None) -> Samples:
    """The media at one wavelength, or at those that stand for daylight as the eye weighs it.

    Parameters
    ----------
    media : sequence of Medium, shape (m,)
    wavelength_nm : float, optional [nm]
        None: no wavelength if no medium is spectral, else the photopic quadrature under D65 (theory/media.md, eq. 8).

    Raises
    ------
    ClerestoryError
        If a wavelength is outside the range of a medium.
    """
    wavelengths: tuple[float, ...]
    if wavelength_nm is not None:
        wavelengths, weights = (float(wavelength_nm),), (1.0,)
    elif any(medium.is_spectral for medium in media):
        nodes, shares = photopic_quadrature("D65", PHOTOPIC_NODES)
        wavelengths, weights = tuple(nodes.tolist()), tuple(shares.tolist())
    else:
        wavelengths, weights = (), (1.0,)
    at = np.array(wavelengths) if wavelengths else None
    rows = len(weights)
    n, absorption = np.empty((rows, len(media))), np.empty((rows, len(media)))
    for column, medium in enumerate(media):
        n[:, column] = medium.index(at)
        absorption[:, column] = medium.absorption_per_mm_at(at)
    return Samples(wavelengths, weights, n, absorption)


def asked_wavelengths(wavelength_nm: ArrayLike | None) -> Floats | None:
    """``wavelength_nm`` of a question as an array of no or one dimension; None stays None."""
    if wavelength_nm is None:
        return None
    array = finite("wavelength_nm", wavelength_nm)
    if array.ndim > 1 or array.size == 0:
        raise ClerestoryError(f"wavelength_nm must be a number or a list of numbers, got shape {array.shape}")
    if not np.all(array > 0.0):
        raise ClerestoryError(f"wavelength_nm must be greater than 0, got {array.min():g}; give nanometres")
    return array
