"""Sun coefficients behind a pane against the closed form."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from tests.validation.claim import Claim, Measured

from clerestory.glazing import Slab
from clerestory.plots.style import blank, line_style, styled
from clerestory.room import Material, Room, Sensors, Surface, Window
from clerestory.sun import SUN_DIAMETER_DEG, direction_of
from clerestory.sun_coefficients import sun_coefficients

Array = NDArray[np.float64]
N = 1.52


def transmittance(cos_i: Array) -> Array:
    """Of a slab that absorbs nothing, unpolarised light."""
    cos_t = np.sqrt(1.0 - (1.0 - cos_i**2) / N**2)
    r_s = ((cos_i - N * cos_t) / (cos_i + N * cos_t)) ** 2
    r_p = ((N * cos_i - cos_t) / (N * cos_i + cos_t)) ** 2
    return (1.0 - r_s) / (1.0 + r_s) / 2.0 + (1.0 - r_p) / (1.0 + r_p) / 2.0


def over_the_disc(sun: Array) -> float:
    """τ cos θ_s, the sensor facing the sun, as the mean over the disc."""
    side = np.cross(sun, [0.0, 0.0, 1.0])
    side /= np.linalg.norm(side)
    up = np.cross(side, sun)
    radius = np.radians(SUN_DIAMETER_DEG) / 2.0 * np.sqrt((np.arange(40) + 0.5) / 40)
    turn = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
    across, along = np.outer(radius, np.cos(turn)).ravel(), np.outer(radius, np.sin(turn)).ravel()
    towards = sun + across[:, None] * side + along[:, None] * up
    towards /= np.linalg.norm(towards, axis=1)[:, None]
    # the window's normal is −y; light from behind it does not come in
    return float(np.mean(transmittance(np.maximum(-towards[:, 1], 0.0)) * (towards @ sun)))


def behind_pane(sun: Array) -> Room:
    """A wall with a window 2 × 2 m and one sensor a hand behind its middle, on the sun's beam and facing it."""
    window = [(1.0, 0.0, -1.0), (-1.0, 0.0, -1.0), (-1.0, 0.0, 1.0), (1.0, 0.0, 1.0)]
    wall = [(9.0, 0.0, -9.0), (-9.0, 0.0, -9.0), (-9.0, 0.0, 9.0), (9.0, 0.0, 9.0)]
    pane = Slab(refractive_index=N, thickness_mm=6.0)
    return Room(
        surfaces=(Surface(name="wall", outline_m=wall, holes_m=[window], material=Material(diffuse_reflectance=0.0)),),
        windows=(Window(name="pane", outline_m=window, glazing=pane),),
        sensors=(Sensors(points_m=[-0.1 * sun], normals=[sun]),),
    )


def claim(thorough: bool) -> Claim:
    """Altitudes at two azimuths."""
    altitudes = np.arange(1.0, 89.0, 1.0 if thorough else 5.0)
    off: dict[str, list[float]] = {"steep": [], "glancing": []}
    curves = {}
    for around in (0.0, 50.0):
        found, exact = [], []
        for altitude in altitudes:
            sun = direction_of(altitude, 180.0 + around)
            traced = sun_coefficients(
                behind_pane(sun), altitude_deg=altitude, azimuth_deg=180.0 + around, rounds=256, seed=12
            )
            found.append(float(traced.direct[0, 0]))
            exact.append(over_the_disc(sun))
            glancing = np.degrees(np.arccos(-sun[1])) > 80.0
            off["glancing" if glancing else "steep"].append(abs(found[-1] / exact[-1] - 1.0))
        curves[f"{around:.0f}° off the normal"] = (found, exact)
    with styled():
        figure = blank(6.2, 3.8)
        axes = figure.add_subplot()
        for row, (label, (found, exact)) in enumerate(curves.items()):
            style = line_style(row)
            axes.plot(altitudes, exact, label=label, **style)
            axes.plot(altitudes, found, "o", markersize=3, color=style["color"])
        axes.set(xlabel="Sun altitude [°]", ylabel="Share of the normal illuminance")
        axes.set_title("Sun through a pane: lines closed form, dots traced")
        axes.legend()
    return Claim(
        [
            Measured("incidence up to 80°: largest deviation, relative", max(off["steep"]), 0.002),
            Measured("incidence above 80°: largest deviation, relative", max(off["glancing"]), 0.01),
        ],
        figure,
    )
