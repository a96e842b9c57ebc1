"""What a file of results is, by what it holds."""

from __future__ import annotations

import xarray as xr

from clerestory.errors import ClerestoryError

#: Kind → what it is, in words.
KINDS = {
    "year": "a year of daylight",
    "coefficients": "daylight coefficients of a room",
    "illuminance": "illuminance in a room under its skies",
    "factor": "daylight factor in a room",
    "room": "daylight in a room",
    "sweep": "the cases of a sweep",
    "design": "the trials of a design",
    "panel": "the shares of a panel by direction",
}


def kind_of(found: xr.Dataset, name: str) -> str:
    """Which of the results of this project a Dataset is.

    Parameters
    ----------
    found : Dataset
        As the reader gives it; heads are enough.
    name : str
        Of the file, for the message.

    Raises
    ------
    ClerestoryError
        If it is none, which says what it seems to be.
    """
    dims, variables = {str(dim) for dim in found.dims}, {str(one) for one in found.variables}
    if "case" in dims and {"key", "status"} <= variables:
        return "sweep"
    if dims == {"row"}:
        return _of_table(variables, name)
    if {"sensor", "time"} <= dims and {"daylight_autonomy", "in_use"} <= variables:
        return "year"
    if {"sensor", "patch"} <= dims and {"direct", "redirected", "interreflected"} <= variables:
        return "coefficients"
    if {"sensor", "sky"} <= dims and {"total", "direct"} <= variables:
        return "illuminance"
    if "sensor" in dims and "daylight_factor_mean" in variables and "daylight_factor" in variables:
        return "room"
    if "elevation" in dims and {"transmittance", "reflectance"} & variables:
        return "panel"
    raise ClerestoryError(f"{name} {_else(dims, variables)}")


def _of_table(variables: set[str], name: str) -> str:
    if {"case", "key", "status"} <= variables:
        return "sweep"
    if {"trial", "on_front", "stage"} <= variables:
        return "design"
    if {"sensor", "x_m", "y_m", "total"} <= variables:
        return "factor"
    if "elevation_deg" in variables and {"transmittance", "reflectance"} & variables:
        return "panel"
    if {"metric", "variant", "value"} <= variables:
        raise ClerestoryError(f"{name} holds the figures of a year alone: open the year.nc beside it, which holds all")
    raise ClerestoryError(f"{name} {_else({'row'}, variables)}")


def _else(dims: set[str], variables: set[str]) -> str:
    if {"sensor", "time"} <= dims and "sun_offset_deg" in variables:
        return "is a piece that a year is put together from: open the year.nc of its study"
    if {"sensor", "sun"} <= dims:
        return "holds coefficients of the sun, of which the studio draws nothing by themselves"
    if any("incident" in one for one in dims | variables):
        return "seems to be a BSDF: open it in the BSDF view"
    shown = ", ".join(sorted(variables)[:6]) or "nothing"
    return (
        f"is no result that the studio knows (it holds {shown[:120]}): open what clerestory year, room, sweep, design "
        "or panel wrote"
    )
