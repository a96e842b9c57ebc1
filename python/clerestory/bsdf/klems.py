"""Klems bases: the hemisphere in rings about the normal, each ring in equal bins of azimuth."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np
import numpy.typing as npt

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.rules import one_of

Floats = npt.NDArray[np.float64]

#: Name → what LBNL's files call it; the rings are the compiled half's (``_native.KlemsBasis``).
_LBNL_NAMES = {
    "klems_full": "LBNL/Klems Full",
    "klems_half": "LBNL/Klems Half",
    "klems_quarter": "LBNL/Klems Quarter",
}
KLEMS_BASES = tuple(_LBNL_NAMES)
"""The usual bases, finest first."""

#: Most patches of a basis that a file may define.
MOST_PATCHES = 20_000


@dataclass(frozen=True)
class KlemsBasis:
    """Rings about the normal, each divided into equal bins of azimuth (J. H. Klems, ASHRAE Transactions 100(1), 1994).

    A patch is named by the (x, y) of the direction in which light travels, x to the right as seen from inside and y up.
    Patches are counted ring by ring from the normal; in each ring, bin 0 is centred on +x and the next ones follow
    counter-clockwise.

    Parameters
    ----------
    name : str
        ``"klems_full"`` …, or the name a file gives a basis of its own.
    theta_deg : tuple of float [degrees]
        Edges of the rings, from 0 to 90: one more than there are rings.
    counts : tuple of int
        Bins of azimuth of each ring.

    Raises
    ------
    ClerestoryError
        If the edges do not rise from 0 to 90, a count is below 1, or there are not as many counts as rings.
    """

    name: str
    theta_deg: tuple[float, ...]
    counts: tuple[int, ...]

    def __post_init__(self) -> None:
        edges, counts = np.asarray(self.theta_deg, dtype=np.float64), tuple(int(count) for count in self.counts)
        where = f"basis {self.name!r}"
        if len(edges) != len(counts) + 1 or not counts:
            raise ClerestoryError(
                f"theta_deg of {where} must have one edge more than there are rings ({len(counts)}), got {len(edges)}"
            )
        rises = np.isfinite(edges).all() and edges[0] == 0.0 and edges[-1] == 90.0 and (np.diff(edges) > 0.0).all()
        if not rises:
            raise ClerestoryError(f"theta_deg of {where} must rise from 0 to 90, got {edges.tolist()}")
        if min(counts) < 1 or sum(counts) > MOST_PATCHES:
            raise ClerestoryError(
                f"counts of {where} must be at least 1 and {MOST_PATCHES} in all at most, got {list(counts)[:20]}"
            )
        object.__setattr__(self, "theta_deg", tuple(edges.tolist()))
        object.__setattr__(self, "counts", counts)

    def __len__(self) -> int:
        return sum(self.counts)

    @property
    def lbnl_name(self) -> str:
        """What LBNL's files call it."""
        return _LBNL_NAMES.get(self.name, self.name)

    @cached_property
    def ring(self) -> npt.NDArray[np.int64]:
        """Ring of each patch, counted from the normal."""
        return np.repeat(np.arange(len(self.counts)), self.counts)

    @cached_property
    def _bin(self) -> npt.NDArray[np.int64]:
        return np.concatenate([np.arange(count) for count in self.counts])

    @cached_property
    def projected_solid_angle(self) -> Floats:
        """Integral of cos θ over each patch [sr]; they sum to π (theory/bsdf.md, eq. 2)."""
        cos2 = np.cos(np.radians(self.theta_deg)) ** 2
        share = np.pi * (cos2[:-1] - cos2[1:]) / np.asarray(self.counts)
        return np.asarray(share[self.ring])

    @cached_property
    def solid_angle(self) -> Floats:
        """Of each patch [sr]; they sum to 2π."""
        cos = np.cos(np.radians(self.theta_deg))
        share = 2.0 * np.pi * (cos[:-1] - cos[1:]) / np.asarray(self.counts)
        return np.asarray(share[self.ring])

    @cached_property
    def bounds(self) -> Floats:
        """Polar angles and azimuths between which each patch lies, shape (patch, 4) [rad]: θ from, to, φ from, to."""
        edges, counts = np.radians(self.theta_deg), np.asarray(self.counts)[self.ring]
        step = 2.0 * np.pi / counts
        return np.stack(
            [edges[self.ring], edges[self.ring + 1], (self._bin - 0.5) * step, (self._bin + 0.5) * step], axis=1
        )

    @cached_property
    def centre_deg(self) -> Floats:
        """Polar angle and azimuth of each patch, shape (patch, 2) [degrees]; the innermost lies on the normal."""
        theta = 0.5 * (self.bounds[:, 0] + self.bounds[:, 1])
        theta[np.asarray(self.counts)[self.ring] == 1] = 0.0
        phi = self._bin * (2.0 * np.pi / np.asarray(self.counts)[self.ring])
        return np.degrees(np.stack([theta, phi], axis=1))

    @cached_property
    def centre(self) -> Floats:
        """(x, y) of the middle of each patch, shape (patch, 2)."""
        theta, phi = np.radians(self.centre_deg).T
        return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi)], axis=1)

    @cached_property
    def native(self) -> _native.KlemsBasis:
        """The compiled half."""
        if self.name in _LBNL_NAMES:
            return _native.KlemsBasis(self.name)
        return _native.KlemsBasis.of_rings(self.name, list(self.theta_deg[:-1]), list(self.counts))

    @cached_property
    def opposite(self) -> npt.NDArray[np.int64] | None:
        """Patch of (−x, −y) for each patch; None if a ring of several bins has an odd number of them."""
        counts = np.asarray(self.counts)
        if ((counts > 1) & (counts % 2 == 1)).any():
            return None
        first = np.concatenate([[0], np.cumsum(counts)[:-1]])[self.ring]
        count = counts[self.ring]
        return np.asarray(first + (self._bin + count // 2) % count)

    def find(self, x: npt.ArrayLike, y: npt.ArrayLike) -> npt.NDArray[np.int64]:
        """Patch that holds the direction of these components; both of one shape, x² + y² at most 1."""
        x, y = np.broadcast_arrays(np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64))
        theta = np.degrees(np.arcsin(np.clip(np.hypot(x, y), 0.0, 1.0)))
        ring = np.clip(np.searchsorted(self.theta_deg, theta, side="right") - 1, 0, len(self.counts) - 1)
        counts = np.asarray(self.counts)
        first = np.concatenate([[0], np.cumsum(counts)[:-1]])
        turn = np.arctan2(y, x) / (2.0 * np.pi)
        return np.asarray(first[ring] + np.floor(turn * counts[ring] + 0.5).astype(np.int64) % counts[ring])


@cache
def _known(name: str) -> KlemsBasis:
    rings = _native.KlemsBasis(name)
    edges = np.round(rings.theta_bounds_deg, 9)
    return KlemsBasis(name, (*edges[:, 0].tolist(), float(edges[-1, 1])), tuple(rings.counts))


def klems_basis(basis: str | KlemsBasis) -> KlemsBasis:
    """The basis of a name, or the basis itself.

    Raises
    ------
    ClerestoryError
        If no basis has that name.
    """
    if isinstance(basis, KlemsBasis):
        return basis
    return _known(one_of("basis", basis, KLEMS_BASES))


def basis_of_lbnl_name(name: str) -> KlemsBasis | None:
    """The usual basis that LBNL's files call so, whatever the capitals; None if there is none."""
    wanted = " ".join(name.split()).casefold()
    return next((_known(name) for name, lbnl in _LBNL_NAMES.items() if lbnl.casefold() == wanted), None)
