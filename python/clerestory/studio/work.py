"""The long jobs, by name; each is done in a process of its own and tells what it has so far."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from clerestory.bsdf import Bsdf
from clerestory.errors import ClerestoryError
from clerestory.panels import Panel, panel_from_dict
from clerestory.panels.wavelengths import samples
from clerestory.studio import year_work
from clerestory.studio.answers import plain
from clerestory.studio.room_work import room, room_sun

#: Told of what is done, of how much, and what there is so far.
Tell = Callable[..., None]

#: Steps between elevations, each pass halving the last [degrees].
_STEPS = (16.0, 8.0, 4.0, 2.0)
_MOST_DEG = 88.0
#: Wavelengths across the visible at which dispersion is shown [nm].
SPECTRUM_NM = tuple(range(400, 701, 25))
#: Lobes below this share are no part of the picture of dispersion.
_LEAST_POWER = 1e-3


def angular(*, panel: dict[str, Any], azimuth_deg: float, side: str, tell: Tell) -> dict[str, Any]:
    """Shares against elevation, coarse first, then between."""
    from clerestory.studio.panel_answers import rows_of

    asked = panel_from_dict(panel)
    passes, seen = [], set[float]()
    for step in _STEPS:
        grid = np.arange(-_MOST_DEG, _MOST_DEG + 1e-9, step).tolist()
        passes.append([e for e in grid if e not in seen])
        seen.update(grid)
    rows: dict[float, dict[str, float]] = {}
    for elevations in passes:
        for elevation in elevations:
            found = rows_of(asked.angular(elevation_deg=elevation, azimuth_deg=azimuth_deg, side=_side(side)))
            rows[elevation] = {name: float(values[0]) for name, values in found.items()}
            is_round = len(rows) % 8 == 0 or elevation == elevations[-1]
            tell(len(rows), len(seen), _columns(rows) if is_round else None)
    return _columns(rows)


def dispersion(*, panel: dict[str, Any], elevation_deg: float, azimuth_deg: float, tell: Tell) -> dict[str, Any]:
    """Elevation and power of every beam that leaves, at the visible wavelengths that its media are known at."""
    asked = panel_from_dict(panel)
    spectrum = [wavelength for wavelength in SPECTRUM_NM if _is_known(asked, wavelength)]
    if not spectrum:
        samples(asked.media, float(SPECTRUM_NM[-1]))
    beams: list[dict[str, Any]] = []
    for done, wavelength in enumerate(spectrum, 1):
        found = asked.lobes(elevation_deg=elevation_deg, azimuth_deg=azimuth_deg, wavelength_nm=float(wavelength))
        strong = found.isel(lobe=found["power"].values >= _LEAST_POWER)
        beams += [
            {"wavelength_nm": wavelength, "elevation_deg": e, "power": p, "side": s}
            for e, p, s in zip(
                strong["elevation_deg"].values, strong["power"].values, strong["side"].values, strict=True
            )
        ]
        tell(done, len(spectrum), plain({"beams": beams}))
    found_all: dict[str, Any] = plain({"beams": beams})
    return found_all


def klems(*, panel: dict[str, Any], tell: Tell) -> Bsdf:
    """The panel's BSDF over Klems patches, as :meth:`Panel.bsdf` makes it by default."""
    tell(0, 0)
    return panel_from_dict(panel).bsdf()


def _is_known(panel: Panel, wavelength_nm: float) -> bool:
    """Whether all media are known at a wavelength."""
    try:
        samples(panel.media, float(wavelength_nm))
    except ClerestoryError:
        return False
    return True


def _columns(rows: dict[float, dict[str, float]]) -> dict[str, Any]:
    names = next(iter(rows.values()))
    ordered = [rows[elevation] for elevation in sorted(rows)]
    columns: dict[str, Any] = plain({name: [row[name] for row in ordered] for name in names})
    return columns


def _side(word: str) -> Any:
    return word


JOBS: dict[str, Callable[..., Any]] = {
    "angular": angular,
    "dispersion": dispersion,
    "klems": klems,
    "year": year_work.year,
    "room": room,
    "room_sun": room_sun,
}
