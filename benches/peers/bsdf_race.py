"""Races BSDFs of one laser-cut panel against Radiance's ray tracer: a figure, and a section of docs/benchmarks.md."""

from __future__ import annotations

import itertools
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from benchmark_page import ROOT, put_section
from numpy.typing import NDArray
from panel_geometry import D_OVER_W, N

from clerestory import KlemsBlock, LaserCutPanel, Medium
from clerestory.bsdf import klems_basis

FIGURE = ROOT / "docs" / "images" / "bsdf_race.png"
HEADING = "## A BSDF of a panel"
REPEATS = 3

Floats = NDArray[np.float64]


def own(**how: Any) -> tuple[float, Floats]:
    """CPU seconds, the best of several, and where light from the front goes: T and R, each (outgoing, incident)."""
    panel, best = (
        LaserCutPanel(spacing_mm=6.0 * D_OVER_W, thickness_mm=6.0, cut_width_mm=0.0, medium=Medium(n=N)),
        np.inf,
    )
    for _ in range(REPEATS):
        before = os.times()
        bsdf = panel.bsdf(bands=("visible",), **how)
        after = os.times()
        best = min(best, after.user + after.system - before.user - before.system)
    blocks = [bsdf.visible.transmission_front, bsdf.visible.reflection_front]
    shares = [b.values * b.outgoing.projected_solid_angle[:, None] for b in blocks if isinstance(b, KlemsBlock)]
    return best, np.array(shares)


def radiance(setting: str) -> tuple[float, Floats] | str:
    """The same of Radiance, or why it did not run."""
    code = f"import json, bsdf_radiance; print(json.dumps(bsdf_radiance.race({setting!r})))"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=Path(__file__).parent, capture_output=True, text=True, check=False
    )
    if done.returncode:
        # the last line of its complaint
        return next((line for line in reversed(done.stderr.splitlines()) if line.strip()), "it ended without a word")
    seconds, shares = json.loads(done.stdout.strip().splitlines()[-1])
    return float(seconds), np.array(shares).transpose(0, 2, 1)


def distances(shares: Floats, converged: Floats) -> Floats:
    """Sum of absolute differences of each column, by the naming of patches that fits best of those a square allows."""
    basis = klems_basis("klems_full").native
    xy = basis.centres[:, :2]
    names = []
    for signs, is_swapped in itertools.product([(1, 1), (1, -1), (-1, 1), (-1, -1)], [False, True]):
        names.append(basis.find((xy[:, ::-1] if is_swapped else xy) * np.array(signs)))
    best: Floats = np.zeros(len(basis))
    # transmission and reflection each have their own naming: a receiver behind is seen from its other side
    for kind, wanted in zip(shares, converged, strict=True):
        fits = [
            np.abs(kind[outgoing][:, incident] - wanted).sum(axis=0)
            for incident, outgoing in itertools.product(names, names)
        ]
        best = best + min(fits, key=lambda fit: float(fit.mean()))
    return best


def figure(found: list[tuple[str, Floats, Floats]], path: Path) -> None:
    """How far each column is from converged, and what becomes of its light."""
    mpl.use("Agg")
    import matplotlib.pyplot as plt

    drawn, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    for name, off, sums in found:
        left.semilogy(np.maximum(off, 1e-6), ".", label=name, markersize=4)
        right.plot(sums, ".", label=name, markersize=4)
    left.axhline(0.002, color="0.6", linewidth=0.8)
    left.set(xlabel="incident patch, Klems full", ylabel="sum of |differences| from converged")
    right.set(xlabel="incident patch, Klems full", ylabel="T + R of a lossless panel")
    drawn.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=3, frameon=False, fontsize=8)
    path.parent.mkdir(parents=True, exist_ok=True)
    drawn.savefig(path, dpi=130)


def section() -> str:
    """The section, and the figure beside it."""
    _, converged = own(accuracy=1e-4)
    rows, drawn = [], []
    for name, how in {
        "Clerestory, Klems full": {},
        "Clerestory, Klems full, `accuracy=1e-3`": {"accuracy": 1e-3},
        "Clerestory, Klems full, polarisation averaged": {"polarisation": "averaged"},
    }.items():
        seconds, shares = own(**how)
        off, sums = np.abs(shares - converged).sum(axis=(0, 1)), shares.sum(axis=(0, 1))
        drawn.append((name.replace("`", ""), off, sums))
        rows.append((name, seconds, off, sums))
    for name, setting in {
        "Radiance rfluxmtx, 300 rays a patch": "tuned",
        "Radiance rfluxmtx, 2000 rays": "fine",
    }.items():
        met = radiance(setting)
        if isinstance(met, str):
            rows.append((f"{name}: did not run here, {met[:60]}", np.nan, np.full(145, np.nan), np.full(145, np.nan)))
            continue
        off, sums = distances(met[1], converged), met[1].sum(axis=(0, 1))
        drawn.append((name, off, sums))
        rows.append((name, met[0], off, sums))
    figure(drawn, FIGURE)
    tree, _ = own(rank=4, log2_resolution=5)
    lines = [
        f"| {name} | {seconds:.3g} | {off.mean():.2g} | {off.max():.2g} | {sums.min():.4f} to {sums.max():.4f} |"
        for name, seconds, off, sums in rows
    ]
    return "\n".join(
        [
            HEADING,
            "",
            f"Laser-cut, n = {N}, D/W = {D_OVER_W}, lossless, cuts of no width (Radiance: 0.001 W), both sides, CPU",
            "seconds; of Clerestory's the fastest of three. Distance: the sum of absolute differences of a column from",
            "converged, as a share of the light, over the 145 columns of light from the front. The converged matrix is",
            "Clerestory's own at `accuracy=1e-4`, polarisation carried along; Radiance averages it at every hit. Its",
            "patches are named as fits best.",
            "",
            "| program | CPU s | distance, mean | distance, worst | T + R |",
            "|---|---|---|---|---|",
            *lines,
            "",
            f"A tensor tree of rank 4, 2⁵ cells along each coordinate, all four blocks: {tree:.2g} CPU s.",
            "",
            "![Distance from converged and T + R of each column](images/bsdf_race.png)",
            "",
        ]
    )


def main() -> None:
    """Puts the section into the page."""
    put_section(HEADING, section())


if __name__ == "__main__":
    main()
