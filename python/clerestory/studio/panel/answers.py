"""What the page draws of a panel: its section with the beams, its lobes and shares, its tables."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from clerestory.panels.angular import LONG_NAMES
from clerestory.panels.optics import whole
from clerestory.panels.section_beams import strips
from clerestory.panels.wavelengths import samples
from clerestory.plots.section_outline import outline
from clerestory.studio.panel.pace import Pace
from clerestory.studio.panel.walk import walked_shares

if TYPE_CHECKING:
    import xarray as xr

    from clerestory.medium import Medium
    from clerestory.panels import Panel

#: Digits behind the point of lengths that are only drawn [mm].
_DIGITS = 4
#: Lobes of an answer, the strongest first; a panel of curved cuts has thousands.
MOST_LOBES = 500


def section_of(
    panel: Panel, *, elevation_deg: Any, azimuth_deg: Any, side: Any = "front", wavelength_nm: Any = None
) -> dict[str, Any]:
    """The section and the strips of light in it.

    Returns
    -------
    dict
        ``pitch_mm``, ``front_mm``, ``back_mm``; ``low_mm``, ``high_mm`` between which ``solids``, ``films`` and
        ``surfaces`` are (lists of points z, y); ``strips`` with ``corners``, ``power``, ``total_reflections`` and
        whether each ``leaves`` the panel; the first is the light that arrives; ``is_smooth``: False if the cuts are
        rough, which the strips pass over.
    """
    if wavelength_nm is None:
        wavelength_nm = _brightest_nm(panel.media)
    corners, power, _, total_reflections, _ = strips(
        panel,
        elevation_deg=elevation_deg,
        azimuth_deg=azimuth_deg,
        side=side,
        wavelength_nm=wavelength_nm,
        least_power=0.005,
    )
    profile = panel.native_profile
    front, back = profile.depth_range_mm
    pitch, depth = profile.pitch_mm, back - front
    # the light wanders up or down within: entry and exits stay in the picture
    inside = corners[power >= 0.05][1:, :2].reshape(-1, 2)
    middle = 0.5 * float(inside[:, 1].min() + inside[:, 1].max()) if len(inside) else 0.5 * pitch
    height = max(2.4 * depth, 3.0 * pitch, 1.5 * float(np.ptp(inside[:, 1])) if len(inside) else 0.0)
    low, high = middle - 0.5 * height, middle + 0.5 * height
    shape = outline(profile, low, high)
    slack = 1e-9 * depth
    ends = corners[:, 2:, 0]
    leaves = ((ends > back + slack) | (ends < front - slack)).all(axis=1) & (np.arange(len(ends)) > 0)
    rounded = np.round(corners, _DIGITS).tolist()
    return {
        "pitch_mm": pitch,
        "front_mm": front,
        "back_mm": back,
        "low_mm": low,
        "high_mm": high,
        "is_smooth": profile.is_smooth,
        "solids": [np.round(one, _DIGITS) for one in shape.solids],
        "films": [np.round(one, _DIGITS) for one in shape.films],
        "surfaces": [np.round(one, _DIGITS) for one in shape.surfaces],
        "strips": [
            {"corners": c, "power": p, "total_reflections": n, "leaves": out}
            for c, p, n, out in zip(rounded, power.tolist(), total_reflections.tolist(), leaves.tolist(), strict=True)
        ],
    }


@lru_cache(maxsize=64)
def _brightest_nm(media: tuple[Medium, ...]) -> float | None:
    """Of the wavelengths that stand for daylight the one that counts most; None if none matters."""
    at = samples(media, None)
    return at.wavelength_nm[int(np.argmax(at.weights))] if at.wavelength_nm else None


def lobes_of(panel: Panel, *, detail: str = "full", most: int | None = None, **incidence: Any) -> dict[str, Any]:
    """The beams that leave and how the light divides.

    Parameters
    ----------
    panel : Panel
    detail : {"full", "quick"}
        "quick" takes rays, with their standard errors, where following all beams takes longer than a blink.
    most : int, optional
        Lobes in the answer at most, the strongest.
    **incidence
        As of :meth:`Panel.lobes`.

    Returns
    -------
    dict
        ``lobes``: list of ``power``, ``side``, ``elevation_deg``, ``azimuth_deg``, ``total_reflections`` and
        ``direction``, none by rays; ``count`` of all; ``shares``: those of :meth:`Panel.angular`, of the same beams;
        ``standard_errors`` of them and ``rays`` by rays, else null; ``is_full``: whether nothing finer can be asked;
        ``is_smooth``: False for a panel that only rays can follow.
    """
    most = None if most is None else whole("most", most, 1)
    is_smooth = panel.native_profile.is_smooth
    if not is_smooth or (detail == "quick" and incidence.get("wavelength_nm") is None and not _PACE.is_quick(panel)):
        incidence.pop("wavelength_nm", None)
        found = walked_shares(panel, **incidence)
        return {"lobes": [], "count": 0, "is_full": False, "is_smooth": is_smooth, **found}
    with _PACE.timed(panel):
        beams = panel.lobes(**incidence)
    return {
        **_beams(beams, most),
        "standard_errors": None,
        "rays": None,
        "is_full": True,
        "is_smooth": True,
    }


_PACE = Pace()


def _beams(found: xr.Dataset, most: int | None) -> dict[str, Any]:
    power, y = found["power"].values, found["direction"].values[:, 1]
    through = found["side"].values == ("back" if found.attrs["side"] == "front" else "front")
    # its vertical sense reversed; light that came in level has none to reverse
    turned = through & (y * -np.sin(np.radians(found.attrs["elevation_deg"])) < -1e-15)
    transmittance, deflected = float(power[through].sum()), float(power[turned].sum())
    names = ("power", "side", "elevation_deg", "azimuth_deg", "total_reflections", "direction")
    columns = [found[name].values[:most].tolist() for name in names]
    return {
        "lobes": [dict(zip(names, row, strict=True)) for row in zip(*columns, strict=True)],
        "count": len(power),
        "shares": {
            "transmittance": transmittance,
            "reflectance": float(power[~through].sum()),
            "absorptance": found.attrs["absorbed"],
            "transmittance_deflected": deflected,
            "transmittance_undeflected": transmittance - deflected,
            "residual": found.attrs["residual"],
        },
    }


def rows_of(table: xr.Dataset) -> dict[str, Any]:
    """A table of :meth:`Panel.angular` over elevation alone, as lists; with standard errors if it has them."""
    plain = table.squeeze([name for name in table.dims if name != "elevation"], drop=True)
    names = [name for name in LONG_NAMES if name in plain]
    names += [f"{name}_standard_error" for name in names if f"{name}_standard_error" in plain]
    return {"elevation_deg": plain["elevation"].values, **{name: plain[name].values for name in names}}
