"""Matrices as Radiance's programs read and write them."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from clerestory.coefficients import PARTS
from clerestory.errors import ClerestoryError
from clerestory.rules import one_of
from clerestory.saving import write_whole
from clerestory.sky.basis import sky_basis

Array = npt.NDArray[np.float64]

FORMATS = {"float": "<f4", "double": "<f8"}
"""Binary formats and how their numbers are laid down."""


def write_matrix(values: Any, path: str | os.PathLike[str], *, form: str = "float", note: str = "") -> Path:
    """Writes a matrix with a header that `dctimestep`, `rmtxop` and `rcollate` understand.

    Parameters
    ----------
    values : array_like, shape (rows, columns) or (rows, columns, components)
        Without components, each number stands for red, green and blue alike.
    path : path-like
    form : "float", "double" or "ascii", default "float"
    note : str, optional
        A line of the header that says what it is.

    Raises
    ------
    ClerestoryError
        If the values are no matrix, the form is unknown, or the file cannot be written.
    """
    one_of("form", form, (*FORMATS, "ascii"))
    matrix = np.asarray(values, dtype=np.float64)
    if matrix.ndim == 2:
        matrix = np.repeat(matrix[:, :, None], 3, axis=2)
    if matrix.ndim != 3 or matrix.size == 0 or not np.isfinite(matrix).all():
        raise ClerestoryError(f"values must be a finite matrix of rows and columns, got shape {np.shape(values)}")
    rows, columns, components = matrix.shape
    lines = ["#?RADIANCE", "SOFTWARE= Clerestory", *([f"NOTE= {' '.join(note.split())}"] if note else [])]
    lines += [f"NROWS={rows}", f"NCOLS={columns}", f"NCOMP={components}"]
    lines += [] if form == "ascii" else ["BigEndian=0"]
    header = "\n".join([*lines, f"FORMAT={form}", "", ""]).encode("ascii", "replace")
    if form == "ascii":
        text = "\n".join("\t".join(" ".join(f"{c:.7e}" for c in cell) for cell in row) for row in matrix.tolist())
        content = header + text.encode() + b"\n"
    else:
        content = header + matrix.astype(FORMATS[form]).tobytes()
    return write_whole(path, lambda draft: draft.write_bytes(content))


def read_matrix(path: str | os.PathLike[str]) -> Array:
    """A matrix that Radiance wrote, shape (rows, columns, components).

    Raises
    ------
    ClerestoryError
        If the file cannot be read, its header lacks NROWS, NCOLS, NCOMP or FORMAT, or it holds more or fewer numbers.
    """
    file = Path(path)
    try:
        content = file.read_bytes()
    except OSError as cause:
        raise ClerestoryError(f"{file} must be a readable file: {cause.strerror}") from None
    return matrix_of(content, file.name)


def matrix_of(content: bytes, name: str = "the matrix") -> Array:
    """A matrix from the bytes of such a file."""
    head, separator, body = content.partition(b"\n\n")
    if not content.startswith(b"#?") or not separator:
        raise ClerestoryError(
            f"{name} must begin with #?RADIANCE and an empty line after its header, got no such header"
        )
    fields = dict(line.split("=", 1) for line in head.decode("latin-1").splitlines() if "=" in line)
    try:
        shape = tuple(int(fields[key]) for key in ("NROWS", "NCOLS", "NCOMP"))
        form = fields["FORMAT"].strip()
    except (KeyError, ValueError) as cause:
        raise ClerestoryError(
            f"{name} must give NROWS, NCOLS, NCOMP and FORMAT in its header, got no {cause}"
        ) from None
    if form == "ascii":
        try:
            numbers = np.array(body.split(), dtype=np.float64)
        except ValueError as cause:
            raise ClerestoryError(f"{name} must hold numbers, got: {cause}") from None
    elif form in FORMATS:
        kind = np.dtype(FORMATS[form])
        if fields.get("BigEndian", "0").strip() == "1":
            kind = kind.newbyteorder(">")
        numbers = np.frombuffer(body[: len(body) // kind.itemsize * kind.itemsize], dtype=kind).astype(np.float64)
    else:
        raise ClerestoryError(f"FORMAT of {name} must be ascii, float or double, got {form!r}; convert it with rmtxop")
    if numbers.size != np.prod(shape):
        raise ClerestoryError(f"{name} must hold {' × '.join(map(str, shape))} numbers, got {numbers.size}")
    return numbers.reshape(shape)


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
