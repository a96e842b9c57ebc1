"""Klems matrices as Radiance's matrix files, which ``rmtxop`` and ``dctimestep`` read and write."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Literal

import numpy as np

from clerestory.bsdf.klems import KLEMS_BASES, Floats, KlemsBasis, klems_basis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.errors import ClerestoryError
from clerestory.exchange.radiance_matrix import LUMINANCE, read_matrix, write_matrix
from clerestory.rules import one_of

Weighting = Literal["incident", "none"]
Encoding = Literal["ascii", "float", "double"]


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
    one_of("encoding", encoding, ("ascii", "float", "double"))
    values = block.values * (block.incident.projected_solid_angle if weighting == "incident" else 1.0)
    return write_matrix(values[:, :, None], path, form=encoding)


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
    where, values = Path(path), read_matrix(path)
    rows, columns, parts = values.shape
    if parts not in (1, 3):
        raise ClerestoryError(f"NCOMP of {where} must be 1 or 3, got {parts}")
    matrix: Floats = values[..., 0] if parts == 1 else np.asarray(values @ LUMINANCE)
    into, out = _basis(where, incident_basis, columns), _basis(where, outgoing_basis, rows)
    if weighting == "incident":
        matrix = matrix / into.projected_solid_angle
    try:
        return KlemsBlock(matrix, into, out)
    except ClerestoryError as cause:
        raise ClerestoryError(f"{where}: {cause}") from None


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
