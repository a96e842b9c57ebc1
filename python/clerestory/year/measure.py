"""From the light of a year to its metrics, for one variant."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from clerestory import metrics
from clerestory.errors import ClerestoryError
from clerestory.metrics.annual_sunlight_exposure import sunlit_hours
from clerestory.metrics.daylight_provision import LEVELS
from clerestory.weather.light import diffuse_horizontal_illuminance_lx
from clerestory.year.settings import Measures
from clerestory.year.study import YearStudy

PLACEMENT = ("worst_sun_offset_deg", "median_relative_difference", "share_of_flips")
"""What suns at fewer places than their own make of a difference."""

SERIES = ("mean", "least")
"""What is kept of each interval over the work plane."""


def measured(study: YearStudy, label: str, groups: Mapping[str, xr.Dataset]) -> xr.Dataset:
    """Every metric of one variant.

    Parameters
    ----------
    study : YearStudy
    label : str
        Of the variant.
    groups : mapping of group of windows → Dataset of `light_of`

    Returns
    -------
    Dataset
        Single figures, each with `…_standard_error` where light's own error moves it (theory/metrics.md, eq. 17); over
        "sensor" what plans are drawn of; over "time" what carpets are drawn of, `illuminance` (sensor, time) [lx] with
        blinds as people have them.
    """
    room, how = study.variants[label], study.measures
    through = {one.name: one.transmittance for one in study.blinds}
    occupied = {
        "in_use": metrics.occupied_hours(study.weather.times, study.schedule),
        "analysis": metrics.occupied_hours(study.weather.times, metrics.ANALYSIS_HOURS),
    }
    open_blinds = _together(groups)
    shaded = metrics.with_blinds(groups, transmittance=through, threshold_lx=how.sunlit_lx)
    error = open_blinds["relative_standard_error"]
    plane = _work_plane(open_blinds, how)
    found = _figures(study, open_blinds, shaded["total"], occupied, plane, room)
    low, high = (
        _figures(study, open_blinds * factor, shaded["total"] * factor, occupied, plane, room)
        for factor in (1.0 - error, 1.0 + error)
    )
    result = found.copy()
    for name in found.data_vars:
        if found[name].dtype.kind == "f":
            half = 0.5 * abs(high[name] - low[name])
            result[f"{name}_standard_error"] = half.assign_attrs(
                units=found[name].attrs["units"], long_name=f"standard error of {found[name].attrs['long_name']}"
            )
    factor = open_blinds["daylight_factor"]
    result["daylight_factor"] = factor
    result["mean_daylight_factor"] = _mean(factor.isel(sensor=plane), "mean daylight factor")
    result["illuminance"] = shaded["total"].astype(np.float32).assign_attrs(units="lx", long_name="illuminance")
    on_plane = shaded["total"].isel(sensor=plane)
    for name in SERIES:
        series = getattr(on_plane, "mean" if name == "mean" else "min")("sensor")
        result[f"{name}_illuminance"] = series.assign_attrs(
            units="lx", long_name=f"{name} illuminance of the work plane"
        )
    if "blinds_closed" in shaded:
        result["blinds_closed"] = shaded["blinds_closed"]
        share = 100.0 * shaded["blinds_closed"].isel(time=np.flatnonzero(occupied["in_use"].values)).mean("time")
        result["blinds_closed_percent"] = share.assign_attrs(
            units="percent", long_name="hours of use with blinds closed"
        )
    result["in_use"] = occupied["in_use"].drop_vars("local_time").assign_attrs(units="1")
    result["relative_standard_error"] = error.assign_attrs(
        units="1", long_name="relative standard error of the year's illuminance"
    )
    placed = [one.attrs for one in groups.values() if "median_relative_difference" in one.attrs]
    if placed:
        # the group that the choice of suns changes most
        most = max(placed, key=lambda one: float(one["median_relative_difference"]))
        result.attrs |= {f"suns_{name}": most[name] for name in PLACEMENT}
    return result.assign_coords(local_time=occupied["in_use"]["local_time"])


def _figures(
    study: YearStudy,
    light: xr.Dataset,
    used: xr.DataArray,
    occupied: Mapping[str, xr.DataArray],
    plane: Any,
    room: Any,
) -> xr.Dataset:
    """The metrics proper, from the light with open blinds and from that with blinds as used."""
    how, hour = study.measures, study.weather.interval_minutes / 60.0
    in_use, analysis = occupied["in_use"], occupied["analysis"]
    target = how.threshold_lx
    desks = used.isel(sensor=plane)
    found: dict[str, xr.DataArray] = {}

    found["daylight_autonomy"] = metrics.daylight_autonomy(used, occupied=in_use, threshold_lx=target)
    found["continuous_daylight_autonomy"] = metrics.continuous_daylight_autonomy(
        used, occupied=in_use, threshold_lx=target
    )
    useful = metrics.useful_daylight_illuminance(used, occupied=in_use, limits_lx=how.useful_limits_lx)
    found["useful_daylight_illuminance"] = useful
    found["sunlit_hours"] = sunlit_hours(
        light["sun_direct"], occupied=analysis, threshold_lx=how.sunlit_lx, interval_h=hour
    )
    found["annual_light_exposure"] = metrics.annual_light_exposure(used, interval_h=hour)

    def patch(sensors: Any) -> xr.Dataset:
        return metrics.glare_prone_hours(
            light["sun_direct"].isel(sensor=sensors),
            light["sun_redirected"].isel(sensor=sensors),
            occupied=in_use,
            threshold_lx=how.sunlit_lx,
            interval_h=hour,
        )

    found["glare_prone_hours"] = patch(slice(None))["glare_prone_hours"]

    found["mean_daylight_autonomy"] = _mean(found["daylight_autonomy"][plane], "mean daylight autonomy")
    found["mean_continuous_daylight_autonomy"] = _mean(
        found["continuous_daylight_autonomy"][plane], "mean continuous daylight autonomy"
    )
    for band in useful["band"].values:
        share = useful.sel(band=band, drop=True).isel(sensor=plane)
        found[f"mean_useful_{str(band).replace('-', '_')}"] = _mean(share, f"mean useful daylight, {band}")
    found["spatial_daylight_autonomy"] = metrics.spatial_daylight_autonomy(
        desks, occupied=analysis, threshold_lx=target
    )
    if study.blinds:
        unshaded = light["total"].isel(sensor=plane)
        found["spatial_daylight_autonomy_without_blinds"] = metrics.spatial_daylight_autonomy(
            unshaded, occupied=analysis, threshold_lx=target
        ).assign_attrs(long_name="sDA without blinds", units="percent")
    found["annual_sunlight_exposure"] = metrics.annual_sunlight_exposure(
        light["sun_direct"].isel(sensor=plane),
        occupied=analysis,
        threshold_lx=how.sunlit_lx,
        limit_h=how.exposure_limit_h,
        interval_h=hour,
    )
    provision = metrics.daylight_provision(desks, daylit=metrics.daylit_hours(_diffuse(study)))
    found["en17037_level"] = provision["level"].assign_attrs(flag_meanings=" ".join(LEVELS))
    found["en17037_target_illuminance"] = provision["target_illuminance"]
    found["en17037_minimum_illuminance"] = provision["minimum_illuminance"]
    found["annual_uniformity"] = metrics.annual_uniformity(desks, occupied=in_use)
    occupied_mean = desks.isel(time=np.flatnonzero(in_use.values)).mean("time")
    found["mean_illuminance_in_use"] = _mean(occupied_mean.assign_attrs(units="lx"), "mean illuminance in use")
    try:
        distance = metrics.distance_from_window_wall(desks, room)
    except ClerestoryError:  # a room lit from its roof has no depth
        distance = None
    if distance is not None:
        found["useful_depth"] = metrics.useful_depth(
            found["daylight_autonomy"][plane], distance.values, threshold=how.depth_percent
        )
    at_eyes = patch(_group(light, how.eyes) if how.eyes else plane)
    found["sun_patch_hours"] = at_eyes["anywhere"]
    found["redirected_sun_patch_hours"] = at_eyes["anywhere_by_redirected"]
    if study.lighting is not None:
        energy = metrics.lighting_energy(desks, occupied=in_use, lighting=study.lighting, interval_h=hour)
        for name in ("used", "without_daylight", "saved", "saved_percent"):
            found[f"lighting_{name}"] = energy[name]
    return xr.Dataset(found).drop_vars("local_time", errors="ignore")


def _together(groups: Mapping[str, xr.Dataset]) -> xr.Dataset:
    """The light of all groups of windows, blinds open."""
    every = list(groups.values())
    names = ("total", "sun_direct", "sun_redirected", "daylight_factor")
    result = xr.Dataset({name: sum(one[name] for one in every) for name in names})
    for name in names:
        result[name].attrs = dict(every[0][name].attrs)
    # independent runs: squares add
    total = result["total"].sum("time")
    squares = sum((one["relative_standard_error"] * one["total"].sum("time")) ** 2 for one in every)
    result["relative_standard_error"] = squares**0.5 / total.where(total > 0.0, 1.0)
    return result


def _work_plane(light: xr.Dataset, how: Measures) -> Any:
    return _group(light, how.work_plane or str(light["group"].values[0]))


def _group(light: xr.Dataset, name: str) -> Any:
    return np.flatnonzero(light["group"].values == name)


def _mean(values: xr.DataArray, name: str) -> xr.DataArray:
    mean: xr.DataArray = values.mean("sensor")
    return mean.assign_attrs(units=values.attrs.get("units", "1"), long_name=name)


def _diffuse(study: YearStudy) -> xr.DataArray:
    """Diffuse daylight outside, by which the standard's daylit hours are chosen."""
    diffuse: xr.DataArray = diffuse_horizontal_illuminance_lx(study.weather)
    return diffuse.drop_vars("local_time")
