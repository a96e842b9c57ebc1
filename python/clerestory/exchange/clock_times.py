"""Times of a year of results as other programs count them: month, day and hour, or hours of the year."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pandas as pd
import xarray as xr

from clerestory.errors import ClerestoryError

Hours = npt.NDArray[np.float64]


def local_times(annual: xr.Dataset) -> pd.DatetimeIndex:
    """Middles of the intervals in the site's standard time, which these formats count in: no hour twice, none skipped.

    It is `time`, moved by the least that `local_time` is ahead of it: daylight saving time is ahead of standard time
    everywhere. Without `local_time`, `time` is taken as it is.

    Raises
    ------
    ClerestoryError
        If there are no times.
    """
    if "time" in annual.coords and np.issubdtype(annual["time"].dtype, np.datetime64):
        utc = pd.DatetimeIndex(annual["time"].values)
        ahead = pd.DatetimeIndex(annual["local_time"].values) - utc if "local_time" in annual.coords else None
        return utc if ahead is None else utc + ahead.min()
    raise ClerestoryError("annual results must have the coordinate time, got none; take those of annual_illuminance")


def interval_h(times: pd.DatetimeIndex) -> float:
    """Length of an interval: the shortest step between times, an hour for a single one."""
    steps = np.diff(np.sort(times.to_numpy())) / np.timedelta64(1, "h")
    steps = steps[steps > 0.0]
    return float(steps.min()) if steps.size else 1.0


def hours_of_year(times: pd.DatetimeIndex) -> Hours:
    """Hours since the year began, in a year of 365 days.

    Raises
    ------
    ClerestoryError
        If a time falls on 29 February: these formats have no such day.
    """
    leap = (times.month == 2) & (times.day == 29)
    if leap.any():
        raise ClerestoryError(
            f"times must not fall on 29 February in this format, got {times[leap][0]}; leave that day out"
        )
    # days before each month in a year that is no leap year
    before = np.concatenate([[0], np.cumsum([31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30])])
    days = before[times.month - 1] + times.day - 1
    hours = 24.0 * days + times.hour + times.minute / 60.0 + times.second / 3600.0
    return np.asarray(hours, dtype=np.float64)
