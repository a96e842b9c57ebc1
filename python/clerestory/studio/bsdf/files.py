"""A BSDF as the bytes of a file that another program reads."""

from __future__ import annotations

import tempfile
import warnings
from pathlib import Path

from clerestory.bsdf import Bsdf, BsdfWarning
from clerestory.bsdf.writing import write_bsdf
from clerestory.errors import ClerestoryError

#: Endings: LBNL's XML (WINDOW, Radiance), NetCDF, a matrix for Radiance, EnergyPlus.
FORMATS = ("xml", "nc", "mtx", "epJSON", "idf")


def file_of(bsdf: Bsdf, ending: str, *, band: str = "visible", direction: str = "transmission_front") -> bytes:
    """The content of a file, as :func:`clerestory.bsdf.writing.write_bsdf` writes it."""
    with tempfile.TemporaryDirectory(prefix="clerestory-") as folder, warnings.catch_warnings():
        # what the file makes up is told by the page's own findings
        warnings.simplefilter("ignore", BsdfWarning)
        path = Path(folder) / f"bsdf.{ending}"
        try:
            return write_bsdf(bsdf, path, band=band, direction=direction).read_bytes()
        except ClerestoryError as error:
            raise ClerestoryError(str(error).replace(str(path), path.name)) from None
