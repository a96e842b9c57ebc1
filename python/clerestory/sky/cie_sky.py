"""A CIE sky in candelas."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.rules import not_negative, within
from clerestory.sky.basis import patch_coordinates
from clerestory.sky.cie import (
    GENERAL_SKIES,
    TRADITIONAL_OVERCAST,
    Array,
    check_sky_type,
    depends_on_sun,
    relative_luminance,
)
from clerestory.sky.horizontal import horizontal_over_zenith
from clerestory.sky.patches import patch_means
from clerestory.sun import direction_of


@dataclass(frozen=True, kw_only=True)
class CieSky:
    """One of the 15 CIE general skies or the traditional overcast sky, in candelas.

    Parameters
    ----------
    sky_type : int, 1..16
        1..15 as in ISO 15469 (1 overcast, 5 uniform, 12 clear); 16 the traditional overcast sky (1 + 2 sin γ) / 3.
    sun_altitude_deg : float, 0..90, optional
        Needed by the skies that are brighter towards the sun.
    sun_azimuth_deg : float, default 180
        Clockwise from north.
    zenith_luminance_cd_m2 : float, optional
        Give this or the next.
    diffuse_horizontal_illuminance_lx : float, optional
        Unobstructed, without the sun.
    direct_normal_illuminance_lx : float, default 0
        Of the sun. It is no part of the sky's luminance, but lights the ground.

    Raises
    ------
    ClerestoryError
        If a value is out of range, the sun is missing, or not exactly one scale is given.
    """

    sky_type: int
    sun_altitude_deg: float | None = None
    sun_azimuth_deg: float = 180.0
    zenith_luminance_cd_m2: float | None = None
    diffuse_horizontal_illuminance_lx: float | None = None
    direct_normal_illuminance_lx: float = 0.0

    def __post_init__(self) -> None:
        check_sky_type(self.sky_type)
        within("sun_azimuth_deg", self.sun_azimuth_deg, -360.0, 360.0)
        not_negative("direct_normal_illuminance_lx", self.direct_normal_illuminance_lx)
        needs_sun = depends_on_sun(self.sky_type) or self.direct_normal_illuminance_lx > 0.0
        if self.sun_altitude_deg is not None:
            within("sun_altitude_deg", self.sun_altitude_deg, 0.0, 90.0)
        elif needs_sun:
            raise ClerestoryError(
                f"sun_altitude_deg must be given: sky_type {self.sky_type} with direct_normal_illuminance_lx "
                f"{self.direct_normal_illuminance_lx:g} depends on the sun, got None"
            )
        scales = {
            "zenith_luminance_cd_m2": self.zenith_luminance_cd_m2,
            "diffuse_horizontal_illuminance_lx": self.diffuse_horizontal_illuminance_lx,
        }
        given = {name: value for name, value in scales.items() if value is not None}
        if len(given) != 1:
            raise ClerestoryError(f"one of {' and '.join(scales)} must be given, got {len(given)} of them")
        for name, value in given.items():
            not_negative(name, value)

    @property
    def description(self) -> str:
        """The sky in the words of the standard."""
        if self.sky_type == TRADITIONAL_OVERCAST:
            return "traditional CIE overcast sky"
        return f"CIE sky {self.sky_type}: {GENERAL_SKIES[self.sky_type].description}"

    @property
    def sun_direction(self) -> Array | None:
        """Unit vector towards the sun, shape (3,), or None."""
        if self.sun_altitude_deg is None:
            return None
        return direction_of(self.sun_altitude_deg, self.sun_azimuth_deg)

    @property
    def zenith_cd_m2(self) -> float:
        """Luminance of the zenith [cd/m²]."""
        if self.zenith_luminance_cd_m2 is not None:
            return float(self.zenith_luminance_cd_m2)
        assert self.diffuse_horizontal_illuminance_lx is not None
        return float(self.diffuse_horizontal_illuminance_lx) / self._horizontal_over_zenith

    @property
    def diffuse_horizontal_lx(self) -> float:
        """Unobstructed horizontal illuminance from the sky alone [lx]."""
        if self.diffuse_horizontal_illuminance_lx is not None:
            return float(self.diffuse_horizontal_illuminance_lx)
        return self.zenith_cd_m2 * self._horizontal_over_zenith

    @property
    def direct_horizontal_lx(self) -> float:
        """Unobstructed horizontal illuminance from the sun alone [lx]."""
        if self.sun_altitude_deg is None:
            return 0.0
        return float(self.direct_normal_illuminance_lx * np.sin(np.radians(self.sun_altitude_deg)))

    @property
    def _horizontal_over_zenith(self) -> float:
        return float(horizontal_over_zenith(self.sky_type, self._sin_sun_altitude))

    @property
    def _sin_sun_altitude(self) -> float:
        return float(np.sin(np.radians(self.sun_altitude_deg or 0.0)))

    def luminance_cd_m2(self, directions: Any) -> Array:
        """Luminance towards points of the sky.

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
        sun = direction_of(self.sun_altitude_deg or 0.0, self.sun_azimuth_deg)
        shape = relative_luminance(self.sky_type, towards[..., 2], towards @ sun, self._sin_sun_altitude)
        return np.where(towards[..., 2] >= 0.0, self.zenith_cd_m2 * shape, 0.0)

    def luminances_cd_m2(self, basis: str = "reinhart577", *, ground_reflectance: float = 0.2) -> Array:
        """The values of `matrix` alone, shape (patch,) [cd/m²]."""
        within("ground_reflectance", ground_reflectance, 0.0, 1.0)
        sky = patch_means(self.luminance_cd_m2, basis=basis)
        ground = ground_reflectance * (self.diffuse_horizontal_lx + self.direct_horizontal_lx) / np.pi
        return np.append(sky, ground)

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
            The ground is the last patch. Attributes `diffuse_horizontal_illuminance_lx` and
            `direct_horizontal_illuminance_lx` say what stands in the open.

        Raises
        ------
        ClerestoryError
            If the basis is unknown or the reflectance out of range.
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
