"""Whether the light in a weather file comes while the sun is up at its site, or at the mirrored one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pandas as pd

from clerestory.errors import ClerestoryError
from clerestory.site import Site
from clerestory.sun import sun_position
from clerestory.weather.columns import DIFFUSE, DIRECT

Array = npt.NDArray[np.float64]

_LIT_W_M2 = 2.0
_TWILIGHT_DEG = 1.5
_LOW_DEG = 25.0
"""Intervals whose mid-sun is lower say when day begins and ends."""
_LEAST_INTERVALS = 60
_WRONG_SHARE = 0.03
"""Of the lit intervals, more than this out of place is a mistake."""
_WRONG_HOURS = 0.5
_STEP_HOURS = 1.0 / 12.0


def checked_site(
    frame: pd.DataFrame, site: Site, *, interval_minutes: float, wrong: Callable[[str], ClerestoryError]
) -> tuple[Site, tuple[str, ...]]:
    """The site, with its longitude mirrored if only that fits the file's clock and light; raises if nothing fits.

    Parameters
    ----------
    frame : DataFrame
        Index with the clock's offset, the middles of the intervals.
    site : Site
    interval_minutes : float
    wrong : callable
        Makes the error from a message.

    Returns
    -------
    site : Site
    notes : tuple of str

    Notes
    -----
    theory/weather.md, section "Whether clock, place and light agree".
    """
    record = frame[[DIRECT, DIFFUSE]].dropna()
    light = record.to_numpy(dtype=np.float64).sum(axis=1)
    if (light > _LIT_W_M2).sum() < _LEAST_INTERVALS:
        return site, ()
    sky = _Sky(site, record.index, light, record[DIFFUSE].to_numpy(dtype=np.float64), interval_minutes)
    # the sun of the mirrored site comes this much later
    mirrored = 2.0 * site.longitude_deg / 15.0
    here = sky.out_of_place(0.0)
    late = sky.best_hours()
    if abs(mirrored) > 0.25:
        there = sky.out_of_place(mirrored)
        unlike = here > _WRONG_SHARE and there < 0.25 * here
        near = _apart(late, mirrored) < 0.25 * abs(mirrored) and abs(late) > 0.6 * abs(mirrored)
        if unlike or (abs(mirrored) < 2.0 and near):
            note = (
                f"longitude {site.longitude_deg:g} has the wrong sign: clock and light fit {-site.longitude_deg:g}, "
                "which is taken (positive to the east)"
            )
            return replace(site, longitude_deg=-site.longitude_deg), (note,)
    if here > _WRONG_SHARE and abs(late) > 1.25:
        raise wrong(
            f"light and sun must agree, got {100.0 * here:.0f} % of the lit intervals while the sun is down at "
            f"latitude {site.latitude_deg:g}, longitude {site.longitude_deg:g} (east) and {record.index.tz}; they "
            f"would fit a sun {abs(late):.1f} h {'later' if late > 0 else 'earlier'}: correct place or time zone, "
            "or give site="
        )
    if abs(late) > _WRONG_HOURS:
        word = "later" if late > 0 else "earlier"
        return site, (f"day begins and ends about {60.0 * abs(late):.0f} min {word} than the sun: is its clock right?",)
    return site, ()


class _Sky:
    """The sun over a record, and over it had it come some hours later."""

    def __init__(self, site: Site, index: pd.DatetimeIndex, light: Array, diffuse: Array, interval_minutes: float):
        sun = sun_position(site, index)
        altitude, azimuth = np.radians(sun.altitude_deg.values), np.radians(sun.azimuth_deg.values)
        latitude = np.radians(site.latitude_deg)
        # hour angle and declination from the horizontal coordinates (theory/sun.md, eq. 2, turned round)
        north, up = np.cos(altitude) * np.cos(azimuth), np.sin(altitude)
        west = -np.cos(altitude) * np.sin(azimuth)
        self._hour_angle = np.arctan2(west, up * np.cos(latitude) - north * np.sin(latitude))
        self._constant = np.sin(latitude) * (up * np.sin(latitude) + north * np.cos(latitude))
        self._swing = np.cos(latitude) * np.hypot(west, up * np.cos(latitude) - north * np.sin(latitude))
        self._light, self._root = light, np.sqrt(np.maximum(diffuse, 0.0))
        self._margin = 7.5 * interval_minutes / 60.0 + _TWILIGHT_DEG

    def sine(self, late_hours: float) -> Array:
        """Of the altitude of a sun that comes so much later."""
        height: Array = self._constant + self._swing * np.cos(self._hour_angle - np.radians(15.0 * late_hours))
        return height

    def out_of_place(self, late_hours: float) -> float:
        """Share of the lit intervals in which no sun is up."""
        lit = self._light > _LIT_W_M2
        down = self.sine(late_hours) < np.sin(np.radians(-self._margin))
        return float((lit & down).sum() / lit.sum())

    def best_hours(self) -> float:
        """How much later the sun would have to come for the low sun's light to follow it best."""
        return max((float(h) for h in np.arange(-12.0, 12.0, _STEP_HOURS)), key=self._likeness)

    def _likeness(self, late_hours: float) -> float:
        """Correlation of the root of the diffuse light with the low sun's height."""
        sine = self.sine(late_hours)
        height = np.clip(sine, np.sin(np.radians(-self._margin)), np.sin(np.radians(_LOW_DEG)))
        return float(np.corrcoef(height, np.minimum(self._root, 12.0))[0, 1])


def _apart(a: float, b: float) -> float:
    """Hours between two times of day."""
    return abs((a - b + 12.0) % 24.0 - 12.0)
