"""What the page draws of a BSDF: its findings, discs and cuts."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from clerestory.bsdf import Bsdf, KlemsBlock, klems_basis
from clerestory.bsdf.cells import outgoing_cells, patch_outline
from clerestory.bsdf.klems import KlemsBasis
from clerestory.bsdf.summary import summary
from clerestory.plots.bsdf_incidence import Side, picked, travel_xy
from clerestory.rules import within
from clerestory.studio.bsdf.shelf import Opened

#: Digits of outlines, whose radius is 90, and the step along their curved edges [rad].
_DIGITS = 1
_EDGE_STEP = np.radians(6.0)
#: Directions of a cut.
_CUT_STEPS = 721
#: Elevations of a curve, and how near to grazing it goes [degrees].
_CURVE_STEPS, _STEEPEST_DEG = 179, 89.0


def told(key: str, opened: Opened) -> dict[str, Any]:
    """Product, shares, what was assumed and what may be wrong."""
    findings = [{"severity": one.severity, "where": one.where, "text": one.text} for one in opened.findings]
    return {"key": key, **summary(opened.bsdf), "assumed": list(opened.assumed), "findings": findings}


def discs(bsdf: Bsdf, *, elevation_deg: Any, azimuth_deg: Any, side: Side, band: str) -> dict[str, Any]:
    """The incident disc and, for one incidence, the outgoing ones.

    Returns
    -------
    dict
        ``incident``: ``cells`` (outlines, the angle from the normal as distance from the middle, in degrees) and
        ``values`` (share of each incidence that passes or comes back, of the first block); ``picked``, the patch;
        ``point``, where the light travels; ``outgoing``: for each block its ``word``, ``cells``, ``values`` [1/sr] and
        the ``share`` of the power that leaves.
    """
    blocks, point = picked(bsdf, band, side, elevation_deg, azimuth_deg)
    first, block = next(iter(blocks.items()))
    basis = block.incident if isinstance(block, KlemsBlock) else klems_basis("klems_full")
    outgoing = []
    for word, one in blocks.items():
        if isinstance(one, KlemsBlock):
            cells = _patches(one.outgoing)
            values = one.values[:, int(one.incident.find(point[0], point[1]))]
        else:
            outlines, values = outgoing_cells(one, point)
            cells = _spread_all(outlines)
        outgoing.append(
            {
                "word": word,
                "cells": cells,
                "values": values,
                "share": float(one.hemispherical_at(point)),
                "mean": one.mean(),
                "standard_error": _error_at(one, point),
            }
        )
    return {
        "incident": {
            "word": first,
            "cells": _patches(basis),
            "values": block.hemispherical_at(basis.centre),
        },
        "picked": int(basis.find(point[0], point[1])),
        "point": _spread(point[None])[0],
        "outgoing": outgoing,
    }


def cut(bsdf: Bsdf, *, elevation_deg: Any, azimuth_deg: Any, side: Side, band: str, plane_deg: Any) -> dict[str, Any]:
    """The light of one incidence in a plane through the normal, turned from the vertical by ``plane_deg``."""
    blocks, point = picked(bsdf, band, side, elevation_deg, azimuth_deg)
    tilt = np.radians(within("plane_deg", plane_deg, -90.0, 90.0))
    along = np.array([np.sin(tilt), np.cos(tilt)])
    angle_deg = np.linspace(-89.9, 89.9, _CUT_STEPS)
    xy = np.sin(np.radians(angle_deg))[:, None] * along
    return {
        "angle_deg": angle_deg,
        "from_deg": float(np.degrees(np.arcsin(np.clip(-point @ along, -1.0, 1.0)))),
        "curves": [{"word": word, "values": block.at(point, xy)} for word, block in blocks.items()],
    }


def curve(bsdf: Bsdf, *, azimuth_deg: Any, side: Side, band: str) -> dict[str, Any]:
    """The shares that pass and come back against elevation: hemispherical, of light from one direction each."""
    blocks, _ = picked(bsdf, band, side, 0.0, azimuth_deg)
    elevation_deg = np.linspace(-_STEEPEST_DEG, _STEEPEST_DEG, _CURVE_STEPS)
    points = travel_xy(elevation_deg, azimuth_deg)
    curves = [{"word": word, "values": block.hemispherical_at(points)} for word, block in blocks.items()]
    return {"elevation_deg": elevation_deg, "curves": curves}


def incidence_of(x: Any, y: Any) -> dict[str, float]:
    """Where light comes from that travels along a point of a disc (degrees from the middle, right and up)."""
    right, up = within("x", x, -90.0, 90.0), within("y", y, -90.0, 90.0)
    angle = np.radians(min(float(np.hypot(right, up)), 89.9))
    turn = np.arctan2(up, right)
    sx, sy, sz = np.sin(angle) * np.cos(turn), np.sin(angle) * np.sin(turn), np.cos(angle)
    return {
        "elevation_deg": float(np.degrees(np.arcsin(-sy))),
        "azimuth_deg": float(np.degrees(np.arctan2(sx, sz))),
    }


@lru_cache(maxsize=32)
def _patches(basis: KlemsBasis) -> list[Any]:
    """Outlines of a basis's patches on a disc."""
    return _spread_all([patch_outline(basis, patch, _EDGE_STEP) for patch in range(len(basis))])


def _error_at(block: Any, point: Any) -> float | None:
    """Standard error of the share that leaves, of a matrix that was found by random draws."""
    errors = block.hemispherical_standard_error() if isinstance(block, KlemsBlock) else None
    return None if errors is None else float(errors[int(block.incident.find(point[0], point[1]))])


def _spread_all(cells: list[Any]) -> list[Any]:
    """Outlines as they are drawn."""
    points = _spread(np.concatenate(cells)).tolist()
    ends = np.cumsum([len(cell) for cell in cells]).tolist()
    return [points[end - len(cell) : end] for cell, end in zip(cells, ends, strict=True)]


def _spread(xy: np.ndarray[Any, np.dtype[np.float64]]) -> Any:
    """(x, y) of directions with their angle from the normal as distance from the middle [degrees]."""
    sine = np.hypot(xy[:, 0], xy[:, 1])
    angle = np.degrees(np.arcsin(np.minimum(sine, 1.0)))
    return np.round(xy * np.where(sine > 0.0, angle / np.where(sine > 0.0, sine, 1.0), 1.0)[:, None], _DIGITS)
