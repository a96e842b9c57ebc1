"""The compiled panel behind a question: profile, media and how to follow light, made once and kept."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.panels.wavelengths import Samples, samples
from clerestory.rules import number, one_of

if TYPE_CHECKING:
    from clerestory.panels.panel import Panel

Polarisation = Literal["resolved", "averaged"]

POLARISATIONS = ("resolved", "averaged")
#: Share of the power that may stay unfollowed.
TOLERANCE = 1e-6
#: Straight facets by which the exact solver draws an arc.
ARC_CHORDS = 32
#: Pieces of light followed for one direction at most; what is left is followed by a walk.
MOST_PIECES = 1_000_000
#: The same for a window, which is asked for thousands of directions; beams of kerfs and odd angles are good to 6·10⁻⁴.
WINDOW_PIECES = 100_000
#: The same for the share that may stay unfollowed: a sun through a window is at most this much too weak.
WINDOW_TOLERANCE = 1e-4


def whole(name: str, value: Any, least: int) -> int:
    """``value`` as a whole number of at least ``least``."""
    if isinstance(value, bool) or number(name, value) != int(value) or value < least:
        raise ClerestoryError(f"{name} must be a whole number of at least {least}, got {value!r}")
    return int(value)


def checked_tolerance(tolerance: Any) -> float:
    """``tolerance`` between 0 and 1."""
    result = number("tolerance", tolerance)
    if not 0.0 < result < 1.0:
        raise ClerestoryError(f"tolerance must be between 0 and 1, got {result:g}; 1e-6 serves most ends")
    return result


def exact_optics(
    panel: Panel,
    *,
    wavelength_nm: float | None,
    polarisation: str,
    tolerance: float,
    arc_chords: int,
    most_pieces: int = MOST_PIECES,
) -> tuple[_native.PanelOptics, Samples]:
    """The panel for the exact solver, arcs drawn by ``arc_chords`` straight facets each."""
    one_of("polarisation", polarisation, POLARISATIONS)
    chords = whole("arc_chords", arc_chords, 2)
    return _optics(panel, wavelength_nm, polarisation, checked_tolerance(tolerance), chords, most_pieces)


def walked_optics(
    panel: Panel, *, wavelength_nm: float | None, polarisation: str
) -> tuple[_native.PanelOptics, Samples]:
    """The panel for the Monte Carlo walk, arcs as arcs."""
    one_of("polarisation", polarisation, POLARISATIONS)
    return _optics(panel, wavelength_nm, polarisation, TOLERANCE, None, MOST_PIECES)


@lru_cache(maxsize=256)
def _optics(
    panel: Panel,
    wavelength_nm: float | None,
    polarisation: str,
    tolerance: float,
    arc_chords: int | None,
    most_pieces: int,
) -> tuple[_native.PanelOptics, Samples]:
    profile = panel.native_profile
    if arc_chords is not None and not profile.is_straight:
        profile = profile.flattened(arc_chords)
    at = samples(panel.media, wavelength_nm)
    return _native.PanelOptics(
        profile,
        n=at.n,
        absorption_per_mm=at.absorption_per_mm,
        weights=np.array(at.weights),
        polarisation=polarisation,
        tolerance=tolerance,
        most_pieces=most_pieces,
    ), at
