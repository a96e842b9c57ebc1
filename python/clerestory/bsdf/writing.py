"""A BSDF to a file of any of the kinds that are written."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from clerestory.bsdf.completing import words
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.errors import ClerestoryError

if TYPE_CHECKING:
    from clerestory.bsdf.bsdf import Bsdf


def write_bsdf(
    bsdf: Bsdf, path: str | os.PathLike[str], *, band: str = "visible", direction: str = "transmission_front"
) -> Path:
    """Writes a BSDF in the format that the file's ending names, whole or not at all.

    Parameters
    ----------
    bsdf : Bsdf
    path : path
        ``.xml``: LBNL's; ``.nc``: all that is known; ``.mtx``: one matrix for Radiance; ``.epJSON``, ``.idf``:
        EnergyPlus.
    band, direction : str
        Of the matrix in a ``.mtx``.

    Returns
    -------
    Path
        Of the file.

    Raises
    ------
    ClerestoryError
        If the ending is another, or the format has no place for the BSDF.
    """
    ending = Path(path).suffix.lower()
    if ending == ".xml":
        return bsdf.to_xml(path)
    if ending == ".nc":
        from clerestory.saving import save

        return save(bsdf.to_dataset(), path)
    if ending == ".mtx":
        from clerestory.bsdf.radiance_matrix import write_radiance_matrix

        block = getattr(getattr(bsdf, band), direction, None)
        if not isinstance(block, KlemsBlock):
            kind = "a tree" if block is not None else "nothing"
            raise ClerestoryError(
                f"{words(direction)}, {band}, must be a Klems matrix for .mtx, got {kind}; give a basis"
            )
        return write_radiance_matrix(block, path)
    if ending in (".epjson", ".json", ".idf"):
        from clerestory.bsdf.energyplus import energyplus_objects
        from clerestory.bsdf.energyplus_file import write_energyplus

        return write_energyplus(energyplus_objects(bsdf), path)
    raise ClerestoryError(f"path must end in .xml, .nc, .mtx, .epJSON or .idf, got {str(path)!r}; choose one")
