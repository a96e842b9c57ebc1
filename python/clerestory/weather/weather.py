"""Weather: what the sun and the sky send down, interval by interval."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.rules import one_of, positive
from clerestory.saving import write_text
from clerestory.site import Site
from clerestory.sky.perez import DEW_POINT_C, SOLAR_CONSTANT_W_M2
from clerestory.sky.perez_sky import PerezSky
from clerestory.sun import sun_position
from clerestory.weather.columns import ALIASES, DEW_POINT, DIFFUSE, DIRECT, LIMITS
from clerestory.weather.gaps import filled


@dataclass(frozen=True, kw_only=True, eq=False)
class Weather:
    """What the sun and the sky send down at a site, interval by interval.

    Read one with `read_epw`, `read_wea` or `Weather.from_frame`.

    Parameters
    ----------
    site : Site
    frame : DataFrame
        Index with a zone: the *middle* of each interval, increasing. Columns ``direct_normal_irradiance_w_m2`` and
        ``diffuse_horizontal_irradiance_w_m2``, means over the interval; optional ``global_horizontal_irradiance_w_m2``,
        ``dew_point_c``, ``dry_bulb_c``.
    interval_minutes : float, default 60
    source : str, default ""
        Where it is from.
    notes : tuple of str
        What was found and put right on reading.

    Raises
    ------
    ClerestoryError
        If a column is missing or a value impossible.
    """

    site: Site
    frame: pd.DataFrame
    interval_minutes: float = 60.0
    source: str = ""
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        positive("interval_minutes", self.interval_minutes)
        index = self.frame.index
        if not isinstance(index, pd.DatetimeIndex) or index.tz is None:
            raise ClerestoryError(f"frame must have times with a zone as its index, got {type(index).__name__}")
        if len(index) == 0:
            raise ClerestoryError("frame must have at least one row, got none")
        if not index.is_monotonic_increasing or index.has_duplicates:
            raise ClerestoryError("frame must have increasing times, got some out of order; sort and remove repeats")
        for column in (DIRECT, DIFFUSE):
            if column not in self.frame:
                raise ClerestoryError(
                    f"frame must have the column {column}, got {sorted(map(str, self.frame.columns))}"
                )
            values = self.frame[column].to_numpy(dtype=np.float64)
            low, high = LIMITS[column]
            wrong = ~((values >= low) & (values <= high))
            if wrong.any():
                row = int(np.argmax(wrong))
                raise ClerestoryError(f"{column} must lie in {low:g}..{high:g}, got {values[row]:g} at {index[row]}")

    def __len__(self) -> int:
        return len(self.frame)

    @property
    def times(self) -> pd.DatetimeIndex:
        """Middle of each interval, with a zone."""
        return self.frame.index

    @cached_property
    def sun(self) -> xr.Dataset:
        """`sun_position` at the middle of each interval; `time` in UTC, `local_time` on the site's clock."""
        return sun_position(self.site, self.frame.index)

    @cached_property
    def sun_distance_au(self) -> npt.NDArray[np.float64]:
        """Distance of the sun in the middle of each interval [astronomical units]."""
        from pvlib import solarposition

        return np.asarray(solarposition.nrel_earthsun_distance(self.frame.index, delta_t=None), dtype=np.float64)

    def sky(self, time: Any) -> PerezSky:
        """The sky of the interval that a time falls in.

        Parameters
        ----------
        time : anything `Site.moments` reads
            One time, with a zone or on the site's wall clock.

        Raises
        ------
        ClerestoryError
            If no interval holds it.
        """
        (moment,) = self.site.moments(time)
        row = int(self.times.get_indexer(pd.DatetimeIndex([moment]), method="nearest")[0])
        if abs(self.times[row] - moment) > pd.Timedelta(minutes=0.5 * self.interval_minutes):
            raise ClerestoryError(f"time must be one of the weather, {self.times[0]} to {self.times[-1]}, got {moment}")
        table = self.frame.iloc[row]
        return PerezSky(
            direct_normal_irradiance_w_m2=float(table[DIRECT]),
            diffuse_horizontal_irradiance_w_m2=float(table[DIFFUSE]),
            sun_altitude_deg=float(self.sun.apparent_altitude_deg[row]),
            sun_azimuth_deg=float(self.sun.azimuth_deg[row]),
            dew_point_c=float(table.get(DEW_POINT, DEW_POINT_C)),
            extraterrestrial_irradiance_w_m2=SOLAR_CONSTANT_W_M2 / float(self.sun_distance_au[row]) ** 2,
        )

    def resampled(self, minutes: float) -> Weather:
        """The same light in shorter intervals, each with its own sun.

        Parameters
        ----------
        minutes : float
            Of the new interval; a whole number of them makes up the old one.

        Returns
        -------
        Weather
            The mean of each irradiance over an old interval is what it was.

        Raises
        ------
        ClerestoryError
            If ``minutes`` does not divide the interval.

        Notes
        -----
        theory/weather.md, eqs. 1-3.
        """
        from clerestory.weather.resampling import resampled_frame

        parts = self.interval_minutes / positive("minutes", minutes)
        if abs(parts - round(parts)) > 1e-9 or round(parts) < 1:
            raise ClerestoryError(
                f"minutes must divide the interval of {self.interval_minutes:g} min, got {minutes:g}; "
                "choose 60 over a whole number"
            )
        if round(parts) == 1:
            return self
        frame = resampled_frame(self.frame, self.site, self.interval_minutes, round(parts))
        note = f"interpolated from {self.interval_minutes:g} to {minutes:g} min"
        return replace(self, frame=frame, interval_minutes=float(minutes), notes=(*self.notes, note))

    def to_wea(self, path: str | os.PathLike[str]) -> Path:
        """Writes a WEA file, as `gendaymtx` of Radiance reads.

        Returns
        -------
        Path
            Of the file, written whole or not at all.
        """
        from clerestory.weather.wea import wea_text

        return write_text(path, wea_text(self))

    @classmethod
    def from_frame(
        cls,
        frame: pd.DataFrame,
        site: Site,
        *,
        times: str = "middle",
        interval_minutes: float | None = None,
        max_gap_hours: float | None = 3.0,
        source: str = "a table",
    ) -> Weather:
        """Weather from any table with direct normal and diffuse horizontal irradiance.

        Parameters
        ----------
        frame : DataFrame
            Indexed by time, with a zone or on the site's wall clock. Columns as of `Weather`, or ``dni``, ``dhi``,
            ``ghi``, ``temp_dew``, ``temp_air`` as in pvlib.
        site : Site
        times : "middle", "start" or "end", default "middle"
            What the times of the index mark of their intervals.
        interval_minutes : float, optional
            Default the shortest step between two times, at most 60.
        max_gap_hours : float, optional, default 3
            As in `read_epw`; None keeps the rows as they are, for chosen hours.
        source : str

        Returns
        -------
        Weather

        Raises
        ------
        ClerestoryError
            If a column is missing, a time wrong, a value impossible or a gap too long.
        """
        one_of("times", times, ("middle", "start", "end"))
        if not isinstance(frame, pd.DataFrame):
            raise ClerestoryError(f"frame must be a pandas DataFrame, got {type(frame).__name__}")
        table = frame.rename(columns={name: ALIASES.get(str(name), name) for name in frame.columns})
        kept = [column for column in LIMITS if column in table]
        for column in (DIRECT, DIFFUSE):
            if column not in kept:
                known = [name for name, means in ALIASES.items() if means == column]
                raise ClerestoryError(
                    f"frame must have the column {column} (or {known[0]}), got {sorted(map(str, frame.columns))}"
                )
        index = site.moments(frame.index)
        if not index.is_monotonic_increasing or index.has_duplicates:
            raise ClerestoryError("frame must have increasing times, got some out of order; sort and remove repeats")
        steps = np.diff(index.tz_convert("UTC").tz_localize(None).to_numpy()) / np.timedelta64(1, "m")
        step = positive("interval_minutes", interval_minutes or min([60.0, *steps]))
        shift = {"middle": 0.0, "start": 0.5, "end": -0.5}[times] * step
        table = pd.DataFrame(
            {column: _numbers(column, table[column]) for column in kept}, index=index + pd.Timedelta(minutes=shift)
        )
        whole, notes = filled(
            table,
            site,
            interval_minutes=step,
            max_gap_hours=max_gap_hours,
            wrong_at=lambda when, message: ClerestoryError(f"frame: {message}"),
        )
        return cls(site=site, frame=whole, interval_minutes=step, source=source, notes=notes)


def _numbers(column: str, values: pd.Series[Any]) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    try:
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as cause:
        raise ClerestoryError(f"{column} must hold numbers: {cause}") from cause
