"""Estimates of the same coefficients, pooled, with the standard error of what they say together."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

#: Batches that are kept apart: their scatter is the standard error.
MOST_BATCHES = 16


@dataclass(frozen=True, eq=False)
class Batch:
    """One independent estimate, or several that were merged.

    Attributes
    ----------
    parts : array of shape (part, sensor, patch or sun)
    weight : float
        In proportion to the work that went into it, and so to one over its variance.
    judged, judged_variance : array of shape (sensor,)
        One weighted sum of the parts, and the variance of its mean as the rounds within the batch scatter.
    rounds : int
    """

    parts: npt.NDArray[Any]
    weight: float
    judged: Array
    judged_variance: Array
    rounds: int

    def merged(self, other: Batch) -> Batch:
        """Both as one."""
        weight = self.weight + other.weight
        a, b = self.weight / weight, other.weight / weight
        return Batch(
            (a * self.parts + b * other.parts).astype(self.parts.dtype),
            weight,
            a * self.judged + b * other.judged,
            a**2 * self.judged_variance + b**2 * other.judged_variance,
            self.rounds + other.rounds,
        )


class Pool:
    """Independent batches; the mean of them weighed by their work.

    Notes
    -----
    With shares :math:`w_j` of the weight the variance of the mean :math:`\\bar x` is estimated by
    :math:`\\sum_j w_j^2 (x_j - \\bar x)^2 / (1 - w_j)`, which is without bias where the variance of a batch is in
    inverse proportion to its weight, as it is of rounds (theory/room.md, eq. 15).
    """

    def __init__(self, batches: tuple[Batch, ...] = (), passes: int = 0, cpu_seconds: float = 0.0) -> None:
        self.batches, self.passes, self.cpu_seconds = batches, passes, cpu_seconds

    def with_batch(self, batch: Batch, cpu_seconds: float) -> Pool:
        """The pool with one more batch; the two lightest neighbours become one where there are too many."""
        batches = [*self.batches, batch]
        if len(batches) > MOST_BATCHES:
            pairs = [one.weight + other.weight for one, other in pairwise(batches)]
            k = int(np.argmin(pairs))
            batches[k : k + 2] = [batches[k].merged(batches[k + 1])]
        return Pool(tuple(batches), self.passes + 1, self.cpu_seconds + cpu_seconds)

    @property
    def rounds(self) -> int:
        """Of all batches."""
        return sum(one.rounds for one in self.batches)

    @property
    def shares(self) -> Array:
        """Of each batch in the mean."""
        weights = np.array([one.weight for one in self.batches])
        return np.asarray(weights / weights.sum())

    @property
    def nbytes(self) -> int:
        """Memory of the batches."""
        return sum(one.parts.nbytes for one in self.batches)

    def parts(self) -> Array:
        """Mean parts, as they are in the batches."""
        return np.asarray(sum(w * one.parts for w, one in zip(self.shares, self.batches, strict=True)), dtype=float)

    def each(self, vector: Any) -> Array:
        """Parts of every batch times a vector over the last axis, such as luminances: (batch, part, sensor)."""
        found = [one.parts @ np.asarray(vector, dtype=one.parts.dtype) for one in self.batches]
        return np.stack(found).astype(np.float64)

    def judged(self) -> tuple[Array, Array]:
        """The judged sum and its standard error, from the scatter of all rounds within their batches."""
        shares = self.shares
        mean = sum(w * one.judged for w, one in zip(shares, self.batches, strict=True))
        variance = sum(w**2 * one.judged_variance for w, one in zip(shares, self.batches, strict=True))
        return np.asarray(mean), np.sqrt(np.asarray(variance))


def scatter(each: Array, shares: Array) -> Array:
    """Standard error of the mean of estimates (batch, sensor), NaN of one alone (theory/room.md, eq. 15)."""
    if len(each) < 2:
        return np.full(each.shape[1:], np.nan)
    mean = np.tensordot(shares, each, axes=1)
    return np.asarray(np.sqrt(np.tensordot(shares**2 / (1.0 - shares), (each - mean) ** 2, axes=1)))


def relative(error: Array, mean: Array) -> tuple[float, float]:
    """Worst and mean relative error of sensors that get light; 0 where none does."""
    lit = mean > 1e-9 * max(float(mean.max(initial=0.0)), 1e-300)
    if not lit.any():
        return 0.0, 0.0
    share = error[lit] / mean[lit]
    return float(share.max()), float(share.mean())
