"""Long jobs: started, followed by server-sent events, cancelled."""

from __future__ import annotations

import hashlib
import json
from collections.abc import AsyncIterator, Callable
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response, StreamingResponse
from starlette.routing import Route

from clerestory.bsdf import Bsdf
from clerestory.panels.writing import described
from clerestory.rules import number, one_of
from clerestory.studio.answers import answer, plain, refused
from clerestory.studio.bsdf_shelf import Opened
from clerestory.studio.jobs import Job, Jobs
from clerestory.studio.panel_calls import asked_panel
from clerestory.studio.requests import Asked, asking, known, needed

#: Seconds between looks at a job, and between signs of life to the page.
_LOOK, _SIGN = 0.05, 10.0


def _angular(_: Request, asked: Asked) -> dict[str, Any]:
    known(asked, ("panel", "azimuth_deg", "side"))
    return {
        "panel": asked_panel(asked).to_dict(),
        "azimuth_deg": number("azimuth_deg", asked.get("azimuth_deg", 0.0)),
        "side": one_of("side", asked.get("side", "front"), ("front", "back")),
    }


def _dispersion(_: Request, asked: Asked) -> dict[str, Any]:
    known(asked, ("panel", "elevation_deg", "azimuth_deg"))
    return {
        "panel": asked_panel(asked).to_dict(),
        "elevation_deg": number("elevation_deg", needed(asked, "elevation_deg")),
        "azimuth_deg": number("azimuth_deg", asked.get("azimuth_deg", 0.0)),
    }


def _klems(_: Request, asked: Asked) -> dict[str, Any]:
    known(asked, ("panel",))
    return {"panel": asked_panel(asked).to_dict()}


def _shelve(state: Any, bsdf: Bsdf) -> dict[str, Any]:
    """Keeps a BSDF beside those that were opened."""
    key = hashlib.sha256(described(bsdf.exact).encode()).hexdigest()[:20]  # type: ignore[arg-type]
    return {"key": state.shelf.put(f"panel-{key}", Opened(bsdf))}


#: Kind of job → checks what was asked before it waits in line.
KINDS: dict[str, Callable[[Request, Asked], dict[str, Any]]] = {
    "angular": _angular,
    "dispersion": _dispersion,
    "klems": _klems,
}
#: Kind of job → what becomes of its result on this side.
FINISHES: dict[str, Callable[[Any, Any], Any]] = {"klems": _shelve}


def start(request: Request, asked: Asked) -> dict[str, Any]:
    """Puts a job in line: ``kind`` and its own fields."""
    kind = one_of("kind", needed(asked, "kind"), KINDS)
    arguments = KINDS[kind](request, {name: value for name, value in asked.items() if name != "kind"})
    jobs: Jobs = request.app.state.jobs
    finish = FINISHES.get(kind)
    state = request.app.state
    job = jobs.start(kind, arguments, (lambda result: finish(state, result)) if finish else lambda result: result)
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
            yield f"data: {json.dumps(plain(job.told()), allow_nan=False, separators=(',', ':'))}\n\n"
            seen, silent = version, 0.0
            if is_over:
                return
        await anyio.sleep(_LOOK)
        silent += _LOOK
        if silent >= _SIGN:
            yield ": still at it\n\n"
            silent = 0.0


ROUTES = [
    Route("/api/jobs", asking(start), methods=["POST"]),
    Route("/api/jobs/{key}", look, methods=["GET"]),
    Route("/api/jobs/{key}", cancel, methods=["DELETE"]),
    Route("/api/jobs/{key}/events", follow, methods=["GET"]),
]
