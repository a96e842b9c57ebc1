"""What the patches of a BSDF file do to a panel's sun patch: python examples/bsdf_sun_patch.py --out out

A laser-cut panel stands high in a window and throws the winter sun on the ceiling. The light that comes straight from
the panel is reckoned three times: with the panel's exact beams, with its Klems matrix and with its tensor tree, as they
stand in files for other programs. Nothing is reflected in the room, so that the patch is all there is to see.
"""

import argparse
from pathlib import Path

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from clerestory import Bsdf, LaserCutPanel
from clerestory.bsdf.shirley_chiu import square_to_disc
from clerestory.plots.style import HAIR, blank, heading, line_style, styled
from clerestory.saving import write_whole

PANEL = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0)
SUN_LX, SUN_ALTITUDE_DEG, SUN_AZIMUTH_DEG = 60_000.0, 17.0, 20.0
"""Normal illuminance; altitude, and azimuth about the vertical, of the light on the panel."""
WINDOW_M = (2.0, 2.2, 2.8)
"""Width of the window, sill and head."""
ROOM_M = (5.0, 5.0, 3.0)
"""Width and depth of the room, height of the ceiling."""
STEP_M = 0.05
FINE = 512
"""Directions a side of the square that the tables are asked at."""
BRIGHT_LX = 1000.0


def sun_on_the_panel() -> tuple[np.ndarray, float]:
    """Direction in which the sunlight travels, in the panel's axes, and the illuminance on the panel."""
    e, a = np.radians(SUN_ALTITUDE_DEG), np.radians(SUN_AZIMUTH_DEG)
    direction = np.array([np.sin(a) * np.cos(e), -np.sin(e), np.cos(a) * np.cos(e)])
    return direction, SUN_LX * direction[2]


def ceiling() -> np.ndarray:
    """Points of the ceiling in the panel's axes, x to the right and z into the room, shape (x, z, 3)."""
    x = np.arange(-ROOM_M[0] / 2.0 + STEP_M / 2.0, ROOM_M[0] / 2.0, STEP_M)
    z = np.arange(STEP_M / 2.0, ROOM_M[1], STEP_M)
    x, z = np.meshgrid(x, z, indexing="ij")
    return np.stack([x, np.full_like(x, ROOM_M[2]), z], axis=-1)


def exact_beams() -> tuple[np.ndarray, np.ndarray]:
    """Directions of the beams that the panel makes of the sunlight, and their shares of its power."""
    incident, _ = sun_on_the_panel()
    directions, powers, *_ = PANEL.glazing().lobes(incident[None])
    return directions, powers


def blurred_beams(bsdf: Bsdf) -> tuple[np.ndarray, np.ndarray]:
    """Likewise of a BSDF's tables: many beams of one projected solid angle each, where there is light."""
    incident, _ = sun_on_the_panel()
    u = (np.arange(FINE) + 0.5) / FINE
    xy = square_to_disc(np.stack(np.meshgrid(u, u, indexing="ij"), axis=-1).reshape(-1, 2))
    out = np.column_stack([xy, np.sqrt(np.maximum(0.0, 1.0 - (xy**2).sum(axis=1)))])
    values = bsdf.blurred_glazing().bsdf(np.broadcast_to(incident, out.shape).copy(), out)
    return out[values > 0.0], values[values > 0.0] * np.pi / FINE**2


def illuminance(beams: tuple[np.ndarray, np.ndarray], points: np.ndarray) -> np.ndarray:
    """On the ceiling, of the beams that come through the window [lx]."""
    _, on_the_panel = sun_on_the_panel()
    total = np.zeros(points.shape[:-1])
    for direction, power in zip(*beams, strict=True):
        if direction[2] > 0.0 and direction[1] > 0.0:
            start = points - direction * (points[..., 2:] / direction[2])
            beside, above = np.abs(start[..., 0]) < WINDOW_M[0] / 2.0, start[..., 1] > WINDOW_M[1]
            through = beside & above & (start[..., 1] < WINDOW_M[2])
            # what falls on 1 m² of the window falls on direction z / direction y of the ceiling
            total += np.where(through, on_the_panel * power * direction[1] / direction[2], 0.0)
    return total


def figure(found: dict[str, np.ndarray]) -> Figure:
    """Plans of the ceiling, the window at the bottom, and a cut along the room."""
    with styled():
        drawn = blank(3.1 * len(found) + 3.6, 3.9)
        axes = drawn.subplots(1, len(found) + 1, width_ratios=[*[1.0] * len(found), 1.25])
        norm = LogNorm(10.0, max(values.max() for values in found.values()))
        half = ROOM_M[0] / 2.0
        for number, (place, (name, values)) in enumerate(zip(axes, found.items(), strict=False)):
            picture = place.imshow(
                np.maximum(values, 1.0).T,
                origin="lower",
                extent=(-half, half, 0.0, ROOM_M[1]),
                cmap="cividis",
                norm=norm,
            )
            bright = (values > BRIGHT_LX).sum() * STEP_M**2
            place.set_title(
                f"{name}\n{values.sum() * STEP_M**2:.0f} lm, {bright:.1f} m² above {BRIGHT_LX:,.0f} lx", fontsize=9
            )
            place.plot([-WINDOW_M[0] / 2, WINDOW_M[0] / 2], [0.03, 0.03], color="white", linewidth=3)
            place.set(xlabel="across the room [m]", ylabel="from the window [m]" if number == 0 else "")
            place.grid(visible=False)
        bar = drawn.colorbar(picture, ax=axes[len(found) - 1], shrink=0.8)
        bar.set_label("Illuminance of the ceiling [lx]")
        bar.outline.set_visible(False)
        depth = np.arange(STEP_M / 2.0, ROOM_M[1], STEP_M)
        for number, (name, values) in enumerate(found.items()):
            # the row on which the exact patch is centred
            row = int(np.argmax(found["exact panel"].sum(axis=1)))
            axes[-1].plot(depth, values[row], label=name, **line_style(number))
        axes[-1].set(xlabel="from the window [m]", ylabel="along the brightest row [lx]", ylim=(0.0, None))
        axes[-1].grid(color=HAIR)
        axes[-1].legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), fontsize=8)
        heading(drawn, "The same panel, exact and as files: light straight from the panel on the ceiling")
    return drawn


def main(out: Path) -> None:
    points = ceiling()
    klems, tree = PANEL.bsdf(), PANEL.bsdf(rank=4, log2_resolution=5)
    found = {
        "exact panel": illuminance(exact_beams(), points),
        "Klems matrix, 145 patches": illuminance(blurred_beams(klems), points),
        "tensor tree, 2⁵": illuminance(blurred_beams(tree), points),
    }
    written = [
        klems.to_xml(out / "bsdf_sun_patch.xml"),
        write_whole(out / "bsdf_sun_patch.png", lambda draft: figure(found).savefig(draft, dpi=150)),
    ]
    for name, values in found.items():
        print(f"{name}: {values.sum() * STEP_M**2:.0f} lm on the ceiling, at most {values.max():.0f} lx")
    for path in written:
        print("written:", path)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=Path("out"))
    main(parser.parse_args().out)
