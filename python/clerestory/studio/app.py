"""The studio's server: the page, and the API's calls as JSON."""

from __future__ import annotations

import contextlib
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import anyio
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles
from starlette.types import Receive, Scope, Send

from clerestory import _native
from clerestory.studio import page_calls
from clerestory.studio.answers import answer, refused
from clerestory.studio.bsdf import calls as bsdf_calls
from clerestory.studio.bsdf.shelf import BsdfShelf
from clerestory.studio.doors.folder import ENDINGS
from clerestory.studio.doors.folder import listed as files_of
from clerestory.studio.doors.guard import Guard
from clerestory.studio.doors.openapi import description
from clerestory.studio.doors.requests import Asked, Call, call
from clerestory.studio.doors.shapes import TEXT, listed, record, word
from clerestory.studio.jobs import calls as job_calls
from clerestory.studio.jobs.running import Jobs
from clerestory.studio.panel import calls as panel_calls
from clerestory.studio.results import calls as result_calls
from clerestory.studio.results.listing import Listing
from clerestory.studio.results.reader import Reader
from clerestory.studio.results.shelf import ResultShelf
from clerestory.studio.room import calls as room_calls
from clerestory.studio.room.asked import Rooms
from clerestory.studio.room.shelf import RoomShelf
from clerestory.studio.settings import Settings
from clerestory.studio.warming import warm_beside

#: The built page, which comes with the wheel.
PAGE = Path(__file__).parent / "page"
#: Light and heavy questions answered at once; more wait, each in their line. More threads only wait for one another:
#: with four, the 95th percentile of a room's new depth was 320 ms while twenty dragged, with two it is 190 to 270.
_THREADS, _HEAVY = 2, 2
_ABOUT = record(
    {
        "version": TEXT,
        "folder": TEXT,
        "files": listed(record({"path": TEXT, "kind": word(*dict.fromkeys(ENDINGS.values()))})),
    }
)


def make_app(settings: Settings) -> Starlette:
    """The application for a server.

    Parameters
    ----------
    settings : Settings
    """
    reader = Reader()
    jobs = Jobs(workers=settings.workers, most_jobs=settings.most_jobs, most_seconds=settings.most_seconds)

    @contextlib.asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        app.state.threads = anyio.CapacityLimiter(_THREADS)
        app.state.heavy = anyio.CapacityLimiter(_HEAVY)
        # one file at a time is read, and none takes the threads of the short questions
        app.state.readers = anyio.CapacityLimiter(1)
        yield
        await anyio.to_thread.run_sync(jobs.close)
        await anyio.to_thread.run_sync(reader.close)

    routes: list[BaseRoute] = [
        call("/api/about", _about, {}, gives=_ABOUT),
        *page_calls.ROUTES,
        *panel_calls.ROUTES,
        *bsdf_calls.ROUTES,
        *result_calls.ROUTES,
        *room_calls.ROUTES,
        *job_calls.ROUTES,
        Call("/api/openapi.json", _described, method="GET"),
        Route("/api/{rest:path}", _Elsewhere()),
        Mount("/", StaticFiles(directory=PAGE, html=True)) if PAGE.is_dir() else Route("/", _no_page),
    ]
    app = Starlette(
        routes=routes,
        lifespan=life,
        middleware=[Middleware(Guard, settings=settings)],
        exception_handlers={500: _fault},
    )
    app.state.settings, app.state.jobs, app.state.shelf = settings, jobs, BsdfShelf()
    app.state.results, app.state.reader, app.state.listing = ResultShelf(), reader, Listing()
    app.state.rooms, app.state.room_shelf = Rooms(), RoomShelf()
    return app


def _about(request: Request, asked: Asked) -> dict[str, Any]:
    """The version, and the files of the studio's folder that a view opens."""
    request.app.state.jobs.warm()
    warm_beside()
    folder = request.app.state.settings.folder
    return {"version": _native.__version__, "folder": folder.name, "files": files_of(folder)}


async def _described(request: Request) -> Response:
    """This description of the calls."""
    return answer(
        description(
            request.app.routes, has_token=request.app.state.settings.token is not None, schemas=job_calls.SCHEMAS
        )
    )


class _Elsewhere:
    """What no call is for: another way to ask one that there is, or a path of none."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        path = scope["path"]
        allowed = [one.method for one in scope["app"].routes if isinstance(one, Call) and one.path_regex.match(path)]
        if allowed:
            found = refused(405, f"{path} must be asked with {' or '.join(allowed)}, got {scope['method']}")
            found.headers["allow"] = ", ".join(allowed)
        else:
            found = refused(404, f"there is no {path}: see /api/openapi.json")
        await found(scope, receive, send)


async def _fault(_: Request, error: Exception) -> Response:
    return refused(500, f"a fault of the program: {type(error).__name__}; please report it with what you did")


async def _no_page(_: Request) -> Response:
    return PlainTextResponse(f"{NO_PAGE}\n", 503)


NO_PAGE = (
    "the studio's page is not built: install Node.js 18 or newer with npm and run `make prepare`, "
    "or install a wheel, which holds it; all else of clerestory works without"
)
