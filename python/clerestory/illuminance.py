"""From coefficients and skies to illuminance."""

from __future__ import annotations

import numpy as np
import xarray as xr

from clerestory.coefficients import PARTS
from clerestory.errors import ClerestoryError
from clerestory.rules import not_negative
from clerestory.sky.cie_sky import CieSky
from clerestory.sky.perez_sky import PerezSky


def illuminance(coefficients: xr.Dataset, sky: CieSky | PerezSky | xr.DataArray) -> xr.Dataset:
    r"""Illuminance at each sensor under a sky, part by part.

    Parameters
    ----------
    coefficients : Dataset of `daylight_coefficients`
    sky : CieSky, PerezSky, or DataArray with dims ("patch", …) [cd/m²]
        Mean luminance of each patch, the ground last; further dimensions such as "time" are kept.

    Returns
    -------
    Dataset, dims ("sensor", …) [lx]
        `total`, `direct`, `redirected`, `interreflected`, and `total_standard_error`. Under the sky that the errors of
        the coefficients were judged under it is the standard error itself; under any other it is an upper bound, as if
        the errors of all patches went the same way: its attribute `kind` says which.

    Raises
    ------
    ClerestoryError
        If the sky has other patches than the coefficients.

    Notes
    -----
    :math:`E_s = \sum_p C_{sp} L_p` (theory/illuminance.md, eq. 1).
    """
    luminance = sky_matrix(coefficients, sky)
    found = {part: coefficients[part] @ luminance for part in PARTS}
    total = sum(found[part] for part in PARTS)
    error, kind = _standard_error(coefficients, luminance)
    result = xr.Dataset({"total": total, **found, "total_standard_error": error})
    for name in result.data_vars:
        result[name].attrs = {"units": "lx", "long_name": f"illuminance, {str(name).replace('_', ' ')}"}
    result["total_standard_error"].attrs["kind"] = kind
    result.attrs = {**coefficients.attrs, "sky": str(luminance.attrs.get("long_name", "luminances given"))}
    return result


def sky_matrix(coefficients: xr.Dataset, sky: CieSky | PerezSky | xr.DataArray) -> xr.DataArray:
    """The luminances of a sky, patch by patch as in the coefficients, with the room's own ground."""
    if isinstance(sky, (CieSky, PerezSky)):
        return sky.matrix(
            coefficients.attrs["basis"], ground_reflectance=float(coefficients.attrs["ground_reflectance"])
        )
    if "patch" not in sky.dims or sky.sizes["patch"] != coefficients.sizes["patch"]:
        raise ClerestoryError(
            f"sky must have the {coefficients.sizes['patch']} patches of the coefficients (ground last), "
            f"got dims {dict(sky.sizes)}"
        )
    return sky


def daylight_factor(coefficients: xr.Dataset, sky: CieSky | None = None) -> xr.Dataset:
    r"""Illuminance at each sensor as a percentage of that of an unobstructed horizontal plane.

    Parameters
    ----------
    coefficients : Dataset of `daylight_coefficients`
    sky : CieSky, default the traditional overcast sky
        Without its sun, whose light is no part of a daylight factor.

    Returns
    -------
    Dataset, dims ("sensor",) [percent]
        As `illuminance`, parts and standard error included.

    Notes
    -----
    :math:`D = 100 E / E_h` (theory/illuminance.md, eq. 4); the parts are the sky and externally reflected
    components (`direct` and `redirected`) and the internally reflected one.
    """
    under = sky or CieSky(sky_type=16, zenith_luminance_cd_m2=1.0)
    if under.direct_normal_illuminance_lx > 0.0:
        raise ClerestoryError(
            "sky of a daylight factor must have no sun, got "
            f"direct_normal_illuminance_lx {under.direct_normal_illuminance_lx:g}"
        )
    result: xr.Dataset = illuminance(coefficients, under) * (100.0 / under.diffuse_horizontal_lx)
    kind = illuminance(coefficients, under).total_standard_error.attrs["kind"]
    for name in result.data_vars:
        result[name].attrs = {"units": "percent", "long_name": f"daylight factor, {str(name).replace('_', ' ')}"}
    result["total_standard_error"].attrs["kind"] = kind
    result.attrs = {**coefficients.attrs, "sky": under.description}
    return result


def sun_illuminance(coefficients: xr.Dataset, normal_illuminance_lx: float | xr.DataArray) -> xr.Dataset:
    """Illuminance at each sensor from the sun itself, part by part.

    Parameters
    ----------
    coefficients : Dataset of `sun_coefficients`
    normal_illuminance_lx : float or DataArray with dims ("sun",) [lx]
        On a plane facing the sun.

    Returns
    -------
    Dataset, dims ("sensor", "sun") [lx]
        `total`, `direct`, `redirected`, `interreflected`, and `total_standard_error`.
    """
    if not isinstance(normal_illuminance_lx, xr.DataArray):
        not_negative("normal_illuminance_lx", normal_illuminance_lx)
    result = xr.Dataset({part: coefficients[part] * normal_illuminance_lx for part in PARTS})
    result["total"] = sum(result[part] for part in PARTS)
    squares = sum(coefficients[f"{part}_standard_error"] ** 2 for part in PARTS)
    result["total_standard_error"] = np.sqrt(squares) * normal_illuminance_lx
    for name in result.data_vars:
        result[name].attrs = {"units": "lx", "long_name": f"illuminance from the sun, {str(name).replace('_', ' ')}"}
    result.attrs = dict(coefficients.attrs)
    return result


def uniformity(values: xr.DataArray) -> xr.DataArray:
    """Least over mean of the sensors (theory/illuminance.md, eq. 5).

    Parameters
    ----------
    values : DataArray, dims ("sensor", …)

    Returns
    -------
    DataArray without "sensor", 0..1
        NaN where the mean is 0.
    """
    mean = values.mean("sensor")
    ratio: xr.DataArray = values.min("sensor") / mean.where(mean > 0.0)
    ratio.attrs = {"units": "1", "long_name": "uniformity, least over mean"}
    return ratio


def average_by_group(values: xr.DataArray) -> xr.DataArray:
    """Mean over the sensors of each grid: with a grid on each surface, the averages of the surfaces.

    Parameters
    ----------
    values : DataArray, dims ("sensor", …)

    Returns
    -------
    DataArray, dims ("group", …)
    """
    averages: xr.DataArray = values.groupby("group").mean("sensor")
    averages.attrs = dict(values.attrs)
    return averages


def _standard_error(coefficients: xr.Dataset, luminance: xr.DataArray) -> tuple[xr.DataArray, str]:
    judged = coefficients["sky_luminance"]
    if luminance.dims == ("patch",):
        values, shape = luminance.values, judged.values
        scale = float(values @ shape / (shape @ shape))
        if np.allclose(values, scale * shape, rtol=1e-9, atol=0.0):
            return coefficients["sky_illuminance_standard_error"] * scale, "standard error"
    errors = xr.concat([coefficients[f"{part}_standard_error"] for part in PARTS], dim="part").sum("part")
    return errors @ abs(luminance), "upper bound"
