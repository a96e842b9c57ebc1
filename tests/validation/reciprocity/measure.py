"""Shares there and back over random panels and directions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from tests.validation.accounts import ROUNDING, unknown
from tests.validation.claim import Claim, Measured
from tests.validation.random_panels import random_incidence, random_panel

from clerestory.panels import Pane
from clerestory.panels.incidence import incident_directions
from clerestory.plots.style import COLOURS, FAINT, blank, styled

_STEP = 1e-5
_GRAZING = np.sin(np.radians(5.0))


def _vector(incidence):
    elevation, azimuth = np.array(incidence["elevation_deg"]), np.array(incidence["azimuth_deg"])
    return incident_directions(elevation, azimuth, incidence["side"])


def _incidence(vector):
    """The words for light that travels along a vector."""
    return {
        "elevation_deg": float(np.degrees(np.arcsin(np.clip(-vector[1], -1.0, 1.0)))),
        "azimuth_deg": float(np.degrees(np.arctan2(vector[0], abs(vector[2])))),
        "side": "front" if vector[2] > 0.0 else "back",
    }


def _raised(vector, step):
    """The same k_x, another k_y."""
    y = vector[1] + step
    return np.array([vector[0], y, np.sign(vector[2]) * np.sqrt(max(1.0 - vector[0] ** 2 - y**2, 0.0))])


def _lobes(panel, vector, **how):
    return panel.lobes(**_incidence(vector), **how)


def _widening(panel, vector, lobe, how):
    """|dk_y,o / dk_y,i| of one lobe; None if it is not there on both sides of the direction."""
    found = []
    for step in (-_STEP, _STEP):
        lobes = _lobes(panel, _raised(vector, step), **how)
        near = lobes.direction.values - lobe
        close = np.flatnonzero(np.linalg.norm(near, axis=1) < 20.0 * _STEP)
        if close.size != 1:
            return None
        found.append(lobes.direction.values[close[0], 1])
    return abs(found[1] - found[0]) / (2.0 * _STEP)


@dataclass(frozen=True)
class Pair:
    """A lobe there and back."""

    there: float
    back: float
    unknown: float
    is_ideal: bool
    keeps_width: bool


def _pairs(panel, vector, polarisation):
    """The strongest lobes of one direction, followed back."""
    keeps_width = isinstance(panel, Pane) or getattr(panel, "cut_tilt_deg", 1.0) == 0.0
    is_ideal = keeps_width and getattr(panel, "cut_width_mm", 0.0) == 0.0 and panel.medium.n > np.sqrt(2.0)
    how = {"polarisation": polarisation, "tolerance": 1e-10 if is_ideal else 1e-5}
    lobes = _lobes(panel, vector, **how)
    for lobe, power in zip(lobes.direction.values[:2], lobes.power.values[:2], strict=True):
        if abs(lobe[2]) < _GRAZING or abs(vector[2]) < _GRAZING or power < 1e-4:
            continue
        factor = 1.0 if keeps_width else _widening(panel, vector, lobe, how)
        if factor is None:
            continue
        sent_back = _lobes(panel, -lobe, **how)
        away = np.linalg.norm(sent_back.direction.values + vector, axis=1)
        back = factor * float(sent_back.power.values[away < 1e-6].sum())
        not_known = unknown(lobes) + factor * unknown(sent_back) + ROUNDING + (0.0 if keeps_width else 1e-7)
        yield Pair(float(power), back, not_known, is_ideal, keeps_width)


def claim(thorough: bool) -> Claim:
    """Random panels, followed there and back."""
    rng = np.random.default_rng(21)
    pairs: list[Pair] = []
    for i in range(60 if thorough else 20):
        polarisation = "resolved" if i % 2 else "averaged"
        pairs += _pairs(random_panel(rng), _vector(random_incidence(rng)), polarisation)
    with styled():
        figure = blank(5.2, 4.6)
        axes = figure.add_subplot()
        axes.plot([0, 1], [0, 1], color=FAINT, linewidth=0.8)
        for number, word in enumerate(("prisms and tilted cuts", "parallel faces, perpendicular cuts")):
            chosen = [p for p in pairs if p.keeps_width == bool(number)]
            there, back = [p.there for p in chosen], [p.back for p in chosen]
            axes.plot(there, back, "o" if number else "s", color=COLOURS[number], markersize=4, label=word)
        axes.set(xlabel="Share there", ylabel="Share back × |dk_y,o / dk_y,i|", title="Reciprocity")
        axes.legend()
    ideal = [abs(p.there - p.back) for p in pairs if p.is_ideal]
    ratio = [abs(p.there - p.back) / p.unknown for p in pairs]
    return Claim(
        [
            Measured(f"difference over what is not known, {len(pairs)} lobes", max(ratio), 1.0),
            Measured(f"ideal cuts and panes: largest difference, {len(ideal)} lobes", max(ideal), 1e-9),
            Measured("prisms and tilted cuts: lobes compared", sum(not p.keeps_width for p in pairs), 5, is_floor=True),
        ],
        figure,
    )
