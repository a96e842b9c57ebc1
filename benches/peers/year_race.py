"""Races a year of skies and illuminances against Radiance in one run, for docs/benchmarks.md."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
import xarray as xr
import year_radiance
from benchmark_page import ROOT, machine, put_section
from room_reference import cpu_seconds

from clerestory import annual_illuminance, read_epw, sky_basis, sky_matrix
from clerestory.coefficients import PARTS
from clerestory.weather import Weather

HEADING = "## A year of skies and illuminances"
WEATHER = ROOT / "examples" / "classroom" / "USA_FL_Miami.Intl.AP.722020_TMY3.epw"
BASES = {"tregenza145": 1, "reinhart577": 2, "reinhart2305": 4}
SENSORS = 128
REPEATS = 5
#: CPU seconds allowed for the sky matrix and for the product.
AIMS = {"tregenza145": (None, 0.1), "reinhart577": (None, None), "reinhart2305": (1.0, 2.0)}

TEXT = f"""8760 hours of Miami, {SENSORS} sensors. CPU seconds, user and system time of all threads: of Clerestory's the
least of {REPEATS} runs, positions of the sun included, of Radiance's of three (binary matrices, without the sun). The
product takes Radiance's own matrix in both programs; *apart* is their greatest difference over the greatest
illuminance. *Whole* is skies and product together, as `annual_illuminance` makes them from weather: no matrix is ever
whole, none is a file. Means over patches take 16, 9 and 4 points a patch of 145, 577 and 2305; `gendaymtx` takes one.
"""


def synthetic(basis: str) -> xr.Dataset:
    """Coefficients of so many sensors: any numbers do for a product, so long as they are the same for both programs."""
    rng = np.random.default_rng(5)
    size = len(sky_basis(basis))
    values = rng.uniform(0.0, 2.0 / size, (SENSORS, size))
    nothing = np.zeros_like(values)
    variables = {part: (("sensor", "patch"), values if part == "direct" else nothing) for part in PARTS}
    places = {name: ("sensor", np.arange(SENSORS, dtype=float)) for name in ("x_m", "y_m", "z_m")}
    return xr.Dataset(variables, coords=places, attrs={"basis": basis, "ground_reflectance": 0.2})


def least(work, repeats: int = REPEATS):  # type: ignore[no-untyped-def]
    """The least CPU seconds of several runs, and the last result."""
    runs = [cpu_seconds(work) for _ in range(repeats)]
    return min(seconds for seconds, _ in runs), runs[-1][1]


def fresh(weather: Weather) -> Weather:
    """The same weather, its sun not known yet."""
    return Weather(site=weather.site, frame=weather.frame, interval_minutes=weather.interval_minutes)


def rows() -> list[str]:
    """One row a basis."""
    reading, weather = least(lambda: read_epw(WEATHER))
    found = [f"Reading the file takes {reading:.2f} CPU s more, where `gendaymtx` reads it by the way.", ""]
    heads = "patches | sky matrix | `gendaymtx`, MB | times ours | product | `dctimestep` | times ours | apart | whole"
    found += [f"| {heads} |", "|---|---|---|---|---|---|---|---|---|"]
    verdicts = []
    with tempfile.TemporaryDirectory() as folder:
        sky_file, dc_file, out = (Path(folder) / name for name in ("sky.mtx", "dc.mtx", "out.dat"))
        for basis, factor in BASES.items():
            own_sky, _ = least(lambda basis=basis: sky_matrix(fresh(weather), basis))
            their_sky = min(year_radiance.sky_matrix(WEATHER, factor, sky_file) for _ in range(3))
            megabytes = sky_file.stat().st_size / 1e6
            coefficients = synthetic(basis)
            year_radiance.write_coefficients(coefficients.direct.values, dc_file)
            runs = [year_radiance.product(dc_file, sky_file, out) for _ in range(3)]
            theirs, values = min(seconds for seconds, _ in runs), runs[-1][1]
            given = xr.DataArray(year_radiance.read_sky_matrix(sky_file).T, dims=("patch", "time"))
            own, mine = least(lambda c=coefficients, s=given: annual_illuminance(c, None, weather, sky=s))
            whole, _ = least(lambda c=coefficients: annual_illuminance(c, None, fresh(weather)))
            apart = float(np.abs(mine.total.values - values).max() / values.max())
            sky_cells = f"{own_sky:.3g} | {their_sky:.3g}, {megabytes:.0f} | {their_sky / own_sky:.2g}"
            product_cells = f"{own:.3g} | {theirs:.3g} | {theirs / own:.2g} | {apart:.0e}"
            found.append(f"| {len(sky_basis(basis)) - 1} | {sky_cells} | {product_cells} | {whole:.3g} |")
            for name, value, aim in (("sky matrix", own_sky, AIMS[basis][0]), ("product", own, AIMS[basis][1])):
                if aim is not None:
                    verdict = "met" if value <= aim else "**missed**"
                    patches = len(sky_basis(basis)) - 1
                    verdicts.append(f"| {name}, {patches} patches | {aim:g} | {value:.3g} | {verdict} |")
    return [*found, "", "| aim | CPU s allowed | measured | |", "|---|---|---|---|", *verdicts]


def section() -> str:
    """The section of docs/benchmarks.md."""
    return "\n".join(
        [
            HEADING,
            "",
            f"On {machine()}; other programs were running where the load is more than two.",
            "",
            TEXT,
            *rows(),
            "",
        ]
    )


def main() -> None:
    """Puts the section into the page."""
    put_section(HEADING, section())


if __name__ == "__main__":
    main()
