"""Races the reference room against Radiance and Mitsuba 3 in one run, for docs/benchmarks.md and its figure."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray as xr
from benchmark_page import machine, put_section
from room_figure import draw
from room_reference import Floats, cpu_seconds, cv_rmse, rms, room

from clerestory import daylight_coefficients, sky_basis, sun_coefficients
from clerestory.coefficients import PARTS

HEADING = "## The reference room in other programs"
SEEDS = 4
#: Rounds, nodes and window samples.
Effort = tuple[int, int, int]
FACTOR_EFFORTS: list[Effort] = [
    (2, 512, 32),
    (2, 1024, 64),
    (2, 2048, 64),
    (2, 2048, 128),
    (2, 4096, 128),
    (2, 8192, 256),
    (2, 16384, 512),
]
COEFFICIENT_EFFORTS: list[Effort] = [(2, 32768, 1024), (2, 49152, 2048), (2, 65536, 2048), (2, 114688, 6144)]
FINE_EFFORTS: list[Effort] = [(2, 32768, 2048), (2, 65536, 4096), (2, 98304, 4096), (2, 131072, 4096)]
DIVISIONS = [64, 256, 1024, 4096]
PATHS = [256, 1024, 4096, 16384, 65536]


@dataclass(frozen=True)
class Point:
    """What one setting of one program costs, and how wrong it is."""

    setting: str
    cpu_seconds: float
    factor_error: float
    coefficient_error: float


@dataclass(frozen=True)
class Reference:
    """The converged answer: luminances, illuminances and coefficients, and how sure they are."""

    luminance: Floats
    illuminance: Floats
    standard_error: Floats
    coefficients: Floats
    cv: float

    def judged(self, setting: str, runs: list[tuple[float, Floats]]) -> Point:
        """The least time of several runs of one setting, and the root mean square of their errors."""
        factor = np.mean([rms(c @ self.luminance, self.illuminance) ** 2 for _, c in runs])
        coefficient = np.mean([cv_rmse(c, self.coefficients) ** 2 for _, c in runs])
        return Point(setting, min(s for s, _ in runs), float(factor**0.5), float(coefficient**0.5))


def whole(found: xr.Dataset) -> Floats:
    """All parts of the coefficients, (sensors, patches)."""
    return np.asarray(sum(found[part].values for part in PARTS))


def own(effort: Effort | None, *, basis: str, panel: bool, seed: int) -> tuple[float, xr.Dataset]:
    """CPU seconds and coefficients by the public call, the building of the room included."""
    names = ("rounds", "nodes", "window_samples")
    asked = {} if effort is None else dict(zip(names, effort, strict=True))
    return cpu_seconds(lambda: daylight_coefficients(room(panel=panel), basis=basis, seed=seed, **asked))


def reference(basis: str, *, panel: bool, effort: Effort) -> Reference:
    """The converged answer."""
    found = own(effort, basis=basis, panel=panel, seed=1_000_003)[1]
    coefficients = whole(found)
    variance = sum(found[f"{part}_standard_error"].values ** 2 for part in PARTS)
    return Reference(
        found.sky_luminance.values,
        found.sky_illuminance.values,
        found.sky_illuminance_standard_error.values,
        coefficients,
        float(np.sqrt(np.mean(variance[:, :-1])) / coefficients[:, :-1].mean()),
    )


def own_points(known: Reference, efforts: list[Effort], *, basis: str, panel: bool) -> list[Point]:
    """Clerestory, setting by setting."""
    points = []
    for effort in efforts:
        runs = [own(effort, basis=basis, panel=panel, seed=seed) for seed in range(SEEDS)]
        name = f"{effort[0]} rounds of {effort[1]:,} nodes, {effort[2]:,} window samples"
        points.append(known.judged(name, [(seconds, whole(found)) for seconds, found in runs]))
    return points


def radiance_points(known: Reference, divisions: list[int], *, basis: str) -> list[Point] | str:
    """Radiance, setting by setting; why not, if it does not run here."""
    try:
        from room_radiance import coefficients

        return [
            known.judged(f"-ad {n} -lw {0.1 / n:.2g}", [(s, c[0])])
            for n in divisions
            for s, c in [coefficients(n, basis=basis)]
        ]
    except (ImportError, OSError, subprocess.CalledProcessError) as cause:
        return f"did not run here: {type(cause).__name__}"


def mitsuba_points(known: Reference, paths: list[int], *, basis: str) -> list[Point] | str:
    """Mitsuba 3 in a process of its own, as it may end without a word where LLVM is too old."""
    with tempfile.TemporaryDirectory() as folder:
        asked = Path(folder) / "asked.json"
        asked.write_text(json.dumps([basis, paths]))
        script = Path(__file__).with_name("room_mitsuba.py")
        done = subprocess.run([sys.executable, script, asked], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            last = (done.stderr.strip().splitlines() or ["it ended without a word"])[-1]
            return f"did not run here: {last[:60]}"
        with np.load(asked.with_suffix(".npz")) as table:
            runs = zip(paths, table["seconds"], table["coefficients"], strict=True)
            return [known.judged(f"{n:,} paths a sensor", [(float(s), one) for one in c]) for n, s, c in runs]


def agreement(known: Reference) -> str:
    """Whether Radiance converges to the same daylight factors, in both standard errors."""
    try:
        from room_radiance import coefficients

        _, runs = coefficients(1024, repeats=16)
    except (ImportError, OSError, subprocess.CalledProcessError) as cause:
        return f"Radiance did not run here ({type(cause).__name__}), so that the reference stands alone."
    theirs = runs @ known.luminance
    error = np.hypot(theirs.std(axis=0, ddof=1) / np.sqrt(len(runs)), known.standard_error)
    z = (theirs.mean(axis=0) - known.illuminance) / error
    ratio = (theirs / known.illuminance).mean(axis=1)
    spread = ratio.std(ddof=1) / np.sqrt(len(ratio))
    return (
        f"{len(runs)} Radiance runs of -ab 12 -ad 1024 find {ratio.mean():.4f} ± {spread:.4f} of the reference's\n"
        "daylight factor (mean over the sensors and standard error of the runs); sensor by sensor the two differ by\n"
        f"{np.sqrt(np.mean(z**2)):.2f} standard errors (rms)."
    )


def seconds_to(points: list[Point], target: float, error: Callable[[Point], float]) -> str:
    """CPU seconds to a target, between the settings by a power law; beyond the last by the −1/2 of random sampling."""
    rows = sorted(points, key=lambda point: point.cpu_seconds)
    for before, after in zip([None, *rows], rows, strict=False):
        if error(after) <= target:
            if before is None:
                return f"≤ {after.cpu_seconds:.3f}"
            slope = np.log(error(after) / error(before)) / np.log(after.cpu_seconds / before.cpu_seconds)
            return f"{before.cpu_seconds * (target / error(before)) ** (1.0 / slope):.3g}"
    best = min(rows, key=error)
    return f"about {best.cpu_seconds * (error(best) / target) ** 2:.2g} (extrapolated)"


def suns() -> tuple[int, float, float, float]:
    """Directions, wall and CPU seconds, and relative standard error, of the suns of troplux5221 through the panel."""
    towards = np.asarray(sky_basis("troplux5221").centres)[:-1]
    altitude = np.degrees(np.arcsin(towards[:, 2]))
    azimuth = np.degrees(np.arctan2(towards[:, 0], towards[:, 1])) % 360.0
    began = time.perf_counter()
    cpu, found = cpu_seconds(lambda: sun_coefficients(room(panel=True), altitude_deg=altitude, azimuth_deg=azimuth))
    wall = time.perf_counter() - began
    noise = np.sqrt(np.mean(found.interreflected_standard_error.values**2)) / found.interreflected.values.mean()
    return len(towards), wall, cpu, float(noise)


def verdicts(
    plain: list[Point], fine: list[Point], panel: list[Point], sun: tuple[int, float, float, float]
) -> list[str]:
    """The targets, met or missed, each by the cheapest setting measured that is good enough."""

    def row(name: str, points: list[Point], error: Callable[[Point], float], target: float, limit: float) -> str:
        enough = [point for point in points if error(point) <= target]
        if not enough:
            best = min(points, key=error)
            return f"| {name} | {limit:g} | {100 * error(best):.1f} % at {best.cpu_seconds:.3g} | **missed** |"
        least = min(enough, key=lambda point: point.cpu_seconds)
        verdict = "met" if least.cpu_seconds <= limit else "**missed**"
        return f"| {name} | {limit:g} | {least.cpu_seconds:.3g} ({100 * error(least):.1f} %) | {verdict} |"

    wall = sun[1]
    return [
        row("daylight factor to 2 %", plain, _factor, 0.02, 0.06),
        row("coefficients of 145 patches to 5 %", plain, _coefficient, 0.05, 1.0),
        row("coefficients of 2305 patches to 15 %", fine, _coefficient, 0.15, 2.0),
        row("daylight factor to 2 %, panel in the upper third", panel, _factor, 0.02, 3 * 0.06),
        row("coefficients of 145 patches to 5 %, panel", panel, _coefficient, 0.05, 3 * 1.0),
        f"| {sun[0]} suns × 128 sensors through the panel, wall clock | 60 | {wall:.3g} | "
        f"{'met' if wall <= 60.0 else '**missed**'} |",
    ]


def _factor(point: Point) -> float:
    return point.factor_error


def _coefficient(point: Point) -> float:
    return point.coefficient_error


def table(name: str, points: list[Point] | str) -> list[str]:
    """Rows of one program."""
    if isinstance(points, str):
        return [f"| {name} | {points} | | | |"]
    return [
        f"| {name} | {p.setting} | {p.cpu_seconds:.3g} | {100 * p.factor_error:.2g} | {100 * p.coefficient_error:.3g} |"
        for p in sorted(points, key=lambda point: point.cpu_seconds)
    ]


def section() -> str:
    """The section of docs/benchmarks.md; draws docs/images/benchmarks/room.svg on the way."""
    coarse, fine_basis = "tregenza145", "reinhart2305"
    known = reference(coarse, panel=False, effort=(48, 65536, 4096))
    agrees = agreement(known)
    efforts = sorted({*FACTOR_EFFORTS, *COEFFICIENT_EFFORTS}, key=lambda effort: effort[1] * effort[0])
    plain = own_points(known, efforts, basis=coarse, panel=False)
    programs: dict[str, list[Point] | str] = {
        "Clerestory": plain,
        "Radiance rfluxmtx": radiance_points(known, DIVISIONS, basis=coarse),
        "Mitsuba 3 loop": mitsuba_points(known, PATHS, basis=coarse),
    }
    usual = [own(None, basis=coarse, panel=False, seed=seed) for seed in range(SEEDS)]
    default = known.judged("as it comes (16 rounds)", [(seconds, whole(found)) for seconds, found in usual])
    known_fine = reference(fine_basis, panel=False, effort=(24, 262144, 8192))
    own_fine = own_points(known_fine, FINE_EFFORTS, basis=fine_basis, panel=False)
    fine: dict[str, list[Point] | str] = {
        "Clerestory": own_fine,
        "Radiance rfluxmtx": radiance_points(known_fine, [1024], basis=fine_basis),
        "Mitsuba 3 loop": mitsuba_points(known_fine, [16384], basis=fine_basis),
    }
    known_panel = reference(coarse, panel=True, effort=(48, 65536, 4096))
    panel = own_points(known_panel, efforts, basis=coarse, panel=True)
    sun = suns()
    ran = {name: points for name, points in programs.items() if not isinstance(points, str)}
    draw(ran, panel)
    noise = float(np.sqrt(np.mean((known.standard_error / known.illuminance) ** 2)))
    header = [
        "| program | setting | CPU s | daylight factor, error % | coefficients, CV(RMSE) % |",
        "|---|---|---|---|---|",
    ]
    return "\n".join(
        [
            HEADING,
            "",
            f"On {machine()}; other programs were running where the load is more than two.",
            "",
            "4 × 8 × 3 m, a window of 3.6 × 1.8 m over a sill of 0.9 m with glass of transmittance 0.88, reflectances",
            "0.2, 0.5 and 0.8, ground 0.2, 128 sensors 0.8 m up, overcast sky. Errors of the daylight factor are the",
            "rms over the sensors of the relative difference from a converged run of Clerestory; those of the",
            "coefficients the rms over sensors and patches of the sky, over the mean coefficient. CPU seconds are user",
            f"and system time of all threads: the least of {SEEDS} seeds for Clerestory (error: rms over them), of",
            "two for Mitsuba 3 (kernels compiled before), of one run for Radiance (-ab 12, octree included). Mitsuba 3",
            "runs a loop of ours, cosine-sampled paths with Russian roulette: it has no daylight coefficients itself.",
            "Clerestory runs two rounds of many samples, which say little of their own standard error.",
            "",
            f"The reference's own error is {100 * noise:.2g} % in the daylight factor and {100 * known.cv:.2g} % in",
            f"the coefficients ({100 * known_fine.cv:.2g} % of 2305 patches, {100 * known_panel.cv:.2g} % with the",
            "panel); it is part of the errors below.",
            agrees,
            "",
            "![Error against CPU time in the reference room](images/benchmarks/room.svg)",
            "",
            "| program | CPU s to 2 % daylight factor | CPU s to 15 % CV of 145 coefficients |",
            "|---|---|---|",
            *[
                f"| {name} | {seconds_to(points, 0.02, _factor)} | {seconds_to(points, 0.15, _coefficient)} |"
                for name, points in ran.items()
            ],
            "",
            "What was aimed at, and the cheapest setting of this run that is good enough:",
            "",
            "| aim | CPU s allowed | measured | |",
            "|---|---|---|---|",
            *verdicts(plain, own_fine, panel, sun),
            "",
            f"The suns took {sun[2]:.3g} CPU s; their interreflected part has a standard error of",
            f"{100 * sun[3]:.2g} % of its mean (rms over sensors and suns).",
            "",
            "145 patches:",
            "",
            *header,
            *table("Clerestory", [default, *plain]),
            *[row for name in list(programs)[1:] for row in table(name, programs[name])],
            *table("Clerestory, panel in the upper third", panel),
            "",
            "2305 patches:",
            "",
            *header,
            *[row for name, points in fine.items() for row in table(name, points)],
            "",
        ]
    )


def main() -> None:
    """Puts the section into the page."""
    put_section(HEADING, section())


if __name__ == "__main__":
    main()
