"""A BSDF from a file, whichever kind it is."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from clerestory.bsdf.bsdf import Bsdf


def read_bsdf(path: str | os.PathLike[str], *, strict: bool = True) -> Bsdf:
    """A window element from LBNL's XML, as WINDOW, genBSDF and others write it, or from our own NetCDF.

    Parameters
    ----------
    path : path
        ``.nc`` is NetCDF that :func:`clerestory.save` wrote of a BSDF, with the exact element beside its tables. All
        else is XML: text before it is skipped; matrices of any rings, by rows or columns, and tensor trees of rank 3
        and 4.
    strict : bool, default True
        Refuse negative values and blocks that send away more than 1.01 of the power. False keeps them for
        :meth:`Bsdf.check` to tell of.

    Returns
    -------
    Bsdf
        With the four blocks of each band that the file holds (visible, solar, CIE X and Z). A direction that is missing
        is filled by reciprocity or with zero, and told as a :class:`~clerestory.BsdfWarning`. ``attrs`` hold the
        file's name and digest, and the material's ``emissivity_front`` and others.

    Raises
    ------
    ClerestoryError
        If the file is no such file, or its numbers cannot be: with the path of the element.
    """
    if Path(path).suffix.lower() == ".nc":
        from clerestory.bsdf.own_file import read_netcdf

        return read_netcdf(path)
    from clerestory.bsdf.xml_read import read_xml

    return read_xml(path, strict=strict)
