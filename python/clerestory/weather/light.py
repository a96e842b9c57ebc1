"""The light that weather brings: of the sun, of the sky and of each patch of it."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from clerestory.rules import one_of, within
from clerestory.sky.basis import patch_coordinates, sky_basis
from clerestory.sky.perez import (
    DEW_POINT_C,
    SOLAR_CONSTANT_W_M2,
    Conditions,
    diffuse_efficacy_lm_w,
    direct_efficacy_lm_w,
    luminance_parameters,
    sky_conditions,
)
from clerestory.sky.perez_sky import quadrature_order
from clerestory.sun import direction_of
from clerestory.weather.columns import DEW_POINT, DIFFUSE, DIRECT
from clerestory.weather.weather import Weather

Array = npt.NDArray[np.float64]


class Light(NamedTuple):
    """Illuminances and what the sky looks like, time by time."""

    conditions: Conditions
    sun_direction: Array
    diffuse_horizontal_lx: Array
    direct_normal_lx: Array

    def at(self, rows: Any) -> Light:
        """The same of some of the times."""
        return Light(
            Conditions(*(values[rows] for values in self.conditions)),
            self.sun_direction[rows],
            self.diffuse_horizontal_lx[rows],
            self.direct_normal_lx[rows],
        )


def light_of(weather: Weather) -> Light:
    """What Perez' models make of weather; a sun below the horizon gives no light itself."""
    frame = weather.frame
    altitude, azimuth = weather.sun.apparent_altitude_deg.values, weather.sun.azimuth_deg.values
    direct, diffuse = (frame[column].to_numpy(dtype=np.float64) for column in (DIRECT, DIFFUSE))
    dew_point = frame[DEW_POINT].to_numpy(dtype=np.float64) if DEW_POINT in frame else DEW_POINT_C
    conditions = sky_conditions(
        direct_normal_irradiance_w_m2=direct,
        diffuse_horizontal_irradiance_w_m2=diffuse,
        sun_altitude_deg=altitude,
        extraterrestrial_irradiance_w_m2=SOLAR_CONSTANT_W_M2 / weather.sun_distance_au**2,
    )
    sun_lx = direct * direct_efficacy_lm_w(conditions, dew_point_c=dew_point)
    return Light(
        conditions,
        direction_of(np.maximum(altitude, 0.0), azimuth),
        diffuse * diffuse_efficacy_lm_w(conditions, dew_point_c=dew_point),
        np.where(altitude > 0.0, sun_lx, 0.0),
    )


def time_coordinates(weather: Weather) -> dict[str, Any]:
    """Coordinates of the dimension "time": UTC without a zone, and the wall clock."""
    return {name: weather.sun[name] for name in ("time", "local_time")}


def sun_normal_illuminance_lx(weather: Weather) -> xr.DataArray:
    """Illuminance of the sun on a plane facing it.

    Returns
    -------
    DataArray, dims ("time",) [lx]
        Direct normal irradiance times Perez' luminous efficacy (theory/perez.md, eq. 4); 0 while the sun is below the
        horizon in the middle of the interval. Attribute `left_out_wh_m2` says what direct irradiation that leaves out.
    """
    light = light_of(weather)
    below = weather.sun.apparent_altitude_deg.values <= 0.0
    left_out = float(weather.frame[DIRECT].to_numpy()[below].sum() * weather.interval_minutes / 60.0)
    about = {"units": "lx", "long_name": "direct normal illuminance", "left_out_wh_m2": left_out}
    return xr.DataArray(light.direct_normal_lx, dims="time", coords=time_coordinates(weather), attrs=about)


def diffuse_horizontal_illuminance_lx(weather: Weather) -> xr.DataArray:
    """Illuminance of the sky on an unobstructed horizontal plane.

    Returns
    -------
    DataArray, dims ("time",) [lx]
        Diffuse horizontal irradiance times Perez' luminous efficacy (theory/perez.md, eq. 3).
    """
    about = {"units": "lx", "long_name": "diffuse horizontal illuminance"}
    light = light_of(weather)
    return xr.DataArray(light.diffuse_horizontal_lx, dims="time", coords=time_coordinates(weather), attrs=about)


def sky_matrix(
    weather: Weather, basis: str = "reinhart577", *, ground_reflectance: float = 0.2, sampling: str = "mean"
) -> xr.DataArray:
    r"""Luminance of each patch of the sky at each time, the sun left out.

    Parameters
    ----------
    weather : Weather
    basis : str, default "reinhart577"
        Name of a sky basis.
    ground_reflectance : float, 0..1, default 0.2
        Of the unobstructed ground, lit by sky and sun alike (theory/sky.md, eq. 8).
    sampling : "mean" or "centre", default "mean"
        The mean over each patch, or the luminance of its centre, as Radiance's `gendaymtx` takes it.

    Returns
    -------
    DataArray, dims ("patch", "time") [cd/m²], float32
        The ground is the last patch. 0 where there is no diffuse light.

    Raises
    ------
    ClerestoryError
        If the basis is unknown or the reflectance out of range.

    Notes
    -----
    Perez' all-weather luminance, scaled so that the patches light an unobstructed horizontal plane with the diffuse
    illuminance (theory/perez.md, eqs. 5-10). R. Perez, R. Seals, J. Michalsky, Solar Energy 50(3), 1993.
    """
    within("ground_reflectance", ground_reflectance, 0.0, 1.0)
    one_of("sampling", sampling, ("mean", "centre"))
    values = patch_luminances(light_of(weather), basis, ground_reflectance=ground_reflectance, sampling=sampling)
    return xr.DataArray(
        values.T,
        dims=("patch", "time"),
        coords={**patch_coordinates(basis), **time_coordinates(weather)},
        name="luminance",
        attrs={
            "units": "cd m-2",
            "long_name": "luminance of the patch, all-weather sky (Perez 1993)",
            "basis": basis,
            "sampling": sampling,
            "ground_reflectance": float(ground_reflectance),
            "source": weather.source,
        },
    )


def patch_luminances(
    light: Light, basis: str, *, ground_reflectance: float, sampling: str = "mean"
) -> npt.NDArray[np.float32]:
    """Luminance of each patch, the ground last, shape (time, patch) [cd/m²]."""
    patches = sky_basis(basis)
    order = 0 if sampling == "centre" else quadrature_order(basis)
    values = patches.all_weather(
        luminance_parameters(light.conditions), light.sun_direction, light.diffuse_horizontal_lx, order
    )
    sun_lx = light.direct_normal_lx * light.sun_direction[:, 2]
    values[:, -1] = ground_reflectance * (light.diffuse_horizontal_lx + sun_lx) / np.pi
    return values
