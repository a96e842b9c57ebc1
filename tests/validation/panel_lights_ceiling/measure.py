"""Specular light on floor and ceiling, pane against panel."""

from __future__ import annotations

from tests.validation.claim import Claim, Measured

from clerestory.coefficients import daylight_coefficients
from clerestory.glazing import Glass
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel
from clerestory.plots.style import blank, line_style, styled
from clerestory.room import Opening, Part, Room, SensorGrid

PANEL = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, medium=Medium(n=1.49))
GLASS = Glass(transmittance=0.88)
DEFLECTED = 0.9


def black_room(glazing: object) -> Room:
    """A black room with sensors on floor and ceiling."""
    return Room.shoebox(
        width_m=6.0,
        depth_m=12.0,
        height_m=3.0,
        floor=0.0,
        walls=0.0,
        ceiling=0.0,
        openings=[Opening(width_m=2.0, height_m=0.5, sill_m=1.2, parts=[Part(glazing=glazing)])],
        sensors=[
            SensorGrid(spacing_m=0.5, height_m=0.0, name="floor"),
            SensorGrid(spacing_m=0.5, height_m=0.0, surface="ceiling", flip=True, name="ceiling"),
        ],
    )


def deflected_share(altitude_deg: float, azimuth_deg: float) -> float:
    """Share of the light through the panel that leaves upwards, for sky light of a southern window."""
    around = azimuth_deg - 180.0
    if abs(around) >= 80.0:
        return 0.0
    lobes = PANEL.lobes(elevation_deg=altitude_deg, azimuth_deg=around)
    through = lobes.side.values == "back"
    up = lobes.elevation_deg.values > 0.0
    return float(lobes.power.values[through & up].sum() / lobes.power.values[through].sum())


def claim(thorough: bool) -> Claim:
    """What falls on ceiling and floor from the patches that the panel deflects."""
    measured, bars = [], {}
    for label, glazing in {"pane": GLASS, "panel": PANEL}.items():
        found = daylight_coefficients(black_room(glazing), basis="reinhart577", rounds=64 if thorough else 8, seed=10)
        chosen = [
            patch
            for patch, (high, around) in enumerate(
                zip(found.patch_altitude_deg.values[:-1], found.patch_azimuth_deg.values[:-1], strict=True)
            )
            if abs(around - 180.0) < 60.0
            and 40.0 < high < 75.0
            and min(deflected_share(high + step, around + turn) for step in (-3, 0, 3) for turn in (-4, 0, 4))
            > DEFLECTED
        ]
        specular = (found.direct + found.redirected).isel(patch=chosen).sum("patch")
        floor, ceiling = (float(specular[found.group.values == name].sum()) for name in ("floor", "ceiling"))
        share = ceiling / (floor + ceiling)
        bars[label] = (floor, ceiling)
        if label == "panel":
            measured.append(
                Measured(
                    f"panel: share of the specular light on the ceiling ({len(chosen)} patches)", share, 0.85, True
                )
            )
            redirected = float(found.redirected.isel(patch=chosen).sum() / specular.sum())
            measured.append(Measured("panel: share counted as redirected", redirected, 0.85, is_floor=True))
        else:
            measured.append(Measured("pane: share of the specular light on the ceiling", share, 0.0))
            measured.append(Measured("pane: redirected light", float(found.redirected.sum()), 0.0))
    with styled():
        figure = blank(5.0, 3.4)
        axes = figure.add_subplot()
        for row, (floor, ceiling) in enumerate(bars.values()):
            colour = line_style(row)["color"]
            axes.bar([row - 0.2, row + 0.2], [floor, ceiling], width=0.36, color=colour, alpha=0.85)
            axes.annotate("floor", (row - 0.2, floor), ha="center", va="bottom")
            axes.annotate("ceiling", (row + 0.2, ceiling), ha="center", va="bottom")
        axes.set_xticks(range(len(bars)), list(bars))
        axes.set(ylabel="Sum over sensors [sr]", title="Where the sky's light lands first")
    return Claim(measured, figure)
