"""Rows and values that are missing from a weather file: filled where that is safe, refused where it is not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import pandas as pd

from clerestory.errors import ClerestoryError
from clerestory.site import Site
from clerestory.sun import sun_position
from clerestory.weather.columns import DIFFUSE, DIRECT, GLOBAL, LONG_NAMES
from clerestory.weather.course import FOLLOWS_THE_SUN, course

Array = npt.NDArray[np.float64]

_LEAST_SINE = 0.1
"""Of the sun's altitude for a direct normal to be found from two horizontal irradiances."""


def filled(
    frame: pd.DataFrame,
    site: Site,
    *,
    interval_minutes: float,
    max_gap_hours: float | None,
    wrong_at: Callable[[pd.Timestamp, str], ClerestoryError],
) -> tuple[pd.DataFrame, tuple[str, ...]]:
    """The table with every interval from the first to the last, and a number in each that the sun lights.

    Parameters
    ----------
    frame : DataFrame
        Index with a zone, the middles of the intervals, increasing; NaN where a value is missing.
    site : Site
    interval_minutes : float
    max_gap_hours : float, optional
        Gaps of at most this many hours of daylight are filled; None keeps the rows as they are.
    wrong_at : callable
        Makes the error at a time, with a message.

    Returns
    -------
    frame : DataFrame
    notes : tuple of str
    """
    notes: list[str] = []
    if max_gap_hours is not None and len(frame) > 1:
        frame, absent = _every_interval(frame, site, interval_minutes, wrong_at)
        if absent:
            notes.append(f"{absent} rows were missing")
    if not frame[[DIRECT, DIFFUSE]].isna().to_numpy().any():
        return _others_even(frame), tuple(notes)
    altitude = sun_position(site, frame.index).apparent_altitude_deg.values
    dark = altitude <= 0.0
    frame = frame.copy()
    notes += _from_global(frame, np.sin(np.radians(altitude)))
    for column in (DIRECT, DIFFUSE):
        values = frame[column].to_numpy(dtype=np.float64).copy()
        by_night = np.isnan(values) & dark
        values[by_night] = 0.0
        if by_night.any():
            notes.append(f"{LONG_NAMES[column]}: {int(by_night.sum())} missing values by night are 0")
        missing = np.isnan(values)
        if missing.any():
            count, first = _longest(missing, dark)
            hours = count * interval_minutes / 60.0
            if max_gap_hours is None or hours > max_gap_hours or not (~missing & ~dark).any():
                allowed = "no" if max_gap_hours is None else f"at most {max_gap_hours:g}"
                raise wrong_at(
                    frame.index[first],
                    f"{LONG_NAMES[column]} must not be missing for longer than {allowed} hours of daylight, got "
                    f"{hours:g} from {frame.index[first]:%d %B %H:%M}; fill them in or raise max_gap_hours",
                )
            shape = course(column, altitude)
            known = ~missing & ~dark
            # the cloudiness before and after the gap, on the sun's course through it
            share = np.interp(np.flatnonzero(missing), np.flatnonzero(known), values[known] / shape[known])
            values[missing] = share * shape[missing]
            notes.append(
                f"{LONG_NAMES[column]}: {int(missing.sum())} missing values by day are filled, longest gap {hours:g} h"
            )
        frame[column] = values
    return _others_even(frame), tuple(notes)


def _every_interval(
    frame: pd.DataFrame, site: Site, interval_minutes: float, wrong_at: Callable[[pd.Timestamp, str], ClerestoryError]
) -> tuple[pd.DataFrame, int]:
    step = pd.Timedelta(minutes=interval_minutes)
    index = frame.index
    phase = (index - index[0]) % step
    off = phase != pd.Timedelta(0)
    if off.any():
        when = index[int(np.argmax(off))]
        raise wrong_at(when, f"times must be {interval_minutes:g} minutes apart, got {when:%d %B %H:%M}")
    # the night at either end belongs to the first and the last day
    midnight, half = index[0].normalize(), step / 2
    before = pd.date_range(midnight + half, index[0], freq=step, inclusive="left")
    after = pd.date_range(index[-1], index[-1].normalize() + pd.Timedelta(days=1), freq=step, inclusive="neither")
    if len(before) and (before[-1] + step != index[0] or _any_sun(site, before)):
        before = before[:0]
    if len(after) and _any_sun(site, after):
        after = after[:0]
    whole = before.append(pd.date_range(index[0], index[-1], freq=step)).append(after)
    absent = len(whole) - len(index)
    return (frame.reindex(whole) if absent else frame), absent


def _any_sun(site: Site, times: pd.DatetimeIndex) -> bool:
    """Whether the sun can be up within the hour about any of the times."""
    return bool((sun_position(site, times).altitude_deg.values > -8.0).any())


def _from_global(frame: pd.DataFrame, sine: Array) -> list[str]:
    """Fills direct or diffuse from the global irradiance and the other where the sun is high enough."""
    if GLOBAL not in frame:
        return []
    notes = []
    direct, diffuse = frame[DIRECT].to_numpy(copy=True), frame[DIFFUSE].to_numpy(copy=True)
    high = (sine > _LEAST_SINE) & frame[GLOBAL].notna().to_numpy()
    total = frame[GLOBAL].to_numpy()
    for column, here, found in (
        (
            DIRECT,
            high & np.isnan(direct) & ~np.isnan(diffuse),
            np.maximum(total - diffuse, 0.0) / np.maximum(sine, 0.1),
        ),
        (DIFFUSE, high & np.isnan(diffuse) & ~np.isnan(direct), np.maximum(total - direct * sine, 0.0)),
    ):
        if here.any():
            frame.loc[here, column] = found[here]
            notes.append(f"{LONG_NAMES[column]}: {int(here.sum())} missing values follow from the global irradiance")
    return notes


def _longest(missing: npt.NDArray[np.bool_], dark: npt.NDArray[np.bool_]) -> tuple[int, int]:
    """Most missing values by day without one that is known between them, and where the first of them is."""
    by_day = np.flatnonzero(~dark)
    runs = np.diff(np.concatenate([[0], missing[by_day].astype(np.int8), [0]]))
    starts, ends = np.flatnonzero(runs == 1), np.flatnonzero(runs == -1)
    which = int(np.argmax(ends - starts))
    return int(ends[which] - starts[which]), int(by_day[starts[which]])


def _others_even(frame: pd.DataFrame) -> pd.DataFrame:
    """What does not follow the sun changes evenly across a gap; a column without any value is left out."""
    others = [column for column in frame.columns if column not in (DIRECT, DIFFUSE)]
    empty = [column for column in others if frame[column].isna().all()]
    frame = frame.drop(columns=empty)
    for column in others:
        if column in frame and column not in FOLLOWS_THE_SUN and frame[column].isna().any():
            frame[column] = frame[column].interpolate(limit_direction="both")
    return frame
