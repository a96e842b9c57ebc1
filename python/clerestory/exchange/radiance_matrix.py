"""Matrices as Radiance's programs read and write them."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from clerestory._native import __version__
from clerestory.errors import ClerestoryError
from clerestory.rules import one_of
from clerestory.saving import write_whole

Array = npt.NDArray[np.float64]

FORMATS = {"float": "<f4", "double": "<f8"}
"""Binary formats and how their numbers are laid down."""

LUMINANCE = np.array([0.265, 0.670, 0.065])
"""Radiance's weights of red, green and blue in luminance (color.h)."""

#: Longest header that is read, and most numbers.
_LONGEST, _MOST = 65_536, 100_000_000


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
    lines = [
        "#?RADIANCE",
        f"SOFTWARE= Clerestory {__version__}",
        *([f"NOTE= {' '.join(note.split())}"] if note else []),
    ]
    lines += [f"NROWS={rows}", f"NCOLS={columns}", f"NCOMP={components}"]
    lines += [] if form == "ascii" else ["BigEndian=0"]
    content = "\n".join([*lines, f"FORMAT={form}", "", ""]).encode("ascii", "replace")
    if form == "ascii":
        text = "\n".join("\t".join(" ".join(f"{c:.9g}" for c in cell) for cell in row) for row in matrix.tolist())
        content += text.encode() + b"\n"
    else:
        content += matrix.astype(FORMATS[form]).tobytes()
    return write_whole(path, lambda draft: draft.write_bytes(content))


def read_matrix(path: str | os.PathLike[str]) -> Array:
    """A matrix that Radiance wrote, shape (rows, columns, components).

    Raises
    ------
    ClerestoryError
        If the file cannot be read, its header lacks NROWS, NCOLS or FORMAT, or it holds more or fewer numbers.
    """
    file = Path(path)
    try:
        content = file.read_bytes()
    except OSError as cause:
        raise ClerestoryError(f"{file} must be a readable file: {cause.strerror or cause}") from None
    return matrix_of(content, file.name)


def matrix_of(content: bytes, name: str = "the matrix") -> Array:
    """A matrix from the bytes of such a file."""
    end = content.find(b"\n\n", 0, _LONGEST)
    if not content.startswith(b"#?") or end < 0:
        raise ClerestoryError(
            f"{name} must begin with Radiance's header (#?RADIANCE … FORMAT=…, then an empty line), got no such "
            "header; getinfo -r or rmtxop -fa writes one"
        )
    head = dict(line.split("=", 1) for line in content[:end].decode("latin-1").splitlines() if "=" in line)
    shape = tuple(_count(name, head, key) for key in ("NROWS", "NCOLS", "NCOMP"))
    count = int(np.prod(shape, dtype=object))
    if count > _MOST:
        raise ClerestoryError(f"{name} must hold no more than {_MOST} numbers, got {' × '.join(map(str, shape))}")
    numbers = _numbers(name, head, content[end + 2 :])
    if numbers.size != count:
        raise ClerestoryError(f"{name} must hold {count} numbers as its header says, got {numbers.size}")
    return numbers.reshape(shape)


def _count(name: str, head: dict[str, str], key: str) -> int:
    text = head.get(key, "1" if key == "NCOMP" else "").strip()
    if not text.isdecimal() or not 0 < int(text) < 10**9:
        raise ClerestoryError(f"{key} of {name} must be a whole number above 0, got {text[:40]!r}")
    return int(text)


def _numbers(name: str, head: dict[str, str], body: bytes) -> Array:
    form = head.get("FORMAT", "").strip()
    if form == "ascii":
        try:
            return np.array(body.split(), dtype=np.float64)
        except ValueError:
            raise ClerestoryError(f"{name} must hold numbers after its header") from None
    if form in FORMATS:
        kind = np.dtype(FORMATS[form])
        if head.get("BigEndian", "0").strip() == "1":
            kind = kind.newbyteorder(">")
        return np.frombuffer(body[: len(body) // kind.itemsize * kind.itemsize], dtype=kind).astype(np.float64)
    raise ClerestoryError(f"FORMAT of {name} must be ascii, float or double, got {form!r}; rmtxop -fa turns it")
