"""A laser-cut panel from its sizes to figures: python examples/laser_cut_panel.py --out out

Cuts every 3 mm through 6 mm of acrylic (D/W = 0.5), lit by daylight from 0 to 89 degrees above the horizon.
"""

import argparse
import time
from pathlib import Path

import numpy as np

from clerestory import LaserCutPanel, save
from clerestory.glass import edmonds_deflected_fraction
from clerestory.panels.section_beams import section_beams
from clerestory.plots import deflected_fraction, radial, section
from clerestory.saving import write_whole

ELEVATION_DEG = np.arange(0.0, 90.0)
SECTION_DEG = 50.0


def main(out: Path) -> None:
    panel = LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0)
    began = time.perf_counter()
    table = panel.angular(elevation_deg=ELEVATION_DEG)
    milliseconds = 1e3 * (time.perf_counter() - began)
    written = [
        panel.to_toml(out / "laser_cut_panel.toml"),
        save(table, out / "laser_cut_panel.nc"),
        save(table, out / "laser_cut_panel.csv"),
    ]

    tables, formula = {}, {}
    for ratio in (0.3, 0.5, 0.7):
        other = LaserCutPanel(spacing_mm=6.0 * ratio, thickness_mm=6.0)
        tables[ratio] = other.angular(elevation_deg=ELEVATION_DEG, wavelength_nm=550.0)
        n = other.medium.index(550.0)
        formula[ratio] = edmonds_deflected_fraction(ELEVATION_DEG, n, spacing_mm=6.0 * ratio, thickness_mm=6.0)
    figures = {
        "laser_cut_panel_radial": radial(table),
        "laser_cut_panel_section": section(panel, section_beams(panel, elevation_deg=SECTION_DEG)),
        "laser_cut_panel_deflected": deflected_fraction(tables, formula=formula),
    }
    for name, figure in figures.items():
        for ending in (".png", ".svg"):
            written.append(write_whole(out / f"{name}{ending}", lambda draft, f=figure: f.savefig(draft, dpi=200)))

    print(
        f"Laser-cut panel, cuts every {panel.spacing_mm:g} mm through {panel.thickness_mm:g} mm of {panel.medium.name}"
    )
    print(f"{table.sizes['elevation']} directions of incidence in daylight, exact, in {milliseconds:.0f} ms\n")
    print("  light from   through   deflected up   reflected   absorbed")
    for elevation in (15, 30, 45, 60, 75):
        shares = table.sel(elevation=elevation, azimuth=0)
        print(
            f"  {elevation:9d}°   {shares.transmittance.item():7.1%}   {shares.transmittance_deflected.item():12.1%}"
            f"   {shares.reflectance.item():9.1%}   {shares.absorptance.item():8.1%}"
        )
    deflected = table.transmittance_deflected
    most = float(deflected.max())
    at = float(table.elevation[int(np.argmax(deflected.values))])
    print(f"\nIt turns most light upwards, {most:.1%}, from {at:g}°. At most {float(table.residual.max()):.0e} of the")
    print("light was not followed to its end.\n")
    for path in written:
        print(f"wrote {path}")


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--out", type=Path, default=Path("out"), help="folder for the results")
    main(arguments.parse_args().out)
