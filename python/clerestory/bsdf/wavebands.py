"""The wavelengths that stand for a band of a BSDF, and what each counts."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from clerestory.errors import ClerestoryError
from clerestory.medium import Medium
from clerestory.panels.wavelengths import Samples
from clerestory.spectrum import colour_matching, gauss_quadrature, illuminant_power

Floats = NDArray[np.float64]

#: Groups of equal solar power, by how strongly the first absorbing medium absorbs.
SOLAR_GROUPS = 4


@cache
def solar_power() -> tuple[Floats, Floats]:
    """Power of direct sunlight through 1.5 air masses: ASTM G173-03, which ISO 9845-1 shares, as pvlib holds it.

    Returns
    -------
    wavelength_nm : ndarray, shape (w,) [nm]
        280 to 4000 nm.
    power : ndarray, shape (w,) [W/m²]
        Of the interval that each wavelength stands for.
    """
    from pvlib.spectrum import get_reference_spectra

    table = get_reference_spectra(standard="ASTM G173-03")["direct"]
    wavelength_nm = table.index.to_numpy(dtype=np.float64)
    return wavelength_nm, table.to_numpy(dtype=np.float64) * np.gradient(wavelength_nm)


def band_samples(media: Sequence[Medium], band: str, nodes: int) -> tuple[Samples, float]:
    """The media at the wavelengths of a band.

    Parameters
    ----------
    media : sequence of Medium, shape (m,)
    band : {"visible", "x", "z", "solar"}
        CIE Y, X and Z of daylight (D65), or sunlight's power.
    nodes : int, at least 1
        Wavelengths of the first three: Gauss quadrature for the weight of the band (theory/media.md, eq. 8).

    Returns
    -------
    Samples
    float, 0..1
        Share of the band's power at wavelengths where all media are known; the samples stand for that share alone.

    Notes
    -----
    Sunlight: wavelengths are grouped by absorption into :data:`SOLAR_GROUPS` groups of equal power, each with the mean
    index and the mean absorption of its wavelengths (theory/bsdf_averaging.md, eq. 11); one group if no medium absorbs.
    """
    if not any(medium.is_spectral for medium in media):
        wavelength_nm, weights = np.empty(0), np.ones(1)
        n = np.array([[medium.index(None) for medium in media]], dtype=np.float64)
        absorption = np.array([[medium.absorption_per_mm_at(None) for medium in media]], dtype=np.float64)
        return Samples((), (1.0,), n, absorption), 1.0
    if band == "solar":
        wavelength_nm, weights = solar_power()
    else:
        wavelength_nm, power = illuminant_power("D65")
        weights = power * colour_matching()[1][:, ["x", "visible", "z"].index(band)]
    whole = weights.sum()
    ranges = [medium.wavelength_range_nm for medium in media]
    low = max((r[0] for r in ranges if r is not None), default=0.0)
    high = min((r[1] for r in ranges if r is not None), default=np.inf)
    known = (wavelength_nm >= low) & (wavelength_nm <= high)
    if not weights[known].sum() > 0.0:
        raise ClerestoryError(
            f"bands must be known to the media, whose range is {low:g} to {high:g} nm; leave {band!r} out"
        )
    wavelength_nm, weights = wavelength_nm[known], weights[known]
    share = float(weights.sum() / whole)
    if band == "solar":
        return _grouped(media, wavelength_nm, weights), share
    at, parts = gauss_quadrature(wavelength_nm, weights / weights.sum(), nodes)
    return _sampled(media, at, parts), share


def _sampled(media: Sequence[Medium], wavelength_nm: Floats, weights: Floats) -> Samples:
    n = np.stack([np.broadcast_to(medium.index(wavelength_nm), wavelength_nm.shape) for medium in media], axis=-1)
    absorption = np.stack(
        [np.broadcast_to(medium.absorption_per_mm_at(wavelength_nm), wavelength_nm.shape) for medium in media], axis=-1
    )
    return Samples(tuple(wavelength_nm.tolist()), tuple(weights.tolist()), n, absorption)


def _grouped(media: Sequence[Medium], wavelength_nm: Floats, weights: Floats) -> Samples:
    every = _sampled(media, wavelength_nm, weights)
    strength = every.absorption_per_mm.sum(axis=1)
    groups = SOLAR_GROUPS if strength.max() > 0.0 else 1
    order = np.argsort(strength, kind="stable")
    upto = np.cumsum(weights[order]) / weights.sum()
    group = np.minimum((upto * groups).astype(int), groups - 1)
    parts, n, absorption, mean_nm = [], [], [], []
    for g in range(groups):
        members = order[group == g]
        share = weights[members] / weights[members].sum()
        parts.append(weights[members].sum() / weights.sum())
        n.append(share @ every.n[members])
        absorption.append(share @ every.absorption_per_mm[members])
        mean_nm.append(float(share @ wavelength_nm[members]))
    return Samples(tuple(mean_nm), tuple(parts), np.array(n), np.array(absorption))
