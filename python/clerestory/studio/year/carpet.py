"""A year hour by hour: carpets by day and hour of the wall clock, months, and one hour's plan."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.plots.carpet import by_day_and_hour
from clerestory.rules import number, one_of
from clerestory.site import Site
from clerestory.studio.results.metrics import Metric, scale_of
from clerestory.studio.results.plans import labels_of, plan_of
from clerestory.studio.results.shelf import Result
from clerestory.sun import sun_position

Floats = npt.NDArray[np.float64]

#: What a carpet shows, and the digits of its numbers.
SERIES = ("mean", "least", "sensor")
_DIGITS = 4
#: Round illuminances between which a carpet's colours run [lx].
_STEPS_LX = (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0, 30_000.0, 100_000.0)


def carpet(result: Result, *, series: Any = "mean", sensor: Any = None) -> dict[str, Any]:
    """Illuminance by day and hour, all variants.

    Parameters
    ----------
    result : Result
    series : {"mean", "least", "sensor"}
        Of the work plane, or of one sensor.
    sensor : int
        Its number, for "sensor".

    Returns
    -------
    dict
        ``days`` (dates), ``step_h`` (of a row), ``hours`` (where rows begin); for each variant ``values`` (row by row:
        hours, then days; null where the clock skips an hour; 4 digits) and ``blinds`` (share of the groups of windows
        whose blinds are closed); ``in_use`` likewise; ``sunrise`` and ``sunset`` of each day on the same clock.
    """
    word = one_of("series", series, SERIES)
    lines = _series(result, word, sensor)
    carpets, days, hours = [], None, None
    for place, label in enumerate(labels_of(result)):
        cells, days, hours = by_day_and_hour(lines.isel(variant=place))
        carpets.append({"label": label, "values": _listed(_rounded(cells))})
    assert days is not None
    assert hours is not None
    low, high = _range(lines.values)
    # what is the same of every place is found once
    blinds = result.once("blinds", lambda: [_blinds(result, place) for place in range(len(carpets))])
    for one, closed in zip(carpets, blinds, strict=True):
        one["blinds"] = closed
    return {
        "series": word,
        "unit": "lx",
        "low": low,
        "high": high,
        "ticks": [tick for tick in _STEPS_LX if low <= tick <= high],
        "days": [str(day)[:10] for day in days[:-1]],
        "step_h": float(hours[1] - hours[0]),
        "rows": len(hours) - 1,
        "in_use": result.once("in_use", lambda: _in_use(result)),
        "variants": carpets,
        **result.once("sun", lambda: _sun(result, days)),
    }


def months(result: Result, *, series: Any = "mean", sensor: Any = None) -> dict[str, Any]:
    """Mean of each month, of all hours between sunrise and sunset and of the hours of use; [lx]."""
    lines = _series(result, one_of("series", series, SERIES), sensor)
    clock = pd.DatetimeIndex(_clock(result))
    month = clock.to_period("M")
    names = month.unique().sort_values()
    used = result.data["in_use"].isel(variant=0).values.astype(bool)
    told = []
    for place, label in enumerate(labels_of(result)):
        values = lines.isel(variant=place).values.astype(np.float64)
        told.append(
            {
                "label": label,
                "daylit": [_mean(values[(month == one) & (values > 0.0)]) for one in names],
                "in_use": [_mean(values[(month == one) & used]) for one in names],
            }
        )
    return {"months": [str(one) for one in names], "unit": "lx", "variants": told}


def hour_plan(result: Result, *, day: Any, hour: Any, plane: Any = None) -> dict[str, Any]:
    """Illuminance in plan at one cell of the carpet: the mean of its intervals, as a repeated hour has two.

    Raises
    ------
    ClerestoryError
        If the year has no such hour.
    """
    which = _intervals(result, day, hour)
    values = result.data["illuminance"].isel(time=which).mean("time").astype(np.float64).transpose("variant", "sensor")
    at = pd.Timestamp(_clock(result)[which[0]])
    metric = Metric("illuminance", "Illuminance", "lx", f"{at:%A %d %B, %H:%M}, the middle of the interval.")
    told = plan_of(result, metric, values, None, plane)
    shown = scale_of(values, metric)
    sun = _sun_at(result, result.data["time"].values[which])
    closed = {}
    if "blinds_closed" in result.data:
        blinds = result.data["blinds_closed"].isel(time=which).any("time").transpose("variant", "window_group").values
        groups = [str(one) for one in result.data["window_group"].values.tolist()]
        closed = {
            label: [group for group, shut in zip(groups, row, strict=True) if shut]
            for label, row in zip(labels_of(result), blinds, strict=True)
        }
    in_use = bool(result.data["in_use"].isel(variant=0, time=which).any())
    return told | shown | {"time": f"{at:%Y-%m-%dT%H:%M}", "sun": sun, "blinds_closed": closed, "in_use": in_use}


def _intervals(result: Result, day: Any, hour: Any) -> npt.NDArray[np.int64]:
    if not isinstance(day, str) or not re.fullmatch(r"\d{4}-\d{2}-\d{2}", day):
        raise ClerestoryError(f"day must be a date such as 2023-06-21, got {str(day)[:40]!r}")
    at = number("hour", hour)
    clock = pd.DatetimeIndex(_clock(result))
    own = np.asarray(clock.strftime("%Y-%m-%d") == day)
    step = _step_h(result)
    row = np.floor((clock.hour + clock.minute / 60.0).to_numpy() / step)
    which = np.flatnonzero(own & (row == np.floor(at / step)))
    if not len(which):
        raise ClerestoryError(f"hour must be one that the year has, got {at:g} h of {day}")
    return which


def _clock(result: Result) -> Any:
    """Times on the wall clock."""
    return result.data["local_time" if "local_time" in result.data.coords else "time"].values


def _step_h(result: Result) -> float:
    steps = np.diff(result.data["time"].values).astype("timedelta64[s]").astype(np.float64) / 3600.0
    return float(min(1.0, *steps)) if len(steps) else 1.0


def _series(result: Result, word: str, sensor: Any) -> xr.DataArray:
    if word != "sensor":
        lines = result.data[f"{word}_illuminance"]
    else:
        count = result.data.sizes["sensor"]
        if sensor is None or not 0 <= sensor < count:
            raise ClerestoryError(f"sensor must be a number of 0..{count - 1}, got {sensor!r}")
        lines = result.data["illuminance"].isel(sensor=int(sensor))
    return lines.transpose("variant", "time").assign_coords(local_time=("time", _clock(result)))


def _in_use(result: Result) -> list[Any]:
    used = result.data["in_use"].isel(variant=0).astype(np.float64)
    cells = by_day_and_hour(used.assign_coords(local_time=("time", _clock(result))))[0]
    return [None if one is None else int(one > 0.5) for one in _listed(cells)]


def _blinds(result: Result, place: int) -> list[Any] | None:
    if "blinds_closed" not in result.data:
        return None
    closed = result.data["blinds_closed"].isel(variant=place).mean("window_group")
    cells: Floats = by_day_and_hour(closed.assign_coords(local_time=("time", _clock(result))))[0]
    return _listed(np.round(cells, 2))


def _site(result: Result) -> Site | None:
    try:
        latitude, longitude = (float(result.data.attrs[f"{name}_deg"]) for name in ("latitude", "longitude"))
        return Site(latitude_deg=latitude, longitude_deg=longitude)
    except (KeyError, ValueError, TypeError):
        return None


def _sun_at(result: Result, times: Any) -> dict[str, float] | None:
    site = _site(result)
    if site is None:
        return None
    found = sun_position(site, pd.DatetimeIndex(times).tz_localize("UTC"))
    return {
        "altitude_deg": float(found["apparent_altitude_deg"][0]),
        "azimuth_deg": float(found["azimuth_deg"][0]),
    }


def _sun(result: Result, days: Any) -> dict[str, Any]:
    """Sunrise and sunset of each day, in hours of the same clock; null where the sun does not rise or set."""
    site = _site(result)
    if site is None:
        return {"sunrise": None, "sunset": None}
    from pvlib.solarposition import sun_rise_set_transit_spa

    clock, utc = pd.DatetimeIndex(_clock(result)), pd.DatetimeIndex(result.data["time"].values)
    ahead = pd.Series((clock - utc).to_numpy(), index=clock.normalize()).groupby(level=0).median()
    local = pd.DatetimeIndex(days[:-1])
    offset = pd.TimedeltaIndex(ahead.reindex(local).ffill().bfill())
    # the day of the sun that has its noon on this date of the clock
    noon = (local + pd.Timedelta(hours=12) - offset).tz_localize("UTC")
    shift = pd.Timedelta(hours=site.longitude_deg / 15.0)
    solar = pd.DatetimeIndex([(moment + shift).normalize() for moment in noon])
    found = sun_rise_set_transit_spa(solar.tz_localize(None).tz_localize("UTC"), site.latitude_deg, site.longitude_deg)

    def hours(name: str) -> list[float | None]:
        at = pd.DatetimeIndex(found[name].to_numpy()).tz_localize(None) + offset
        told = ((at - local) / pd.Timedelta(hours=1)).to_numpy(dtype=np.float64)
        # an event of the day before or after is brought to this one
        return [None if np.isnan(one) else round(float(one % 24.0), 3) for one in told]

    return {"sunrise": hours("sunrise"), "sunset": hours("sunset")}


def _range(values: Any) -> tuple[float, float]:
    """Round ends of a logarithmic scale that nearly all of the light lies between."""
    lit = values[np.isfinite(values) & (values > 0.0)]
    if not len(lit):
        return 30.0, 10_000.0
    least, most = np.percentile(lit, [8.0, 99.5])
    low = max((step for step in _STEPS_LX if step <= least), default=_STEPS_LX[0])
    high = min((step for step in _STEPS_LX if step >= most), default=_STEPS_LX[-1])
    return (low, high) if low < high else (low, 10.0 * low)


def _rounded(cells: Floats) -> Floats:
    """Numbers with a few digits, as a picture needs them."""
    size = np.where(cells > 0.0, cells, 1.0)
    scale = 10.0 ** (_DIGITS - 1 - np.floor(np.log10(size)))
    return np.round(cells * scale) / scale


def _listed(cells: Floats) -> list[Any]:
    """Numbers row by row, null where there is none: so they are written as they are, and not looked at one by one."""
    told = cells.ravel().astype(object)
    told[np.isnan(cells.ravel())] = None
    numbers: list[Any] = told.tolist()
    return numbers


def _mean(values: Any) -> float | None:
    return float(values.mean()) if len(values) else None
