"""`clerestory weather` and its figures."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

from clerestory import ClerestoryError, Weather, read_wea
from clerestory.cli import app
from clerestory.plots import weather_carpet
from clerestory.weather.summary import summary

from .conftest import MIAMI


def run(*words):
    return CliRunner().invoke(app, ["weather", *map(str, words)])


def test_summary_is_printed_and_drawn(tmp_path):
    done = run(MIAMI, "--out", tmp_path / "out", "--wea", tmp_path / "miami.wea")
    assert done.exit_code == 0, done.output
    assert "25.82° north" in done.output
    assert "1454 kWh/m²" in done.output
    assert "note: months of 1977 to 2004 put together" in done.output
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "weather.png",
        "sky-clearest.png",
        "sky-dullest.png",
    }
    assert len(read_wea(tmp_path / "miami.wea")) == 8760


def test_json_holds_the_summary(miami):
    told = json.loads(run(MIAMI, "--json").output)
    assert told["files"] == []
    assert told["direct_normal_kwh_m2"] == pytest.approx(miami.frame.direct_normal_irradiance_w_m2.sum() / 1e3)
    assert told["daylit_hours"] == told["overcast_hours"] + told["intermediate_hours"] + told["clear_hours"]
    assert told["sunshine_hours"] == (miami.frame.direct_normal_irradiance_w_m2 > 120.0).sum()
    assert told["hours"] == 8760.0


def test_global_light_of_the_summary_is_near_the_files_own(miami):
    """TMY3 has a global irradiance of its own."""
    own = miami.frame.global_horizontal_irradiance_w_m2.sum() / 1e3
    assert summary(miami)["global_horizontal_kwh_m2"] == pytest.approx(own, rel=0.01)


def test_shorter_intervals_keep_the_sums(miami):
    told = json.loads(run(MIAMI, "--json", "--minutes", "30").output)
    assert told["intervals"] == 17520
    assert told["direct_normal_kwh_m2"] == pytest.approx(summary(miami)["direct_normal_kwh_m2"])


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["none.epw"], "none.epw must be a file to read"),
        ([MIAMI, "--timezone", "Asia/Tokyo"], "timezone must keep the file's standard time"),
        ([MIAMI, "--minutes", "7"], "minutes must divide the interval of 60 min, got 7"),
        (["a.wea", "--timezone", "UTC"], "timezone must be left out for a WEA file"),
    ],
)
def test_mistakes_are_told_in_one_line(words, message):
    done = run(*words)
    assert done.exit_code == 2
    assert message in done.stderr
    assert done.stderr.count("\n") == 1


def test_carpet_holds_each_hour_once(miami):
    figure = weather_carpet(miami, columns=("diffuse_horizontal_irradiance_w_m2",))
    (mesh,) = [one for one in figure.axes[0].collections if type(one).__name__ == "QuadMesh"]
    values = np.asarray(mesh.get_array()).reshape(24, 365)
    np.testing.assert_array_equal(values.T.ravel(), miami.frame.diffuse_horizontal_irradiance_w_m2)


def test_carpet_of_a_day_and_of_an_unknown_column(miami):
    day = Weather.from_frame(miami.frame.iloc[24:48], miami.site)
    assert weather_carpet(day).axes
    with pytest.raises(ClerestoryError, match="columns must be among"):
        weather_carpet(day, columns=("rain",))
