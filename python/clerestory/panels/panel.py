"""What every panel can be asked: where its light goes, how that depends on incidence, and how it is written down."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from numpy.typing import ArrayLike

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.medium import Medium
from clerestory.panels.incidence import Side
from clerestory.panels.optics import ARC_CHORDS, TOLERANCE, Polarisation

if TYPE_CHECKING:
    import os
    from typing import Self

    import xarray as xr

    from clerestory.bsdf import Bsdf
    from clerestory.panels.angular import Method
    from clerestory.profile import Profile

#: Rays of the Monte Carlo walk for each direction.
RAYS = 100_000


@dataclass(frozen=True, slots=True, kw_only=True)
class Panel:
    """A flat element of a window whose cross-section repeats upwards: what all kinds have in common.

    Frozen and hashable; every argument is checked when the panel is made.

    Attributes
    ----------
    media : tuple of Medium
        What it is made of, in the numbering of its profile from 1; 0 is the air around it.
    profile : Profile
        Its cross-section.
    """

    #: The word for it in files and on the command line.
    kind: ClassVar[str] = ""

    native_profile: _native.Profile = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        for name, value in self._checked().items():
            object.__setattr__(self, name, value)
        object.__setattr__(self, "native_profile", self._drawn())

    def _checked(self) -> dict[str, Any]:
        """Each argument as it is kept: its type is right, its rules beyond that are the profile's."""
        raise NotImplementedError

    def _drawn(self) -> _native.Profile:
        """The cross-section, which checks the sizes."""
        raise NotImplementedError

    @property
    def media(self) -> tuple[Medium, ...]:
        """What it is made of, in the numbering of its profile from 1."""
        raise NotImplementedError

    @property
    def profile(self) -> Profile:
        """Its cross-section, to draw or to change."""
        from clerestory.profile import Profile

        return Profile._of_native(self.native_profile)

    @property
    def arguments(self) -> dict[str, Any]:
        """What it was made from, by name."""
        return {f.name: getattr(self, f.name) for f in fields(self) if f.init}

    def __reduce__(self) -> tuple[Any, ...]:
        return _made_again, (type(self), self.arguments)

    def glazing(self) -> _native.Glazing:
        """The panel as what fills a window: polarisation resolved, daylight as the eye weighs it, arcs as chords.

        Beams follow all but 1e-4 of the light, so that thousands of suns are affordable; :meth:`lobes` follows as much
        as is asked.
        """
        from clerestory.panels.optics import WINDOW_PIECES, WINDOW_TOLERANCE, exact_optics

        optics, _ = exact_optics(
            self,
            wavelength_nm=None,
            polarisation="resolved",
            tolerance=WINDOW_TOLERANCE,
            arc_chords=ARC_CHORDS,
            most_pieces=WINDOW_PIECES,
        )
        return optics.glazing()

    def lobes(
        self,
        *,
        elevation_deg: float,
        azimuth_deg: float = 0.0,
        side: Side = "front",
        wavelength_nm: float | None = None,
        polarisation: Polarisation = "resolved",
        tolerance: float = TOLERANCE,
        arc_chords: int = ARC_CHORDS,
    ) -> xr.Dataset:
        r"""Every beam that leaves when a plane wave of unpolarised light comes in: exact, no random numbers.

        Parameters
        ----------
        elevation_deg, azimuth_deg : float, between -90 and 90 [degrees]
            Where the light comes from: elevation above 0 from above, azimuth about the panel's y axis, 0 in the plane
            across the cuts (NOTATION.md).
        side : {"front", "back"}, default "front"
            The side it meets; front is the outside.
        wavelength_nm : float, optional [nm]
            None: as the eye weighs daylight (D65, five wavelengths) if a medium is spectral.
        polarisation : {"resolved", "averaged"}, default "resolved"
            Stokes vectors carried along each beam, or light unpolarised again at every hit.
        tolerance : float, between 0 and 1, default 1e-6
            Share of the power that may stay unfollowed; it is reported as ``residual``.
        arc_chords : int, at least 2, default 32
            Straight facets by which an arc is drawn.

        Returns
        -------
        Dataset over ``lobe``, strongest first
            ``direction`` (lobe, axis) unit vectors x, y, z; ``power`` [0..1 of the incident]; ``side`` it leaves by;
            ``total_reflections``, the fewest on any way; ``elevation_deg`` (above 0: upwards) and ``azimuth_deg`` it
            leaves at; ``stokes`` (lobe, parameter) about the reference axes of theory/polarisation.md, eq. 1, if
            resolved. Attributes ``absorbed``, ``residual`` (with the powers they add to 1), ``displaced`` (share moved
            along a facet to save work), ``walked`` (share that a quasi-random walk finished), ``pieces`` (of light
            followed), and what it was made from.

        Raises
        ------
        ClerestoryError
            If an argument is out of its range, the wavelength outside that of a medium, or the cuts are rough.

        Notes
        -----
        theory/panels.md. Over several wavelengths, light of one direction is one lobe; dispersed light is several.
        """
        from clerestory.panels.lobes import lobes

        return lobes(
            self,
            elevation_deg=elevation_deg,
            azimuth_deg=azimuth_deg,
            side=side,
            wavelength_nm=wavelength_nm,
            polarisation=polarisation,
            tolerance=tolerance,
            arc_chords=arc_chords,
        )

    def angular(
        self,
        *,
        elevation_deg: ArrayLike,
        azimuth_deg: ArrayLike = 0.0,
        side: Side = "front",
        method: Method = "exact",
        rays: int = RAYS,
        seed: int = 0,
        wavelength_nm: ArrayLike | None = None,
        polarisation: Polarisation = "resolved",
        tolerance: float = TOLERANCE,
        arc_chords: int = ARC_CHORDS,
    ) -> xr.Dataset:
        r"""How the light divides for each of many directions of incidence.

        Parameters
        ----------
        elevation_deg, azimuth_deg : array_like of no or one dimension, between -90 and 90 [degrees]
            As of :meth:`lobes`.
        side : {"front", "back"}, default "front"
        method : {"exact", "monte_carlo"}, default "exact"
            Beams followed without random numbers, or rays; rough and diffuse cuts need rays.
        rays : int, at least 2, default 100 000
            For each direction; ``monte_carlo`` alone.
        seed : int, at least 0, default 0
            The same seed gives the same result, for any number of threads.
        wavelength_nm : array_like of no or one dimension, optional [nm]
            A list adds the dimension ``wavelength``; None as of :meth:`lobes`.
        polarisation, tolerance, arc_chords
            As of :meth:`lobes`; the last two for ``exact`` alone (rays meet arcs as arcs).

        Returns
        -------
        Dataset, dims ("elevation", "azimuth"[, "wavelength"]) [0..1]
            ``transmittance``, ``reflectance``, ``absorptance``, ``residual`` (not followed to its end), which add to 1;
            ``transmittance_deflected`` (its vertical sense reversed) and ``transmittance_undeflected`` (kept), which
            add to ``transmittance``; after a Monte Carlo walk ``…_standard_error`` of each.

        Raises
        ------
        ClerestoryError
            If an argument is out of its range, a wavelength outside that of a medium, or the cuts are rough and the
            method exact.

        Notes
        -----
        theory/panels.md.
        """
        from clerestory.panels.angular import angular

        return angular(
            self,
            elevation_deg=elevation_deg,
            azimuth_deg=azimuth_deg,
            side=side,
            method=method,
            rays=rays,
            seed=seed,
            wavelength_nm=wavelength_nm,
            polarisation=polarisation,
            tolerance=tolerance,
            arc_chords=arc_chords,
        )

    def bsdf(
        self,
        basis: str | None = None,
        *,
        rank: int | None = None,
        log2_resolution: int = 5,
        bands: Sequence[str] = ("visible", "solar"),
        wavelengths: int = 1,
        accuracy: float = 4e-3,
        polarisation: Polarisation = "resolved",
        tolerance: float = 1e-5,
        arc_chords: int = ARC_CHORDS,
        draws: int = 20_000,
        seed: int = 0,
        name: str | None = None,
        manufacturer: str = "unspecified",
    ) -> Bsdf:
        r"""The panel as matrices or tensor trees over directions, for files that other programs read.

        Parameters
        ----------
        basis : {"klems_full", "klems_half", "klems_quarter"}, optional
            Patches of the matrices; None: ``klems_full``.
        rank : {3, 4}, optional
            Tensor trees instead of matrices; 3 for panes alone, which are the same turned about their normal.
        log2_resolution : int, 1 to 7, default 5
            The finest cells of a tree are 2**-log2_resolution of the square's side.
        bands : sequence of {"visible", "solar", "x", "z"}, default visible and solar
            CIE Y of daylight (D65), the power of sunlight (ASTM G173-03, direct), CIE X and Z.
        wavelengths : int, at least 1, default 1
            That stand for each of the three bands of CIE; one is exact for what changes evenly with the wavelength.
        accuracy : float, between 0 and 1, default 4e-3
            A column is settled when quartering the parts of its cell changes it by less: the sum of absolute
            differences as a share of the incident light. What is left is several times smaller.
        polarisation, arc_chords
            As of :meth:`lobes`.
        tolerance : float, between 0 and 1, default 1e-5
            Share of the power that may stay unfollowed; it is taken to go where the rest goes.
        draws : int, at least 100, default 20 000
            Random draws for each incident cell of a panel with rough or diffuse cuts.
        seed : int, at least 0, default 0
        name : str, optional
            None: the kind of panel.
        manufacturer : str, default "unspecified"

        Returns
        -------
        Bsdf
            All four blocks of each band [1/sr]: reciprocal to rounding, and with absorption they send out all light, to
            1e-9 of each incident cell. Its ``exact`` is the panel, so that a room sees its beams and not the patches.
            Blocks of rough panels carry standard errors. ``attrs`` tells of each band how closely it was found
            (``…_change``, ``…_asymmetry``, ``…_correction``, ``…_residual``, ``…_misfit``), at which wavelengths, and
            the share of its power at wavelengths that the media are known for.

        Raises
        ------
        ClerestoryError
            If an argument is out of its range, ``basis`` and ``rank`` are both given, or ``rank`` is 3 and the panel
            has an up and a down.

        Notes
        -----
        theory/bsdf_averaging.md.
        """
        from clerestory.bsdf.of_glazing import Averaging, panel_bsdf

        return panel_bsdf(
            self,
            Averaging(basis, rank, log2_resolution, accuracy, draws, seed),
            bands=bands,
            wavelengths=wavelengths,
            polarisation=polarisation,
            tolerance=tolerance,
            arc_chords=arc_chords,
            name=name,
            manufacturer=manufacturer,
        )

    def to_dict(self) -> dict[str, Any]:
        """Plain values for TOML or JSON, with the panel's ``kind``; :func:`panel_from_dict` reads them."""
        from clerestory.panels.writing import panel_to_dict

        return panel_to_dict(self)

    def to_toml(self, path: str | os.PathLike[str]) -> Path:
        """Writes the panel to a file, whole or not at all, and returns its path; :func:`read_panel` reads it.

        Raises
        ------
        ClerestoryError
            If the file cannot be written.
        """
        from clerestory.panels.writing import write_panel

        return write_panel(self, path)

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Self:
        """The panel of a file, which must be of this kind.

        Raises
        ------
        ClerestoryError
            If the file cannot be read, is not TOML, names an unknown key, breaks a rule or holds another kind.
        """
        from clerestory.panels.writing import read_panel

        panel = read_panel(path)
        if not isinstance(panel, cls):
            raise ClerestoryError(f"{path}: kind must be {cls.kind!r}, got {panel.kind!r}; use read_panel")
        return panel


def _made_again(kind: type[Panel], arguments: dict[str, Any]) -> Panel:
    return kind(**arguments)
