"""Klems matrices of panels by plain sampling of their beams, and what turning the element round does to them.

Coarse, and that does no harm: what is asked here is whether two programs do the same with the same matrices.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from clerestory import LaserCutPanel, Medium, PrismaticPanel
from clerestory.bsdf import Band, Bsdf, KlemsBlock
from clerestory.bsdf.klems import klems_basis
from clerestory.panels import Panel

BASIS = klems_basis("klems_full")
ACRYLIC = Medium(n=1.49)


@cache
def laser_cut() -> Bsdf:
    """A laser-cut panel with cuts of no width: it throws light from above up."""
    panel = LaserCutPanel(spacing_mm=4.0, thickness_mm=3.0, cut_width_mm=0.0, medium=ACRYLIC)
    return bsdf_of_beams(panel, "laser-cut panel", side=2)


@cache
def prism() -> Bsdf:
    """A prismatic sheet whose facets and sides are all different."""
    panel = PrismaticPanel(pitch_mm=10.0, lower_deg=70.0, upper_deg=35.0, base_mm=2.0, ridges="back", medium=ACRYLIC)
    return bsdf_of_beams(panel, "prism", side=2)


def bsdf_of_beams(panel: Panel, name: str, *, side: int) -> Bsdf:
    """Beams of ``side`` times ``side`` directions in each incident patch, put into the patches they leave into."""
    glazing, solid = panel.glazing(), BASIS.projected_solid_angle
    sums = {word: np.zeros((len(BASIS), len(BASIS))) for word in ("tf", "tb", "rf", "rb")}
    share = (np.arange(side) + 0.5) / side
    for patch, (theta_low, theta_high, phi_low, phi_high) in enumerate(BASIS.bounds):
        low, high = np.sin(theta_low) ** 2, np.sin(theta_high) ** 2
        for sine2 in low + share * (high - low):
            for phi in phi_low + share * (phi_high - phi_low):
                x, y = np.sqrt(sine2) * np.cos(phi), np.sqrt(sine2) * np.sin(phi)
                for word, z in (("f", 1.0), ("b", -1.0)):
                    incident = np.array([[x, y, z * np.sqrt(1.0 - sine2)]])
                    directions, powers, *_ = glazing.lobes(incident)
                    into = BASIS.find(directions[:, 0], directions[:, 1])
                    goes_on = directions[:, 2] * z > 0.0
                    np.add.at(sums["t" + word][:, patch], into[goes_on], powers[goes_on])
                    np.add.at(sums["r" + word][:, patch], into[~goes_on], powers[~goes_on])
    tf, tb, rf, rb = (KlemsBlock(sums[word] / side**2 / solid[:, None]) for word in ("tf", "tb", "rf", "rb"))
    # sampled from both sides: the mean of the two ways along each path is reciprocal, as light is
    both = KlemsBlock(0.5 * (tf.values + tb.reversed().values))
    blocks = (both, both.reversed(), rf, rb)
    # no column of so coarse a mean may send away more than it gets
    most = max((t.hemispherical() + r.hemispherical()).max() for t, r in (blocks[::2], blocks[1::2]))
    band = Band(*(KlemsBlock(block.values / max(most, 1.0)) for block in blocks))
    return Bsdf(name=name, visible=band, solar=band, thickness_mm=3.0)


def upside_down(band: Band) -> Band:
    """The element turned by half a turn about its normal."""
    turned = BASIS.opposite
    return Band(*(KlemsBlock(block.values[np.ix_(turned, turned)]) for _, block in band))


def inside_out(band: Band) -> Band:
    """The element turned by half a turn about its upright axis: front is back, and x is -x."""
    across = BASIS.find(-BASIS.centre[:, 0], BASIS.centre[:, 1])

    def mirrored(block: KlemsBlock) -> KlemsBlock:
        return KlemsBlock(block.values[np.ix_(across, across)])

    tf, tb, rf, rb = (block for _, block in band)
    return Band(mirrored(tb), mirrored(tf), mirrored(rb), mirrored(rf))


def travel(altitude_deg: float, azimuth_deg: float) -> NDArray[np.float64]:
    """Way of sunlight that comes down at an altitude, and from the left (azimuth above 0 travels towards +x)."""
    h, a = np.radians(altitude_deg), np.radians(azimuth_deg)
    return np.array([np.cos(h) * np.sin(a), -np.sin(h), np.cos(h) * np.cos(a)])
