"""Long jobs: started, followed by server-sent events, cancelled."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response, StreamingResponse

from clerestory.studio.answers import answer, refused, written
from clerestory.studio.doors.fields import Field, checked, shape_of
from clerestory.studio.doors.requests import Asked, Call, asking
from clerestory.studio.doors.shapes import TEXT, MisshapenError, Shape, fit, listed, record, word
from clerestory.studio.jobs.kinds import Kind
from clerestory.studio.jobs.running import Job, Jobs
from clerestory.studio.jobs.shapes import asked_fields, schemas
from clerestory.studio.panel import jobs as panel_jobs
from clerestory.studio.room import jobs as room_jobs
from clerestory.studio.year import calls as year_calls

#: Seconds between looks at a job, and between signs of life to the page.
_LOOK, _SIGN = 0.05, 10.0
#: Seconds that a job goes on without a follower, if it ends alone: enough for a page to be loaded again and find it.
ALONE_S = 8.0


#: The kinds of jobs; each has a function of the same name in :mod:`clerestory.studio.jobs.work`.
KINDS: dict[str, Kind] = {**panel_jobs.KINDS, **year_calls.KINDS, **room_jobs.KINDS}
#: Shapes of what is told of a job, for the description of the calls.
SCHEMAS = schemas(KINDS)
_JOB: Shape = {"$ref": "#/components/schemas/Job"}
_LISTED = record({"jobs": listed({"$ref": "#/components/schemas/ListedJob"})})
#: A stream is text; each line of it that begins with "data: " goes on with this.
_EVENTS: Shape = {
    **TEXT,
    "description": "Server-sent events; the data of each is a `Job` as JSON",
    "contentMediaType": "application/json",
    "contentSchema": _JOB,
}
_GONE = "there is no such job (any more): start it again"


def _checked(asked: Asked) -> Asked:
    if "kind" not in asked:
        raise MisshapenError("kind", f"kind must be given, one of {', '.join(KINDS)}; add it")
    fit("kind", asked["kind"], word(*KINDS))
    return checked(asked_fields(asked["kind"], KINDS[asked["kind"]]), asked)


def start(request: Request, asked: Asked) -> dict[str, Any]:
    """Puts a job in line: `kind` and its own fields."""
    whole, name = dict(asked), asked.pop("kind")
    kind, jobs, state = KINDS[name], request.app.state.jobs, request.app.state
    arguments = kind.check(request, asked)
    job: Job = jobs.start(
        name,
        arguments,
        lambda result: kind.finish(state, result) if kind.finish else result,
        lambda partial: kind.heard(state, arguments, partial) if kind.heard else partial,
        is_slow=kind.is_slow,
        asked=whole,
    )
    return job.told()


async def every(request: Request) -> Response:
    """The jobs that wait, run, or were lately over, the newest first: what each was asked, and how far it is."""
    kinds = request.query_params.getlist("kind")
    try:
        for one in kinds:
            fit("kind", one, word(*KINDS))
    except MisshapenError as error:
        return refused(422, str(error), "kind")
    # each that was asked for by a request
    found = [one for one in reversed(request.app.state.jobs.every()) if one.asked]
    return answer({"jobs": [_listed(one) for one in found if not kinds or one.kind in kinds]})


def _listed(job: Job) -> dict[str, Any]:
    """A job with what the page asked, and not with its arguments, which name places of this machine."""
    at = job.asked_at.isoformat(timespec="seconds")
    return {**job.told(), "asked": job.asked, "asked_at": at, "followers": job.followers}


async def look(request: Request) -> Response:
    """How far a job is."""
    job = request.app.state.jobs.get(request.path_params["key"])
    return answer(job.told()) if job else refused(404, _GONE, "job")


async def cancel(request: Request) -> Response:
    """Ends a job."""
    job = request.app.state.jobs.cancel(request.path_params["key"])
    return answer(job.told()) if job else refused(404, _GONE, "job")


async def follow(request: Request) -> Response:
    """Server-sent events: the job each time something changed, until it is over."""
    job = request.app.state.jobs.get(request.path_params["key"])
    if job is None:
        return refused(404, _GONE, "job")
    headers = {"cache-control": "no-store", "x-accel-buffering": "no"}
    return StreamingResponse(_counted(request.app.state.jobs, job), media_type="text/event-stream", headers=headers)


async def _counted(jobs: Jobs, job: Job) -> AsyncIterator[str]:
    """The events of a job, which if it is of that kind ends a little after its last follower is gone."""
    job.followers += 1
    try:
        async for event in _events(job):
            yield event
    finally:
        job.followers -= 1
        if not job.followers and not job.is_over and KINDS[job.kind].ends_alone:
            asyncio.get_running_loop().call_later(ALONE_S, _end_alone, jobs, job)


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
        takes={"oneOf": [shape_of(asked_fields(name, kind)) for name, kind in KINDS.items()]},
        gives=_JOB,
    ),
    Call(
        "/api/jobs",
        every,
        method="GET",
        query={"kind": Field(word(*KINDS), "Only the jobs of this kind", None)},
        gives=_LISTED,
    ),
    Call("/api/jobs/{key}", look, method="GET", gives=_JOB),
    Call("/api/jobs/{key}", cancel, method="DELETE", gives=_JOB),
    Call("/api/jobs/{key}/events", follow, method="GET", gives=_EVENTS, media="text/event-stream"),
]
