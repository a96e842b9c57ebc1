"""How light divides against incidence, as a Dataset: exactly or by a Monte Carlo walk."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from clerestory import _native
from clerestory.panels.incidence import SIDES, angles, incident_directions
from clerestory.panels.optics import exact_optics, walked_optics, whole
from clerestory.panels.wavelengths import Samples, asked_wavelengths
from clerestory.panels.writing import described
from clerestory.provenance import provenance
from clerestory.rules import one_of

if TYPE_CHECKING:
    from clerestory.panels.panel import Panel

Method = Literal["exact", "monte_carlo"]
Floats = NDArray[np.float64]
#: Called with the directions done and all of them.
Progress = Callable[[int, int], object]

METHODS = ("exact", "monte_carlo")

LONG_NAMES = {
    "transmittance": "share of the power that leaves by the far side",
    "reflectance": "share of the power that leaves by the side it came from",
    "absorptance": "share of the power that is absorbed",
    "transmittance_deflected": "share transmitted with its vertical sense reversed",
    "transmittance_undeflected": "share transmitted with its vertical sense kept",
    "residual": "share of the power not followed to its end",
}
#: Directions solved between two reports of progress.
_BATCH = 256


def angular(
    panel: Panel,
    *,
    elevation_deg: ArrayLike,
    azimuth_deg: ArrayLike,
    side: str,
    method: str,
    rays: int,
    seed: int,
    wavelength_nm: ArrayLike | None,
    polarisation: str,
    tolerance: float,
    arc_chords: int,
    progress: Progress | None = None,
) -> xr.Dataset:
    """What :meth:`Panel.angular` returns; ``progress`` is told of the directions done."""
    elevation, azimuth = angles("elevation_deg", elevation_deg), angles("azimuth_deg", azimuth_deg)
    wavelengths = asked_wavelengths(wavelength_nm)
    one_of("side", side, SIDES)
    one_of("method", method, METHODS)
    rays, seed = whole("rays", rays, 2), whole("seed", seed, 0)

    def optics(at_nm: float | None) -> tuple[_native.PanelOptics, Samples]:
        if method == "monte_carlo":
            return walked_optics(panel, wavelength_nm=at_nm, polarisation=polarisation)
        return exact_optics(
            panel, wavelength_nm=at_nm, polarisation=polarisation, tolerance=tolerance, arc_chords=arc_chords
        )

    # every wavelength is checked before the first is worked on
    asked = [None] if wavelengths is None else [float(w) for w in wavelengths.ravel()]
    panels = [optics(at_nm) for at_nm in asked]
    grid = incident_directions(elevation[:, None], azimuth, side)
    incident = grid.reshape(-1, 3)
    report = _Report(progress, len(incident) * len(panels))
    if method == "exact":
        parts = [_solve(one, incident, report) for one, _ in panels]
    else:
        parts = [_walk(one, incident, rays, seed, report) for one, _ in panels]

    is_list = wavelengths is not None and wavelengths.ndim == 1
    dims = ("elevation", "azimuth", "wavelength") if is_list else ("elevation", "azimuth")
    # (wavelength, incident, quantity) to (quantity, elevation, azimuth[, wavelength])
    columns = np.array(parts).transpose(2, 1, 0).reshape(-1, len(elevation), len(azimuth), len(panels))
    if not is_list:
        columns = columns[..., 0]
    names = _native.PanelOptics.SHARES
    variables = {name: _variable(dims, column, name) for name, column in zip(names, columns[: len(names)], strict=True)}
    if method == "monte_carlo":
        errors = columns[len(names) :]
        variables |= {
            f"{name}_standard_error": _variable(dims, error, name, is_error=True)
            for name, error in zip(names, errors, strict=True)
        }
    coordinates: dict[str, Any] = {
        "elevation": ("elevation", elevation, {"long_name": "elevation, above 0 from above", "units": "degree"}),
        "azimuth": ("azimuth", azimuth, {"long_name": "azimuth about the panel's y axis", "units": "degree"}),
    }
    if wavelengths is not None:
        attributes = {"long_name": "wavelength in vacuum", "units": "nm"}
        coordinates["wavelength"] = (("wavelength",) if is_list else (), wavelengths, attributes)
    is_exact = method == "exact"
    photopic = panels[0][1] if wavelengths is None else None
    attributes = provenance(
        panel=described(panel),
        method=method,
        side=side,
        polarisation=polarisation,
        tolerance=tolerance if is_exact else None,
        arc_chords=arc_chords if is_exact and not panel.native_profile.is_straight else None,
        rays=None if is_exact else rays,
        seed=None if is_exact else seed,
        wavelength_nm=list(photopic.wavelength_nm) if photopic else None,
        wavelength_weights=list(photopic.weights) if photopic else None,
    )
    return xr.Dataset(variables, coordinates, attributes)


class _Report:
    """Counts directions done and tells of them."""

    def __init__(self, progress: Progress | None, total: int) -> None:
        self.progress, self.total, self.done = progress, total, 0

    def add(self, count: int) -> None:
        self.done += count
        if self.progress is not None:
            self.progress(self.done, self.total)


def _solve(optics: _native.PanelOptics, incident: Floats, report: _Report) -> Floats:
    rows = []
    for first in range(0, len(incident), _BATCH):
        batch = incident[first : first + _BATCH]
        rows.append(optics.shares(batch))
        report.add(len(batch))
    return np.concatenate(rows)


def _walk(optics: _native.PanelOptics, incident: Floats, rays: int, seed: int, report: _Report) -> Floats:
    """Shares, then their standard errors."""
    rows = []
    for place, direction in enumerate(incident):
        # each direction has random numbers of its own, as it would among all in one call
        own_seed = (seed + (place << 32)) % 2**64
        rows.append(np.concatenate(optics.walk_shares(direction[None, :], rays, own_seed), axis=1))
        report.add(1)
    return np.concatenate(rows)


def _variable(dims: tuple[str, ...], values: Floats, name: str, is_error: bool = False) -> tuple[Any, ...]:
    long_name = f"standard error of {name}" if is_error else LONG_NAMES[name]
    return dims, values, {"long_name": long_name, "units": "1"}
