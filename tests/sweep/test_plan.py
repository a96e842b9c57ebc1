"""A study as tables: which cases it has, and what their hashes are made of."""

import copy
import json
import os

import numpy as np
import pytest
from tests.sweep.studies import PANEL, quick

from clerestory.errors import ClerestoryError
from clerestory.sweep import fingerprint, read_sweep
from clerestory.sweep.dotted import put, steps_of
from clerestory.sweep.plan import sweep_of


def study(parameters, **more):
    base = {"panel": dict(PANEL), "light": {"elevation_deg": [30]}, "other": [{"a": 1}, {"a": 2}]}
    return sweep_of({"kind": "panel", "base": base, "parameters": parameters, **more}, name="study.toml")


def values(sweep, *names):
    return [tuple(row[name] for name in names) for row in sweep.rows]


def test_a_path_leads_into_tables_arrays_and_quoted_names():
    assert steps_of('glazings."panel 1.5".spacing_mm') == ("glazings", "panel 1.5", "spacing_mm")
    tables = {"opening": [{"sill_m": 1}, {"sill_m": 2}]}
    put(tables, "opening[2].sill_m", 5)
    assert tables == {"opening": [{"sill_m": 1}, {"sill_m": 5}]}


def test_a_grid_has_every_value_with_every_other():
    sweep = study({"panel.spacing_mm": [2, 3], "panel.thickness_mm": {"range": {"start": 4, "stop": 6, "step": 1}}})
    assert values(sweep, "spacing_mm", "thickness_mm") == [(2, 4), (2, 5), (2, 6), (3, 4), (3, 5), (3, 6)]


def test_zipped_parameters_go_together():
    sweep = study({"panel.spacing_mm": [2, 3], "panel.thickness_mm": [4, 5]}, join="zip")
    assert values(sweep, "spacing_mm", "thickness_mm") == [(2, 4), (3, 5)]


def test_a_tied_parameter_follows_and_one_value_goes_to_several_places():
    sweep = study(
        {
            "panel.thickness_mm": {"values": [4, 6], "also": "other[1].a"},
            "panel.spacing_mm": {"of": "thickness_mm", "times": 0.5, "plus": 1},
        }
    )
    assert values(sweep, "thickness_mm", "spacing_mm") == [(4, 3.0), (6, 4.0)]
    assert sweep.cases[1].tables["other"] == [{"a": 6}, {"a": 2}]
    assert sweep.base["other"] == [{"a": 1}, {"a": 2}], "the base must stay as it is"


@pytest.mark.parametrize("kind", ["sobol", "latin-hypercube"])
def test_a_sampled_design_fills_each_range_evenly_and_repeats_by_its_seed(kind):
    parameters = {
        "panel.spacing_mm": {"low": 1.0, "high": 100.0, "log": True},
        "panel.cut_tilt_deg": {"low": -10.0, "high": 10.0},
        "light.rays": {"low": 1, "high": 4, "whole": True},
    }
    sweep = study(parameters, design={"kind": kind, "n": 32, "seed": 3})
    spacing = np.array(values(sweep, "spacing_mm")).ravel()
    # one point in each of 32 slices of the logarithm: what both designs promise
    assert sorted(np.floor(np.log10(spacing) / 2.0 * 32).astype(int)) == list(range(32))
    assert set(np.ravel(values(sweep, "rays"))) == {1, 2, 3, 4}
    again = study(parameters, design={"kind": kind, "n": 32, "seed": 3})
    other = study(parameters, design={"kind": kind, "n": 32, "seed": 4})
    assert [case.key for case in again.cases] == [case.key for case in sweep.cases]
    assert again.rows != other.rows


def test_samples_are_crossed_with_a_grid():
    parameters = {"panel.spacing_mm": {"low": 1.0, "high": 4.0}, "panel.thickness_mm": [4, 6]}
    assert len(study(parameters, design={"n": 8}).cases) == 16


def test_the_hash_knows_inputs_files_and_program_and_nothing_else(tmp_path, monkeypatch):
    panel = tmp_path / "panel.toml"
    panel.write_text('kind = "pane"\nthickness_mm = 4\n')
    tables = {
        "kind": "panel",
        "base": {"panel": {"file": "panel.toml"}, "light": {}},
        "parameters": {"light.tilt_deg": [0]},
    }

    def key():
        return sweep_of(copy.deepcopy(tables), where=tmp_path, name="s.toml").cases[0].key

    first = key()
    os.utime(panel, (0, 0))
    (tmp_path / "unrelated.txt").write_text("x")
    assert key() == first, "neither a file's time nor another file may count"
    panel.write_text('kind = "pane"\nthickness_mm = 5\n')
    second = key()
    assert second != first, "the content of a file counts"
    tables["base"]["light"] = {"elevation_deg": [20]}
    third = key()
    assert third not in (first, second)
    program = dict(fingerprint.build())
    monkeypatch.setattr(fingerprint, "build", lambda: program | {"version": "9.9"})
    assert key() != third, "another version is another result"


def test_a_file_names_its_base(tmp_path):
    (tmp_path / "rooms").mkdir()
    (tmp_path / "rooms" / "base.toml").write_text("[panel]\nkind = 'pane'\nthickness_mm = 3\n")
    path = tmp_path / "panes.toml"
    path.write_text('kind = "panel"\nbase = "rooms/base.toml"\n[parameters]\n"panel.thickness_mm" = [3, 4]\n')
    sweep = read_sweep(path)
    assert sweep.name == "panes"
    assert sweep.where == tmp_path / "rooms"
    assert json.loads(json.dumps(sweep.cases[1].tables)) == {"panel": {"kind": "pane", "thickness_mm": 4}}


@pytest.mark.parametrize(
    ("parameters", "more", "message"),
    [
        ({"pannel.spacing_mm": [1]}, {}, "got 'pannel'; did you mean 'panel'?"),
        ({"panel..x": [1]}, {}, "must be names between dots"),
        ({"other[3].a": [1]}, {}, "got [3] of 2"),
        ({"panel.spacing_mm": []}, {}, "must be a list of at least one, got []"),
        ({"panel.spacing_mm": {"values": [1], "low": 2}}, {}, "got values and low"),
        ({"panel.spacing_mm": {"low": 3, "high": 2}}, {}, "must be less than high (2), got 3"),
        ({"panel.spacing_mm": {"low": 1, "high": 2}}, {}, "must come with a [design], got none"),
        ({"panel.spacing_mm": {"low": 1, "high": 2}}, {"design": {"n": 12}}, "must be a power of 2"),
        ({"panel.spacing_mm": [1]}, {"design": {"n": 8}}, "must come with parameters that have low and high"),
        ({"panel.spacing_mm": {"range": {"start": 1, "stop": 2, "step": -1}}}, {}, "must lead from 1 to 2, got -1"),
        ({"panel.spacing_mm": [1, 2], "panel.thickness_mm": [1]}, {"join": "zip"}, "spacing_mm: 2, thickness_mm: 1"),
        ({"panel.a": [1], "light.a": [1]}, {}, "got 'a' twice; give one a name"),
        ({"panel.a": [1], "panel.b": {"of": "c"}}, {}, "must be one of a, got 'c'"),
        ({}, {}, "must hold at least one, got none"),
        ({"panel.spacing_mm": [1]}, {"sensors_per_task": 5}, "must come with kind room, got panel"),
        ({"panel.spacing_mm": [1]}, {"joined": "zip"}, "got joined; did you mean join?"),
    ],
)
def test_mistakes_say_name_rule_value_and_way_out(parameters, more, message):
    with pytest.raises(ClerestoryError) as told:
        study(parameters, **more)
    assert message in str(told.value)


def test_one_variant_of_the_base_is_kept():
    base = {"panel": dict(PANEL), "variant": [{"name": "glass"}, {"name": "lcp"}]}
    tables = {"kind": "year", "base": base, "parameters": {"panel.spacing_mm": [2]}}
    assert sweep_of(tables | {"variant": "lcp"}, name="s.toml").base["variant"] == [{"name": "lcp"}]
    assert sweep_of(tables | {"variant": ""}, name="s.toml").base["variant"] == []
    assert len(sweep_of(tables, name="s.toml").base["variant"]) == 2
    with pytest.raises(ClerestoryError, match="variant must be one of , glass, lcp, got 'lpc'; did you mean 'lcp'"):
        sweep_of(tables | {"variant": "lpc"}, name="s.toml")


def test_the_quick_study_has_six_cases():
    assert len(quick().cases) == 6
