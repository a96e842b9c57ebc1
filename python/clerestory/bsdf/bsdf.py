"""What a window element does to light, as tables over directions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from clerestory.bsdf.band import Band
from clerestory.errors import ClerestoryError
from clerestory.glazing import Glazing, check_glazing
from clerestory.rules import positive

if TYPE_CHECKING:
    import os
    from pathlib import Path

    import xarray as xr

    from clerestory import _native
    from clerestory.bsdf.checking import Finding
    from clerestory.bsdf.klems import KlemsBasis

BANDS = ("visible", "solar", "x", "z")
"""Names of the bands of a BSDF."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Bsdf:
    """A window element known by its bidirectional scattering distribution, from a file, a panel or a measurement.

    Parameters
    ----------
    name : str
        Of the product; files must have one.
    visible : Band
        As the eye weighs daylight (CIE Y).
    solar : Band, optional
        Weighed by the power of sunlight.
    x, z : Band, optional
        CIE X and Z, for colour.
    thickness_mm : float, optional [mm]
        Of the element; files must have one.
    manufacturer : str, default "unspecified"
    exact : Glazing, optional
        Where the matrices come from: its specular beams are kept beside them, and a room uses those.
    attrs : dict, optional
        Whatever else is known, as text and numbers.

    Raises
    ------
    ClerestoryError
        If an argument is of another type or out of its range.
    """

    name: str
    visible: Band
    solar: Band | None = None
    x: Band | None = None
    z: Band | None = None
    thickness_mm: float | None = None
    manufacturer: str = "unspecified"
    exact: Glazing | None = None
    attrs: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("name", "manufacturer"):
            text = getattr(self, name)
            if not isinstance(text, str) or not text.strip():
                raise ClerestoryError(f"{name} must be a word or more, got {text!r}; some readers fail without it")
        for name in BANDS:
            band = getattr(self, name)
            if not (isinstance(band, Band) or (band is None and name != "visible")):
                raise ClerestoryError(f"{name} must be a Band, got {type(band).__name__}")
        if self.thickness_mm is not None:
            object.__setattr__(self, "thickness_mm", positive("thickness_mm", self.thickness_mm))
        if self.exact is not None:
            check_glazing("exact", self.exact)

    @property
    def bands(self) -> Iterator[tuple[str, Band]]:
        """Name and band of those that are known."""
        return ((name, getattr(self, name)) for name in BANDS if getattr(self, name) is not None)

    def glazing(self) -> _native.Glazing:
        """What fills a window: the exact element if there is one, else the visible band's matrices or trees.

        Raises
        ------
        ClerestoryError
            If a block has negative values or sends away more than it takes.
        """
        return self.blurred_glazing() if self.exact is None else self.exact.glazing()

    def blurred_glazing(self) -> _native.Glazing:
        """The visible band's matrices or trees as a glazing, whether or not the exact element is known."""
        from clerestory.bsdf.filling import glazing_of_band

        return glazing_of_band(self.visible, self.name)

    def blurred(self) -> Bsdf:
        """The same element known by its tables alone: a room then sees light spread over patches."""
        return replace(self, exact=None)

    def check(self) -> list[Finding]:
        """What may be wrong with the tables, in plain words.

        Returns
        -------
        list of Finding
            The gravest first; empty if nothing was found. Energy (theory/bsdf.md, eq. 6), reciprocity (eq. 5), negative
            values, front and back exchanged, incident vectors not negated, and what some programs miss.
        """
        from clerestory.bsdf.checking import check

        return check(self)

    def to_xml(self, path: str | os.PathLike[str]) -> Path:
        """Writes the BSDF as LBNL's XML (BSDF-v1.4), which Radiance and WINDOW read; whole or not at all.

        Parameters
        ----------
        path : path
            ``.xml``.

        Returns
        -------
        Path
            Of the file: all four directions of the visible and the solar band, and of CIE X and Z if they are known.
            Values in 1/sr; a line for each outgoing patch; Front is the outside. What is made up (a missing direction
            by reciprocity or as zero, a missing solar band by the visible one) is told as a
            :class:`~clerestory.bsdf.BsdfWarning`.

        Raises
        ------
        ClerestoryError
            If the thickness is unknown, the bands are of different kinds, or the file cannot be written.
        """
        from clerestory.bsdf.xml_write import write_xml

        return write_xml(self, path)

    @classmethod
    def from_xml(cls, path: str | os.PathLike[str], *, strict: bool = True) -> Bsdf:
        """The BSDF of an XML file; arguments, result and errors as of :func:`clerestory.read_bsdf`."""
        from clerestory.bsdf.xml_read import read_xml

        return read_xml(path, strict=strict)

    def to_dataset(self) -> xr.Dataset:
        """The tables as a Dataset, which :func:`clerestory.save` writes to NetCDF.

        Returns
        -------
        Dataset
            A variable for each block (``visible_transmission_front`` …) [1/sr]: matrices over (outgoing, incident)
            patches with their standard errors, trees as their walks. Attributes hold the rings of the bases, where it
            comes from, and the exact element as the table of a room file.
        """
        from clerestory.bsdf.own_file import to_dataset

        return to_dataset(self)

    @classmethod
    def from_dataset(cls, dataset: xr.Dataset) -> Bsdf:
        """The BSDF of a Dataset that :meth:`to_dataset` made.

        Raises
        ------
        ClerestoryError
            If it is no such Dataset.
        """
        from clerestory.bsdf.own_file import of_dataset

        return of_dataset(dataset)

    def in_basis(self, basis: str | KlemsBasis) -> Bsdf:
        """The BSDF as matrices of a Klems basis, the power of each direction kept (theory/bsdf.md, eq. 9).

        Parameters
        ----------
        basis : {"klems_full", "klems_half", "klems_quarter"} or KlemsBasis
        """
        from clerestory.bsdf.rebasing import in_basis

        turned = {
            name: Band(**{direction: in_basis(block, basis) for direction, block in band}) for name, band in self.bands
        }
        return replace(self, **turned)  # type: ignore[arg-type]
