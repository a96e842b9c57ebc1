"""Illuminance at every sensor, interval by interval through a year."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from clerestory.annual_sun import nearest_suns
from clerestory.coefficients import PARTS
from clerestory.errors import ClerestoryError
from clerestory.provenance import provenance
from clerestory.rules import positive
from clerestory.saving import write_whole
from clerestory.weather.light import Light, light_of, patch_luminances, time_coordinates
from clerestory.weather.weather import Weather

Floats = npt.NDArray[np.float32]

_FARTHEST_DEG = 5.0
"""A sun further than this from every sun with coefficients is not covered by them."""

_LONG_NAMES = {
    "sky": "illuminance from the sky, all parts",
    "sun_direct": "illuminance from the sun, without total reflection",
    "sun_redirected": "illuminance from the sun, with a total reflection",
    "sun_interreflected": "illuminance from the sun after a diffuse reflection",
    "total": "illuminance",
    "total_standard_error": "standard error of the illuminance, upper bound",
}


def annual_illuminance(
    coefficients: xr.Dataset,
    sun_coefficients: xr.Dataset | None,
    weather: Weather,
    *,
    sky: xr.DataArray | None = None,
    standard_errors: bool = False,
    max_memory_mb: float = 2048.0,
    store: str | os.PathLike[str] | None = None,
) -> xr.Dataset:
    r"""Illuminance at every sensor, interval by interval, its parts kept.

    Parameters
    ----------
    coefficients : Dataset of `daylight_coefficients`
    sun_coefficients : Dataset of `annual_sun_coefficients` or `sun_coefficients`, or None
        Same sensors. At each time the nearest of its suns serves, at its own coordinates; with ``suns="exact"`` that is
        the sun itself. None leaves the sun out.
    weather : Weather
    sky : DataArray with dims ("patch", "time") [cd/m²], optional
        Default the all-weather sky of the weather, made piece by piece and never whole.
    standard_errors : bool, default False
        Adds `total_standard_error`, an upper bound; doubles the work.
    max_memory_mb : float, default 2048
        The result and what is at hand beside it stay below this.
    store : path, optional
        A folder ending in ``.zarr`` that the result is written to, whole or not at all, sensors by sensors; it is then
        read from there as it is needed. For results larger than ``max_memory_mb``.

    Returns
    -------
    Dataset, dims ("sensor", "time") [lx], float32
        `sky`, `sun_direct`, `sun_redirected`, `sun_interreflected` and their sum `total`. `sun_offset_deg` ("time")
        says how far the sun was from the one that served, NaN without sun. `time` is in UTC, `local_time` on the wall
        clock.

    Raises
    ------
    ClerestoryError
        If sensors, patches or times differ, a sun is further than 5° from every sun with coefficients, or the result
        does not fit into the memory allowed.

    Notes
    -----
    :math:`E_{st} = \sum_p C_{sp} L_{pt} + c_s(\mathbf{s}_t) E_{b,t}` (theory/weather.md, eqs. 4-5), in single
    precision: relative rounding below 1e-6 of the sum.
    """
    positive("max_memory_mb", max_memory_mb)
    whole = _Year(coefficients, sun_coefficients, weather, sky, standard_errors)
    budget = 1e6 * max_memory_mb
    needed = whole.result_bytes(whole.sensors)
    if store is None:
        # half for the result, the rest for luminances and copies
        if needed > 0.5 * budget:
            raise ClerestoryError(
                f"max_memory_mb must hold twice the result of {needed / 1e6:.0f} MB ({whole.sensors} sensors × "
                f"{len(weather)} times), got {max_memory_mb:g}; raise it, give store=FOLDER.zarr, or split the sensors"
            )
        return whole.part(slice(0, whole.sensors), budget)
    where = Path(store)
    if where.suffix != ".zarr":
        raise ClerestoryError(f"store must be a folder ending in .zarr, got {str(where)!r}")
    if where.exists():
        raise ClerestoryError(f"store must not exist yet, got {where}; remove it or choose another")
    count = int(whole.sensors * 0.25 * budget // max(needed, 1))
    if count < 1:
        raise ClerestoryError(
            f"max_memory_mb must hold a few times one sensor's {needed / whole.sensors / 1e6:.3g} MB, "
            f"got {max_memory_mb:g}; raise it"
        )

    def write(draft: Path) -> None:
        # names of groups are text of fixed length, of which zarr warns
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            write_sensors(draft)

    def write_sensors(draft: Path) -> None:
        for k, first in enumerate(range(0, whole.sensors, count)):
            part = whole.part(slice(first, min(first + count, whole.sensors)), budget)
            if k == 0:
                part.to_zarr(draft, mode="w", consolidated=False)
            else:
                # what has no sensors stands there already
                fixed = [name for name in part.variables if "sensor" not in part[name].dims]
                part.drop_vars(fixed).to_zarr(draft, append_dim="sensor", consolidated=False)

    write_whole(where, write)
    stored: xr.Dataset = xr.open_zarr(where, chunks=None, consolidated=False)
    return stored


class _Year:
    """What all sensors share: the weather's light, lit times, the suns that serve, and how to make any part."""

    def __init__(
        self,
        coefficients: xr.Dataset,
        sun_coefficients: xr.Dataset | None,
        weather: Weather,
        sky: xr.DataArray | None,
        standard_errors: bool,
    ) -> None:
        _check(coefficients, sun_coefficients, weather, sky)
        self.sensors = coefficients.sizes["sensor"]
        self._coefficients, self._suns, self._weather, self._sky = coefficients, sun_coefficients, weather, sky
        self._standard_errors = standard_errors
        self._light: Light = light_of(weather)
        self._basis = str(coefficients.attrs["basis"])
        lit = (self._light.diffuse_horizontal_lx > 0.0) | (self._light.direct_normal_lx > 0.0)
        self._lit = np.flatnonzero(lit) if sky is None else np.flatnonzero(sky.values.any(axis=0))
        self._sunny = np.flatnonzero(self._light.direct_normal_lx > 0.0)
        self._offset_deg = np.full(len(weather), np.nan)
        self._which = np.zeros(0, dtype=np.int64)
        if sun_coefficients is not None and len(self._sunny):
            self._which, offset = nearest_suns(sun_coefficients, self._light.sun_direction[self._sunny])
            worst = int(np.argmax(offset))
            if offset[worst] > _FARTHEST_DEG:
                raise ClerestoryError(
                    f"sun_coefficients must have a sun within {_FARTHEST_DEG:g}° of every sun of the weather, got "
                    f"{offset[worst]:.1f}° at {weather.times[self._sunny[worst]]}; make them with "
                    "annual_sun_coefficients"
                )
            self._offset_deg[self._sunny] = offset

    def result_bytes(self, sensors: int) -> int:
        """Of the variables by sensor and time."""
        return 4 * sensors * len(self._weather) * (len(self._names()) + 1)

    def _names(self) -> list[str]:
        parts = ["sky"] if self._suns is None else ["sky", "sun_direct", "sun_redirected", "sun_interreflected"]
        return [*parts, "total_standard_error"] if self._standard_errors else parts

    def part(self, sensors: slice, budget: float) -> xr.Dataset:
        """The result of some sensors."""
        some = self._coefficients.isel(sensor=sensors)
        count, times = some.sizes["sensor"], len(self._weather)
        found = {name: np.zeros((count, times), dtype=np.float32) for name in self._names()}
        weights = _single(sum(some[part].values for part in PARTS))
        errors = (
            _single(sum(some[f"{part}_standard_error"].values for part in PARTS)) if self._standard_errors else None
        )
        # luminances, products and their copies take half of what is allowed
        at_once = max(24, int(0.125 * budget // (4 * (weights.shape[1] + count))))
        for rows, luminance in self._luminances(at_once):
            found["sky"][:, rows] = weights @ luminance.T
            if errors is not None:
                found["total_standard_error"][:, rows] = errors @ luminance.T
        if self._suns is not None:
            self._add_sun(found, sensors)
        total = found["sky"].copy()
        for name in ("sun_direct", "sun_redirected", "sun_interreflected"):
            if name in found:
                total += found[name]
        found["total"] = total
        about = {name: {"units": "lx", "long_name": long_name} for name, long_name in _LONG_NAMES.items()}
        result = xr.Dataset(
            {name: (("sensor", "time"), values, about[name]) for name, values in found.items()},
            coords={
                **{name: some[name] for name in some.coords if some[name].dims == ("sensor",)},
                **time_coordinates(self._weather),
            },
            attrs=self._attributes(),
        )
        long_name = "angle between the sun and the one whose coefficients serve"
        result["sun_offset_deg"] = ("time", self._offset_deg, {"units": "degree", "long_name": long_name})
        return result

    def _luminances(self, at_once: int) -> Iterator[tuple[npt.NDArray[np.intp] | slice, Floats]]:
        """Lit times and the luminances of their patches, (time, patch), some times at once."""
        reflectance = float(self._coefficients.attrs["ground_reflectance"])
        for first in range(0, len(self._lit), at_once):
            rows = self._lit[first : first + at_once]
            if self._sky is None:
                yield rows, patch_luminances(self._light.at(rows), self._basis, ground_reflectance=reflectance)
            else:
                yield rows, _single(self._sky.values[:, rows].T)

    def _add_sun(self, found: dict[str, Floats], sensors: slice) -> None:
        assert self._suns is not None
        normal = _single(self._light.direct_normal_lx[self._sunny])
        variance = np.zeros((sensors.stop - sensors.start, len(normal)), dtype=np.float32)
        for part in PARTS:
            values = _single(self._suns[part].values[sensors])
            found[f"sun_{part}"][:, self._sunny] = np.take(values, self._which, axis=1) * normal
            if self._standard_errors:
                error = _single(self._suns[f"{part}_standard_error"].values[sensors])
                variance += (np.take(error, self._which, axis=1) * normal) ** 2
        if self._standard_errors:
            found["total_standard_error"][:, self._sunny] += np.sqrt(variance)

    def _attributes(self) -> dict[str, Any]:
        given, weather = self._coefficients.attrs, self._weather
        worst = float(np.nanmax(self._offset_deg)) if len(self._sunny) and self._suns is not None else None
        return provenance(
            room=given.get("room"),
            basis=self._basis,
            ground_reflectance=given["ground_reflectance"],
            weather=weather.source,
            interval_minutes=weather.interval_minutes,
            latitude_deg=weather.site.latitude_deg,
            longitude_deg=weather.site.longitude_deg,
            timezone=weather.site.timezone,
            sky="given" if self._sky is not None else "all-weather sky, Perez 1993",
            suns="none" if self._suns is None else str(self._suns.attrs.get("suns", "given")),
            worst_sun_offset_deg=worst,
        )


def _check(coefficients: xr.Dataset, suns: xr.Dataset | None, weather: Weather, sky: xr.DataArray | None) -> None:
    if "basis" not in coefficients.attrs or "patch" not in coefficients.dims:
        raise ClerestoryError(
            f"coefficients must be those of daylight_coefficients, got dims {dict(coefficients.sizes)}"
        )
    if suns is not None:
        if "sun" not in suns.dims:
            raise ClerestoryError(f"sun_coefficients must have suns, got dims {dict(suns.sizes)}")
        same = suns.sizes["sensor"] == coefficients.sizes["sensor"] and all(
            np.allclose(suns[name], coefficients[name], atol=1e-9) for name in ("x_m", "y_m", "z_m")
        )
        if not same:
            raise ClerestoryError(
                f"sun_coefficients must be of the {coefficients.sizes['sensor']} sensors of the coefficients, "
                f"got {suns.sizes['sensor']} or others"
            )
    if sky is not None:
        wanted = {"patch": coefficients.sizes["patch"], "time": len(weather)}
        if sky.dims != ("patch", "time") or dict(sky.sizes) != wanted:
            raise ClerestoryError(f"sky must have dims {wanted}, got {dict(sky.sizes)}")


def _single(values: Any) -> Floats:
    return np.asarray(values, dtype=np.float32)
