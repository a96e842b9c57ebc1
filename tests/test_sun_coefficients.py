"""What the sun itself gives a sensor."""

import warnings
from dataclasses import replace

import numpy as np
import pytest

from clerestory.coefficients import PARTS
from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass, Open
from clerestory.illuminance import sun_illuminance
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel
from clerestory.room import Interface, Material, Opening, Part, Room, SensorGrid, Sensors
from clerestory.sun_coefficients import SunWarning, sun_coefficients

PANEL = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, medium=Medium(n=1.49))


def room(glazing, reflectance=0.5):
    return Room.shoebox(
        width_m=4.0,
        depth_m=6.0,
        height_m=3.0,
        floor=reflectance,
        walls=reflectance,
        ceiling=reflectance,
        openings=[Opening(width_m=3.0, height_m=1.6, parts=[Part(glazing=glazing)])],
        sensors=[SensorGrid(spacing_m=0.5)],
    )


def test_sun_through_an_open_window_is_on_or_off():
    """A sensor the whole disc reaches has the sine of the altitude, one it does not reach has nothing."""
    direct = sun_coefficients(room(Open()), altitude_deg=40.0, azimuth_deg=180.0).direct.values[:, 0]
    lit = direct > 0.5 * np.sin(np.radians(40.0))
    assert 0 < lit.sum() < len(lit)
    np.testing.assert_allclose(direct[lit], np.sin(np.radians(40.0)), rtol=2e-3)


def test_sun_behind_the_building_gives_nothing():
    found = sun_coefficients(room(Open()), altitude_deg=40.0, azimuth_deg=0.0)
    assert sum(float(found[part].sum()) for part in PARTS) == 0.0


def test_panel_sends_the_sun_to_the_ceiling():
    up = SensorGrid(spacing_m=0.25, height_m=0.0, surface="ceiling", flip=True)
    pane, panel = (
        sun_coefficients(room(glazing, 0.0), up, altitude_deg=55.0, azimuth_deg=180.0)
        for glazing in (Glass(transmittance=0.88), PANEL)
    )
    assert float(pane.direct.sum() + pane.redirected.sum()) == 0.0
    assert float(panel.direct.sum()) == 0.0
    assert float(panel.redirected.max()) > 0.3


def test_flux_on_the_ceiling_is_the_share_of_the_lobes():
    """All light that the panel turns upwards lands on a large ceiling: power × area × cos θ_i."""
    tall = Room.shoebox(
        width_m=12.0,
        depth_m=12.0,
        height_m=3.0,
        floor=0.0,
        walls=0.0,
        ceiling=0.0,
        openings=[Opening(width_m=2.0, height_m=0.8, sill_m=2.0, parts=[Part(glazing=PANEL)])],
    )
    grid = SensorGrid(spacing_m=0.05, height_m=0.0, surface="ceiling", flip=True)
    found = sun_coefficients(tall, grid, altitude_deg=55.0, azimuth_deg=180.0)
    flux = float(found.redirected.sum()) * 0.05**2
    lobes = PANEL.lobes(elevation_deg=55.0)
    upwards = (lobes.side == "back") & (lobes.elevation_deg > 0.0)
    expected = float(lobes.power.where(upwards, 0.0).sum()) * 2.0 * 0.8 * np.cos(np.radians(55.0))
    assert flux == pytest.approx(expected, rel=0.02)


def test_illuminance_is_the_coefficient_times_the_normal_illuminance():
    found = sun_coefficients(room(Open()), altitude_deg=[30.0, 50.0], azimuth_deg=180.0)
    lit = sun_illuminance(found, 80_000.0)
    np.testing.assert_allclose(lit.total, 80_000.0 * sum(found[part] for part in PARTS))
    assert lit.total.dims == ("sensor", "sun")
    assert lit.total.attrs["units"] == "lx"


def test_same_seed_same_sun():
    one, two = (
        sun_coefficients(room(PANEL), altitude_deg=50.0, azimuth_deg=170.0, seed=4, threads=threads)
        for threads in (1, 2)
    )
    for part in PARTS:
        np.testing.assert_array_equal(one[part], two[part])


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"altitude_deg": [-5.0], "azimuth_deg": 0.0}, r"altitude_deg must be above the horizon, got -5"),
        ({"altitude_deg": [], "azimuth_deg": 0.0}, r"altitude_deg must be one row of angles"),
        ({"altitude_deg": float("nan"), "azimuth_deg": 0.0}, r"altitude_deg and azimuth_deg must be finite"),
    ],
)
def test_night_is_an_error(values, message):
    with pytest.raises(ClerestoryError, match=message):
        sun_coefficients(room(Open()), Sensors(points_m=[[2, 3, 1]]), **values)


def test_a_boundary_that_could_turn_the_sun_is_told_of():
    """What is not looked for is not left out in silence; mirrors are looked for."""
    plain = room(Glass(transmittance=0.88))
    corners = [[1.0, 1.0, 1.0], [2.0, 1.0, 1.0], [1.0, 2.0, 1.0], [1.0, 1.0, 2.0]]
    prism = Interface(
        name="prism", vertices_m=corners, triangles=[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], back_index=1.5
    )
    shiny = Material(diffuse_reflectance=0.1, specular_reflectance=0.8)
    mirrored = replace(plain, surfaces=(*plain.surfaces[:-1], replace(plain.surfaces[-1], material=shiny)))
    with pytest.warns(SunWarning, match="interface 'prism' is not looked for"):
        sun_coefficients(replace(plain, interfaces=(prism,)), altitude_deg=40.0, azimuth_deg=180.0, rounds=2)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        sun_coefficients(mirrored, altitude_deg=40.0, azimuth_deg=180.0, rounds=2)


def test_a_suns_light_may_be_that_of_any_sun():
    """With `any_sun` numbers do not hang on the suns that are asked with one; without it they are as right."""
    one, suns = room(PANEL), ([50.0, 25.0], [180.0, 150.0])
    both = sun_coefficients(one, altitude_deg=suns[0], azimuth_deg=suns[1], any_sun=True, rounds=16)
    alone = sun_coefficients(one, altitude_deg=50.0, azimuth_deg=180.0, any_sun=True, rounds=16)
    own = sun_coefficients(one, altitude_deg=50.0, azimuth_deg=180.0, rounds=16, seed=1)
    for part in PARTS:
        np.testing.assert_allclose(both[part].values[:, 0], alone[part].values[:, 0], rtol=1e-12, atol=1e-15)
    value, error = (
        [each[f"interreflected{kind}"].values[:, 0] for each in (alone, own)] for kind in ("", "_standard_error")
    )
    sigmas = (value[0] - value[1]) / np.hypot(*error)
    assert (np.array(error) < 0.1 * np.array(value)).all()
    assert np.abs(sigmas).max() < 5.0
