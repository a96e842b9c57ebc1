"""Trees of elements without a preferred azimuth as Klems matrices."""

from __future__ import annotations

import itertools
import math

import numpy as np

from clerestory.bsdf.klems import Floats, KlemsBasis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.tree_block import TreeBlock

#: Polar angles at which each ring is asked, for the incident and for the outgoing light, evenly in sin²θ.
_INCIDENT, _OUTGOING = 6, 8
#: Steps of azimuth: at least this many, and for bins of odd numbers no more than that.
_LEAST_STEPS, _MOST_STEPS = 1440, 11_520


def of_isotropic(tree: TreeBlock, basis: KlemsBasis) -> KlemsBlock:
    """The mean of a tree of rank 3 over the patches of a basis.

    Light depends on the difference of azimuths alone, so that for each pair of rings one row of differences is asked,
    and patches are sums over ranges of it.
    """
    steps = _steps(basis)
    difference = 2.0 * np.pi * (np.arange(steps) + 0.5) / steps
    across = np.stack([np.cos(difference), np.sin(difference)], axis=-1)
    first = np.concatenate([[0], np.cumsum(basis.counts)])
    values: Floats = np.zeros((len(basis), len(basis)))
    for into, incoming in enumerate(basis.counts):
        for out, outgoing in enumerate(basis.counts):
            sines = _sines(basis, out, _OUTGOING)
            row = np.zeros(steps)
            for sine in _sines(basis, into, _INCIDENT):
                row += tree.at([sine, 0.0], sines[:, None, None] * across).mean(axis=0) / _INCIDENT
            # a difference of two midpoints of steps is a whole number of steps: the mean of its neighbours
            row = 0.5 * (row + np.roll(row, 1))
            part = _mean_over_bins(row, incoming, outgoing)
            values[first[out] : first[out + 1], first[into] : first[into + 1]] = part
    return KlemsBlock(values, basis, basis)


def _steps(basis: KlemsBasis) -> int:
    """Steps of azimuth that half a bin of every ring is a whole number of, if there are not too many."""
    common = math.lcm(*(2 * count for count in basis.counts))
    return min(common * -(-_LEAST_STEPS // common), _MOST_STEPS)


def _sines(basis: KlemsBasis, ring: int, count: int) -> Floats:
    low, high = np.sin(np.radians(basis.theta_deg[ring : ring + 2])) ** 2
    return np.asarray(np.sqrt(low + (np.arange(count) + 0.5) / count * (high - low)))


def _mean_over_bins(row: Floats, incoming: int, outgoing: int) -> Floats:
    """Mean of ``row[outgoing azimuth - incident azimuth]`` over pairs of bins, shape (outgoing, incoming)."""
    steps = len(row)
    doubled = np.concatenate([[0.0], np.cumsum(np.concatenate([row, row, row]))])
    start = np.rint((np.arange(outgoing) - 0.5) * steps / outgoing).astype(np.int64)
    end = np.rint((np.arange(outgoing) + 0.5) * steps / outgoing).astype(np.int64)
    azimuth = np.arange(steps) - round(0.5 * steps / incoming)
    shift = (start[:, None] - azimuth[None, :]) % steps
    mean = (doubled[shift + (end - start)[:, None]] - doubled[shift]) / (end - start)[:, None]
    bins = np.rint(np.arange(incoming + 1) * steps / incoming).astype(np.int64)
    return np.stack([mean[:, low:high].mean(axis=1) for low, high in itertools.pairwise(bins)], axis=1)
