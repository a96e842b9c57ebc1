"""A place on Earth and its clock."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd

from clerestory.errors import ClerestoryError
from clerestory.rules import within


@dataclass(frozen=True, kw_only=True)
class Site:
    """A place on Earth and its clock.

    Parameters
    ----------
    latitude_deg : float, -90..90
        Positive to the north.
    longitude_deg : float, -180..180
        Positive to the east (Radiance counts to the west).
    elevation_m : float, default 0
        Height above sea level, -500..9000.
    timezone : str, default "UTC"
        Of the wall clock: a name such as ``"America/Maceio"`` or an offset such as ``"-03:00"``.

    Raises
    ------
    ClerestoryError
        If a number is out of range or the time zone is unknown.
    """

    latitude_deg: float
    longitude_deg: float
    elevation_m: float = 0.0
    timezone: str = "UTC"

    def __post_init__(self) -> None:
        within("latitude_deg", self.latitude_deg, -90.0, 90.0)
        within("longitude_deg", self.longitude_deg, -180.0, 180.0)
        within("elevation_m", self.elevation_m, -500.0, 9000.0)
        try:
            pd.Timestamp("2000-01-01").tz_localize(self.timezone)
        except Exception as cause:
            raise ClerestoryError(
                f'timezone must be a known name such as "America/Maceio" or an offset such as "-03:00", '
                f"got {self.timezone!r}"
            ) from cause

    def moments(self, times: Any) -> pd.DatetimeIndex:
        """Times as absolute moments on the site's clock.

        Parameters
        ----------
        times : str, datetime, datetime64, Timestamp, or a sequence, Series, index or DataArray of them
            A time with a zone is that moment; one without is the wall clock at the site.

        Returns
        -------
        DatetimeIndex, in the site's time zone

        Raises
        ------
        ClerestoryError
            If a time cannot be read, is missing, or is skipped or repeated by a clock change.
        """
        try:
            plain = times if isinstance(times, (pd.DatetimeIndex, pd.Series)) else getattr(times, "values", times)
            index = pd.DatetimeIndex(plain if np.ndim(plain) else [plain])
        except (ValueError, TypeError) as cause:
            raise ClerestoryError(f"times must be dates and times such as 2024-06-21 12:00, got {times!r}") from cause
        if index.hasnans:
            raise ClerestoryError(f"times must not be missing, got NaT at position {int(np.argmax(index.isna()))}")
        if index.tz is not None:
            return index.tz_convert(self.timezone)
        try:
            return index.tz_localize(self.timezone)
        except ValueError as cause:
            raise ClerestoryError(
                f"times must exist once on the clock of {self.timezone}: {cause}; give times with a zone"
            ) from cause
