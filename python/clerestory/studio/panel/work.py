"""Long jobs about a panel: shares against elevation, rays that refine, dispersion."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.panels import Panel, panel_from_dict
from clerestory.panels.wavelengths import samples
from clerestory.studio.answers import plain
from clerestory.studio.panel.answers import rows_of
from clerestory.studio.panel.walk import refining

#: Told of what is done, of how much, and what there is so far.
Tell = Callable[..., None]

#: Steps between elevations, each pass halving the last [degrees].
_STEPS = (16.0, 8.0, 4.0, 2.0)
_MOST_DEG = 88.0
#: Step of the first pass, by rays, and rays for each elevation in it and in the last.
_QUICK_STEP, _QUICK_RAYS, _FINE_RAYS = 4.0, 2000, 50_000
#: Share of the power that may stay unfollowed in the picture of dispersion.
_TOLERANCE = 1e-5
#: Wavelengths across the visible at which dispersion is shown [nm].
SPECTRUM_NM = tuple(range(400, 701, 25))
#: Lobes below this share are no part of the picture of dispersion.
_LEAST_POWER = 1e-3


def angular(*, panel: dict[str, Any], azimuth_deg: float, side: Any, tell: Tell) -> dict[str, Any]:
    """Shares against elevation: by rays at once, then exactly, coarse first and then between.

    A rough panel stays with rays, of which it gets more.
    """
    asked = panel_from_dict(panel)
    is_smooth = asked.native_profile.is_smooth
    quick = _grid(_QUICK_STEP)
    rays: dict[str, Any] = {"method": "monte_carlo", "rays": _QUICK_RAYS}
    coarse = rows_of(asked.angular(elevation_deg=quick, azimuth_deg=azimuth_deg, side=side, **rays))
    rows = {e: {name: float(values[k]) for name, values in coarse.items()} for k, e in enumerate(quick)}
    passes, seen = [], set[float]()
    for step in _STEPS:
        grid = _grid(step)
        passes.append([e for e in grid if e not in seen])
        seen.update(grid)
    fine: dict[str, Any] = {"method": "monte_carlo", "rays": _FINE_RAYS} if not is_smooth else {}
    tell(0, len(seen), _columns(rows))
    done = 0
    for elevations in passes:
        for elevation in elevations:
            found = rows_of(asked.angular(elevation_deg=elevation, azimuth_deg=azimuth_deg, side=side, **fine))
            rows[elevation] = {name: float(values[0]) for name, values in found.items()}
            done += 1
            is_round = done % 6 == 0 or elevation == elevations[-1]
            tell(done, len(seen), _columns(rows) if is_round else None)
    return _columns(rows)


def walk(*, panel: dict[str, Any], elevation_deg: float, azimuth_deg: float, side: str, tell: Tell) -> dict[str, Any]:
    """How the light of one incidence divides and where it leaves, by ever more rays."""
    found: dict[str, Any] = {}
    for found in refining(panel_from_dict(panel), elevation_deg=elevation_deg, azimuth_deg=azimuth_deg, side=side):
        found = plain(found)
        tell(found["share_done"], 1.0, found)
    return found


def dispersion(
    *, panel: dict[str, Any], elevation_deg: float, azimuth_deg: float, side: Any, tell: Tell
) -> dict[str, Any]:
    """Elevation and power of every beam that leaves, at the visible wavelengths that its media are known at."""
    asked = panel_from_dict(panel)
    if not asked.native_profile.is_smooth:
        raise ClerestoryError(
            "cut_slope_deg and cut_diffuse must be 0 for dispersion: rough cuts send no beams that could be told apart"
        )
    spectrum = [wavelength for wavelength in SPECTRUM_NM if _is_known(asked, wavelength)]
    if not spectrum:
        samples(asked.media, float(SPECTRUM_NM[-1]))
    # the ends first, then between
    order = sorted(range(len(spectrum)), key=lambda k: (k % 4 != 0, k % 2 != 0, k))
    beams: list[dict[str, Any]] = []
    for done, wavelength in enumerate((spectrum[k] for k in order), 1):
        found = asked.lobes(
            elevation_deg=elevation_deg,
            azimuth_deg=azimuth_deg,
            side=side,
            wavelength_nm=float(wavelength),
            tolerance=_TOLERANCE,
        )
        strong = found.isel(lobe=found["power"].values >= _LEAST_POWER)
        columns = [strong[name].values.tolist() for name in ("elevation_deg", "azimuth_deg", "power", "side")]
        beams += [
            {"wavelength_nm": wavelength, "elevation_deg": e, "azimuth_deg": a, "power": p, "side": s}
            for e, a, p, s in zip(*columns, strict=True)
        ]
        beams.sort(key=lambda beam: (beam["wavelength_nm"], -beam["power"]))
        tell(done, len(spectrum), {"beams": list(beams)})
    return {"beams": beams}


def _grid(step: float) -> list[float]:
    grid: list[float] = np.arange(-_MOST_DEG, _MOST_DEG + 1e-9, step).tolist()
    return grid


def _is_known(panel: Panel, wavelength_nm: float) -> bool:
    """Whether all media are known at a wavelength."""
    try:
        samples(panel.media, float(wavelength_nm))
    except ClerestoryError:
        return False
    return True


def _columns(rows: dict[float, dict[str, float]]) -> dict[str, Any]:
    """Columns of rows in the order of elevation; what a row found exactly has no standard error."""
    names = list(dict.fromkeys(name for row in rows.values() for name in row))
    ordered = [rows[elevation] for elevation in sorted(rows)]
    columns: dict[str, Any] = plain({name: [row.get(name, 0.0) for row in ordered] for name in names})
    return columns
