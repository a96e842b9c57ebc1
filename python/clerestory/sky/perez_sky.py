"""The sky of one moment, as irradiances say it looks."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import xarray as xr

from clerestory.rules import not_negative, positive, within
from clerestory.sky.basis import patch_coordinates, sky_basis
from clerestory.sky.patches import patch_nodes
from clerestory.sky.perez import (
    DEW_POINT_C,
    SOLAR_CONSTANT_W_M2,
    Array,
    Conditions,
    diffuse_efficacy_lm_w,
    direct_efficacy_lm_w,
    luminance_parameters,
    relative_luminance,
    sky_conditions,
)
from clerestory.sun import direction_of

_NODE_RAD = np.radians(3.0)


@dataclass(frozen=True, kw_only=True)
class PerezSky:
    """Perez' all-weather sky of one moment, in candelas.

    Parameters
    ----------
    direct_normal_irradiance_w_m2, diffuse_horizontal_irradiance_w_m2 : float, at least 0
    sun_altitude_deg : float, -90..90
        Below the horizon the model takes the sun on it, and it gives no light itself.
    sun_azimuth_deg : float, default 180
        Clockwise from north.
    dew_point_c : float, -90..60, default 11
        For the luminous efficacies.
    extraterrestrial_irradiance_w_m2 : float, default 1367
        Normal to the sun outside the atmosphere.

    Raises
    ------
    ClerestoryError
        If a value is out of range.

    Notes
    -----
    theory/perez.md, eqs. 1-10. R. Perez, R. Seals, J. Michalsky, Solar Energy 50(3), 1993.
    """

    direct_normal_irradiance_w_m2: float
    diffuse_horizontal_irradiance_w_m2: float
    sun_altitude_deg: float
    sun_azimuth_deg: float = 180.0
    dew_point_c: float = DEW_POINT_C
    extraterrestrial_irradiance_w_m2: float = SOLAR_CONSTANT_W_M2

    def __post_init__(self) -> None:
        not_negative("direct_normal_irradiance_w_m2", self.direct_normal_irradiance_w_m2)
        not_negative("diffuse_horizontal_irradiance_w_m2", self.diffuse_horizontal_irradiance_w_m2)
        within("sun_altitude_deg", self.sun_altitude_deg, -90.0, 90.0)
        within("sun_azimuth_deg", self.sun_azimuth_deg, -360.0, 360.0)
        within("dew_point_c", self.dew_point_c, -90.0, 60.0)
        positive("extraterrestrial_irradiance_w_m2", self.extraterrestrial_irradiance_w_m2)

    @cached_property
    def conditions(self) -> Conditions:
        """Sky clearness, sky brightness and their bin, each an array of one."""
        return sky_conditions(
            direct_normal_irradiance_w_m2=[self.direct_normal_irradiance_w_m2],
            diffuse_horizontal_irradiance_w_m2=[self.diffuse_horizontal_irradiance_w_m2],
            sun_altitude_deg=[self.sun_altitude_deg],
            extraterrestrial_irradiance_w_m2=[self.extraterrestrial_irradiance_w_m2],
        )

    @property
    def description(self) -> str:
        """The sky in words."""
        clearness, brightness = self.conditions.clearness[0], self.conditions.brightness[0]
        return f"all-weather sky, clearness {clearness:.2f}, brightness {brightness:.2f}"

    @property
    def sun_direction(self) -> Array:
        """Unit vector towards the sun, on the horizon if it is below, shape (3,)."""
        return direction_of(max(self.sun_altitude_deg, 0.0), self.sun_azimuth_deg)

    @property
    def diffuse_horizontal_lx(self) -> float:
        """Unobstructed horizontal illuminance from the sky alone [lx]."""
        efficacy = diffuse_efficacy_lm_w(self.conditions, dew_point_c=self.dew_point_c)[0]
        return float(self.diffuse_horizontal_irradiance_w_m2 * efficacy)

    @property
    def direct_normal_illuminance_lx(self) -> float:
        """Illuminance of the sun on a plane facing it [lx]."""
        if self.sun_altitude_deg <= 0.0:
            return 0.0
        efficacy = direct_efficacy_lm_w(self.conditions, dew_point_c=self.dew_point_c)[0]
        return float(self.direct_normal_irradiance_w_m2 * efficacy)

    @property
    def direct_horizontal_lx(self) -> float:
        """Unobstructed horizontal illuminance from the sun alone [lx]."""
        return float(self.direct_normal_illuminance_lx * self.sun_direction[2])

    @cached_property
    def _parameters(self) -> Array:
        return np.asarray(luminance_parameters(self.conditions)[0])

    @cached_property
    def _scale(self) -> float:
        """Luminance over relative luminance [cd/m²]."""
        directions, weights, starts = patch_nodes("reinhart577", 6)
        relative = relative_luminance(self._parameters, directions[:, 2], directions @ self.sun_direction)
        shares = np.add.reduceat(relative * directions[:, 2] * weights, starts)
        return self.diffuse_horizontal_lx / float(shares @ np.asarray(sky_basis("reinhart577").solid_angles)[:-1])

    def luminance_cd_m2(self, directions: Any) -> Array:
        """Luminance towards points of the sky, without the sun's disc.

        Parameters
        ----------
        directions : array_like, shape (…, 3)
            Unit vectors from the observer, x east, y north, z up.

        Returns
        -------
        ndarray, shape (…) [cd/m²]
            Zero below the horizon.
        """
        towards = np.asarray(directions, dtype=np.float64)
        relative = relative_luminance(self._parameters, towards[..., 2], towards @ self.sun_direction)
        return np.where(towards[..., 2] >= 0.0, self._scale * relative, 0.0)

    def luminances_cd_m2(self, basis: str = "reinhart577", *, ground_reflectance: float = 0.2) -> Array:
        """The values of `matrix` alone, shape (patch,) [cd/m²]."""
        within("ground_reflectance", ground_reflectance, 0.0, 1.0)
        illuminance = np.array([self.diffuse_horizontal_lx])
        means = sky_basis(basis).all_weather(
            self._parameters[None], self.sun_direction[None], illuminance, quadrature_order(basis)
        )
        values = means[0].astype(np.float64)
        values[-1] = ground_reflectance * (self.diffuse_horizontal_lx + self.direct_horizontal_lx) / np.pi
        return np.asarray(values)

    def matrix(self, basis: str = "reinhart577", *, ground_reflectance: float = 0.2) -> xr.DataArray:
        r"""Mean luminance of each patch of the sky, and of the ground.

        Parameters
        ----------
        basis : str, default "reinhart577"
            Name of a sky basis.
        ground_reflectance : float, 0..1, default 0.2
            Of the unobstructed, evenly lit ground: :math:`L_g = \rho (E_{sky} + E_{sun}) / \pi` (theory/sky.md, eq. 8).

        Returns
        -------
        DataArray, dims ("patch",) [cd/m²]
            The ground is the last patch.
        """
        return xr.DataArray(
            self.luminances_cd_m2(basis, ground_reflectance=ground_reflectance),
            dims="patch",
            coords=patch_coordinates(basis),
            name="luminance",
            attrs={
                "units": "cd m-2",
                "long_name": f"mean luminance, {self.description}",
                "basis": basis,
                "ground_reflectance": float(ground_reflectance),
                "diffuse_horizontal_illuminance_lx": self.diffuse_horizontal_lx,
                "direct_horizontal_illuminance_lx": self.direct_horizontal_lx,
            },
        )


def quadrature_order(basis: str) -> int:
    """Points each way in a patch: one for each 3° of its height begun, at least two."""
    bounds = np.asarray(sky_basis(basis).bounds)[:-1]
    return max(2, int(np.ceil(float((bounds[:, 1] - bounds[:, 0]).max()) / float(_NODE_RAD) - 1e-9)))
