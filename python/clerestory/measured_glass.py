"""Measured glass: from a file of normal transmittance and reflectance to any incidence and any wavelength."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from clerestory import _native
from clerestory.array_rules import within
from clerestory.elementwise import FloatOrArray
from clerestory.errors import ClerestoryError
from clerestory.glass import PaneShares, Polarisation, cos_of_incidence
from clerestory.medium import Medium
from clerestory.spectrum import Illuminant, photopic_mean

_NM_PER_MICRON = 1000.0
#: Where the eye is most sensitive.
_MOST_VISIBLE_NM = 555.0


@dataclass(frozen=True, eq=False)
class MeasuredGlass:
    """An uncoated pane whose spectrum was measured at normal incidence.

    Parameters
    ----------
    name : str
    thickness_mm : float [mm]
    wavelength_nm : ndarray, shape (w,), increasing [nm]
    transmittance, reflectance_front, reflectance_back : ndarrays, shape (w,) [0..1]
        At normal incidence.

    Notes
    -----
    At each wavelength the pane is taken for a plane-parallel slab: its index and absorption follow from T and R at
    normal incidence, and T and R at any other incidence from those (theory/glass.md, eqs. 12 to 15). For a coated or
    laminated pane this is wrong; WINDOW treats those by other means.
    """

    name: str
    thickness_mm: float
    wavelength_nm: NDArray[np.float64]
    transmittance: NDArray[np.float64]
    reflectance_front: NDArray[np.float64]
    reflectance_back: NDArray[np.float64]

    def spectral(
        self,
        incidence_deg: ArrayLike,
        *,
        side: Literal["front", "back"] = "front",
        polarisation: Polarisation = "resolved",
    ) -> PaneShares:
        """Transmittance, reflectance and absorptance at each measured wavelength.

        Parameters
        ----------
        incidence_deg : array_like, 0 to 90 [degrees]
        side : {"front", "back"}, default "front"
            The side that the light meets.
        polarisation : {"resolved", "averaged", "s", "p"}, default "resolved"

        Returns
        -------
        PaneShares of ndarrays, shape (..., w)
            The incidence's shape and then the wavelengths.

        Raises
        ------
        ClerestoryError
            If an angle is outside 0 to 90 degrees, the side another, or a measured value impossible.
        """
        if side not in ("front", "back"):
            raise ClerestoryError(f"side must be front or back, got {side!r}; front is the outside")
        reflectance = self.reflectance_front if side == "front" else self.reflectance_back
        n, depth = _native.uncoated_glass(self.transmittance, reflectance)
        cos_i = cos_of_incidence(incidence_deg)
        shape = (*cos_i.shape, n.size)
        columns = (np.broadcast_to(column, shape).ravel() for column in (cos_i[..., None], n, depth))
        cos_column, n_column, depth_column = columns
        shares = _native.slab(cos_column, n_column, depth_column, polarisation)
        return PaneShares(*(share.reshape(shape) for share in shares))

    def photopic(
        self,
        incidence_deg: ArrayLike,
        *,
        side: Literal["front", "back"] = "front",
        illuminant: Illuminant = "D65",
        polarisation: Polarisation = "resolved",
    ) -> PaneShares:
        """Visible transmittance, reflectance and absorptance: means of :meth:`spectral` as the eye weighs them.

        Arguments and errors as of :meth:`spectral`, and ``illuminant`` as of
        :func:`~clerestory.spectrum.photopic_mean`.

        Returns
        -------
        PaneShares of floats, or ndarrays of the incidence's shape [0..1]
        """
        shares = self.spectral(incidence_deg, side=side, polarisation=polarisation)
        means: list[FloatOrArray] = [photopic_mean(self.wavelength_nm, share, illuminant) for share in shares]
        return PaneShares(*means)

    def medium(self) -> Medium:
        """What the pane is made of, to build other panes and panels from it.

        Returns
        -------
        Medium
            Spectral; n and absorption from the mean of the two reflectances. Its range is the run of wavelengths around
            555 nm that the pane transmits at all.

        Raises
        ------
        ClerestoryError
            If the pane transmits nothing at 555 nm, or was not measured there.
        """
        reflectance = 0.5 * (self.reflectance_front + self.reflectance_back)
        n, depth = _native.uncoated_glass(self.transmittance, reflectance)
        middle = int(np.argmin(np.abs(self.wavelength_nm - _MOST_VISIBLE_NM)))
        opaque = np.flatnonzero(self.transmittance <= 0.0)
        start = int(opaque[opaque <= middle].max(initial=-1)) + 1
        stop = int(opaque[opaque >= middle].min(initial=self.wavelength_nm.size))
        known = self.wavelength_nm[start:stop]
        if known.size < 2 or not known[0] <= _MOST_VISIBLE_NM <= known[-1]:
            raise ClerestoryError(
                f"{self.name} must transmit light around {_MOST_VISIBLE_NM:g} nm to be a medium, got none; "
                "measure a clear pane"
            )
        absorption_per_mm = depth[start:stop] / self.thickness_mm
        return Medium.tabulated(known, n[start:stop], absorption_per_mm=absorption_per_mm, name=self.name)


def medium_of_pane(transmittance: float, reflectance: float, *, thickness_mm: float, name: str | None = None) -> Medium:
    """The glass of an uncoated pane of which a data sheet gives two values at normal incidence.

    Parameters
    ----------
    transmittance, reflectance : float [0..1]
        Visible, or at one wavelength; together at most 1.
    thickness_mm : float, greater than 0 [mm]
    name : str, optional

    Returns
    -------
    Medium
        Not spectral. A slab of it has the given values at normal incidence.

    Raises
    ------
    ClerestoryError
        If the values are impossible together, or the pane transmits nothing.

    Notes
    -----
    Theory: theory/glass.md, eqs. 12 to 15. Taking visible means for one wavelength costs little: at most 3e-4
    of transmittance up to 85° on three clear panes of 3 to 8 mm.

    Examples
    --------
    >>> glass = medium_of_pane(0.893, 0.080, thickness_mm=8.0)
    >>> round(glass.index(), 3), round(glass.absorption_per_mm_at(), 4)
    (1.522, 0.0034)
    """
    way_out = "give shares of 1 from the data sheet"
    t = within("transmittance", transmittance, 0.0, 1.0, open_low=True, way_out=way_out)
    r = within("reflectance", reflectance, 0.0, 1.0, way_out=way_out)
    thickness = within("thickness_mm", thickness_mm, 0.0, open_low=True, way_out="give the distance between the faces")
    n, depth = _native.uncoated_glass(np.atleast_1d(t), np.atleast_1d(r))
    return Medium(float(n[0]), float(depth[0] / thickness), name)


def measured_glass(path: str | os.PathLike[str]) -> MeasuredGlass:
    """Reads a pane's spectrum from a text file of the International Glazing Database (Optics format).

    Parameters
    ----------
    path : path
        Heading lines in braces, of which the units of wavelength, ``Thickness`` [mm] and ``Product Name`` are read;
        then rows of wavelength, transmittance, reflectance front and back, as shares of 1, at normal incidence.

    Returns
    -------
    MeasuredGlass

    Raises
    ------
    ClerestoryError
        If the file cannot be read, a row has not four numbers, the wavelengths do not increase, a share is
        impossible, the thickness is missing, or the pane is coated; the message names file and line.
    """
    where = Path(path)
    try:
        text = where.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise ClerestoryError(f"{where} must be a readable file, got: {error.strerror}; check the path") from None
    headings: dict[str, str] = {}
    rows: list[list[float]] = []
    for number, line in enumerate(text.splitlines(), start=1):
        stripped = line.strip()
        heading = re.fullmatch(r"\{\s*([^{}:]*?)\s*(?::\s*([^{}]*?)\s*)?\}\s*(.*)", stripped)
        if heading:
            key, inside, after = heading.groups()
            headings[key.lower()] = after or inside or ""
        elif stripped:
            rows.append(_row(where, number, stripped, rows))
    if len(rows) < 2:
        raise ClerestoryError(f"{where} must hold two or more rows of wavelength, T, Rf, Rb, got {len(rows)}; check it")
    if headings.get("coated side", "Neither").lower() not in ("neither", "n/a", "na", ""):
        raise ClerestoryError(
            f"{where}: coated side must be Neither, got {headings['coated side']}; the angular behaviour of a coated "
            "pane cannot be told from normal incidence, use its BSDF"
        )
    columns = np.array(rows, dtype=np.float64).T
    wavelength_nm = columns[0] * _wavelength_unit(where, headings)
    name = headings.get("product name") or where.stem
    return MeasuredGlass(name, _thickness_mm(where, headings), wavelength_nm, columns[1], columns[2], columns[3])


def _row(where: Path, number: int, line: str, before: list[list[float]]) -> list[float]:
    place = f"{where}, line {number}"
    try:
        row = [float(field) for field in re.split(r"[\s,]+", line)]
    except ValueError:
        row = []
    if len(row) != 4 or not np.all(np.isfinite(row)):
        raise ClerestoryError(f"{place}: a row must be wavelength, T, Rf, Rb, got {line!r}; correct the line")
    wavelength, transmittance, front, back = row
    if wavelength <= 0 or (before and wavelength <= before[-1][0]):
        raise ClerestoryError(f"{place}: wavelengths must be above 0 and increase, got {wavelength:g}; sort the rows")
    for reflectance in (front, back):
        if not (transmittance >= 0 and 0 <= reflectance < 1 and transmittance + reflectance <= 1):
            raise ClerestoryError(
                f"{place}: T and R must be at least 0, R below 1 and T + R at most 1, got {transmittance:g} and "
                f"{reflectance:g}; give shares of 1, not per cent"
            )
    return row


def _wavelength_unit(where: Path, headings: dict[str, str]) -> float:
    """Nanometres in one unit of the file's wavelengths."""
    unit = next((value for key, value in headings.items() if "wavelength units" in key), "SI Microns").lower()
    if "micron" in unit:
        return _NM_PER_MICRON
    if "nanomet" in unit:
        return 1.0
    raise ClerestoryError(f"{where}: wavelength units must be microns or nanometers, got {unit!r}; convert the file")


def _thickness_mm(where: Path, headings: dict[str, str]) -> float:
    text = headings.get("thickness")
    if text is None:
        raise ClerestoryError(f"{where} must have a heading {{ Thickness }} with millimetres, got none; add the line")
    try:
        thickness = float(text)
    except ValueError:
        raise ClerestoryError(f"{where}: thickness must be a number of mm, got {text!r}; correct the heading") from None
    return float(within(f"{where}: thickness", thickness, 0.0, open_low=True, way_out="correct the heading"))
