"""Daylight coefficients as a matrix of Radiance's."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import xarray as xr

from clerestory.coefficients import PARTS
from clerestory.errors import ClerestoryError
from clerestory.exchange.radiance_matrix import write_matrix
from clerestory.rules import one_of
from clerestory.sky.basis import sky_basis


def write_coefficients(
    coefficients: xr.Dataset, path: str | os.PathLike[str], *, part: str = "total", form: str = "float"
) -> Path:
    r"""Writes daylight coefficients for `dctimestep`, patches in the order of `gendaymtx` and `rfluxmtx`.

    Parameters
    ----------
    coefficients : Dataset of `daylight_coefficients`
    path : path-like
        A matrix of sensors by patches [sr], the ground first, then rings from the horizon up, clockwise from north.
    part : "total", "direct", "redirected" or "interreflected", default "total"
    form : "float", "double" or "ascii", default "float"

    Raises
    ------
    ClerestoryError
        If the basis of the coefficients is none of Radiance's, or the file cannot be written.

    Notes
    -----
    ``dctimestep coefficients.mtx sky.smx`` gives irradiance; times 179 lm/W with the weights 0.265, 0.670, 0.065 of
    red, green and blue it is the illuminance that ``coefficients @ sky`` gives here.
    """
    one_of("part", part, ("total", *PARTS))
    basis = str(coefficients.attrs.get("basis", ""))
    if not basis.startswith(("tregenza", "reinhart")):
        raise ClerestoryError(
            f"coefficients must be over tregenza145 or a reinhart basis for Radiance to read them, got {basis!r}"
        )
    values = sum(coefficients[one].values for one in PARTS) if part == "total" else coefficients[part].values
    order = np.asarray(sky_basis(basis).order("radiance"))
    note = f"{part} daylight coefficients [sr], sensors by patches of {basis}, ground first"
    return write_matrix(np.asarray(values)[:, order], path, form=form, note=note)
