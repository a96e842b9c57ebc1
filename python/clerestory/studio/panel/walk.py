"""How light divides by rays: at once within a few tenths of a percent, and for rough panels the only way there is."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from clerestory import _native
from clerestory.panels.incidence import angles, incident_directions
from clerestory.panels.optics import walked_optics
from clerestory.rules import number

if TYPE_CHECKING:
    from clerestory.panels import Panel

#: Rays of an answer at once: a few milliseconds, 0.1 to 0.3 % of one standard error.
QUICK_RAYS = 8000
#: Rays of the first round of an answer that refines; each round has as many as all before it.
_FIRST, _MOST = 4000, 4_096_000
#: Standard error at which refining ends.
ENOUGH = 3e-4
#: Edges of the elevations among which light that leaves is counted [degrees].
EDGES_DEG = np.arange(-90.0, 90.1, 2.0)
#: Directions drawn in a round of the distribution at most.
_MOST_DRAWN = 100_000


def walked_shares(
    panel: Panel, *, elevation_deg: Any, azimuth_deg: Any, side: str = "front", rays: int = QUICK_RAYS, seed: int = 0
) -> dict[str, Any]:
    """``shares`` by rays, and the ``standard_errors`` of them; both by the names of :meth:`Panel.angular`."""
    optics, _ = walked_optics(panel, wavelength_nm=None, polarisation="resolved")
    mean, error = optics.walk_shares(_incident(elevation_deg, azimuth_deg, side), rays, seed)
    names = _native.PanelOptics.SHARES
    return {
        "shares": dict(zip(names, mean[0].tolist(), strict=True)),
        "standard_errors": dict(zip(names, error[0].tolist(), strict=True)),
        "rays": rays,
    }


def refining(
    panel: Panel, *, elevation_deg: Any, azimuth_deg: Any, side: str, seed: int = 0
) -> Iterator[dict[str, Any]]:
    """The same of ever more rays, until the standard errors are small; with ``distribution``, where the light leaves.

    Yields
    ------
    dict
        ``shares``, ``standard_errors``, ``rays`` so far; ``distribution`` with ``edges_deg`` of elevations and, for
        each side, the share of the light that leaves between two of them; ``share_done``, 0..1.
    """
    optics, _ = walked_optics(panel, wavelength_nm=None, polarisation="resolved")
    glazing, incident = optics.glazing(), _incident(elevation_deg, azimuth_deg, side)
    names = _native.PanelOptics.SHARES
    total = np.zeros(len(names))
    square = np.zeros(len(names))
    counts, drawn = {"front": np.zeros(len(EDGES_DEG) - 1), "back": np.zeros(len(EDGES_DEG) - 1)}, 0
    rays, step, place = 0, _FIRST, 0
    while True:
        own_seed = seed + 2 * place
        mean, error = optics.walk_shares(incident, step, own_seed)
        # rounds are independent: means add by their rays, errors by their squares
        total += step * mean[0]
        square += (step * error[0]) ** 2
        rays += step
        many = min(step, _MOST_DRAWN)
        leaves = glazing.scatter(np.repeat(incident, many, axis=0), own_seed + 1)
        drawn += many
        leaves = leaves[np.isfinite(leaves[:, 0])]
        elevation = np.degrees(np.arcsin(np.clip(leaves[:, 1], -1.0, 1.0)))
        for word, chosen in (("front", leaves[:, 2] < 0.0), ("back", leaves[:, 2] > 0.0)):
            counts[word] += np.histogram(elevation[chosen], EDGES_DEG)[0]
        errors = np.sqrt(square) / rays
        worst = float(errors.max())
        is_last = worst <= ENOUGH or rays >= _MOST
        yield {
            "shares": dict(zip(names, (total / rays).tolist(), strict=True)),
            "standard_errors": dict(zip(names, errors.tolist(), strict=True)),
            "rays": rays,
            "distribution": {"edges_deg": EDGES_DEG, **{word: count / drawn for word, count in counts.items()}},
            # the variance falls as the rays grow
            "share_done": 1.0 if is_last else min(0.99, max(rays / _MOST, (ENOUGH / worst) ** 2)),
        }
        if is_last:
            return
        step, place = rays, place + 1


def _incident(elevation_deg: Any, azimuth_deg: Any, side: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    elevation = angles("elevation_deg", number("elevation_deg", elevation_deg))
    azimuth = angles("azimuth_deg", number("azimuth_deg", azimuth_deg))
    return incident_directions(elevation, azimuth, side)
