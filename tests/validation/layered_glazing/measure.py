"""Shares of layers of clear glass against pywincalc."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from tests.validation.claim import Claim, Measured
from tests.validation.layered_glazing.wincalc import wincalc

from clerestory import Gap, Pane, Stack, measured_glass
from clerestory.plots.style import COLOURS, blank, degrees, styled
from clerestory.spectrum import luminous_efficiency, photopic_mean

DATA = Path(__file__).parents[2] / "data"
SYSTEMS = {"double, 3 + 6 mm": ("CLEAR_3", "CLEAR_6"), "triple, 6 + 3 + 6 mm": ("CLEAR_6", "CLEAR_3", "CLEAR_6")}
THETA_DEG = (0.0, 30.0, 45.0, 60.0, 70.0, 80.0)
Floats = NDArray[np.float64]


def stack_of(files: tuple[str, ...]) -> Stack:
    """Panes of the glass of each file, with air between."""
    layers: list[Pane | Gap] = []
    for file in files:
        glass = measured_glass(DATA / f"{file}.DAT")
        layers += [Gap(width_mm=12.7), Pane(thickness_mm=glass.thickness_mm, medium=glass.medium())]
    return Stack(layers[1:])


def visible(stack: Stack, theta_deg: object, polarisation: str) -> Floats:
    """T, R and the absorptance of each layer, shape (share, theta)."""
    wavelength_nm = luminous_efficiency()[0]
    return np.array(
        [photopic_mean(wavelength_nm, row) for row in shares(stack, theta_deg, wavelength_nm, polarisation)]
    )


def solar(stack: Stack, source: list[list[float]]) -> Floats:
    """The same weighed by sunlight: trapezia on the wavelengths of the source, as the standard has it."""
    nm, power = (np.array(column) for column in source)
    within = (nm >= 315.0) & (nm <= 2500.0)
    nm, power = nm[within], power[within]
    rows = shares(stack, THETA_DEG, nm, "averaged")
    return np.asarray(np.trapezoid(rows * power, nm) / np.trapezoid(power, nm))


def shares(stack: Stack, theta_deg: object, wavelength_nm: Floats, polarisation: str) -> Floats:
    """Shape (share, theta, wavelength)."""
    found = stack.angular(elevation_deg=theta_deg, wavelength_nm=wavelength_nm, polarisation=polarisation)
    rows = [found.transmittance.values, found.reflectance.values, *found.layer_absorptance.values]
    return np.array(rows)[:, :, 0, :]


def theirs(rows: list[dict[str, object]]) -> Floats:
    """The same of pywincalc."""
    table = [
        [row["front"]["transmission direct_direct"], row["front"]["reflection direct_direct"], *row["absorptance"]]
        for row in rows
    ]
    return np.array(table).T


def claim(thorough: bool) -> Claim:
    """Largest difference of each share, and the cost of forgetting polarisation."""
    measured, fine = [], np.arange(0.0, 89.5, 2.0 if thorough else 10.0)
    with styled():
        figure = blank(6.0, 4.0)
        axes = figure.add_subplot()
        for number, (name, files) in enumerate(SYSTEMS.items()):
            stack = stack_of(files)
            paths = [str(DATA / f"{file}.DAT") for file in files]
            answer = wincalc({"layers": paths, "theta_deg": THETA_DEG, "methods": ["PHOTOPIC", "SOLAR"]})
            reference = theirs(answer["PHOTOPIC"])
            for band, ours, expected, limit in (
                ("visible", visible(stack, THETA_DEG, "averaged"), reference, 3e-5),
                ("solar", solar(stack, answer["source"]), theirs(answer["SOLAR"]), 5e-4),
            ):
                off = np.abs(ours - expected)
                measured.append(Measured(f"{name}, {band}: T and R", float(off[:2].max()), limit))
                measured.append(Measured(f"{name}, {band}: absorptance of each layer", float(off[2:].max()), limit))
            resolved, averaged = (visible(stack, 70.0, word)[0, 0] for word in ("resolved", "averaged"))
            cost, floor = float(resolved - averaged), 0.02 * (len(files) - 1)
            measured.append(Measured(f"{name}: T at 70° lost by averaging", cost, floor, is_floor=True))
            colour = COLOURS[number]
            axes.plot(fine, visible(stack, fine, "resolved")[0], color=colour, label=f"{name}, resolved")
            axes.plot(fine, visible(stack, fine, "averaged")[0], color=colour, linestyle="--", label="averaged")
            axes.plot(THETA_DEG, reference[0], "o", color=colour, markersize=4, markerfacecolor="white")
        axes.plot([], [], "o", color=COLOURS[-1], markersize=4, markerfacecolor="white", label="pywincalc")
        axes.set(xlabel="Angle of incidence", ylabel="Visible transmittance", ylim=(0, 1))
        axes.set_title("Clear double and triple glazing")
        degrees(axes.xaxis, 15.0)
        axes.legend(fontsize="small")
    return Claim(measured, figure)
