"""Figures of rooms and skies hold the data they were given."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.colors import LogNorm

from clerestory.errors import ClerestoryError
from clerestory.plots import room_ceiling, room_plan, room_section, sky_dome
from clerestory.room import Opening, Room, SensorGrid
from clerestory.room.sensors import Sensors
from clerestory.sky import CieSky


def room(azimuth=180.0):
    return Room.shoebox(
        width_m=4.0,
        depth_m=6.0,
        height_m=3.0,
        facade_azimuth_deg=azimuth,
        openings=[Opening(width_m=3.0, height_m=1.5)],
    )


def on_grid(of_place, azimuth=180.0, **grid):
    """A value at every sensor of a grid from its place across and into the room."""
    (sensors,) = room(azimuth).sensor_points(SensorGrid(spacing_m=1.0, **grid))
    values = [of_place(column + 0.5, row + 0.5) for row, column in zip(sensors.row, sensors.column, strict=True)]
    return as_array(values, sensors)


def as_array(values, sensors):
    coords = {f"{axis}_m": ("sensor", sensors.points_m[:, k]) for k, axis in enumerate("xyz")}
    coords |= {"row": ("sensor", sensors.row), "column": ("sensor", sensors.column)}
    coords["group"] = ("sensor", [sensors.name] * len(sensors))
    about = {"units": "percent", "long_name": "daylight factor, total"}
    return xr.DataArray(values, dims="sensor", coords=coords, attrs=about)


@pytest.mark.parametrize("azimuth", [180.0, 0.0, 37.0])
def test_plan_lies_with_the_facade_at_the_bottom_wherever_it_looks(azimuth):
    values = on_grid(lambda across, into: 10.0 * into + across, azimuth)
    axes = room_plan(values, room=room(azimuth)).axes[0]
    texts = {text.get_text(): text.get_position() for text in axes.texts}
    assert len(texts) == 24
    np.testing.assert_allclose(texts["5.5"], (0.5, 0.5), atol=1e-9)
    np.testing.assert_allclose(texts["58.5"], (3.5, 5.5), atol=1e-9)
    window = axes.lines[0].get_xydata()
    np.testing.assert_allclose(window[:, 1], 0.0, atol=1e-9)
    np.testing.assert_allclose(np.ptp(window[:, 0]), 3.0)


def test_plan_of_a_wide_range_is_logarithmic_with_round_contours():
    figure = room_plan(on_grid(lambda across, into: 40.0 * 0.4**into))
    assert isinstance(figure.axes[0].collections[0].norm, LogNorm)
    np.testing.assert_allclose(figure.axes[1].get_yticks(), [0.5, 1, 2, 5, 10, 20])


def test_section_is_the_mean_of_each_row():
    values = on_grid(lambda across, into: 10.0 - into + 0.1 * across)
    axes = room_section({"glass": values, "panel": 0.5 * values}, room=room(), threshold=2.0).axes[0]
    np.testing.assert_allclose(axes.lines[0].get_xdata(), np.arange(6) + 0.5, atol=1e-9)
    np.testing.assert_allclose(axes.lines[0].get_ydata(), 10.0 - (np.arange(6) + 0.5) + 0.2)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["glass", "panel"]
    assert axes.get_ylabel() == "Daylight factor [%]"


def test_dome_puts_the_sun_in_the_brightest_patch():
    sky = CieSky(sky_type=13, sun_altitude_deg=30.0, sun_azimuth_deg=90.0, zenith_luminance_cd_m2=1000.0)
    axes = sky_dome(sky, basis="tregenza145").axes[0]
    patches = axes.collections[0]
    brightest = patches.get_paths()[int(np.argmax(patches.get_array()))]
    sun = axes.lines[0].get_xydata()[0]
    np.testing.assert_allclose(sun, (60.0, 0.0), atol=1e-9)
    assert brightest.contains_point(sun)
    np.testing.assert_allclose(patches.get_array(), sky.matrix("tregenza145").values[:-1])


def test_ceiling_draws_one_plan_a_sun_to_one_scale():
    values = on_grid(lambda across, into: into)
    several = xr.concat([values, 3.0 * values], dim="sun").transpose("sensor", "sun").assign_attrs(units="lx")
    figure = room_ceiling(several, room=room(), labels=["morning", "noon"])
    assert [axes.get_title(loc="left") for axes in figure.axes[:2]] == ["morning", "noon"]
    limits = [axes.collections[0].get_clim() for axes in figure.axes[:2]]
    assert limits == [(0.0, 16.5), (0.0, 16.5)]


def test_figures_refuse_what_is_no_grid():
    alone = Sensors(points_m=[[1, 1, 1]], row=[-1], column=[-1], name="alone")
    with pytest.raises(ClerestoryError, match="values must be of one grid of sensors, got alone"):
        room_plan(as_array([1.0], alone))
    with pytest.raises(ClerestoryError, match="curves must hold at least one"):
        room_section({})
    with pytest.raises(ClerestoryError, match="sky must hold one luminance a patch"):
        sky_dome(xr.DataArray(np.zeros(146), dims="patch"))
    many = xr.concat([on_grid(lambda across, into: into)] * 7, dim="sun")
    with pytest.raises(ClerestoryError, match="values must have at most 6 suns, got 7"):
        room_ceiling(many)
