"""What may fill a window."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Protocol, runtime_checkable

from numpy.typing import ArrayLike

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.layers.gap import Gap
from clerestory.panels.incidence import Side
from clerestory.panels.optics import TOLERANCE as _TOLERANCE
from clerestory.panels.optics import Polarisation
from clerestory.rules import not_negative, positive, within

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray as xr

    from clerestory.bsdf import Bsdf


@runtime_checkable
class Glazing(Protocol):
    """Anything that may fill a window: a pane, a panel, a stack of them."""

    def glazing(self) -> _native.Glazing:
        """The compiled half, which the rays meet."""
        ...


@dataclass(frozen=True)
class Open:
    """An opening with nothing in it."""

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.open()


@dataclass(frozen=True, kw_only=True)
class PlainTransmittance:
    """A sheet that lets the same share of light through at every angle, and reflects none.

    Parameters
    ----------
    transmittance : float, 0..1
    """

    transmittance: float

    def __post_init__(self) -> None:
        within("transmittance", self.transmittance, 0.0, 1.0)

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.constant(self.transmittance)


@dataclass(frozen=True, kw_only=True)
class Glass:
    """A single pane of index 1.52 known by its transmittance at normal incidence, as Radiance's ``glass``.

    Parameters
    ----------
    transmittance : float, 0..0.9179
        At normal incidence, reflections between the faces included. A pane that absorbs nothing has 0.918.
    """

    transmittance: float

    def __post_init__(self) -> None:
        n = 1.52
        within("transmittance", self.transmittance, 0.0, 2.0 * n / (n * n + 1.0))

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.glass(self.transmittance)


@dataclass(frozen=True)
class TregenzaSharples:
    """Clear 6 mm glass by the polynomial of Tregenza and Sharples; nothing is reflected."""

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.tregenza_sharples()


@dataclass(frozen=True, kw_only=True)
class Slab:
    """A plane-parallel sheet with Fresnel's reflections at both faces and absorption on the way.

    Parameters
    ----------
    refractive_index : float, at least 1
    thickness_mm : float
    absorption_per_mm : float, default 0
    """

    refractive_index: float
    thickness_mm: float
    absorption_per_mm: float = 0.0

    def __post_init__(self) -> None:
        within("refractive_index", self.refractive_index, 1.0, 5.0)
        positive("thickness_mm", self.thickness_mm)
        not_negative("absorption_per_mm", self.absorption_per_mm)

    def glazing(self) -> _native.Glazing:
        """The compiled half."""
        return _native.Glazing.slab(self.refractive_index, self.thickness_mm, self.absorption_per_mm)


@dataclass(frozen=True)
class Stack:
    """Layers with gaps between them, such as a panel in a double window.

    Parameters
    ----------
    layers : sequence of Glazing and Gap
        From the outside to the room. A :class:`~clerestory.Gap` between two layers is kept for programs that compute
        heat; light crosses it unchanged, and layers may also follow one another without.

    Raises
    ------
    ClerestoryError
        If there is no layer, an entry is neither a glazing nor a gap, or a gap is not between two layers.

    Notes
    -----
    Light is followed back and forth between the layers, its polarisation with it (theory/layers.md). A stack with a
    BSDF among its layers is combined from matrices (theory/layers.md, eq. 8).

    Examples
    --------
    >>> from clerestory import Gap, Medium, Pane
    >>> pane = Pane(thickness_mm=4.0, medium=Medium(n=1.52))
    >>> double = Stack([pane, Gap(width_mm=16.0, gas="argon"), pane])
    >>> round(double.angular(elevation_deg=60.0).transmittance.item(), 4)
    0.7498
    """

    layers: tuple[Glazing | Gap, ...]

    def __post_init__(self) -> None:
        layers = tuple(self.layers)
        for index, layer in enumerate(layers):
            if isinstance(layer, Gap):
                if index in (0, len(layers) - 1) or isinstance(layers[index - 1], Gap):
                    raise ClerestoryError(
                        f"layers[{index}] must be a glazing, since a gap lies between two of them, got {layer!r}; "
                        "move it"
                    )
            else:
                check_glazing(f"layers[{index}]", layer)
        if not layers:
            raise ClerestoryError("layers must hold at least one glazing, got none")
        object.__setattr__(self, "layers", layers)

    @property
    def glazings(self) -> tuple[Glazing, ...]:
        """The layers without the gaps, from the outside to the room."""
        return tuple(layer for layer in self.layers if not isinstance(layer, Gap))

    @property
    def gaps(self) -> tuple[Gap | None, ...]:
        """What is known of the gap behind each layer but the last; None where nothing was said."""
        found: list[Gap | None] = []
        for before, layer in pairwise(self.layers):
            if isinstance(layer, Gap):
                found.append(layer)
            elif not isinstance(before, Gap):
                found.append(None)
        return tuple(found)

    def glazing(self) -> _native.Glazing:
        """The compiled half: polarisation resolved, daylight as the eye weighs it.

        Panels follow all but 1e-4 of the light they meet, as where one fills a window alone; of very many beams those
        weaker than 1e-3 are put together within 0.1° to 0.4° (theory/layers.md, eq. 13). With a BSDF among the layers
        it is their combined matrices in the full Klems basis.
        """
        from clerestory.layers.matrices import layered_stack
        from clerestory.layers.optics import stack_optics
        from clerestory.panels.optics import WINDOW_TOLERANCE

        if any(self._is_spreading(layer) for layer in self.glazings):
            return layered_stack(self, basis="klems_full").bsdf.blurred_glazing()
        return stack_optics(self, wavelength_nm=None, polarisation="resolved", tolerance=WINDOW_TOLERANCE)[0].glazing()

    def lobes(
        self,
        *,
        elevation_deg: float,
        azimuth_deg: float = 0.0,
        side: Side = "front",
        wavelength_nm: float | None = None,
        polarisation: Polarisation = "resolved",
        tolerance: float = _TOLERANCE,
    ) -> xr.Dataset:
        r"""Every beam that leaves when a plane wave of unpolarised light comes in, and what each layer absorbs.

        Parameters
        ----------
        elevation_deg, azimuth_deg, side, wavelength_nm
            As of :meth:`Panel.lobes`. Each wavelength that stands for daylight goes through all layers by itself.
        polarisation : {"resolved", "averaged"}, default "resolved"
            Stokes vectors carried from layer to layer, or light unpolarised again before every layer, as WINDOW has it.
            Within a layer they are always resolved.
        tolerance : float, between 0 and 1, default 1e-6
            Share of the power that may stay unfollowed within a panel.

        Returns
        -------
        Dataset over ``lobe``, strongest first, and ``layer``, the outermost 1
            As of :meth:`Panel.lobes`, with ``layer_absorptance`` (layer) [0..1 of the incident]. Powers,
            ``layer_absorptance`` and the attribute ``residual`` add to 1. Attribute ``walked``: the share that panels
            of odd angles send into ever new directions and that a quasi-random walk followed from layer to layer;
            ``walked_standard_error``: of any share by that, at most.

        Raises
        ------
        ClerestoryError
            If an argument is out of its range, a layer has rough cuts or is a BSDF.

        Notes
        -----
        theory/layers.md, eqs. 5, 6, 11 and 12.
        """
        from clerestory.layers.light import stack_lobes

        return stack_lobes(
            self,
            elevation_deg=elevation_deg,
            azimuth_deg=azimuth_deg,
            side=side,
            wavelength_nm=wavelength_nm,
            polarisation=polarisation,
            tolerance=tolerance,
        )

    def angular(
        self,
        *,
        elevation_deg: ArrayLike,
        azimuth_deg: ArrayLike = 0.0,
        side: Side = "front",
        wavelength_nm: ArrayLike | None = None,
        polarisation: Polarisation = "resolved",
        tolerance: float = _TOLERANCE,
    ) -> xr.Dataset:
        r"""How the light divides for each of many directions of incidence, layer by layer.

        Parameters
        ----------
        elevation_deg, azimuth_deg : array_like of no or one dimension, between -90 and 90 [degrees]
        side, polarisation, tolerance
            As of :meth:`lobes`.
        wavelength_nm : array_like of no or one dimension, optional [nm]
            A list adds the dimension ``wavelength``; None: as the eye weighs daylight.

        Returns
        -------
        Dataset, dims ("elevation", "azimuth"[, "wavelength"]) [0..1]
            ``transmittance``, ``reflectance``, ``absorptance``, ``residual``, which add to 1;
            ``transmittance_deflected`` and ``transmittance_undeflected``; ``layer_absorptance`` (layer, …), the
            outermost layer 1, which adds to ``absorptance``.

        Raises
        ------
        ClerestoryError
            As of :meth:`lobes`.

        Notes
        -----
        In closed form where no layer turns light (theory/layers.md, eqs. 1 to 3), by following beams otherwise.
        """
        from clerestory.layers.light import stack_angular

        return stack_angular(
            self,
            elevation_deg=elevation_deg,
            azimuth_deg=azimuth_deg,
            side=side,
            wavelength_nm=wavelength_nm,
            polarisation=polarisation,
            tolerance=tolerance,
        )

    def absorptances(
        self, *, elevation_deg: ArrayLike, azimuth_deg: ArrayLike = 0.0, side: Side = "front"
    ) -> xr.DataArray:
        """What each layer absorbs of visible daylight from each direction: ``layer_absorptance`` of :meth:`angular`.

        Returns
        -------
        DataArray, dims ("layer", "elevation", "azimuth") [0..1]
            The outermost layer is 1, for light from either side.
        """
        shares = self.angular(elevation_deg=elevation_deg, azimuth_deg=azimuth_deg, side=side)
        return shares["layer_absorptance"]

    @staticmethod
    def _is_spreading(layer: Glazing) -> bool:
        if isinstance(layer, Stack):
            return any(Stack._is_spreading(each) for each in layer.glazings)
        return layer.glazing().spreads

    def bsdf(
        self,
        basis: str | None = None,
        *,
        rank: int | None = None,
        log2_resolution: int = 5,
        bands: Sequence[str] = ("visible", "solar"),
        wavelengths: int = 1,
        polarisation: Polarisation = "resolved",
        accuracy: float = 4e-3,
        tolerance: float = 1e-5,
        name: str | None = None,
        manufacturer: str = "unspecified",
    ) -> Bsdf:
        """The stack as one BSDF, for files and other programs.

        Parameters
        ----------
        basis, rank, log2_resolution, bands, wavelengths, accuracy, tolerance, manufacturer
            As of :meth:`Panel.bsdf <clerestory.panels.panel.Panel.bsdf>`.
        polarisation : {"resolved", "averaged"}, default "resolved"
            As of :meth:`lobes`.
        name : str, optional
            None: the layers' names or kinds.

        Returns
        -------
        Bsdf
            Exact where every layer sends light into beams: averages of the beams of the whole stack, with ``exact`` the
            stack itself. Where a layer spreads light (a BSDF, rough cuts), the matrices of all layers multiplied with
            all reflections between them, in the bands that every layer has. Layers by formula (``Glass``, ``Slab``) do
            the same in every band.

        Raises
        ------
        ClerestoryError
            If an argument is out of its range, or ``rank`` is given and a layer spreads light.

        Notes
        -----
        theory/layers.md, eq. 8; theory/bsdf_averaging.md.
        """
        from clerestory.bsdf.of_glazing import DRAWS, Averaging
        from clerestory.layers.matrices import stack_bsdf

        return stack_bsdf(
            self,
            Averaging(basis, rank, log2_resolution, accuracy, DRAWS, 0),
            bands=bands,
            wavelengths=wavelengths,
            polarisation=polarisation,
            tolerance=tolerance,
            name=name,
            manufacturer=manufacturer,
        )

    def hemispherical(
        self,
        *,
        side: Side = "front",
        wavelength_nm: float | None = None,
        polarisation: Polarisation = "resolved",
        tolerance: float = _TOLERANCE,
        rings: int = 12,
        azimuths: int = 16,
    ) -> xr.Dataset:
        """How light divides that comes evenly from the whole hemisphere before a side.

        Parameters
        ----------
        side, wavelength_nm, polarisation, tolerance
            As of :meth:`lobes`.
        rings, azimuths : int, at least 1, default 12 and 16
            Angles from the normal and about it at which light comes in.

        Returns
        -------
        Dataset without dimensions but ``layer`` [0..1]
            The variables of :meth:`angular`.

        Raises
        ------
        ClerestoryError
            As of :meth:`lobes`.

        Notes
        -----
        theory/layers.md, eq. 7.
        """
        from clerestory.layers.hemispherical import stack_hemispherical

        return stack_hemispherical(
            self,
            side=side,
            wavelength_nm=wavelength_nm,
            polarisation=polarisation,
            tolerance=tolerance,
            rings=rings,
            azimuths=azimuths,
        )


def check_glazing(name: str, value: object) -> Glazing:
    """The value, if it can fill a window."""
    if not isinstance(value, Glazing) or isinstance(value, type):
        raise ClerestoryError(
            f"{name} must be a glazing such as Glass(transmittance=0.88) or LaserCutPanel(…), got {value!r}"
        )
    return value
