"""A case of kind "panel": what a panel does to light from a few directions, as figures to compare."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from clerestory import _native
from clerestory.array_rules import numbers
from clerestory.errors import ClerestoryError
from clerestory.glazing_table import glazing_tables, read_glazing
from clerestory.panels.angular import LONG_NAMES
from clerestory.panels.optics import ARC_CHORDS, TOLERANCE, exact_optics, walked_optics, whole
from clerestory.panels.panel import Panel
from clerestory.panels.writing import described
from clerestory.provenance import provenance
from clerestory.room.toml_table import Table
from clerestory.rules import number, one_of, within

Floats = NDArray[np.float64]

BAND_DEG = (0.0, 20.0)
"""Above the horizontal: light that leaves in this band runs along the ceiling to the depth of a room."""


def evaluate(tables: Mapping[str, Any], *, where: Path = Path(), progress: Any = None) -> xr.Dataset:
    """How a panel divides light from some directions, and where it sends it.

    Parameters
    ----------
    tables : mapping
        ``panel``: a panel's table, ``{ file = … }``, or the name of one in ``glazings``. ``light``: ``elevation_deg``
        (default 10 to 70 by 10) and ``azimuth_deg`` (default 0), lists that make a grid, as seen from a vertical
        facade; ``tilt_deg`` of the panel in its opening, above 0 if its lower edge is swung into the room;
        ``band_deg``, two elevations above the horizontal (default 0 and 20); ``method``, ``rays``, ``seed``,
        ``wavelength_nm``, ``polarisation``, ``tolerance`` as of `Panel.angular`.
    where : Path
    progress : ignored
        So that all kinds are called alike.

    Returns
    -------
    Dataset, dims ("elevation", "azimuth") [0..1]
        `transmittance`, `reflectance`, `absorptance`, `residual`, `transmittance_deflected` and
        `transmittance_undeflected` as `Panel.angular` has them; `deflected_share` of what is transmitted. By the exact
        method also `upward_transmittance`, what leaves above the horizontal of the room, and `band_transmittance`, what
        leaves in the band. After rays, `…_standard_error`. Without dimensions, `mean_…`: the mean of each over the
        directions that meet the front.

    Raises
    ------
    ClerestoryError
        If the panel or a value is wrong, or the light meets the panel nowhere from the front.
    """
    top = Table({name: tables[name] for name in ("panel", "light", "glazings") if name in tables}, "the case")
    panel = _panel(top, where)
    light = top.table("light")
    grid = {
        "elevation": np.atleast_1d(numbers("elevation_deg", light.take("elevation_deg", list(range(10, 71, 10))))),
        "azimuth": np.atleast_1d(numbers("azimuth_deg", light.take("azimuth_deg", 0.0))),
    }
    for name, values in grid.items():
        for value in values:
            within(f"{name}_deg of {light.where}", value, -89.999, 89.999)
    tilt = np.radians(within("tilt_deg", light.take("tilt_deg", 0.0), -90.0, 90.0))
    band = light.take("band_deg", list(BAND_DEG))
    if not isinstance(band, list) or len(band) != 2:
        raise ClerestoryError(f"band_deg of {light.where} must be two elevations, got {band!r}")
    low, high = (within("band_deg", edge, -90.0, 90.0) for edge in band)
    method = one_of("method", light.take("method", "exact"), ("exact", "monte_carlo"))
    wavelength = light.take("wavelength_nm", None)
    at = None if wavelength is None else number("wavelength_nm", wavelength)
    polarisation = light.take("polarisation", "resolved")
    tolerance = light.take("tolerance", TOLERANCE)
    rays, seed = whole("rays", light.take("rays", 20_000), 2), whole("seed", light.take("seed", 0), 0)
    light.finish()

    travel = _travel(grid["elevation"], grid["azimuth"])
    incident = _turned(travel, -tilt)
    meets = incident[:, 2] > 1e-9
    if not meets.any():
        raise ClerestoryError("tilt_deg must let light meet the front of the panel, got none; turn it back")
    names = _native.PanelOptics.SHARES
    found = {name: np.full(len(travel), np.nan) for name in names}
    if method == "exact":
        optics, _ = exact_optics(
            panel, wavelength_nm=at, polarisation=polarisation, tolerance=tolerance, arc_chords=ARC_CHORDS
        )
        rows = optics.shares(incident[meets])
        sent = {name: np.full(len(travel), np.nan) for name in ("upward_transmittance", "band_transmittance")}
        for place in np.flatnonzero(meets):
            up, along = _sent(optics, incident[place], tilt, low, high)
            sent["upward_transmittance"][place], sent["band_transmittance"][place] = up, along
        found |= sent
    else:
        optics, _ = walked_optics(panel, wavelength_nm=at, polarisation=polarisation)
        rows, errors = optics.walk_shares(incident[meets], rays, seed)
        for column, name in enumerate(names):
            found[f"{name}_standard_error"] = np.full(len(travel), np.nan)
            found[f"{name}_standard_error"][meets] = errors[:, column]
    for column, name in enumerate(names):
        found[name][meets] = rows[:, column]
    with np.errstate(invalid="ignore", divide="ignore"):
        found["deflected_share"] = found["transmittance_deflected"] / found["transmittance"]
    shape = (len(grid["elevation"]), len(grid["azimuth"]))
    variables: dict[str, Any] = {
        name: (("elevation", "azimuth"), values.reshape(shape), _about(name, low, high))
        for name, values in found.items()
    }
    for name, values in found.items():
        if not name.endswith("_standard_error"):
            about = _about(name, low, high)
            variables[f"mean_{name}"] = ((), float(np.mean(values[meets])), about)
    coordinates = {
        name: (name, values, {"units": "degree", "long_name": f"{name} of the light, as seen from a vertical facade"})
        for name, values in grid.items()
    }
    made_from = provenance(panel=described(panel), method=method, tilt_deg=float(np.degrees(tilt)), band_deg=band)
    return xr.Dataset(variables, coordinates, made_from)


def _panel(top: Table, where: Path) -> Panel:
    glazing = glazing_tables(top.table("glazings"), where)
    given = top.take("panel")
    made = glazing(given) if isinstance(given, str) else read_glazing(Table(given, "[panel]"), glazing, where)
    if not isinstance(made, Panel):
        raise ClerestoryError(f"panel must be a laser-cut, prismatic, extruded panel or a pane, got {made!r}")
    return made


def _travel(elevation_deg: Floats, azimuth_deg: Floats) -> Floats:
    """Directions of travel, x along the facade, y up, z into the room, shape (elevation · azimuth, 3)."""
    e, a = (angle.ravel() for angle in np.meshgrid(np.radians(elevation_deg), np.radians(azimuth_deg), indexing="ij"))
    return np.stack([np.sin(a) * np.cos(e), -np.sin(e), np.cos(a) * np.cos(e)], axis=1)


def _turned(vectors: Floats, angle: float) -> Floats:
    """Vectors turned about x as a panel whose lower edge swings into the room by ``angle``."""
    cos, sin = np.cos(angle), np.sin(angle)
    x, y, z = vectors.T
    # its own −y, the way down the sheet, turns towards +z, into the room
    return np.stack([x, cos * y + sin * z, cos * z - sin * y], axis=1)


def _sent(optics: _native.PanelOptics, incident: Floats, tilt: float, low: float, high: float) -> tuple[float, float]:
    """Shares of the incident light that leave above the horizontal, and between two elevations."""
    directions, stokes, *_ = optics.lobes(incident[None, :])
    leaves = directions[:, 2] > 0.0
    power = stokes[leaves, 0]
    rise = np.degrees(np.arcsin(np.clip(_turned(directions[leaves], tilt)[:, 1], -1.0, 1.0)))
    # a beam at an edge of the band but for rounding counts
    inside = (rise >= low - 1e-6) & (rise <= high + 1e-6)
    return float(power[rise > 1e-6].sum()), float(power[inside].sum())


def _about(name: str, low: float, high: float) -> dict[str, str]:
    told = LONG_NAMES | {
        "deflected_share": "share of the transmitted power with its vertical sense reversed",
        "upward_transmittance": "share of the power that leaves above the horizontal of the room",
        "band_transmittance": f"share of the power that leaves {low:g} to {high:g} degrees above the horizontal",
    }
    plain = name.removesuffix("_standard_error")
    return {"units": "1", "long_name": told[plain] if plain == name else f"standard error of {told[plain]}"}
