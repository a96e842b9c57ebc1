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

from clerestory import _native
from clerestory.studio import bsdf_calls, job_calls, panel_calls
from clerestory.studio.answers import refused
from clerestory.studio.bsdf_shelf import Shelf
from clerestory.studio.folder import listed
from clerestory.studio.guard import Guard
from clerestory.studio.jobs import Jobs
from clerestory.studio.requests import Asked, asking, known
from clerestory.studio.settings import Settings

#: The built page, which comes with the wheel.
PAGE = Path(__file__).parent / "page"
#: Short questions answered at once; more wait, so that long ones do not starve the rest.
_THREADS = 4


def make_app(settings: Settings) -> Starlette:
    """The application for a server.

    Parameters
    ----------
    settings : Settings
    """
    jobs = Jobs(workers=settings.workers, most_jobs=settings.most_jobs, most_seconds=settings.most_seconds)

    @contextlib.asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        app.state.threads = anyio.CapacityLimiter(_THREADS)
        yield
        await anyio.to_thread.run_sync(jobs.close)

    routes: list[BaseRoute] = [
        Route("/api/about", asking(_about), methods=["POST"]),
        *panel_calls.ROUTES,
        *bsdf_calls.ROUTES,
        *job_calls.ROUTES,
        Route("/api/{rest:path}", _unknown),
        Mount("/", StaticFiles(directory=PAGE, html=True)) if PAGE.is_dir() else Route("/", _no_page),
    ]
    app = Starlette(
        routes=routes,
        lifespan=life,
        middleware=[Middleware(Guard, settings=settings)],
        exception_handlers={500: _fault},
    )
    app.state.settings, app.state.jobs, app.state.shelf = settings, jobs, Shelf()
    return app


def _about(request: Request, asked: Asked) -> dict[str, Any]:
    """The version, and the files of the studio's folder that a view opens."""
    known(asked, ())
    request.app.state.jobs.warm()
    folder = request.app.state.settings.folder
    return {"version": _native.__version__, "folder": folder.name, "files": listed(folder)}


async def _unknown(request: Request) -> Response:
    return refused(404, f"there is no {request.url.path}: see docs/how-to/studio.md")


async def _fault(_: Request, error: Exception) -> Response:
    return refused(500, f"a fault of the program: {type(error).__name__}; please report it with what you did")


async def _no_page(_: Request) -> Response:
    return PlainTextResponse(f"{NO_PAGE}\n", 503)


NO_PAGE = (
    "the studio's page is not built: install Node.js 18 or newer with npm and run `make prepare`, "
    "or install a wheel, which holds it; all else of clerestory works without"
)
