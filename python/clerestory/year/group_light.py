"""The light of a year through one group of windows: traced once, kept by what it was made from."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import xarray as xr

from clerestory.annual_illuminance import annual_illuminance
from clerestory.annual_sun import annual_sun_coefficients, sun_placement_difference, sunny_directions
from clerestory.coefficients import PARTS, daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.illuminance import daylight_factor
from clerestory.room.scene import Room
from clerestory.room.toml_text import room_to_toml
from clerestory.sweep.fingerprint import key_of
from clerestory.weather import Weather
from clerestory.year.calculation import YearCalculation
from clerestory.year.window_groups import lit_through

Step = Callable[[str, float], "bool | None"]
"""Told what is done now and which share of it is done, 0..1; False stops."""

PLACEMENT_HOURS = 24
"""Size of the sample on which suns at fewer places are compared with the sun's own."""

SKY_SHARE = 0.35
"""Of the time that the light of a group takes, about, the sky's; the rest is the sun's."""


class Stopped(KeyboardInterrupt):
    """Tracing was stopped before its end: what it has is not good enough to keep."""


def group_light(
    room: Room,
    windows: Iterable[str],
    weather: Weather,
    how: YearCalculation,
    step: Step = lambda _what, _share: None,
) -> xr.Dataset:
    """Illuminance of every interval that enters a room through some of its windows.

    Parameters
    ----------
    room : Room
    windows : names of those that light enters through
        The others are black.
    weather : Weather
    how : YearCalculation
    step : callable, optional

    Returns
    -------
    Dataset
        That of `annual_illuminance`, single precision, with `daylight_factor` [percent] and
        `relative_standard_error` [1], over "sensor": of the sum over the year, as if the errors of all intervals went
        the same way. With suns at fewer places than their own, attributes that say on a sample what that changes.

    Raises
    ------
    Stopped
        If ``step`` says False, or Ctrl-C comes.
    """
    lit = lit_through(room, windows)
    stopped = False

    def told(what: str, begin: float, end: float) -> Callable[..., bool]:
        def progress(done: int, expected: int, *_: Any) -> bool:
            nonlocal stopped
            if step(what, begin + (end - begin) * done / max(done, expected, 1)) is False:
                stopped = True
            return not stopped

        return progress

    sky = daylight_coefficients(
        lit,
        basis=how.basis,
        rounds=how.rounds,
        nodes=how.nodes,
        window_samples=how.window_samples,
        max_bounces=how.max_bounces,
        seed=how.seed,
        progress=told("sky", 0.0, SKY_SHARE),
    )
    if stopped or sky.attrs["interrupted"]:
        raise Stopped
    sun = None
    if len(sunny_directions(weather)[0]):
        sun = annual_sun_coefficients(
            lit,
            None,
            weather,
            suns=how.suns,
            rounds=how.sun_rounds,
            max_bounces=how.max_bounces,
            seed=how.seed,
            progress=told("sun", SKY_SHARE, 1.0),
        )
        if stopped or sun.attrs["interrupted"]:
            raise Stopped
    light = annual_illuminance(sky, sun, weather, max_memory_mb=how.max_memory_mb)
    for name in PARTS_OF_LIGHT:
        if name not in light:
            light[name] = xr.zeros_like(light["sky"])
    result = light[list(PARTS_OF_LIGHT)]
    result["sun_offset_deg"] = light["sun_offset_deg"]
    factor = daylight_factor(sky)
    result["daylight_factor"] = factor.total
    result["daylight_factor_standard_error"] = factor.total_standard_error
    result["relative_standard_error"] = _relative_error(sky, sun, light)
    if sun is not None and how.suns != "exact":
        difference = sun_placement_difference(
            lit, None, weather, suns=how.suns, hours=PLACEMENT_HOURS, rounds=how.sun_rounds, seed=how.seed
        )
        exact, nearest = (difference[name].mean("sensor") for name in ("exact", "nearest"))
        # a sensor that the beam just reaches outweighs all others in a mean, not in a median
        off = abs(nearest / exact.where(exact > 0.0) - 1.0).median()
        result.attrs["median_relative_difference"] = float(off)
        result.attrs["share_of_flips"] = difference.attrs["share_of_flips"]
        result.attrs["worst_sun_offset_deg"] = float(light["sun_offset_deg"].max())
    step("done", 1.0)
    return result


PARTS_OF_LIGHT = ("sky", "sun_direct", "sun_redirected", "sun_interreflected", "total")


def key_of_light(room: Room, windows: Iterable[str], weather: Weather, how: YearCalculation, else_from: Any) -> str:
    """The hash of all that the light of a group rests on; of ``else_from`` if the room cannot be written down."""
    lit = lit_through(room, windows)
    try:
        # the name of a room is no matter of its light
        written: Any = room_to_toml(lit).split("\n", 1)[1] if lit.name else room_to_toml(lit)
    except ClerestoryError:
        written = [else_from, sorted(windows)]
    inputs = {"room": written, "calculation": vars(how), "weather": _digest(weather)}
    return key_of("light of a year", inputs, {})


def _digest(weather: Weather) -> str:
    import hashlib

    frame = weather.frame
    content = hashlib.sha256(repr((weather.site, weather.interval_minutes, list(frame.columns))).encode())
    content.update(frame.index.asi8.tobytes() + str(frame.index.dtype).encode())
    content.update(np.ascontiguousarray(frame.to_numpy(dtype=np.float64)).tobytes())
    return content.hexdigest()


def _relative_error(sky: xr.Dataset, sun: xr.Dataset | None, light: xr.Dataset) -> xr.DataArray:
    """Standard error of the year's sum over that sum, sensor by sensor."""
    from_sky = light["sky"].sum("time") * (
        sky["sky_illuminance_standard_error"] / sky["sky_illuminance"].where(sky["sky_illuminance"] > 0.0, 1.0)
    )
    squares = from_sky**2
    if sun is not None:
        for part in PARTS:
            mean = sun[part].mean("sun")
            # what is drawn for one sun is drawn for all: their errors go together
            share = sun[f"{part}_standard_error"].mean("sun") / mean.where(mean > 0.0, 1.0)
            squares = squares + (share * light[f"sun_{part}"].sum("time")) ** 2
    total = light["total"].sum("time")
    relative: xr.DataArray = squares**0.5 / total.where(total > 0.0, 1.0)
    return relative
