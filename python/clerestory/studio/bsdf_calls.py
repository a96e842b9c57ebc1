"""Questions about a BSDF: files dropped or opened, discs, cuts, and the file of one that was computed."""

from __future__ import annotations

import warnings
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from clerestory.bsdf.told import BsdfWarning
from clerestory.errors import ClerestoryError
from clerestory.rules import one_of
from clerestory.studio.answers import answer, refused
from clerestory.studio.bsdf_answers import cut, discs, incidence_of, told
from clerestory.studio.bsdf_shelf import Shelf
from clerestory.studio.folder import inside
from clerestory.studio.panel_calls import xml_of
from clerestory.studio.requests import Asked, asking, known, needed

_LOOK = ("key", "elevation_deg", "azimuth_deg", "side", "band")


async def dropped(request: Request) -> Response:
    """A file's content as the body, its name as the query ``name``."""
    shelf: Shelf = request.app.state.shelf
    content, name = await request.body(), request.query_params.get("name", "file.xml")

    def read() -> dict[str, Any]:
        key = shelf.read(content, name)
        return told(key, shelf.get(key))

    try:
        return answer(await anyio.to_thread.run_sync(read, limiter=request.app.state.threads))
    except ClerestoryError as error:
        return refused(422, str(error), "file")


def opened(request: Request, asked: Asked) -> dict[str, Any]:
    """A file of the studio's folder, by ``path``; or one that is open, by ``key``."""
    known(asked, ("path", "key"))
    shelf: Shelf = request.app.state.shelf
    if "key" in asked:
        return told(asked["key"], shelf.get(asked["key"]))
    folder, limit = request.app.state.settings.folder, request.app.state.settings.most_upload_bytes
    path = inside(folder, needed(asked, "path"))
    if not path.is_file() or path.stat().st_size > limit:
        raise ClerestoryError(f"path must be a file of at most {limit} bytes, got {asked['path']!r}")
    key = shelf.read(path.read_bytes(), path.name)
    return told(key, shelf.get(key))


def disc(request: Request, asked: Asked) -> dict[str, Any]:
    """Where light of one incidence goes."""
    known(asked, _LOOK)
    return discs(request.app.state.shelf.get(needed(asked, "key")).bsdf, **_look(asked))


def section(request: Request, asked: Asked) -> dict[str, Any]:
    """A cut through the light of one incidence."""
    known(asked, (*_LOOK, "plane_deg"))
    bsdf = request.app.state.shelf.get(needed(asked, "key")).bsdf
    return cut(bsdf, **_look(asked), plane_deg=asked.get("plane_deg", 0.0))


def incidence(_: Request, asked: Asked) -> dict[str, Any]:
    """Elevation and azimuth of a point of a disc."""
    known(asked, ("x", "y"))
    return incidence_of(needed(asked, "x"), needed(asked, "y"))


def xml(request: Request, asked: Asked) -> Response:
    """The BSDF as LBNL's XML."""
    known(asked, ("key",))
    bsdf = request.app.state.shelf.get(needed(asked, "key")).bsdf
    with warnings.catch_warnings():
        # what the file makes up is told by the page's own findings
        warnings.simplefilter("ignore", BsdfWarning)
        return Response(xml_of(bsdf), media_type="application/xml", headers={"cache-control": "no-store"})


def _look(asked: Asked) -> dict[str, Any]:
    side = one_of("side", asked.get("side", "front"), ("front", "back"))
    return {
        "elevation_deg": needed(asked, "elevation_deg"),
        "azimuth_deg": asked.get("azimuth_deg", 0.0),
        "side": side,
        "band": asked.get("band", "visible"),
    }


ROUTES = [
    Route("/api/bsdf", dropped, methods=["POST"]),
    Route("/api/bsdf/open", asking(opened), methods=["POST"]),
    Route("/api/bsdf/discs", asking(disc), methods=["POST"]),
    Route("/api/bsdf/cut", asking(section), methods=["POST"]),
    Route("/api/bsdf/incidence", asking(incidence), methods=["POST"]),
    Route("/api/bsdf/xml", asking(xml), methods=["POST"]),
]
