"""The sun through a year: what it gives each sensor from its own places, or from the nearest of fewer."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from clerestory.coefficients import PARTS, Progress
from clerestory.errors import ClerestoryError
from clerestory.room.scene import Room
from clerestory.room.sensors import SensorGrid, Sensors
from clerestory.sky.basis import sky_basis
from clerestory.sun import direction_of
from clerestory.sun_coefficients import sun_coefficients
from clerestory.weather.light import light_of, time_coordinates
from clerestory.weather.weather import Weather

Array = npt.NDArray[np.float64]
Some = SensorGrid | Sensors | Iterable[SensorGrid | Sensors] | None


def annual_sun_coefficients(
    room: Room,
    sensors: Some,
    weather: Weather,
    *,
    suns: str = "exact",
    rounds: int = 8,
    max_bounces: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Sun coefficients for every place that the sun takes while it shines.

    Parameters
    ----------
    room : Room
    sensors : SensorGrid, Sensors or a sequence of them, or None
        None for the room's own.
    weather : Weather
        Its direct irradiance says when the sun shines.
    suns : str, default "exact"
        ``"exact"``: the sun's own place in each sunny interval, some 4400 in a year of hours. Or a sky basis such as
        ``"troplux5221"`` or ``"reinhart2305"``: the centres of those of its patches that the sun comes through.
    rounds, max_bounces, seed, threads, progress
        As in `sun_coefficients`.

    Returns
    -------
    Dataset, dims ("sensor", "sun") [1]
        As `sun_coefficients`; the attribute `suns` says which. Without any sunshine there are no suns.
    """
    directions = sunny_directions(weather)[0]
    if len(directions) == 0:
        raise ClerestoryError("weather must have direct irradiance while the sun is up, got none; leave the sun out")
    places = directions if suns == "exact" else _centres(suns, directions)
    altitude, azimuth = _angles(places)
    found = sun_coefficients(
        room,
        sensors,
        altitude_deg=altitude,
        azimuth_deg=azimuth,
        rounds=rounds,
        max_bounces=max_bounces,
        seed=seed,
        threads=threads,
        progress=progress,
    )
    found.attrs |= {"suns": suns, "weather": weather.source}
    return found


def sun_placement_difference(
    room: Room,
    sensors: Some,
    weather: Weather,
    *,
    suns: str = "troplux5221",
    hours: int = 64,
    rounds: int = 8,
    seed: int = 0,
) -> xr.Dataset:
    """What the sun gives from the nearest place of a basis instead of its own, on a sample of sunny intervals.

    Parameters
    ----------
    room, sensors, weather, suns, rounds
        As in `annual_sun_coefficients`.
    hours : int, default 64
        Size of the sample, drawn evenly over the sunny intervals.
    seed : int, default 0

    Returns
    -------
    Dataset, dims ("sensor", "time")
        `exact` and `nearest` [lx], all parts together; `offset_deg` ("time"). Attributes: `mean_relative_difference` of
        the mean over sensors and times, `rms_relative_difference` of the mean over the sensors time by time,
        `rms_relative_noise`, what of that may be the standard errors of the two (more ``rounds`` lessen it), and
        `share_of_flips`, sensor and time at which the sun's direct light is there in one and not in the other.
    """
    directions, rows = sunny_directions(weather)
    if hours < 1:
        raise ClerestoryError(f"hours must be at least 1, got {hours}")
    if len(rows) == 0:
        raise ClerestoryError("weather must have direct irradiance while the sun is up, got none")
    # one from each of so many equal stretches
    edges = np.linspace(0, len(rows), min(hours, len(rows)) + 1)
    drawn = np.random.default_rng(seed).uniform(edges[:-1], edges[1:]).astype(np.int64)
    normal = light_of(weather).direct_normal_lx[rows[drawn]]
    both, offset, direct, noise = {}, np.zeros(len(drawn)), {}, np.zeros(len(drawn))
    for name, places in (("exact", directions[drawn]), ("nearest", _centres(suns, directions[drawn]))):
        altitude, azimuth = _angles(places)
        found = sun_coefficients(room, sensors, altitude_deg=altitude, azimuth_deg=azimuth, rounds=rounds, seed=seed)
        which, offset = nearest_suns(found, directions[drawn])
        part = {part: found[part].values[:, which] * normal for part in PARTS}
        # errors of the sensors go together: the mean of them bounds that of the mean
        noise += (found.interreflected_standard_error.values[:, which].mean(axis=0) * normal) ** 2
        both[name], direct[name] = sum(part.values()), part["direct"] + part["redirected"]
    means = {name: np.asarray(values).mean(axis=0) for name, values in both.items()}
    level = float(means["exact"].mean())
    flips = (direct["exact"] > 0.0) != (direct["nearest"] > 0.0)
    coordinates = {name: values[rows[drawn]] for name, values in time_coordinates(weather).items()}
    by_sensor = {name: found[name] for name in found.coords if found[name].dims == ("sensor",)}
    result = xr.Dataset(
        {
            **{name: (("sensor", "time"), values, {"units": "lx"}) for name, values in both.items()},
            "offset_deg": ("time", offset, {"units": "degree"}),
        },
        coords={**by_sensor, **coordinates},
    )
    apart = means["nearest"] - means["exact"]
    relative = {
        "mean_relative_difference": apart.mean(),
        "rms_relative_difference": np.sqrt(np.mean(apart**2)),
        "rms_relative_noise": np.sqrt(noise.mean()),
    }
    result.attrs = {"suns": suns, **{name: float(value / level) if level else 0.0 for name, value in relative.items()}}
    result.attrs["share_of_flips"] = float(flips.mean())
    return result


def sunny_directions(weather: Weather) -> tuple[Array, npt.NDArray[np.intp]]:
    """Towards the sun in each interval that it shines in, shape (k, 3), and which those are."""
    light = light_of(weather)
    rows = np.flatnonzero(light.direct_normal_lx > 0.0)
    return light.sun_direction[rows], rows


def nearest_suns(coefficients: xr.Dataset, directions: Array) -> tuple[npt.NDArray[np.int64], Array]:
    """For each direction the nearest sun of sun coefficients, and the angle between them [deg]."""
    known = direction_of(coefficients.sun_altitude_deg.values, coefficients.sun_azimuth_deg.values)
    which = np.arange(len(directions))
    if known.shape != directions.shape or np.abs(known - directions).max(initial=0.0) > 1e-6:
        # a few hundred at once keep the table of cosines small
        single = known.T.astype(np.float32)
        pieces = [
            np.argmax(directions[k : k + 512].astype(np.float32) @ single, axis=1)
            for k in range(0, len(directions), 512)
        ]
        which = np.concatenate([np.zeros(0, dtype=np.int64), *pieces])
    chord = np.linalg.norm(known[which] - directions, axis=1)
    return which, np.degrees(2.0 * np.arcsin(np.minimum(0.5 * chord, 1.0)))


def _centres(basis: str, directions: Array) -> Array:
    """Centres of the patches that directions go through, each once."""
    patches = sky_basis(basis)
    return np.asarray(patches.centres)[np.unique(patches.find(directions))]


def _angles(directions: Array) -> tuple[Any, Any]:
    altitude = np.degrees(np.arcsin(np.clip(directions[:, 2], -1.0, 1.0)))
    return altitude, np.degrees(np.arctan2(directions[:, 0], directions[:, 1])) % 360.0
