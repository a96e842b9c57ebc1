"""Long jobs: started, followed by server-sent events, cancelled."""

from __future__ import annotations

import hashlib
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response, StreamingResponse

from clerestory.bsdf import Bsdf
from clerestory.panels.writing import described
from clerestory.studio import room_jobs, year_calls
from clerestory.studio.answers import answer, refused, written
from clerestory.studio.bsdf_shelf import Opened
from clerestory.studio.fields import Field, Fields, checked, shape_of
from clerestory.studio.jobs import Job
from clerestory.studio.panel_calls import PANEL, asked_panel
from clerestory.studio.requests import Asked, Call, asking
from clerestory.studio.shapes import ANYTHING, NUMBER, TEXT, MisshapenError, fit, listed, maybe, record, word

#: Seconds between looks at a job, and between signs of life to the page.
_LOOK, _SIGN = 0.05, 10.0


@dataclass(frozen=True)
class Kind:
    """A kind of job.

    Parameters
    ----------
    fields : Fields
        What it is asked with, besides ``kind``.
    check : callable
        Makes of what was asked the arguments of the function of :mod:`clerestory.studio.work`; what is wrong is told
        before the job waits in line.
    finish : callable, optional
        Makes of the application's state and the result what the page gets.
    heard : callable, optional
        Makes of the application's state, the arguments and what there is so far what the page gets of it.
    """

    fields: Fields
    check: Callable[[Request, Asked], Asked]
    finish: Callable[[Any, Any], Any] | None = None
    heard: Callable[[Any, Asked, Any], Any] | None = None


def _of_panel(_: Request, asked: Asked) -> Asked:
    return {**asked, "panel": asked_panel(asked).to_dict()}


def _shelve(state: Any, bsdf: Bsdf) -> dict[str, Any]:
    """Keeps a BSDF beside those that were opened."""
    key = hashlib.sha256(described(bsdf.exact).encode()).hexdigest()[:20]  # type: ignore[arg-type]
    return {"key": state.shelf.put(f"panel-{key}", Opened(bsdf))}


_AZIMUTH = Field(NUMBER, "Azimuth that the light comes from, about the upright [°, -90..90]", 0.0)
#: The kinds of jobs; each has a function of the same name in :mod:`clerestory.studio.work`.
KINDS: dict[str, Kind] = {
    "angular": Kind(
        {
            "panel": PANEL,
            "azimuth_deg": _AZIMUTH,
            "side": Field(word("front", "back"), "Side that the light meets", "front"),
        },
        _of_panel,
    ),
    "dispersion": Kind(
        {
            "panel": PANEL,
            "elevation_deg": Field(
                NUMBER, "Elevation that the light comes from, above positive [°, -90..90]", example=40.0
            ),
            "azimuth_deg": _AZIMUTH,
        },
        _of_panel,
    ),
    "klems": Kind({"panel": PANEL}, _of_panel, _shelve),
    "year": Kind(year_calls.FIELDS, year_calls.check),
    "room": Kind(room_jobs.ROOM_FIELDS, room_jobs.asked_room_job, heard=room_jobs.keep_pass),
    "room_sun": Kind(room_jobs.SUN_FIELDS, room_jobs.asked_sun_job, heard=room_jobs.keep_sun_pass),
}
JOB = record(
    {
        "job": TEXT,
        "kind": TEXT,
        "state": word("waiting", "running", "done", "failed", "cancelled"),
        "done": NUMBER,
        "total": NUMBER,
        "partial": ANYTHING,
        "result": ANYTHING,
        "errors": listed(record({"field": maybe(TEXT), "message": TEXT})),
    }
)


def _fields(kind: str) -> Fields:
    return {"kind": Field(word(kind), "Kind of the job"), **KINDS[kind].fields}


def _checked(asked: Asked) -> Asked:
    if "kind" not in asked:
        raise MisshapenError("kind", f"kind must be given, one of {', '.join(KINDS)}; add it")
    fit("kind", asked["kind"], word(*KINDS))
    return checked(_fields(asked["kind"]), asked)


def start(request: Request, asked: Asked) -> dict[str, Any]:
    """Puts a job in line: `kind` and its own fields."""
    name = asked.pop("kind")
    kind, jobs, state = KINDS[name], request.app.state.jobs, request.app.state
    arguments = kind.check(request, asked)
    job: Job = jobs.start(
        name,
        arguments,
        lambda result: kind.finish(state, result) if kind.finish else result,
        lambda partial: kind.heard(state, arguments, partial) if kind.heard else partial,
    )
    return job.told()


async def look(request: Request) -> Response:
    """How far a job is."""
    job = request.app.state.jobs.get(request.path_params["key"])
    return answer(job.told()) if job else refused(404, "there is no such job (any more): start it again", "job")


async def cancel(request: Request) -> Response:
    """Ends a job."""
    job = request.app.state.jobs.cancel(request.path_params["key"])
    return answer(job.told()) if job else refused(404, "there is no such job (any more): start it again", "job")


async def follow(request: Request) -> Response:
    """Server-sent events: the job each time something changed, until it is over."""
    job = request.app.state.jobs.get(request.path_params["key"])
    if job is None:
        return refused(404, "there is no such job (any more): start it again", "job")
    headers = {"cache-control": "no-store", "x-accel-buffering": "no"}
    return StreamingResponse(_events(job), media_type="text/event-stream", headers=headers)


async def _events(job: Job) -> AsyncIterator[str]:
    seen, silent = -1, 0.0
    while True:
        version, is_over = job.version, job.is_over
        if version != seen:
            yield f"data: {written(job.told())}\n\n"
            seen, silent = version, 0.0
            if is_over:
                return
        await anyio.sleep(_LOOK)
        silent += _LOOK
        if silent >= _SIGN:
            yield ": still at it\n\n"
            silent = 0.0


ROUTES = [
    Call(
        "/api/jobs",
        asking(start, _checked),
        takes={"oneOf": [shape_of(_fields(name)) for name in KINDS]},
        gives=JOB,
    ),
    Call("/api/jobs/{key}", look, method="GET", gives=JOB),
    Call("/api/jobs/{key}", cancel, method="DELETE", gives=JOB),
    Call("/api/jobs/{key}/events", follow, method="GET", gives=TEXT, media="text/event-stream"),
]
