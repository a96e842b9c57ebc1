"""A folder with one result of each kind, written as the commands write them."""

from pathlib import Path
from unittest.mock import patch

from tests.sweep.studies import PANEL
from tests.year.small import YEAR, write_small

from clerestory import read_panel
from clerestory.design import run_design
from clerestory.design.plan import design_of
from clerestory.design.report import write_report as write_design
from clerestory.saving import save
from clerestory.study import read_study, run_study
from clerestory.study_report import write_report as write_room
from clerestory.sweep import gather, run_sweep
from clerestory.sweep.figures import figures_of
from clerestory.sweep.gather import write_zarr
from clerestory.sweep.plan import sweep_of
from clerestory.year import read_year, run_year, write_year

ROOM = (
    YEAR.split("[weather]")[0]
    + "[glazings.glass]"
    + YEAR.split("[glazings.glass]")[1].split("[[blinds]]")[0].replace('title = "Small room"\n', "")
    + """
[calculation]
basis = "tregenza145"
rounds = 2
[[sky]]
name = "overcast"
sky_type = 16
diffuse_horizontal_illuminance_lx = 10000
[[sky]]
name = "bright overcast"
sky_type = 16
diffuse_horizontal_illuminance_lx = 20000
"""
)


def write_results(folder: Path) -> None:
    """Fills a folder: `year.toml` with `out/year`, `room.toml` with `out/room`, and sweep, design, panel there."""
    # the pictures of reports take longer than all numbers
    with (
        patch("clerestory.year.report.report_text", return_value=""),
        patch("clerestory.study_report._figures", return_value=[]),
        patch("clerestory.design.report._pictures", return_value={}),
    ):
        _write(folder)


def _write(folder: Path) -> None:
    study = read_year(write_small(folder))
    write_year(study, run_year(study, folder / "out/year"), folder / "out/year")
    (folder / "room.toml").write_text(ROOM.replace('title = "Small room"\n', ""))
    rooms = read_study(folder / "room.toml")
    write_room(rooms, run_study(rooms), folder / "out/room")
    sweep = sweep_of(
        {
            "kind": "panel",
            "base": {"panel": dict(PANEL), "light": {"elevation_deg": [30, 50]}},
            "parameters": {"panel.spacing_mm": [3.0, 4.0, 5.0], "panel.cut_width_mm": [0.0, 3.5]},
        },
        name="spacings",
    )
    run_sweep(sweep, folder / "out/sweep", workers=0)
    gathered = gather(sweep, folder / "out/sweep")
    write_zarr(gathered, folder / "out/sweep/results.zarr")
    save(figures_of(gathered), folder / "out/sweep/results.csv")
    design = design_of(
        {
            "kind": "panel",
            "base": {"panel": dict(PANEL), "light": {"elevation_deg": [40], "band_deg": [0, 15]}},
            "parameters": {
                "panel.spacing_mm": {"low": 2.0, "high": 8.0},
                "light.tilt_deg": {"low": -30.0, "high": 10.0},
            },
            "objective": [{"figure": "mean_band_transmittance"}, {"figure": "mean_transmittance"}],
            "search": {"trials": 12, "seed": 2},
        },
        name="band",
    )
    write_design(design, run_design(design, folder / "out/design"), folder / "out/design")
    panel = folder / "panel.toml"
    panel.write_text('kind = "laser-cut"\nspacing_mm = 4.0\nthickness_mm = 6.0\nmedium = "pmma"\n')
    save(read_panel(panel).angular(elevation_deg=[0, 20, 40, 60]), folder / "out/panel/angular.nc")
