"""How the light of one direction divides, with what the solver itself says it does not know."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from clerestory.panels import Panel

NAMES = ("transmitted", "reflected", "absorbed", "transmitted upwards", "transmitted downwards")
#: Of sums of some thousand terms of at most 1 in double precision.
ROUNDING = 1e-13
#: Rays by which the solver finishes what its budget left.
WALKED_RAYS = 4096


@dataclass(frozen=True)
class Accounts:
    """Shares in the order of NAMES, and the share that was not followed or moved along a facet."""

    shares: NDArray[np.float64]
    unknown: float


def accounts(panel: Panel, incidence: dict[str, object], **how: object) -> Accounts:
    """The accounts of all lobes of one direction."""
    lobes = panel.lobes(**incidence, **how)
    power, through = lobes.power.values, lobes.side.values != incidence["side"]
    up = lobes.elevation_deg.values > 0.0
    sums = [power[through].sum(), power[~through].sum(), lobes.attrs["absorbed"]]
    sums += [power[through & up].sum(), power[through & ~up].sum()]
    return Accounts(np.array(sums), unknown(lobes))


def unknown(lobes: xr.Dataset) -> float:
    """Residual, displaced power, and four standard errors of what a walk finished: of independent rays, at most."""
    walked = 4.0 * 0.5 * lobes.attrs["walked"] / np.sqrt(WALKED_RAYS)
    return float(lobes.attrs["residual"] + lobes.attrs["displaced"] + walked)


def disagreement(first: Accounts, second: Accounts) -> float:
    """Largest difference of two accounts that should be one, in units of what both say they do not know."""
    return float(np.abs(first.shares - second.shares).max() / (first.unknown + second.unknown + ROUNDING))
