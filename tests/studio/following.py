"""Jobs of a studio: started, followed with each event held against its declared shape, and left."""

import json
import os
import time
from typing import Any

import psutil

from clerestory.studio.doors.shapes import fit
from clerestory.studio.jobs.calls import KINDS
from clerestory.studio.jobs.shapes import job_shape


def started(client: Any, **asked: Any) -> str:
    """The key of a job that is in line."""
    answer = client.post("/api/jobs", json=asked)
    assert answer.status_code == 200, answer.text
    return str(is_as_declared(answer.json())["job"])


def ended(client: Any, key: str) -> list[dict[str, Any]]:
    """Every event of a job until it is over, each as it is declared."""
    told = []
    with client.stream("GET", f"/api/jobs/{key}/events") as stream:
        assert stream.headers["content-type"].startswith("text/event-stream")
        for line in stream.iter_lines():
            if line.startswith("data: "):
                told.append(is_as_declared(json.loads(line[6:])))
    return told


def looked(client: Any, key: str) -> dict[str, Any]:
    """What is told of a job now."""
    return is_as_declared(client.get(f"/api/jobs/{key}").json())


def is_as_declared(told: dict[str, Any]) -> dict[str, Any]:
    """What is told of a job, which is what the description of its kind says."""
    fit("job", told, job_shape(told["kind"], KINDS[told["kind"]]))
    assert (told["result"] is not None) == (told["state"] == "done")
    return told


def works(client: Any, key: str) -> dict[str, Any]:
    """What is told of a job as soon as there is something of it."""
    late = time.monotonic() + 300.0
    while (told := looked(client, key))["partial"] is None:
        assert told["state"] in ("waiting", "running"), told
        assert time.monotonic() < late, told
        time.sleep(0.02)
    return told


def is_left_at_once(client: Any, key: str) -> None:
    """Cancels a job that works: its process stops or ends within a second, and the next job is done.

    The second is one of the process' own work on all cores: a machine that is busy with others gives it less than that,
    and then more time passes. A process that goes on is seen by its work and, at the last, by the clock.
    """
    [process] = [one for one in client.app.state.jobs.processes() if one.is_busy]
    before = cpu_s(process.pid)
    assert before is not None
    assert client.delete(f"/api/jobs/{key}").json()["state"] == "cancelled"
    late, last = time.monotonic() + 60.0, before
    while process.is_busy and time.monotonic() < late:
        last = cpu_s(process.pid) or last
        time.sleep(0.01)
    assert not process.is_busy, "it went on for a minute"
    assert last - before <= 1.0 * (os.cpu_count() or 1), "it worked on for more than a second"
    # what says that it has stopped works no more
    quiet = cpu_s(process.pid)
    time.sleep(0.5)
    assert quiet is None or (cpu_s(process.pid) or quiet) - quiet < 0.1
    assert looked(client, key)["state"] == "cancelled"
    panel = {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 5.0}
    key, late = started(client, kind="dispersion", panel=panel, elevation_deg=30.0), time.monotonic() + 300.0
    while (told := looked(client, key))["state"] != "done":
        assert told["state"] in ("waiting", "running"), told
        assert time.monotonic() < late, told
        time.sleep(0.02)


def cpu_s(process: int) -> float | None:
    """CPU seconds of a process so far, all threads together; None if it is gone."""
    try:
        times = psutil.Process(process).cpu_times()
    except psutil.NoSuchProcess:
        return None
    return float(times.user + times.system)
