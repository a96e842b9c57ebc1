"""The long jobs of a room: how soon, how good, and how they end."""

import copy
from typing import Any

import numpy as np
import pytest
from tests.studio.following import ended, started
from tests.studio.test_room_calls import CLEAR, ROOM, WHEN, ask

from clerestory import daylight_coefficients, daylight_factor
from clerestory.studio.room.asked import asked_room
from clerestory.studio.room.kinds import start_tables
from clerestory.studio.room.pool import MOST_BATCHES, Batch, Pool, relative, scatter


def job(client: Any, **asked: Any) -> list[dict[str, Any]]:
    return ended(client, started(client, **{"kind": "room", "room": ROOM, "basis": "tregenza145", **asked}))


def test_coefficients_are_coarse_at_once_and_get_better(rooms: Any) -> None:
    events = job(rooms, target_relative_error=0.02)
    assert events[-1]["state"] == "done", events[-1]["errors"]
    partials = [event["partial"] for event in events if event["partial"]] + [events[-1]["result"]]
    result = partials[-1]
    assert result["converged"]
    assert result["worst_relative_error"] <= 0.02
    rounds = [one["rounds"] for one in partials]
    assert rounds == sorted(rounds)
    assert rounds[-1] >= 8
    # the error falls as the root of the work
    pool = rooms.app.state.room_shelf.get(result["key"]).pool
    begun = Pool(pool.batches[:2], 2)
    errors = [relative(*reversed(one.judged()))[1] for one in (begun, pool)]
    assert errors[1] == pytest.approx(result["mean_relative_error"])
    work = sum(one.weight for one in pool.batches) / sum(one.weight for one in begun.batches)
    assert work > 2.0
    assert errors[0] / errors[1] == pytest.approx(np.sqrt(work), rel=0.4)
    told = ask(rooms, "light", key=result["key"], sky={"kind": "overcast"}, **WHEN)
    own = daylight_factor(
        daylight_coefficients(
            asked_room(rooms.app.state, {"room": ROOM}).room(), basis="tregenza145", rounds=8, nodes=4096, seed=99
        )
    )
    error = np.hypot(told["daylight_factor_standard_error_percent"], own.total_standard_error.values)
    off = np.abs(np.array(told["daylight_factor_percent"]) - own.total.values) / error
    assert np.median(off) < 1.5
    assert off.max() < 6.0


def test_asking_again_goes_on_from_what_is_kept(rooms: Any) -> None:
    first = job(rooms, target_relative_error=0.04)[-1]["result"]
    again = job(rooms, target_relative_error=0.05)[-1]["result"]
    assert {name: again[name] for name in ("key", "rounds", "cpu_seconds")} == {
        name: first[name] for name in ("key", "rounds", "cpu_seconds")
    }, "what is good enough is not computed again"
    better = job(rooms, target_relative_error=0.9 * again["worst_relative_error"])[-1]["result"]
    assert better["rounds"] > again["rounds"]
    assert better["cpu_seconds"] > again["cpu_seconds"]


def test_what_the_light_does_not_depend_on_keeps_the_key(rooms: Any) -> None:
    key = job(rooms, target_relative_error=0.1)[-1]["result"]["key"]
    tables = copy.deepcopy(start_tables())
    tables["name"], tables["site"]["latitude_deg"] = "another", 40.0
    assert job(rooms, room={"tables": tables}, target_relative_error=0.1)[-1]["result"]["key"] == key
    for change in (
        {"variant": "glass only"},
        {"surface": "on ceiling", "spacing_m": 1.0},
        {"basis": "reinhart577"},
        {"room": {"tables": start_tables() | {"ground_reflectance": 0.4}}},
    ):
        assert job(rooms, target_relative_error=0.2, **change)[-1]["result"]["key"] != key


def test_the_sun_is_refined_while_one_looks(rooms: Any) -> None:
    key = job(rooms, target_relative_error=0.1)[-1]["result"]["key"]
    when = {"key": key, "sky": CLEAR, "day_of_year": 150, "hour": 9.5}
    coarse = ask(rooms, "light", **when)
    events = ended(rooms, started(rooms, kind="room_sun", target_relative_error=0.1, **when))
    assert events[-1]["state"] == "done", events[-1]
    fine = ask(rooms, "light", **when)
    assert fine["sun_rounds"] == events[-1]["result"]["rounds"] > coarse["sun_rounds"]
    assert np.mean(fine["sun_standard_error_lx"]) < np.mean(coarse["sun_standard_error_lx"])
    night = rooms.post("/api/jobs", json={"kind": "room_sun", **when, "hour": 1.0})
    assert (night.status_code, night.json()["errors"][0]["field"]) == (422, "hour")


@pytest.mark.parametrize(
    ("asked", "field"),
    [
        ({"target_relative_error": 0.0}, "target_relative_error"),
        ({"surface": "on roof"}, "surface"),
        ({"variant": "gold"}, "variant"),
        ({"basis": "cube"}, "basis"),
        ({"max_rounds": 1}, "max_rounds"),
        ({"spacing_m": -1.0, "surface": "on floor"}, "spacing_m"),
    ],
)
def test_mistakes_are_told_before_a_job_waits(rooms: Any, asked: dict[str, Any], field: str) -> None:
    answer = rooms.post("/api/jobs", json={"kind": "room", "room": ROOM, **asked})
    assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, field), answer.text


def batch(values: Any, weight: float = 1.0) -> Batch:
    values = np.asarray(values, dtype=np.float64)
    return Batch(values[None, :, None], weight, values, np.zeros(len(values)), 2)


def test_the_error_of_a_pool_is_that_of_its_mean() -> None:
    """Over many pools of noise the scatter of the mean is what each says of itself, weights equal or not."""
    noise = np.random.default_rng(4)
    for weights in ([1.0] * 5, [1.0, 1.0, 2.0, 4.0, 8.0]):
        means, variances = [], []
        for _ in range(2000):
            each = np.array([noise.normal(3.0, 1.0 / np.sqrt(weight), 1) for weight in weights])
            shares = np.array(weights) / sum(weights)
            means.append(shares @ each)
            variances.append(scatter(each, shares) ** 2)
        assert np.mean(variances) == pytest.approx(np.var(means), rel=0.1)
        assert np.mean(variances) == pytest.approx(1.0 / sum(weights), rel=0.1)


def test_a_pool_stays_small_and_keeps_its_mean() -> None:
    noise = np.random.default_rng(5)
    values, pool = noise.normal(2.0, 0.1, (50, 4)), Pool()
    for row in values:
        pool = pool.with_batch(batch(row), 0.5)
    assert len(pool.batches) <= MOST_BATCHES
    assert (pool.rounds, pool.passes, pool.cpu_seconds) == (100, 50, 25.0)
    np.testing.assert_allclose(pool.parts()[0, :, 0], values.mean(axis=0), rtol=1e-12)
    np.testing.assert_allclose(pool.judged()[0], values.mean(axis=0), rtol=1e-12)
    spread = scatter(pool.each(np.ones(1))[:, 0], pool.shares)
    np.testing.assert_allclose(spread, values.std(axis=0, ddof=1) / np.sqrt(50.0), rtol=0.6)


def test_one_batch_says_nothing_of_its_error() -> None:
    assert np.isnan(scatter(np.ones((1, 3)), np.ones(1))).all()
