"""The map between disc and square that keeps areas, in which tensor trees are written."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


def disc_to_square(xy: npt.ArrayLike) -> Floats:
    """Points of the unit square for points of the unit disc, both of shape (..., 2) (theory/bsdf.md, eq. 7).

    Notes
    -----
    Concentric squares and circles correspond; areas are kept up to the constant π. P. Shirley, K. Chiu, *A low
    distortion map between disk and square*, Journal of Graphics Tools 2(3), 1997.
    """
    xy = np.asarray(xy, dtype=np.float64)
    x, y = xy[..., 0], xy[..., 1]
    r = np.minimum(np.hypot(x, y), 1.0)
    # turned by 45° so that a sector belongs to one side of the square
    phi = np.arctan2(y, x)
    phi = np.where(phi < -np.pi / 4.0, phi + 2.0 * np.pi, phi)
    sector = np.minimum(np.floor((phi + np.pi / 4.0) / (np.pi / 2.0)), 3.0)
    along = r * (phi - sector * np.pi / 2.0) / (np.pi / 4.0)
    a = np.choose(sector.astype(np.int64), [r, -along, -r, along])
    b = np.choose(sector.astype(np.int64), [along, r, -along, -r])
    return np.stack([0.5 * (a + 1.0), 0.5 * (b + 1.0)], axis=-1)


def square_to_disc(uv: npt.ArrayLike) -> Floats:
    """Points of the unit disc for points of the unit square: the inverse of :func:`disc_to_square`."""
    uv = np.asarray(uv, dtype=np.float64)
    a, b = 2.0 * uv[..., 0] - 1.0, 2.0 * uv[..., 1] - 1.0
    wide = np.abs(a) >= np.abs(b)
    r = np.where(wide, a, b)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(r == 0.0, 0.0, np.where(wide, b, a) / np.where(r == 0.0, 1.0, r))
    phi = np.where(wide, ratio * np.pi / 4.0, np.pi / 2.0 - ratio * np.pi / 4.0)
    return np.stack([r * np.cos(phi), r * np.sin(phi)], axis=-1)
