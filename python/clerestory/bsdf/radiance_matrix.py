"""Klems matrices as Radiance's matrix files, which ``rmtxop`` and ``dctimestep`` read and write."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Literal

import numpy as np

from clerestory._native import __version__
from clerestory.bsdf.klems import KLEMS_BASES, Floats, KlemsBasis, klems_basis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.errors import ClerestoryError
from clerestory.rules import one_of
from clerestory.saving import write_whole

Weighting = Literal["incident", "none"]
Encoding = Literal["ascii", "float", "double"]

_KINDS = {"float": "f4", "double": "f8"}
#: Radiance's weights of red, green and blue in luminance (color.h).
_LUMINANCE = np.array([0.265, 0.670, 0.065])
#: Longest header that is read, and most values.
_LONGEST, _MOST = 65_536, 50_000_000


def write_radiance_matrix(
    block: KlemsBlock,
    path: str | os.PathLike[str],
    *,
    weighting: Weighting = "incident",
    encoding: Encoding = "ascii",
) -> Path:
    """Writes a Klems matrix as a Radiance matrix file, whole or not at all.

    Parameters
    ----------
    block : KlemsBlock
        ``transmission_front`` for a three-phase calculation: a matrix has no side, and Radiance counts its patches as
        we do.
    path : path
    weighting : {"incident", "none"}, default "incident"
        ``"incident"``: each column times the projected solid angle of its patch, as ``rmtxop`` and ``dctimestep`` make
        of an XML file, so that radiance in gives radiance out. ``"none"``: values in 1/sr.
    encoding : {"ascii", "float", "double"}, default "ascii"

    Returns
    -------
    Path
        Of the file: a row for each outgoing and a column for each incident patch, one component.

    Raises
    ------
    ClerestoryError
        If a word is unknown, or the file cannot be written.
    """
    one_of("weighting", weighting, ("incident", "none"))
    one_of("encoding", encoding, ("ascii", *_KINDS))
    values = block.values * (block.incident.projected_solid_angle if weighting == "incident" else 1.0)
    rows, columns = values.shape
    head = ["#?RADIANCE", f"SOFTWARE=Clerestory {__version__}", f"NROWS={rows}", f"NCOLS={columns}", "NCOMP=1"]
    if encoding != "ascii":
        head.append(f"BigEndian={int(sys.byteorder == 'big')}")
    text = "\n".join([*head, f"FORMAT={encoding}", "", ""]).encode()
    if encoding == "ascii":
        body = "".join("\t".join(f"{value:.9g}" for value in row) + "\n" for row in values.tolist()).encode()
    else:
        body = values.astype(_KINDS[encoding]).tobytes()
    return write_whole(path, lambda draft: draft.write_bytes(text + body))


def read_radiance_matrix(
    path: str | os.PathLike[str],
    *,
    incident_basis: str | KlemsBasis | None = None,
    outgoing_basis: str | KlemsBasis | None = None,
    weighting: Weighting = "incident",
) -> KlemsBlock:
    """A Klems matrix from a Radiance matrix file.

    Parameters
    ----------
    path : path
        With a header that says NROWS, NCOLS and FORMAT (ascii, float or double). Three components are weighed as
        luminance.
    incident_basis, outgoing_basis : str or KlemsBasis, optional
        Of columns and rows; by default the one of Klems's bases that has as many patches.
    weighting : {"incident", "none"}, default "incident"
        What the columns are multiplied by, as in :func:`write_radiance_matrix`.

    Raises
    ------
    ClerestoryError
        If the file is no such matrix, or no basis has as many patches.
    """
    one_of("weighting", weighting, ("incident", "none"))
    where = Path(path)
    try:
        content = where.read_bytes()
    except OSError as error:
        raise ClerestoryError(f"{where} must be a file to read, got: {error.strerror or error}") from None
    head, body = _head(where, content)
    rows, columns, parts = (_count(where, head, name) for name in ("NROWS", "NCOLS", "NCOMP"))
    if rows * columns * parts > _MOST:
        raise ClerestoryError(f"{where} must hold no more than {_MOST} values, got {rows} × {columns} × {parts}")
    values = _values(where, head, body, rows * columns * parts).reshape(rows, columns, parts)
    if parts not in (1, 3):
        raise ClerestoryError(f"NCOMP of {where} must be 1 or 3, got {parts}")
    matrix: Floats = values[..., 0] if parts == 1 else np.asarray(values @ _LUMINANCE)
    into, out = _basis(where, incident_basis, columns), _basis(where, outgoing_basis, rows)
    if weighting == "incident":
        matrix = matrix / into.projected_solid_angle
    try:
        return KlemsBlock(matrix, into, out)
    except ClerestoryError as cause:
        raise ClerestoryError(f"{where}: {cause}") from None


def _head(where: Path, content: bytes) -> tuple[dict[str, str], bytes]:
    end = content.find(b"\n\n", 0, _LONGEST)
    if not content.startswith(b"#?") or end < 0:
        raise ClerestoryError(
            f"{where} must begin with Radiance's header (#?RADIANCE … FORMAT=…, then an empty line); "
            "getinfo -r or rmtxop -fa writes one"
        )
    lines = content[:end].decode("latin-1").splitlines()
    return dict(line.split("=", 1) for line in lines if "=" in line), content[end + 2 :]


def _count(where: Path, head: dict[str, str], name: str) -> int:
    text = head.get(name, "1" if name == "NCOMP" else "").strip()
    if not text.isdecimal() or not 0 < int(text) < 10**9:
        raise ClerestoryError(f"{name} of {where} must be a whole number above 0, got {text[:40]!r}")
    return int(text)


def _values(where: Path, head: dict[str, str], body: bytes, count: int) -> Floats:
    encoding = head.get("FORMAT", "").strip()
    if encoding == "ascii":
        try:
            found = np.array(body.split(), dtype=np.float64)
        except ValueError:
            raise ClerestoryError(f"{where} must hold numbers after its header") from None
    elif encoding in _KINDS:
        order = ">" if head.get("BigEndian", "0").strip() == "1" else "<"
        kind = np.dtype(order + _KINDS[encoding])
        found = np.frombuffer(body[: len(body) // kind.itemsize * kind.itemsize], dtype=kind).astype(np.float64)
    else:
        raise ClerestoryError(
            f"FORMAT of {where} must be ascii, float or double, got {encoding!r}; rmtxop -fa turns it"
        )
    if len(found) != count:
        raise ClerestoryError(f"{where} must hold {count} values as its header says, got {len(found)}")
    return found


def _basis(where: Path, given: str | KlemsBasis | None, count: int) -> KlemsBasis:
    if given is None:
        fitting = next((name for name in KLEMS_BASES if len(klems_basis(name)) == count), None)
        if fitting is None:
            raise ClerestoryError(f"{where} must have as many patches as a Klems basis, got {count}; name the basis")
        return klems_basis(fitting)
    basis = klems_basis(given)
    if len(basis) != count:
        raise ClerestoryError(f"{where} must have the {len(basis)} patches of {basis.name}, got {count}")
    return basis
