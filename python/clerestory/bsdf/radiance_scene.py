"""A window with a BSDF as lines of a Radiance scene."""

from __future__ import annotations

import math
from pathlib import PurePath
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from clerestory.bsdf.bsdf import Bsdf
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.errors import ClerestoryError
from clerestory.room.window import normal_of
from clerestory.rules import points, vector

if TYPE_CHECKING:
    import os

#: Share of the light from everywhere that must pass straight on before a peak is worth taking out.
_LEAST_STRAIGHT = 0.05


def radiance_snippet(
    bsdf: Bsdf,
    xml: str | os.PathLike[str],
    outline_m: ArrayLike,
    *,
    name: str = "window",
    up: tuple[float, float, float] | None = None,
    peak_extraction: bool | None = None,
) -> str:
    """Material and polygon of a window for a Radiance scene.

    Parameters
    ----------
    bsdf : Bsdf
    xml : path
        Of the file that :meth:`Bsdf.to_xml` wrote, as Radiance shall find it (no blanks: Radiance cannot read them).
    outline_m : array_like, shape (n, 3) [m]
        Corners anticlockwise as seen from the room, as of :class:`clerestory.Window`: the normal points inwards, which
        is Radiance's front.
    name : str, default "window"
    up : tuple of 3 floats, optional
        What is up for the element: its y axis is the part of this in the window's plane. Default the world's z, and
        north for a horizontal window.
    peak_extraction : bool, optional
        True writes ``aBSDF``, which replaces light that passes straight through its own patch by a sharp view; False
        writes ``BSDF``. Default: True for matrices of which at least 5 % of the light from everywhere stays on the
        diagonal, False for the rest and for trees. Light that is *redirected* is never sharpened (docs/how-to/bsdf.md).

    Returns
    -------
    str
        Text of two primitives.

    Raises
    ------
    ClerestoryError
        If the outline is no polygon, ``up`` stands across the window, or a name has blanks.
    """
    file = PurePath(xml).as_posix()
    for what, word in (("xml", file), ("name", name)):
        if not word or any(letter.isspace() for letter in word):
            raise ClerestoryError(f"{what} must be a word without blanks for Radiance, got {word!r}; rename it")
    corners = points("outline_m", outline_m)
    if len(corners) < 3 or not np.linalg.norm(normal := normal_of(corners)) > 0.0:
        raise ClerestoryError(
            f"outline_m must be a polygon of 3 corners or more with an area, got {len(corners)} corners"
        )
    y = _up(normal, up)
    sharp = _passes_straight_on(bsdf) if peak_extraction is None else peak_extraction
    words = " ".join(f"{component:.9g}" for component in y)
    material = (
        f"void aBSDF {name}_bsdf\n5 {file} {words} .\n0\n0\n"
        if sharp
        else f"void BSDF {name}_bsdf\n6 0 {file} {words} .\n0\n0\n"
    )
    rows = "\n".join("  " + " ".join(f"{value:.9g}" for value in corner) for corner in corners)
    heading = (
        f"# {' '.join(bsdf.name.split())}: the polygon's normal points into the room, the vector is the element's up\n"
    )
    return f"{heading}{material}\n{name}_bsdf polygon {name}\n0\n0\n{3 * len(corners)}\n{rows}\n"


def _up(
    normal: np.ndarray[tuple[int, ...], np.dtype[np.float64]], up: tuple[float, float, float] | None
) -> list[float]:
    """The element's y axis in the world: the part of ``up`` in the window's plane."""
    if up is None:
        wanted = np.array([0.0, 0.0, 1.0] if abs(normal[2]) < 1.0 - 1e-6 else [0.0, 1.0, 0.0])
    else:
        wanted = np.array(vector("up", up))
    y = wanted - normal * float(wanted @ normal)
    length = math.sqrt(float(y @ y))
    if length < 1e-6:
        raise ClerestoryError(f"up must not stand across the window, got {wanted.tolist()}; give another direction")
    return [float(f"{component:.9g}") + 0.0 for component in y / length]


def _passes_straight_on(bsdf: Bsdf) -> bool:
    block = bsdf.visible.transmission_front
    if not isinstance(block, KlemsBlock) or block.incident != block.outgoing:
        return False
    share = block.incident.projected_solid_angle
    return float((np.diagonal(block.values) * share**2).sum() / np.pi) >= _LEAST_STRAIGHT
