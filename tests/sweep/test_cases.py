"""What the kinds of cases find: panels in a tilted opening, rooms whole and in parts."""

import numpy as np
import pytest
import xarray as xr
from tests.sweep.studies import PANEL

from clerestory.errors import ClerestoryError
from clerestory.panels import LaserCutPanel
from clerestory.sweep import gather, run_sweep
from clerestory.sweep.figures import figures_of
from clerestory.sweep.gather import write_zarr
from clerestory.sweep.panel_case import evaluate
from clerestory.sweep.plan import sweep_of
from clerestory.sweep.room_case import evaluate as evaluate_room

ROOM = {
    "ground_reflectance": 0.2,
    "glazings": {"glass": {"kind": "glass", "transmittance": 0.88}, "panel": PANEL},
    "shoebox": {
        "width_m": 3.0,
        "depth_m": 4.0,
        "height_m": 3.0,
        "opening": [{"width_m": 2.0, "height_m": 1.5, "glazing": "panel"}],
    },
    "sensors": [{"spacing_m": 1.0}],
    "calculation": {"basis": "tregenza145", "target_relative_error": 0.05},
}


def light(**changes):
    return {"panel": PANEL, "light": {"elevation_deg": [20, 40, 65]} | changes}


def test_without_tilt_a_panel_does_what_its_angular_table_says():
    found = evaluate(light(azimuth_deg=[0, 30]))
    table = LaserCutPanel(spacing_mm=4, thickness_mm=6, medium=found_medium()).angular(
        elevation_deg=[20, 40, 65], azimuth_deg=[0, 30]
    )
    for name in ("transmittance", "transmittance_deflected", "reflectance"):
        np.testing.assert_allclose(found[name], table[name], rtol=0, atol=1e-12)
    # in a vertical panel what is deflected leaves upwards, all of it
    np.testing.assert_allclose(found.upward_transmittance, found.transmittance_deflected, rtol=0, atol=1e-9)
    assert found.mean_transmittance == pytest.approx(float(table.transmittance.mean()), abs=1e-12)


def found_medium():
    from clerestory.medium import Medium

    return Medium(n=1.49)


def test_a_panel_tilted_outwards_by_t_sends_the_sun_to_elevation_e_minus_2_t():
    """A mirror across the sheet turns E - T to T - E of the panel, which is E - 2 T of the room."""
    for elevation, outwards in [(40.0, 0.0), (40.0, 16.0), (60.0, 26.0), (30.0, 11.0)]:
        rise = elevation - 2.0 * outwards
        at = light(elevation_deg=[elevation], tilt_deg=-outwards)
        at["light"]["band_deg"] = [rise - 0.01, rise + 0.01]
        found = evaluate(at)
        assert found.transmittance_deflected > 0.2
        assert found.band_transmittance.item() == pytest.approx(found.transmittance_deflected.item(), abs=1e-6)


def test_light_behind_a_tilted_panel_is_left_out():
    found = evaluate(light(elevation_deg=[10, 70], tilt_deg=30.0))
    # the lower edge swung inwards by 30 degrees: the front looks down, and the sun at 70 degrees is behind it
    assert np.isnan(found.transmittance[1].item())
    assert found.mean_transmittance == found.transmittance[0].item()
    with pytest.raises(ClerestoryError, match="tilt_deg must let light meet the front"):
        evaluate(light(elevation_deg=[80], tilt_deg=30.0))


def test_rays_agree_with_beams_by_their_standard_errors():
    exact, walked = evaluate(light()), evaluate(light(method="monte_carlo", rays=20_000, seed=2))
    error = walked.transmittance_standard_error
    assert float(error.max()) < 0.01
    assert float((abs(walked.transmittance - exact.transmittance) / error).max()) < 4.0


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"panel": "none"}, "must be one of glass, panel"),
        ({"panel": "glass"}, "panel must be a laser-cut, prismatic"),
        ({"light": {"tilt": 3}}, "got tilt; did you mean tilt_deg?"),
        ({"light": {"band_deg": 3}}, "must be two elevations, got 3"),
    ],
)
def test_mistakes_in_a_panel_case_are_told(changes, message):
    with pytest.raises(ClerestoryError) as told:
        evaluate({"glazings": ROOM["glazings"]} | light() | changes)
    assert message in str(told.value)


def test_a_room_in_parts_is_the_room_within_its_errors(tmp_path):
    tables = {"kind": "room", "base": ROOM, "parameters": {"glazings.panel.spacing_mm": [4.0]}}
    split = sweep_of(tables | {"sensors_per_task": 5}, name="split.toml")
    tally = run_sweep(split, tmp_path, workers=0)
    assert (tally.cases, tally.computed) == (1, 1)
    parts, whole = gather(split, tmp_path).isel(case=0, variant=0), evaluate_room(ROOM).isel(variant=0)
    assert parts.sizes["sensor"] == whole.sizes["sensor"] == 12
    for name in ("x_m", "y_m", "row", "column"):
        np.testing.assert_array_equal(parts[name], whole[name])
    error = np.hypot(parts.daylight_factor_standard_error, whole.daylight_factor_standard_error)
    assert float((error / whole.daylight_factor).max()) < 0.1
    assert float((abs(parts.daylight_factor - whole.daylight_factor) / error).max()) < 4.0
    assert float(parts.daylight_factor_mean) == pytest.approx(float(parts.daylight_factor.mean()), rel=1e-12)
    assert len(list((tmp_path / "cases").iterdir())) == 1, "parts are gone once they are joined"


def test_parts_that_are_there_are_not_computed_again(tmp_path, monkeypatch):
    from clerestory.sweep import work

    tables = {"kind": "room", "base": ROOM, "parameters": {"calculation.rounds": [2]}, "sensors_per_task": 5}
    study = sweep_of(tables, name="split.toml")
    counted = []
    real = work.evaluate

    def stopped(kind, tables, where):
        if len(counted) == 2:
            raise KeyboardInterrupt
        counted.append(tables["sensor_chunk"])
        return real(kind, tables, where=where)

    monkeypatch.setattr(work, "evaluate", stopped)
    assert run_sweep(study, tmp_path, workers=0).interrupted
    counted_before, counted[:] = list(counted), [None]
    left = []
    tally = run_sweep(study, tmp_path, workers=0, progress=lambda now: left.append((now.tasks, now.seconds_left())))
    assert left == [(1, 0.0)], "progress counts the parts that are left"
    assert tally.computed == 1
    assert counted_before == [[0, 5], [5, 10]]
    assert counted[1:] == [[10, 12]]


def test_a_case_of_kind_year_is_what_the_year_finds(tmp_path, monkeypatch):
    """The kind calls `clerestory.year.evaluate` with the tables of the case and the folder of its files."""
    import sys
    from types import ModuleType

    asked = []
    year = ModuleType("clerestory.year")

    def of_year(tables, *, where):
        asked.append((tables, where))
        return xr.Dataset({"sda": 0.5 + 0.1 * tables["room"]["sill_m"], "hourly": ("time", np.zeros(8760))})

    year.evaluate = of_year
    monkeypatch.setitem(sys.modules, "clerestory.year", year)
    tables = {"kind": "year", "base": {"room": {"sill_m": 1.0}}, "parameters": {"room.sill_m": [1.0, 2.0]}}
    study = sweep_of(tables, where=tmp_path, name="years.toml")
    assert run_sweep(study, tmp_path / "out", workers=0).computed == 2
    assert asked[1] == ({"room": {"sill_m": 2.0}}, tmp_path.resolve())
    found = gather(study, tmp_path / "out")
    np.testing.assert_allclose(found.sda, [0.6, 0.7])
    assert "hourly" not in found, "hour by hour stays in the files of the cases"
    assert gather(study, tmp_path / "out", without=()).hourly.shape == (2, 8760)


def test_rooms_of_other_sizes_stand_side_by_side(tmp_path):
    tables = {"kind": "room", "base": ROOM, "parameters": {"shoebox.depth_m": [3.0, 5.0], "calculation.rounds": [2]}}
    tables["base"] = {**ROOM, "calculation": {"basis": "tregenza145"}}
    study = sweep_of(tables, name="depths.toml")
    assert run_sweep(study, tmp_path, workers=0).computed == 2
    found = gather(study, tmp_path)
    written = write_zarr(found, tmp_path / "results.zarr")
    with xr.open_zarr(written, consolidated=False) as read:
        factor = read.daylight_factor.isel(variant=0).values
        names = read.group.values.tolist()
    # 3 by 3 sensors, and 3 by 5: what the smaller room lacks is NaN, and has no name
    assert np.isfinite(factor).sum(axis=1).tolist() == [9, 15]
    assert names[0] == ["floor"] * 9 + [""] * 6
    assert found.y_m.values[1, -1] > np.nanmax(found.y_m.values[0])
    figures = figures_of(found)
    assert figures.daylight_factor_mean.dims == ("case",)
    assert figures.daylight_factor_mean[1] == pytest.approx(factor[1].mean(), rel=1e-12)
