"""A BSDF from exact optics: averages over patches or the cubes of a tree, for every band of wavelengths."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from clerestory import _native
from clerestory.bsdf.band import DIRECTIONS, Band
from clerestory.bsdf.bsdf import BANDS, Bsdf
from clerestory.bsdf.klems import KLEMS_BASES
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.tree_block import TreeBlock
from clerestory.bsdf.wavebands import band_samples
from clerestory.errors import ClerestoryError
from clerestory.glazing import Glazing, check_glazing
from clerestory.panels.optics import POLARISATIONS, checked_tolerance, whole
from clerestory.panels.wavelengths import Samples
from clerestory.rules import number, one_of

if TYPE_CHECKING:
    from clerestory.panels.panel import Panel

#: Greatest change of a column by quartering the parts of its cell, as a share of its light.
ACCURACY = 4e-3
#: Share of the power that may stay unfollowed within a panel; it is taken to go where the rest goes.
TOLERANCE = 1e-5
#: Random draws for each incident cell of an element without exact beams.
DRAWS = 20_000
#: Pieces of light followed exactly for one direction; a walk finishes what is left (panels with kerfs).
MOST_PIECES = 20_000
#: How often a part of a patch, or of the smaller cell of a tree, is quartered at most.
_LEVELS = {"klems": 3, "tree": 2}
#: Finest trees: 2**7 cells along each coordinate.
_FINEST = 7


class Averaging:
    """How a BSDF is averaged: into what, and how closely."""

    def __init__(
        self,
        basis: str | None,
        rank: int | None,
        log2_resolution: int,
        accuracy: float,
        draws: int,
        seed: int,
    ) -> None:
        if rank is None:
            one_of("basis", basis or KLEMS_BASES[0], KLEMS_BASES)
        elif basis is not None:
            raise ClerestoryError(f"rank must be left out if basis is given, got rank={rank!r} and basis={basis!r}")
        elif rank not in (3, 4):
            raise ClerestoryError(f"rank must be 3 (the same turned about the normal) or 4, got {rank!r}")
        self.basis, self.rank = basis or KLEMS_BASES[0], rank
        self.log2_resolution = whole("log2_resolution", log2_resolution, 1)
        if self.log2_resolution > _FINEST:
            raise ClerestoryError(
                f"log2_resolution must be at most {_FINEST}, got {log2_resolution}; 5 serves most ends"
            )
        self.accuracy = number("accuracy", accuracy)
        if not 0.0 < self.accuracy < 1.0:
            raise ClerestoryError(f"accuracy must be between 0 and 1, got {accuracy:g}; 4e-3 serves most ends")
        self.draws, self.seed = whole("draws", draws, 100), whole("seed", seed, 0)

    def band(self, glazing: _native.Glazing) -> tuple[Band, dict[str, float]]:
        """The four blocks of a glazing, and how closely they were found."""
        how: dict[str, Any] = {"tolerance": self.accuracy, "draws": self.draws, "seed": self.seed}
        if self.rank is None:
            tables, errors, (_, accounts) = glazing.klems(self.basis, levels=_LEVELS["klems"], **how)
            given: Sequence[Any] = errors or [None] * len(tables)
            blocks: Sequence[Any] = [
                KlemsBlock(values, self.basis, self.basis, error) for values, error in zip(tables, given, strict=True)
            ]
        else:
            merged = 0.0 if glazing.has_lobes else 0.1
            walks, found = glazing.tree(self.rank, self.log2_resolution, merged=merged, levels=_LEVELS["tree"], **how)
            blocks, accounts = [TreeBlock(self.rank, walk) for walk in walks], [] if found is None else found[1]
        return Band(**dict(zip(DIRECTIONS, blocks, strict=True))), dict(accounts)


def panel_bsdf(
    panel: Panel,
    averaging: Averaging,
    *,
    bands: Sequence[str],
    wavelengths: int,
    polarisation: str,
    tolerance: float,
    arc_chords: int,
    name: str | None,
    manufacturer: str,
) -> Bsdf:
    """The BSDF of a panel; arguments, result and errors as of :meth:`clerestory.panels.panel.Panel.bsdf`."""
    one_of("polarisation", polarisation, POLARISATIONS)
    checked_tolerance(tolerance)
    profile = panel.native_profile
    if profile.is_smooth and not profile.is_straight:
        profile = profile.flattened(whole("arc_chords", arc_chords, 2))

    def glazing(samples: Samples) -> _native.Glazing:
        return _native.PanelOptics(
            profile,
            n=samples.n,
            absorption_per_mm=samples.absorption_per_mm,
            weights=np.array(samples.weights),
            polarisation=polarisation,
            tolerance=tolerance,
            most_pieces=MOST_PIECES,
        ).glazing()

    low, high = profile.depth_range_mm
    return _of_bands(
        lambda band: band_samples(panel.media, band, whole("wavelengths", wavelengths, 1)),
        glazing,
        averaging,
        bands,
        name=name or f"{type(panel).__name__}",
        manufacturer=manufacturer,
        thickness_mm=high - low,
        exact=panel,
    )


def _of_bands(
    samples: Callable[[str], tuple[Samples, float]],
    glazing: Callable[[Samples], _native.Glazing],
    averaging: Averaging,
    bands: Sequence[str],
    **known: Any,
) -> Bsdf:
    for band in bands:
        one_of("bands", band, BANDS)
    if "visible" not in bands:
        raise ClerestoryError(f"bands must hold 'visible', got {list(bands)}; add it")
    found: dict[str, Any] = {}
    attrs: dict[str, Any] = {}
    solved: dict[bytes, Band] = {}
    for band in bands:
        at, share = samples(band)
        same = b"".join(array.tobytes() for array in (at.n, at.absorption_per_mm, np.array(at.weights)))
        if same not in solved:
            solved[same], accounts = averaging.band(glazing(at))
            attrs |= {f"{band}_{name}": value for name, value in accounts.items()}
        found[band] = solved[same]
        attrs[f"{band}_share_known"] = share
        if at.wavelength_nm:
            attrs[f"{band}_wavelength_nm"] = " ".join(f"{w:.1f}" for w in at.wavelength_nm)
    return Bsdf(**found, **known, attrs=attrs)


def bsdf_of(
    glazing: Glazing,
    *,
    basis: str | None = None,
    rank: int | None = None,
    log2_resolution: int = 5,
    accuracy: float = ACCURACY,
    draws: int = DRAWS,
    seed: int = 0,
    name: str | None = None,
    manufacturer: str = "unspecified",
    thickness_mm: float | None = None,
) -> Bsdf:
    """The BSDF of anything that may fill a window: a stack of layers, glass by formula, a BSDF in another basis.

    Parameters
    ----------
    glazing : Glazing
        Averaged as it stands, for visible daylight. :meth:`Panel.bsdf <clerestory.panels.panel.Panel.bsdf>` gives a
        panel's solar band as well.
    basis, rank, log2_resolution, accuracy, draws, seed
        As of :meth:`Panel.bsdf <clerestory.panels.panel.Panel.bsdf>`.
    name : str, optional
        None: the kind of glazing.
    manufacturer : str, default "unspecified"
    thickness_mm : float, optional [mm]
        Files must have one.

    Returns
    -------
    Bsdf
        Its visible band; ``exact`` is the glazing.

    Raises
    ------
    ClerestoryError
        If an argument is out of its range, or ``rank`` is 3 and the element is not the same turned about its normal.

    Notes
    -----
    theory/bsdf_averaging.md, eqs. 5 to 10.
    """
    check_glazing("glazing", glazing)
    band, accounts = Averaging(basis, rank, log2_resolution, accuracy, draws, seed).band(glazing.glazing())
    return Bsdf(
        name=name or type(glazing).__name__,
        manufacturer=manufacturer,
        thickness_mm=thickness_mm,
        visible=band,
        exact=glazing,
        attrs={f"visible_{key}": value for key, value in accounts.items()},
    )
