"""Measured angular tables: any CSV with a column of angles and columns named as the quantities of a panel."""

from __future__ import annotations

import csv
import math
import os
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from clerestory.errors import ClerestoryError
from clerestory.rules import one_of

if TYPE_CHECKING:
    import xarray as xr

#: Columns that say where light comes from, with the names they may have.
ANGLES = {"elevation_deg": "elevation_deg", "theta_deg": "elevation_deg", "azimuth_deg": "azimuth_deg"}
QUANTITIES = (
    "transmittance",
    "reflectance",
    "absorptance",
    "transmittance_deflected",
    "transmittance_undeflected",
    "residual",
)


def read_measured(path: str | os.PathLike[str]) -> xr.Dataset:
    """A table of measured shares against incidence.

    Parameters
    ----------
    path : path
        CSV: ``#`` lines and empty lines are skipped; the first other line names the columns. One of them is
        ``elevation_deg`` (or ``theta_deg``), another may be ``azimuth_deg`` (0 if there is none), both between -90 and
        90 degrees; the others are named as the variables of :meth:`Panel.angular <clerestory.Panel.angular>`
        (``transmittance``, ``reflectance``, ``transmittance_deflected`` …), in shares of 1, each perhaps with its
        ``…_standard_error``. An empty field is a value that was not measured.

    Returns
    -------
    Dataset over ``point``
        ``elevation_deg``, ``azimuth_deg`` and the quantities of the file; ``source`` in the attributes is its path.

    Raises
    ------
    ClerestoryError
        If the file cannot be read, a column is unknown or missing, or a field is no number or out of range; the
        message begins with path and line.
    """
    import xarray as xr

    where = Path(path)
    try:
        text = where.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise ClerestoryError(f"{where} must be a readable file, got: {error.strerror}; check the path") from None
    except UnicodeDecodeError:
        raise ClerestoryError(f"{where} must be a CSV file in UTF-8, got other bytes; save it as CSV") from None
    lines = [(number, line) for number, line in enumerate(text.splitlines(), start=1) if line.strip()]
    rows = [(number, next(csv.reader([line]))) for number, line in lines if not line.lstrip().startswith("#")]
    if len(rows) < 2:
        raise ClerestoryError(f"{where} must hold a line of column names and a row of numbers, got {len(rows)} lines")
    (number, heading), *body = rows
    names = _columns(f"{where}, line {number}", heading)
    values = np.array([_row(f"{where}, line {number}", names, row) for number, row in body])
    columns = dict(zip(names, values.T, strict=True))
    columns.setdefault("azimuth_deg", np.zeros(len(body)))
    return xr.Dataset({name: ("point", column) for name, column in columns.items()}, attrs={"source": str(where)})


def _columns(place: str, heading: list[str]) -> list[str]:
    known = {**ANGLES, **{name: name for name in QUANTITIES}}
    known |= {f"{name}_standard_error": f"{name}_standard_error" for name in QUANTITIES}
    try:
        names = [known[one_of("column", name.strip(), known)] for name in heading]
    except ClerestoryError as error:
        raise ClerestoryError(f"{place}: {error}") from None
    if "elevation_deg" not in names:
        raise ClerestoryError(f"{place}: columns must include elevation_deg or theta_deg, got {', '.join(names)}")
    if not set(names) & set(QUANTITIES):
        raise ClerestoryError(f"{place}: columns must include a quantity such as transmittance, got {', '.join(names)}")
    if len(set(names)) < len(names):
        raise ClerestoryError(f"{place}: each column must be named once, got {', '.join(names)}; remove one")
    return names


def _row(place: str, names: list[str], fields: list[str]) -> NDArray[np.float64]:
    if len(fields) != len(names):
        raise ClerestoryError(f"{place}: a row must have {len(names)} fields, got {len(fields)}; correct the line")
    row = []
    for name, field in zip(names, fields, strict=True):
        is_angle = name in ANGLES
        if not field.strip() and not is_angle:
            row.append(math.nan)
            continue
        try:
            value = float(field)
        except ValueError:
            raise ClerestoryError(f"{place}: {name} must be a number, got {field.strip()!r}; correct it") from None
        if is_angle and not -90.0 < value < 90.0:
            raise ClerestoryError(f"{place}: {name} must be greater than -90 and less than 90, got {value:g}")
        # measurements scatter a little beyond 0 and 1
        if not is_angle and not -0.1 <= value <= 1.1:
            raise ClerestoryError(f"{place}: {name} must be a share of 1, got {value:g}; divide per cent by 100")
        row.append(value)
    return np.array(row, dtype=np.float64)
