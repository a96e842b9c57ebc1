"""Figures of a year show what they are given, where it belongs."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.plots import carpet, metric_plans, variant_dots
from clerestory.plots.carpet import by_day_and_hour


def hourly(start, count, clock):
    index = pd.date_range(start, periods=count, freq="h", tz=clock)
    utc = index.tz_convert("UTC").tz_localize(None).to_numpy().astype("datetime64[ns]")
    local = index.tz_localize(None).to_numpy().astype("datetime64[ns]")
    return xr.DataArray(
        np.arange(count, dtype=float),
        dims="time",
        coords={"time": utc, "local_time": ("time", local)},
        attrs={"units": "lx", "long_name": "illuminance"},
    )


def test_an_hour_stands_in_its_row_and_its_day():
    cells, days, hours = by_day_and_hour(hourly("2023-01-30 00:30", 72, "-05:00"))
    assert cells.shape == (24, 3)
    np.testing.assert_array_equal(cells.T.ravel(), np.arange(72.0))
    assert str(days[0])[:10] == "2023-01-30"
    assert (hours[0], hours[-1]) == (0.0, 24.0)


def test_a_clock_change_leaves_one_cell_empty_and_one_with_a_mean():
    spring, _, _ = by_day_and_hour(hourly("2023-03-12 00:30", 23, "America/New_York"))
    assert np.flatnonzero(np.isnan(spring[:, 0])).tolist() == [2]
    autumn, _, _ = by_day_and_hour(hourly("2023-11-05 00:30", 25, "America/New_York"))
    # 1:30 comes twice, as the second and the third hour
    assert autumn[1, 0] == 1.5
    assert np.isfinite(autumn).all()


def test_half_hours_have_rows_of_their_own():
    series = hourly("2023-06-01 00:15", 48, "UTC")
    half = series.assign_coords(
        time=series["time"].values[0] + np.arange(48) * np.timedelta64(30, "m"),
        local_time=("time", series["time"].values[0] + np.arange(48) * np.timedelta64(30, "m")),
    )
    cells, _, _ = by_day_and_hour(half)
    assert cells.shape == (48, 1)


def test_carpets_share_one_scale():
    series = hourly("2023-01-01 00:30", 24 * 40, "UTC")
    figure = carpet({"a": series, "b": series * 2.0}, title="Two")
    first, second, bar = figure.axes
    assert first.collections[0].norm is second.collections[0].norm
    assert "lx" in bar.get_ylabel()
    assert [axes.get_title(loc="left") for axes in (first, second)] == ["a", "b"]
    with pytest.raises(ClerestoryError, match="at least one"):
        carpet({})
    with pytest.raises(ClerestoryError, match="over time alone"):
        carpet({"a": series.expand_dims("sensor")})


def test_plans_stand_side_by_side_on_one_scale():
    row, column = (part.ravel() for part in np.mgrid[0:3, 0:2])
    values = xr.DataArray(
        np.linspace(0.0, 90.0, 6),
        dims="sensor",
        coords={
            "x_m": ("sensor", 0.5 + column),
            "y_m": ("sensor", 0.5 + row),
            "z_m": ("sensor", np.full(6, 0.8)),
            "row": ("sensor", row),
            "column": ("sensor", column),
            "group": ("sensor", ["floor"] * 6),
        },
        attrs={"units": "percent", "long_name": "daylight autonomy"},
    )
    figure = metric_plans({"a": values, "b": values / 2.0}, level=50.0)
    first, second, _ = figure.axes
    assert first.collections[0].get_clim() == second.collections[0].get_clim() == (0.0, 100.0)
    assert sorted(float(text.get_text()) for text in first.texts) == [0.0, 18.0, 36.0, 54.0, 72.0, 90.0]
    with pytest.raises(ClerestoryError, match="at least one"):
        metric_plans({})


def test_dots_stand_at_their_values():
    rows = {"sDA": {"glass": (50.0, 1.0), "panel": (60.0, 2.0)}, "ASE": {"panel": (10.0, 0.0)}}
    figure = variant_dots(rows)
    (axes,) = figure.axes
    places = {container.get_label(): container.lines[0].get_xdata().tolist() for container in axes.containers}
    assert places == {"glass": [50.0], "panel": [60.0, 10.0]}
    assert [label.get_text() for label in axes.get_yticklabels()] == ["sDA", "ASE"]
    with pytest.raises(ClerestoryError, match="at least one figure"):
        variant_dots({})
