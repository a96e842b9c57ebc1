"""Transmitted sunlight of a prismatic window in EnergyPlus against its matrices."""

from __future__ import annotations

import tempfile
import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from tests.bsdf.panels_as_matrices import BASIS, prism, upside_down
from tests.validation.claim import Claim, Measured
from tests.validation.energyplus_shoebox.shoebox import WINDOW_AREA_M2, run

from clerestory.bsdf import Band, Bsdf, BsdfWarning, KlemsBlock, energyplus_objects
from clerestory.plots.style import COLOURS, blank, degrees, styled

Floats = NDArray[np.float64]
SOLAR_SHARE = 0.8
EDGE_DEG = 1.0


def element(is_upside_down: bool) -> Bsdf:
    """The prism, its solar band weaker than the visible one."""
    band = upside_down(prism().visible) if is_upside_down else prism().visible
    solar = Band(*(KlemsBlock(SOLAR_SHARE * block.values) for _, block in band))
    return Bsdf(name="prism", visible=band, solar=solar, thickness_mm=3.0)


def travel(altitude_deg: Floats, azimuth_deg: Floats) -> Floats:
    """Way of sunlight in the axes of a south window, shape (time, 3): x is west, to the right as seen from inside."""
    h, a = np.radians(altitude_deg), np.radians(azimuth_deg)
    east, north, up = np.sin(a) * np.cos(h), np.cos(a) * np.cos(h), np.sin(h)
    return np.stack([east, -up, -north], axis=1)


def is_well_inside(way: Floats) -> NDArray[np.bool_]:
    """Whether light from a degree beside comes through the same patch."""
    patch, inside = BASIS.find(way[:, 0], way[:, 1]), np.ones(len(way), dtype=bool)
    for turn in np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False):
        beside = way[:, :2] + np.radians(EDGE_DEG) * np.array([np.cos(turn), np.sin(turn)])
        inside &= (np.hypot(*beside.T) < 1.0) & (
            BASIS.find(*(beside / np.maximum(1.0, np.hypot(*beside.T)[:, None])).T) == patch
        )
    return inside


def from_above(values: Floats) -> float:
    """Share of an even sky that passes: patches in which light travels down or level, as EnergyPlus counts them."""
    solid = BASIS.projected_solid_angle * (BASIS.centre[:, 1] < 1e-9)
    return float(BASIS.projected_solid_angle @ values @ solid / solid.sum())


def transmitted(is_upside_down: bool) -> dict[str, Floats]:
    """Transmittances of the sun at steps where it is well inside a patch, by both programs; the same of the sky."""
    bsdf = element(is_upside_down)
    with warnings.catch_warnings(), tempfile.TemporaryDirectory() as folder:
        # heat is not asked about
        warnings.simplefilter("ignore", BsdfWarning)
        found = {name: np.array(row) for name, row in run(energyplus_objects(bsdf), bsdf.name, Path(folder)).items()}
    way = travel(found["altitude"], found["azimuth"])
    front = bsdf.solar.transmission_front
    sunny = (found["beam"] > 1.0) & (way[:, 2] > 0.05) & is_well_inside(way)
    cloudy = found["sky"] > 1.0
    return {
        "altitude": found["altitude"][sunny],
        "theirs": (found["through"] / WINDOW_AREA_M2)[sunny] / found["beam"][sunny],
        "ours": front.hemispherical_at(way[sunny, :2]),
        "cosine": np.abs(found["cosine"] - way[:, 2])[sunny],
        "sky": (found["through"] / WINDOW_AREA_M2)[cloudy] / found["sky"][cloudy],
        "sky ours": np.array(from_above(front.values)),
        "sky transposed": np.array(from_above(front.values.T)),
    }


def claim(thorough: bool) -> Claim:
    """Largest differences over all steps of six days, upright and upside down."""
    measured, runs = [], [transmitted(False), transmitted(True)]
    with styled():
        figure = blank(6.0, 3.8)
        axes = figure.add_subplot()
        for held, found, colour in zip(("upright", "upside down"), runs, COLOURS, strict=False):
            off = float(np.abs(found["theirs"] - found["ours"]).max())
            measured.append(Measured(f"{held}: sun's transmittance, largest of {len(found['ours'])} steps", off, 1e-6))
            sky = float(np.abs(found["sky"] - found["sky transposed"]).max())
            measured.append(Measured(f"{held}: sky's transmittance by the transposed matrix", sky, 1e-6))
            wrong = float(np.abs(found["sky"] - found["sky ours"]).min())
            measured.append(Measured(f"{held}: what the transposition does to it", wrong, 0.02, is_floor=True))
            axes.plot(
                found["altitude"], found["ours"], "o", color=colour, markersize=6, markerfacecolor="white", label=held
            )
            axes.plot(found["altitude"], found["theirs"], ".", color=colour, markersize=4)
        axes.plot([], [], ".", color=COLOURS[-1], label="EnergyPlus")
        axes.set(xlabel="Altitude of the sun", ylabel="Solar transmittance", ylim=(0.0, 0.8))
        axes.set_title("A prismatic window in EnergyPlus")
        degrees(axes.xaxis, 15.0)
        axes.legend()
    upright, turned = runs
    change = float(np.abs(upright["ours"] - turned["ours"]).max())
    measured.append(Measured("held upside down: largest change", change, 0.1, is_floor=True))
    measured.append(Measured("cosine of incidence, largest difference", float(upright["cosine"].max()), 1e-3))
    return Claim(measured, figure)
