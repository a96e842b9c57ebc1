"""How well to compute a year."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class YearCalculation:
    """How well to compute: parameters of `daylight_coefficients`, `annual_sun_coefficients` and `annual_illuminance`.

    Parameters
    ----------
    basis : str, default "tregenza145"
        Patches of the sky; the sun is none of them.
    suns : str, default "exact"
        ``"exact"`` follows the sun of every sunlit interval; a name of a basis such as ``"troplux5221"`` those of its
        sectors that the sun passes, the nearest standing for each interval.
    rounds, nodes, window_samples, max_bounces, seed
        As in `daylight_coefficients`.
    sun_rounds, sun_nodes : int
        As in `sun_coefficients`.
    max_memory_mb : float, default 500
        Of the tables at work.
    """

    basis: str = "tregenza145"
    suns: str = "exact"
    rounds: int = 8
    nodes: int = 4096
    window_samples: int = 128
    sun_rounds: int = 4
    max_bounces: int | None = None
    seed: int = 0
    max_memory_mb: float = 500.0
