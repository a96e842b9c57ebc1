"""Panes and published formulas: a plane-parallel slab, a glass polynomial, Edmonds' rules for laser-cut panels."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clerestory import _native
from clerestory.array_rules import within
from clerestory.elementwise import FloatOrArray, elementwise

Polarisation = Literal["resolved", "averaged", "s", "p"]


class PaneShares(NamedTuple):
    """Where the power that meets a pane goes; the three add to 1."""

    transmittance: FloatOrArray
    reflectance: FloatOrArray
    absorptance: FloatOrArray


def cos_of_incidence(incidence_deg: ArrayLike) -> NDArray[np.float64]:
    """Cosines of angles of incidence from 0 to 90 degrees; at 90 exactly 0."""
    angle = within("incidence_deg", incidence_deg, 0.0, 90.0, way_out="give the angle between the light and the normal")
    return np.where(angle == 90.0, 0.0, np.cos(np.radians(angle)))


def _index(n: ArrayLike) -> NDArray[np.float64]:
    return within("n", n, 1.0, way_out="give the index relative to air")


def tregenza_sharples(incidence_deg: ArrayLike) -> FloatOrArray:
    r"""Transmittance of 6 mm clear float glass, absorption included, as a polynomial.

    Parameters
    ----------
    incidence_deg : array_like, 0 to 90 [degrees]

    Returns
    -------
    float or ndarray of the same shape [0..1]

    Raises
    ------
    ClerestoryError
        If an angle is outside 0 to 90 degrees or not a number.

    Notes
    -----
    :math:`t = -0.028378 + 3.156075c - 3.058376c^2 - 1.428919c^3 + 4.014235c^4 - 1.775827c^5`, c = cos i
    (theory/glass.md, eq. 8). Negative as published beyond 89.48°: clamped at 0 there.
    P. R. Tregenza, S. Sharples, *Daylighting Algorithms*, ETSU S 1350, 1993.
    """
    return elementwise(lambda c: [_native.tregenza_sharples(c)], cos_of_incidence(incidence_deg))[0]


def edmonds_greenup_compagnon(incidence_deg: ArrayLike, n: ArrayLike) -> FloatOrArray:
    r"""Reflectance of one clear surface for unpolarised light from the air.

    Parameters
    ----------
    incidence_deg : array_like, 0 to 90 [degrees]
    n : array_like, at least 1
        Refractive index, A in the paper. Broadcasts with ``incidence_deg``.

    Returns
    -------
    float or ndarray of the broadcast shape [0..1]

    Raises
    ------
    ClerestoryError
        If an angle is outside 0 to 90 degrees, an index below 1, or the shapes do not broadcast.

    Notes
    -----
    :math:`R = \tfrac12 (r_{te}^2 + r_{tm}^2)` with :math:`r_{te} = (c - q)/(c + q)`,
    :math:`r_{tm} = (A^2c - q)/(A^2c + q)`,
    :math:`q = \sqrt{A^2 - 1 + c^2}` (theory/glass.md, eqs. 5 to 7). P. Greenup, I. R. Edmonds,
    R. Compagnon, Lighting Research and Technology 32, 49-54, 2000.
    """
    return elementwise(
        lambda c, a: [_native.edmonds_greenup_compagnon(c, a)], cos_of_incidence(incidence_deg), _index(n)
    )[0]


def slab(
    incidence_deg: ArrayLike,
    n: ArrayLike,
    *,
    absorption_per_mm: ArrayLike = 0.0,
    thickness_mm: ArrayLike = 1.0,
    polarisation: Polarisation = "resolved",
) -> PaneShares:
    r"""What a plane-parallel pane in air does to light: every inner reflection, absorption along the true path.

    Parameters
    ----------
    incidence_deg : array_like, 0 to 90 [degrees]
    n : array_like, at least 1
    absorption_per_mm : array_like, at least 0, default 0 [1/mm]
    thickness_mm : array_like, greater than 0, default 1 [mm]
        Without absorption it does not matter. All four broadcast.
    polarisation : {"resolved", "averaged", "s", "p"}, default "resolved"
        Unpolarised light with s and p followed apart (exact), unpolarised again at every surface (as in much of the
        literature), or one polarisation alone.

    Returns
    -------
    PaneShares of transmittance, reflectance, absorptance
        Each a float or an ndarray of the broadcast shape [0..1]; they add to 1.

    Raises
    ------
    ClerestoryError
        If an argument is out of its range or the shapes do not broadcast.

    Notes
    -----
    :math:`T = (1 - R)^2 \tau / (1 - R^2 \tau^2)`, reflected :math:`R (1 + \tau T)`,
    :math:`\tau = e^{-\alpha d / \cos\theta_t}` (theory/glass.md, eqs. 1 to 3), R by Fresnel. No interference: the pane
    is thicker than daylight is coherent.
    """
    results = elementwise(
        lambda c, a, depth: _native.slab(c, a, depth, polarisation),
        cos_of_incidence(incidence_deg),
        _index(n),
        _optical_depth(absorption_per_mm, thickness_mm),
    )
    return PaneShares(*results)


def slab_single_pass(
    incidence_deg: ArrayLike, n: ArrayLike, *, absorption_per_mm: ArrayLike = 0.0, thickness_mm: ArrayLike = 1.0
) -> FloatOrArray:
    r"""Transmittance of a pane when its inner reflections are left out.

    Parameters, shapes and errors as of :func:`slab`; unpolarised light, R the mean of s and p.

    Returns
    -------
    float or ndarray of the broadcast shape [0..1]

    Notes
    -----
    :math:`(1 - R)^2 \tau` (theory/glass.md, eq. 4).
    """
    return elementwise(
        lambda c, a, depth: [_native.slab_single_pass(c, a, depth)],
        cos_of_incidence(incidence_deg),
        _index(n),
        _optical_depth(absorption_per_mm, thickness_mm),
    )[0]


def edmonds_deflected_fraction(
    incidence_deg: ArrayLike, n: ArrayLike, *, spacing_mm: ArrayLike, thickness_mm: ArrayLike
) -> FloatOrArray:
    r"""Share of the light inside an ideal laser-cut panel that leaves it deflected.

    Parameters
    ----------
    incidence_deg : array_like, 0 to 90 [degrees]
        In the plane across the cuts.
    n : array_like, at least 1
    spacing_mm : array_like, greater than 0 [mm]
        Between the cuts, D in the paper.
    thickness_mm : array_like, greater than 0 [mm]
        Of the panel, W in the paper. All four broadcast.

    Returns
    -------
    float or ndarray of the broadcast shape [0..1]

    Raises
    ------
    ClerestoryError
        If an argument is out of its range or the shapes do not broadcast.

    Notes
    -----
    A triangle wave of :math:`x = (W/D) \tan(\arcsin(\sin\theta / n))`: 0 at x = 0, 2, 4 …, 1 at x = 1, 3, 5 …
    (theory/glass.md, eqs. 9 and 10). Surface losses are not in it, and every cut is taken to mirror all light.
    I. R. Edmonds, Solar Energy Materials and Solar Cells 29, 1-26, 1993.
    """
    spacing = within("spacing_mm", spacing_mm, 0.0, open_low=True, way_out="give the distance between cuts")
    ratio, *_ = elementwise(lambda w, d: [w / d], _thickness(thickness_mm), spacing)
    return elementwise(
        lambda c, a, w_over_d: [_native.edmonds_deflected_fraction(c, a, w_over_d)],
        cos_of_incidence(incidence_deg),
        _index(n),
        ratio,
    )[0]


def edmonds_panel_tilt_deg(sun_altitude_deg: ArrayLike) -> FloatOrArray:
    r"""Tilt of a laser-cut panel that sends the sun's light into the room at 8° above the horizontal.

    Parameters
    ----------
    sun_altitude_deg : array_like, -90 to 90 [degrees]
        Above the horizon, E in the paper.

    Returns
    -------
    float or ndarray of the same shape [degrees]
        Negative for a sun below 8°.

    Raises
    ------
    ClerestoryError
        If an altitude is outside -90 to 90 degrees or not a number.

    Notes
    -----
    :math:`\tfrac12 (E - 8°)` (theory/glass.md, eq. 11).
    I. R. Edmonds, Solar Energy Materials and Solar Cells 29, 1-26, 1993.
    """
    altitude = within("sun_altitude_deg", sun_altitude_deg, -90.0, 90.0, way_out="give the angle above the horizon")
    return elementwise(lambda e: [np.degrees(_native.edmonds_panel_tilt(e))], np.radians(altitude))[0]


def _thickness(thickness_mm: ArrayLike) -> NDArray[np.float64]:
    return within("thickness_mm", thickness_mm, 0.0, open_low=True, way_out="give the distance between the faces")


def _optical_depth(absorption_per_mm: ArrayLike, thickness_mm: ArrayLike) -> FloatOrArray:
    absorption = within("absorption_per_mm", absorption_per_mm, 0.0, way_out="use 0 for a lossless medium")
    return elementwise(lambda a, d: [a * d], absorption, _thickness(thickness_mm))[0]
