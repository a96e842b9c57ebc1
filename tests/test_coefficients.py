"""Daylight coefficients as the user meets them."""

import numpy as np
import pytest
import xarray as xr

from clerestory.coefficients import PARTS, SensorWarning, daylight_coefficients
from clerestory.errors import ClerestoryError
from clerestory.illuminance import daylight_factor
from clerestory.room import Material, Opening, Room, SensorGrid, Sensors, Surface
from clerestory.saving import save
from clerestory.sky import BASES, CieSky, sky_basis

ROOM = Room.shoebox(
    width_m=4.0,
    depth_m=6.0,
    height_m=3.0,
    openings=[Opening(width_m=3.0, height_m=1.6)],
    sensors=[SensorGrid(spacing_m=1.0)],
)
FEW = {"basis": "tregenza145", "rounds": 4}


def total(coefficients: xr.Dataset) -> np.ndarray:
    return sum(coefficients[part].values for part in PARTS)


@pytest.mark.parametrize("basis", BASES)
def test_unobstructed_sensor_sees_pi(basis):
    """∫ cos θ dω over the hemisphere, whatever it is divided into."""
    direct = daylight_coefficients(open_field(), basis=basis, rounds=2).direct.values[0]
    assert direct.sum() == pytest.approx(np.pi, rel=1e-12)


def test_unobstructed_sensor_sees_each_patch_as_it_should():
    """∫ cos θ dω over a piece of a ring is Δα (sin² γ₂ − sin² γ₁) / 2."""
    found = daylight_coefficients(open_field(), basis="tregenza145", rounds=64)
    low, high, start, end = np.asarray(sky_basis("tregenza145").bounds)[:-1].T
    exact = (end - start) * (np.sin(high) ** 2 - np.sin(low) ** 2) / 2.0
    error = found.direct_standard_error.values[0, :-1]
    assert error.max() < 0.1 * exact.max()
    assert np.abs((found.direct.values[0, :-1] - exact) / error).max() < 5.0


def open_field() -> Room:
    below = Surface(
        name="plate", outline_m=[[0, 0, -9], [1, 0, -9], [0, 1, -9]], material=Material(diffuse_reflectance=0)
    )
    return Room(surfaces=(below,), sensors=(Sensors(points_m=[[0, 0, 0]]),))


def test_dataset_says_what_it_is_and_survives_a_file(tmp_path):
    coefficients = daylight_coefficients(ROOM, seed=3, **FEW)
    assert coefficients.direct.dims == ("sensor", "patch")
    assert dict(coefficients.sizes) == {"sensor": 24, "patch": 146}
    assert coefficients.direct.attrs["units"] == "sr"
    assert coefficients.attrs["seed"] == 3
    assert coefficients.attrs["basis"] == "tregenza145"
    save(coefficients, tmp_path / "coefficients.nc")
    with xr.load_dataset(tmp_path / "coefficients.nc") as read:
        assert read.identical(coefficients)


def test_same_seed_same_result_whatever_the_threads():
    one, two = (daylight_coefficients(ROOM, seed=5, threads=threads, **FEW) for threads in (1, 2))
    np.testing.assert_array_equal(total(one), total(two))
    assert not np.array_equal(total(one), total(daylight_coefficients(ROOM, seed=6, **FEW)))


def test_target_is_reached_at_every_sensor():
    coefficients = daylight_coefficients(ROOM, basis="tregenza145", target_relative_error=0.05)
    assert coefficients.attrs["converged"] == 1
    factor = daylight_factor(coefficients)
    assert float((factor.total_standard_error / factor.total).max()) <= 0.05
    assert factor.total_standard_error.attrs["kind"] == "standard error"


def test_stopping_keeps_what_is_there():
    def stop(done: int, _expected: int, _worst: float, _seconds: float) -> bool:
        return done < 3

    coefficients = daylight_coefficients(ROOM, basis="tregenza145", rounds=50, progress=stop)
    assert coefficients.attrs["interrupted"] == 1
    assert 3 <= coefficients.attrs["rounds"] < 50
    assert float(total(coefficients).sum()) > 0.0


def test_an_exception_while_watching_comes_through():
    def fail(*_: float) -> None:
        raise RuntimeError("no more")

    with pytest.raises(RuntimeError, match="no more"):
        daylight_coefficients(ROOM, basis="tregenza145", rounds=50, progress=fail)


def test_light_beyond_a_limit_of_bounces_is_told():
    """With a limit, what is found and what is lost are together what is found without one."""
    free = daylight_coefficients(ROOM, basis="tregenza145", rounds=64)
    few = daylight_coefficients(ROOM, basis="tregenza145", rounds=64, max_bounces=1)
    assert "lost" not in free
    whole, kept, lost = total(free).sum(), total(few).sum(), float(few.lost.sum())
    assert kept < whole
    assert kept + lost == pytest.approx(whole, rel=0.05)


def test_sensors_outside_are_warned_of():
    outside = Sensors(points_m=[[2.0, -9.0, 5.0], [2.0, 3.0, 1.0]], name="lost")
    with pytest.warns(SensorWarning, match=r"1 of 2 sensors of 'lost' stand outside the room"):
        daylight_coefficients(ROOM, outside, **FEW)


def test_errors_may_be_judged_under_another_sky():
    clear = CieSky(sky_type=12, sun_altitude_deg=40.0, diffuse_horizontal_illuminance_lx=1e4)
    coefficients = daylight_coefficients(ROOM, sky=clear, **FEW)
    assert "clear, low turbidity" in coefficients.attrs["judged_sky"]


@pytest.mark.parametrize(("more", "part"), [("nodes", "interreflected"), ("window_samples", "direct")])
def test_more_work_in_a_round_makes_its_part_surer(more, part):
    """Sixteen times the samples: an error a quarter as large, or better, as they are spread evenly."""
    few, many = (
        daylight_coefficients(ROOM, basis="tregenza145", rounds=16, **{more: n})[f"{part}_standard_error"].values
        for n in (128, 2048)
    )
    assert np.sqrt(np.mean(many**2)) < 0.35 * np.sqrt(np.mean(few**2))


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"basis": "reinhart578"}, "basis"),
        ({"sampling": "corner"}, r"sampling must be one of patch, centre, got 'corner'"),
        ({"rounds": 1}, r"rounds must be a whole number of at least 2, got 1"),
        ({"nodes": 0}, r"nodes must be a whole number of at least 1, got 0"),
        ({"window_samples": 2.5}, r"window_samples must be a whole number of at least 1, got 2.5"),
        ({"seed": -1}, r"seed must be a whole number of at least 0, got -1"),
        ({"max_bounces": 1.5}, r"max_bounces must be a whole number of at least 0, got 1.5"),
        ({"target_relative_error": 0.0}, r"target_relative_error must be greater than 0, got 0"),
        ({"sensors": []}, r"sensors must hold at least one grid or point"),
    ],
)
def test_wrong_parameters_say_name_rule_and_value(values, message):
    with pytest.raises(ClerestoryError, match=message):
        daylight_coefficients(ROOM, **values)


@pytest.mark.parametrize(
    ("outline", "message"),
    [
        ([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]], "bent tie"),
        ([[0, 0, 0], [1, 0, 0], [1, 1, 0.2], [0, 1, 0]], "bent tie"),
        ([[0, 0, 0], [1, 0, 0], [2, 0, 0]], "bent tie"),
    ],
)
def test_crossing_bent_and_flat_polygons_are_named(outline, message):
    room = Room(surfaces=(Surface(name="bent tie", outline_m=outline, material=Material(diffuse_reflectance=0.5)),))
    with pytest.raises(ClerestoryError, match=message):
        _ = room.scene


def test_one_ray_a_sector_is_near_the_whole_sector():
    """As published: for a plain opening the two ways differ only where an edge cuts a sector."""
    whole, centres = (
        daylight_coefficients(ROOM, basis="troplux5221", rounds=16, sampling=way) for way in ("patch", "centre")
    )
    assert float(centres.direct_standard_error.max()) == 0.0
    np.testing.assert_allclose(centres.direct.sum("patch"), whole.direct.sum("patch"), rtol=0.1)
    assert float(centres.direct.sum()) == pytest.approx(float(whole.direct.sum()), rel=0.02)


def test_target_out_of_reach_is_given_up_and_told():
    coefficients = daylight_coefficients(ROOM, basis="tregenza145", target_relative_error=1e-6, max_rounds=10)
    assert coefficients.attrs["converged"] == 0
    assert coefficients.attrs["rounds"] == 10
