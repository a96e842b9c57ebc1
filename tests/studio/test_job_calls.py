"""Long jobs: what they find, how they are followed, how soon they end."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from tests.studio.following import ended, started

from clerestory import panel_from_dict
from clerestory.studio.doors.shapes import MisshapenError, Shape, fit
from clerestory.studio.jobs.calls import KINDS
from clerestory.studio.jobs.shapes import job_shape
from clerestory.studio.panel.walk import ENOUGH

IDEAL = {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 5.0}
#: Takes a minute at least.
SLOW = IDEAL | {"spacing_mm": [3.1, 4.7, 5.3], "thickness_mm": 9.0, "cut_width_mm": 0.31, "cut_tilt_deg": 7.3}


def test_deflection_against_elevation_is_that_of_the_api(client: Any) -> None:
    events = ended(client, started(client, kind="angular", panel=IDEAL, azimuth_deg=20.0))
    assert events[-1]["state"] == "done"
    found = events[-1]["result"]
    assert len(found["elevation_deg"]) == 89
    table = panel_from_dict(IDEAL).angular(elevation_deg=found["elevation_deg"], azimuth_deg=20.0)
    for name in ("transmittance", "transmittance_deflected", "reflectance", "absorptance"):
        np.testing.assert_allclose(found[name], table[name].values.ravel(), atol=1e-12)
    done = [event["done"] for event in events]
    assert done == sorted(done)


def test_dispersion_is_that_of_the_api(client: Any) -> None:
    prism = {"kind": "prismatic", "pitch_mm": 2.0, "lower_deg": 45.0, "upper_deg": 80.0, "base_mm": 3.0}
    events = ended(client, started(client, kind="dispersion", panel=prism, elevation_deg=40.0))
    beams = events[-1]["result"]["beams"]
    at = {beam["wavelength_nm"] for beam in beams}
    # the medium is known from 420 nm
    assert (min(at), max(at)) == (425, 700)
    lobes = panel_from_dict(prism).lobes(elevation_deg=40.0, wavelength_nm=500.0)
    own = sorted(beam["elevation_deg"] for beam in beams if beam["wavelength_nm"] == 500)
    np.testing.assert_allclose(own, sorted(lobes["elevation_deg"].values[lobes["power"].values >= 1e-3]))


def test_the_klems_disc_of_a_panel_is_its_bsdf(client: Any) -> None:
    key = ended(client, started(client, kind="klems", panel=IDEAL))[-1]["result"]["key"]
    own = panel_from_dict(IDEAL).bsdf().visible.transmission_front
    discs = client.post("/api/bsdf/discs", json={"key": key, "elevation_deg": 40.0}).json()
    np.testing.assert_allclose(discs["incident"]["values"], own.hemispherical(), rtol=1e-12)
    np.testing.assert_allclose(discs["outgoing"][0]["values"], own.values[:, discs["picked"]], rtol=1e-12)
    assert b"LBNL/Klems Full" in client.post("/api/bsdf/xml", json={"key": key}).content


def test_what_is_wrong_is_told_before_a_job_waits(client: Any) -> None:
    answer = client.post("/api/jobs", json={"kind": "angular", "panel": IDEAL | {"cut_width_mm": 9}})
    assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, "cut_width_mm")
    answer = client.post("/api/jobs", json={"kind": "mining"})
    assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, "kind")
    assert client.get("/api/jobs/none").status_code == 404
    assert client.delete("/api/jobs/none").status_code == 404
    assert client.get("/api/jobs/none/events").status_code == 404


def test_what_is_wrong_within_a_job_is_told_beside_its_field(client: Any) -> None:
    rough = IDEAL | {"cut_slope_deg": 2.0}
    last = ended(client, started(client, kind="dispersion", panel=rough, elevation_deg=40.0))[-1]
    assert last["state"] == "failed"
    assert last["errors"][0]["field"] == "cut_slope_deg"
    assert "no beams" in last["errors"][0]["message"]


def test_a_short_question_does_not_wait_for_a_long_job(client: Any) -> None:
    key = started(client, kind="angular", panel=SLOW)
    assert client.post("/api/panel/section", json={"panel": IDEAL, "elevation_deg": 33.0}).status_code == 200
    assert client.get(f"/api/jobs/{key}").json()["state"] != "done"
    client.delete(f"/api/jobs/{key}")


def test_jobs_in_line_are_few(client: Any) -> None:
    most = client.app.state.jobs.most_jobs
    keys = [started(client, kind="angular", panel=SLOW) for _ in range(most)]
    answer = client.post("/api/jobs", json={"kind": "angular", "panel": SLOW})
    assert answer.status_code == 422
    assert "at most" in answer.json()["errors"][0]["message"]
    for key in keys:
        client.delete(f"/api/jobs/{key}")


def test_a_fault_in_a_job_or_in_what_becomes_of_it_is_told_and_ends_no_worker(client: Any) -> None:
    def broken(_: Any) -> Any:
        raise ZeroDivisionError

    jobs = client.app.state.jobs
    arguments = {"panel": IDEAL, "azimuth_deg": 0.0, "side": "front"}
    for kind, asked, finish in (
        ("angular", arguments, broken),
        ("angular", {"panel": 7}, lambda result: result),
    ):
        job = jobs.start(kind, asked, finish)
        assert ended(client, job.key)[-1]["state"] == "failed"
        assert "a fault of the program" in job.errors[0]["message"]
    assert ended(client, started(client, kind="angular", panel=IDEAL))[-1]["state"] == "done"


def test_rays_that_refine_end_where_their_errors_are_small(client: Any) -> None:
    rough = IDEAL | {"cut_slope_deg": 3.0}
    events = ended(client, started(client, kind="walk", panel=rough, elevation_deg=40.0))
    found = [event["partial"] for event in events if event["partial"]] + [events[-1]["result"]]
    rays = [one["rays"] for one in found]
    assert rays == sorted(rays)
    assert max(found[-1]["standard_errors"].values()) <= ENOUGH
    whole = sum(found[-1]["shares"][name] for name in ("transmittance", "reflectance", "absorptance", "residual"))
    assert whole == pytest.approx(1.0)


def test_every_kind_says_what_it_answers_down_to_the_numbers() -> None:
    """No part of an answer is declared as whatever it may be."""
    for kind in KINDS.values():
        for shape in (kind.partial, kind.result):
            assert list(leaves(shape))
            assert all("type" in leaf for leaf in leaves(shape)), shape
    shapes = {name: job_shape(name, kind) for name, kind in KINDS.items()}
    told = {"job": "a", "kind": "room", "state": "running", "done": 0.0, "total": 1.0, "partial": {}, "result": None}
    with pytest.raises(MisshapenError, match="key must be given"):
        fit("job", told | {"errors": []}, shapes["room"])


def leaves(shape: Shape) -> Iterator[Shape]:
    """What a shape is made of in the end; a table that does not say its names is such an end without a type."""
    if "anyOf" in shape:
        for one in shape["anyOf"]:
            yield from leaves(one)
    elif shape.get("type") == "array":
        yield from leaves(shape["items"])
    elif shape.get("type") == "object":
        assert shape["additionalProperties"] is False
        for one in shape["properties"].values():
            yield from leaves(one)
    else:
        yield shape
