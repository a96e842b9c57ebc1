"""The closed-form series of an ideal laser-cut panel, for light in the plane across the cuts."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def fresnel(incidence_deg: float, n: float) -> tuple[NDArray[np.float64], float]:
    """Reflectances of s and p light from the air, and the angle inside."""
    i = np.radians(incidence_deg)
    r = np.arcsin(np.sin(i) / n)
    if incidence_deg == 0.0:
        return np.full(2, ((n - 1.0) / (n + 1.0)) ** 2), 0.0
    return np.array([np.sin(i - r) / np.sin(i + r), np.tan(i - r) / np.tan(i + r)]) ** 2, float(r)


def triangle(x: NDArray[np.float64]) -> NDArray[np.float64]:
    """0 at 0, 2, 4 …, 1 at 1, 3, 5 …"""
    return 1.0 - np.abs(np.mod(x, 2.0) - 1.0)


def series(incidence_deg: float, n: float, d_over_w: float, polarisation: str) -> NDArray[np.float64]:
    """T undeflected, T deflected, R specular, R sent back where it came from."""
    reflectances, r = fresnel(incidence_deg, n)
    if polarisation == "averaged":
        reflectances = np.array([reflectances.mean()])
    x, k = np.tan(r) / d_over_w, np.arange(4000)
    odd, even = triangle((2 * k + 1) * x), triangle((2 * k + 2) * x)
    shares = []
    for reflectance in reflectances:
        through = (1.0 - reflectance) ** 2 * reflectance ** (2 * k)
        back = through * reflectance
        shares.append(
            [
                (through * (1.0 - odd)).sum(),
                (through * odd).sum(),
                reflectance + (back * (1.0 - even)).sum(),
                (back * even).sum(),
            ]
        )
    return np.mean(shares, axis=0)
