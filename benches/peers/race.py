"""Races the walk against Mitsuba 3 and Radiance on one panel in one run, and writes docs/benchmarks.md."""

from __future__ import annotations

import ast
import json
import os
import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from benchmark_page import ROOT, machine, put_page
from panel_geometry import D_OVER_W, ELEVATION_DEG, KERF_OVER_W, N

from clerestory import LaserCutPanel, Medium, __version__

REPEATS = 5


def own(polarisation: str, rays: int) -> tuple[float, float]:
    """CPU seconds of a million rays through the same bars, and the deflected transmittance: the best of several."""
    panel = LaserCutPanel(spacing_mm=D_OVER_W, thickness_mm=1.0, cut_width_mm=KERF_OVER_W, medium=Medium(n=N))
    best, deflected = np.inf, 0.0
    for seed in range(REPEATS):
        before = os.times()
        table = panel.angular(
            elevation_deg=ELEVATION_DEG, method="monte_carlo", rays=rays, seed=seed, polarisation=polarisation
        )
        after = os.times()
        best = min(best, after.user + after.system - before.user - before.system)
        deflected = table.transmittance_deflected.item()
    return 1e6 * best / rays, deflected


def peer(call: str) -> tuple[float, float] | str:
    """The same of another program in a process of its own; the last line of its complaint if it cannot run."""
    module, function = call.split(".", 1)
    code = f"import {module}; print({module}.{function})"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=Path(__file__).parent, capture_output=True, text=True, check=False
    )
    if done.returncode == 0:
        seconds, deflected = ast.literal_eval(done.stdout.strip().splitlines()[-1])
        return float(seconds), float(deflected)
    complaint = next((line for line in done.stderr.splitlines() if "error" in line.lower()), "it ended without a word")
    return complaint.split(":")[0] + ": " + complaint.partition(":")[2].strip()[:60]


def table_of_elevations() -> float:
    """Wall milliseconds of an angular table of 90 elevations."""
    panel, best = LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0, medium=Medium(n=N)), np.inf
    for _ in range(20):
        began = time.perf_counter()
        panel.angular(elevation_deg=np.arange(0.0, 90.0))
        best = min(best, time.perf_counter() - began)
    return 1e3 * best


def memory_growth() -> list[tuple[int, float]]:
    """Greatest resident memory [MiB] after ever more rays."""
    panel, grown = LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0, medium=Medium(n=N)), []
    for rays in (10_000, 100_000, 1_000_000, 5_000_000):
        panel.angular(elevation_deg=40.0, method="monte_carlo", rays=rays)
        grown.append((rays, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0))
    return grown


def criterion() -> list[tuple[str, float]]:
    """Name and fastest mean [µs] of the benches of the crate panel, as criterion left them."""
    found = []
    for path in sorted((ROOT / "target" / "criterion").glob("**/new/estimates.json")):
        name = json.loads((path.parent / "benchmark.json").read_text())["full_id"]
        found.append((name, json.loads(path.read_text())["median"]["point_estimate"] / 1e3))
    return found


def page() -> str:
    """The whole of docs/benchmarks.md."""
    memory = memory_growth()
    ours, resolved = own("averaged", 1_000_000), own("resolved", 1_000_000)
    rows = [
        f"| Clerestory walk, averaged | {ours[0]:.3g} | 1 | {ours[1]:.4f} |",
        f"| Clerestory walk, resolved | {resolved[0]:.3g} | {resolved[0] / ours[0]:.3g} | {resolved[1]:.4f} |",
    ]
    peers = {
        "Mitsuba 3, LLVM": "mitsuba_walk.race('llvm_ad_mono', 1_000_000)",
        "Radiance, dielectric": "radiance.race(2000)",
    }
    for name, call in peers.items():
        found = peer(call)
        if isinstance(found, str):
            rows.append(f"| {name} | did not run here: {found} | | |")
        else:
            rows.append(f"| {name} | {found[0]:.3g} | {found[0] / ours[0]:.3g} | {found[1]:.4f} |")
    benches = [f"| {name} | {value:.4g} |" for name, value in criterion()]
    growth = [f"| {rays:,} | {mebibytes:.0f} |" for rays, mebibytes in memory]
    return "\n".join(
        [
            "# Speed",
            "",
            f"Written by `make bench`, Clerestory {__version__}, on: {machine()}.",
            "",
            "## The same panel in other programs",
            "",
            f"Laser-cut, n = {N}, D/W = {D_OVER_W}, air kerf {KERF_OVER_W} W, light from {ELEVATION_DEG:g}°:",
            "CPU seconds of a million rays, all threads together, and the deflected transmittance each finds. Programs",
            "run after one another in one run; of Clerestory's the fastest of five is given.",
            "",
            "| program | CPU s per million rays | times ours | T deflected |",
            "|---|---|---|---|",
            *rows,
            "",
            "## Exact solver and walk on one core",
            "",
            "Medians by criterion. The walk follows 16 384 rays.",
            "",
            "| bench | µs |",
            "|---|---|",
            *benches,
            "",
            "## From Python",
            "",
            f"An angular table of 90 elevations (laser-cut, D/W = 0.5, resolved): {table_of_elevations():.2g} ms.",
            "",
            "Greatest resident memory after a walk, which must not grow with the rays:",
            "",
            "| rays | MiB |",
            "|---|---|",
            *growth,
            "",
        ]
    )


def main() -> None:
    """Writes the page, whole or not at all."""
    put_page(page())


if __name__ == "__main__":
    main()
