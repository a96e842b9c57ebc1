"""What the eye makes of a spectrum: photopic means, the few wavelengths that stand for one, and the colour of each."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clerestory.array_rules import numbers, within
from clerestory.errors import ClerestoryError

Floats = NDArray[np.float64]
Illuminant = Literal["D65", "E"]

#: XYZ of a D65 white of Y = 1 to linear sRGB (IEC 61966-2-1).
_LINEAR_SRGB = np.array(
    [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]], dtype=np.float64
)


@cache
def _observer() -> dict[str, Floats]:
    """The packaged table, column by column."""
    text = (files("clerestory") / "data" / "cie_observer_d65_5nm.csv").read_text(encoding="utf-8")
    heading, *rows = (line.split(",") for line in text.splitlines() if not line.startswith("#"))
    values = np.array(rows, dtype=np.float64).T
    columns: dict[str, Floats] = dict(zip(heading, values, strict=True))
    for column in columns.values():
        column.setflags(write=False)
    return columns


def luminous_efficiency() -> tuple[Floats, Floats]:
    """The photopic luminous efficiency V(λ) of CIE 1924.

    Returns
    -------
    wavelength_nm : ndarray, shape (81,) [nm]
        380 to 780 nm, every 5 nm.
    efficiency : ndarray, shape (81,) [0..1]
        1 at 555 nm.
    """
    return _observer()["wavelength_nm"], _observer()["y_bar"]


def illuminant_power(illuminant: Illuminant = "D65") -> tuple[Floats, Floats]:
    """Relative spectral power of a CIE standard illuminant.

    Parameters
    ----------
    illuminant : {"D65", "E"}
        Average daylight of 6504 K, or equal power at every wavelength.

    Returns
    -------
    wavelength_nm : ndarray, shape (81,) [nm]
        380 to 780 nm, every 5 nm.
    power : ndarray, shape (81,)
        100 at 560 nm.

    Raises
    ------
    ClerestoryError
        If the illuminant is another.
    """
    wavelength_nm = _observer()["wavelength_nm"]
    if illuminant == "D65":
        return wavelength_nm, _observer()["d65"]
    if illuminant == "E":
        return wavelength_nm, np.full_like(wavelength_nm, 100.0)
    raise ClerestoryError(f"illuminant must be D65 or E, got {illuminant!r}; D65 is average daylight")


def colour_matching() -> tuple[Floats, Floats]:
    """The colour matching functions x̄, ȳ, z̄ of the CIE 1931 2° observer.

    Returns
    -------
    wavelength_nm : ndarray, shape (81,) [nm]
        380 to 780 nm, every 5 nm.
    xyz : ndarray, shape (81, 3)
        The second column is V(λ).
    """
    table = _observer()
    return table["wavelength_nm"], np.stack([table["x_bar"], table["y_bar"], table["z_bar"]], axis=-1)


def _photopic_weights(illuminant: Illuminant) -> tuple[Floats, Floats]:
    """V(λ)·S(λ) at the table's wavelengths, in shares of 1: CIE's summation every 5 nm (theory/media.md, eq. 7)."""
    wavelength_nm, power = illuminant_power(illuminant)
    weights = luminous_efficiency()[1] * power
    return wavelength_nm, weights / weights.sum()


def photopic_mean(wavelength_nm: ArrayLike, values: ArrayLike, illuminant: Illuminant = "D65") -> float | Floats:
    """Mean of a spectral quantity as the eye weighs it: visible transmittance from spectral transmittance, say.

    Parameters
    ----------
    wavelength_nm : array_like, shape (w,), increasing, from 380 nm or below to 780 nm or above [nm]
    values : array_like, shape (..., w)
        The quantity; straight lines between the wavelengths.
    illuminant : {"D65", "E"}, default "D65"

    Returns
    -------
    float or ndarray, shape (...)

    Raises
    ------
    ClerestoryError
        If the wavelengths do not increase or do not span 380 to 780 nm, or a value is not finite.

    Notes
    -----
    Σ V S x / Σ V S over 380 (5) 780 nm (theory/media.md, eq. 7; CIE 015:2018; ASTM E308). Where a medium is not
    known over the whole visible range, take :func:`photopic_quadrature`, whose nodes lie well inside it.
    """
    nodes, weights = _photopic_weights(illuminant)
    known, spectrum = numbers("wavelength_nm", wavelength_nm), numbers("values", values)
    if known.ndim != 1 or spectrum.ndim == 0 or spectrum.shape[-1] != known.size:
        raise ClerestoryError(
            f"values must have one entry a wavelength on their last axis, got {spectrum.shape} for {known.shape}; "
            "transpose or complete them"
        )
    if known.size < 2 or not np.all(np.diff(known) > 0):
        raise ClerestoryError("wavelength_nm must be two or more increasing wavelengths, got others; sort them")
    if known[0] > nodes[0] or known[-1] < nodes[-1]:
        raise ClerestoryError(
            f"wavelength_nm must span {nodes[0]:g} to {nodes[-1]:g} nm, got {known[0]:g} to {known[-1]:g} nm; "
            "measure further, or take the nodes of photopic_quadrature"
        )
    within("values", spectrum, -np.inf, way_out="replace what is not a finite number")
    upper = np.searchsorted(known, nodes).clip(1, known.size - 1)
    share = (nodes - known[upper - 1]) / (known[upper] - known[upper - 1])
    mean: Floats = (spectrum[..., upper - 1] * (1.0 - share) + spectrum[..., upper] * share) @ weights
    return float(mean) if mean.ndim == 0 else mean


def photopic_quadrature(illuminant: Illuminant = "D65", nodes: int = 5) -> tuple[Floats, Floats]:
    """A few wavelengths and weights whose weighted sum is the photopic mean of anything smooth.

    Parameters
    ----------
    illuminant : {"D65", "E"}, default "D65"
    nodes : int, 1 to 20, default 5

    Returns
    -------
    wavelength_nm : ndarray, shape (nodes,), increasing [nm]
    weights : ndarray, shape (nodes,)
        Positive; their sum is 1.

    Raises
    ------
    ClerestoryError
        If ``nodes`` is not a whole number from 1 to 20.

    Notes
    -----
    Gauss quadrature for the weight V(λ)·S(λ) on 380 (5) 780 nm: exact for polynomials of λ up to degree 2·nodes − 1
    (theory/media.md, eq. 8). The recurrence of the orthogonal polynomials comes from Stieltjes' procedure, nodes and
    weights from its Jacobi matrix: G. H. Golub, J. H. Welsch, Mathematics of Computation 23, 221-230, 1969;
    W. Gautschi, *Orthogonal Polynomials*, 2004, §2.2.
    """
    if isinstance(nodes, bool) or not isinstance(nodes, (int, np.integer)) or not 1 <= nodes <= 20:
        raise ClerestoryError(f"nodes must be a whole number from 1 to 20, got {nodes!r}; 5 serves smooth spectra")
    table_nm, weights = _photopic_weights(illuminant)
    return gauss_quadrature(table_nm, weights, nodes)


def gauss_quadrature(table_nm: Floats, weights: Floats, nodes: int) -> tuple[Floats, Floats]:
    """The nodes and weights of Gauss quadrature for a weight of sum 1 on given wavelengths (theory/media.md, eq. 8)."""
    centre, half = 0.5 * (table_nm[0] + table_nm[-1]), 0.5 * (table_nm[-1] - table_nm[0])
    x = (table_nm - centre) / half
    # p_{k+1} = (x − a_k) p_k − b_k p_{k−1}, each orthogonal to all before
    diagonal, beside = np.zeros(nodes), np.zeros(nodes)
    before, current, norm_before = np.zeros_like(x), np.ones_like(x), 1.0
    for k in range(nodes):
        norm = float(weights @ current**2)
        diagonal[k] = weights @ (x * current**2) / norm
        beside[k] = norm / norm_before
        before, current = current, (x - diagonal[k]) * current - (beside[k] if k else 0.0) * before
        norm_before = norm
    # the Jacobi matrix: eigenvalues are the nodes, first components of its eigenvectors the roots of the weights
    jacobi = np.diag(diagonal) + np.diag(np.sqrt(beside[1:]), 1) + np.diag(np.sqrt(beside[1:]), -1)
    eigenvalues, eigenvectors = np.linalg.eigh(jacobi)
    return centre + half * eigenvalues, eigenvectors[0] ** 2


def srgb(xyz: ArrayLike) -> Floats:
    """Colours for a screen.

    Parameters
    ----------
    xyz : array_like, shape (..., 3)
        CIE XYZ, a white of D65 having Y = 1.

    Returns
    -------
    ndarray, shape (..., 3) [0..1]
        Gamma-encoded sRGB. A colour outside the screen's gamut is made paler, by as much white as its most negative
        channel lacks; one brighter than the screen is scaled down to its brightest channel.

    Notes
    -----
    IEC 61966-2-1:1999.
    """
    array = within("xyz", xyz, -np.inf, way_out="replace what is not a finite number")
    if array.ndim == 0 or array.shape[-1] != 3:
        raise ClerestoryError(f"xyz must have 3 values on its last axis, got shape {array.shape}; give X, Y and Z")
    linear = array @ _LINEAR_SRGB.T
    # as much white as the most negative channel lacks
    linear = linear - np.minimum(linear.min(axis=-1, keepdims=True), 0.0)
    linear = linear / np.maximum(linear.max(axis=-1, keepdims=True), 1.0)
    encoded: Floats = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return encoded


def srgb_of_wavelength(wavelength_nm: ArrayLike) -> Floats:
    """Colours that stand for single wavelengths in a plot of dispersion.

    Parameters
    ----------
    wavelength_nm : array_like, 380 to 780 [nm]

    Returns
    -------
    ndarray, shape (..., 3) [0..1]
        sRGB of the wavelength's hue, paler where the screen's gamut ends, darker where the eye's sensitivity ends.

    Raises
    ------
    ClerestoryError
        If a wavelength is outside 380 to 780 nm.
    """
    table_nm, xyz = colour_matching()
    wavelengths = within(
        "wavelength_nm", wavelength_nm, table_nm[0], table_nm[-1], way_out="light outside this range has no colour"
    )
    return srgb(np.stack([np.interp(wavelengths, table_nm, column) for column in xyz.T], axis=-1))
