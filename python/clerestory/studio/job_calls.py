"""Long jobs: started, followed by server-sent events, cancelled."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response, StreamingResponse

from clerestory.studio import panel_jobs, room_jobs, year_calls
from clerestory.studio.answers import answer, refused, written
from clerestory.studio.fields import Field, Fields, checked, shape_of
from clerestory.studio.job_kinds import Kind
from clerestory.studio.jobs import Job, Jobs
from clerestory.studio.requests import Asked, Call, asking
from clerestory.studio.shapes import ANYTHING, NUMBER, TEXT, MisshapenError, fit, listed, maybe, record, word

#: Seconds between looks at a job, and between signs of life to the page.
_LOOK, _SIGN = 0.05, 10.0
#: Seconds that a job goes on without a follower, if it ends alone.
_ALONE = 3.0


#: The kinds of jobs; each has a function of the same name in :mod:`clerestory.studio.work`.
KINDS: dict[str, Kind] = {
    **panel_jobs.KINDS,
    "year": Kind(year_calls.FIELDS, year_calls.check, is_slow=True),
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
        is_slow=kind.is_slow,
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
    events = _watched(request.app.state.jobs, job) if KINDS[job.kind].ends_alone else _events(job)
    return StreamingResponse(events, media_type="text/event-stream", headers=headers)


async def _watched(jobs: Jobs, job: Job) -> AsyncIterator[str]:
    """The events of a job that ends a little after its last follower is gone."""
    job.followers += 1
    try:
        async for event in _events(job):
            yield event
    finally:
        job.followers -= 1
        if not job.followers and not job.is_over:
            asyncio.get_running_loop().call_later(_ALONE, _end_alone, jobs, job)


def _end_alone(jobs: Jobs, job: Job) -> None:
    if not job.followers:
        jobs.cancel(job.key)


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
