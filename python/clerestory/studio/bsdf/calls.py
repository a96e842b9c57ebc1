"""Questions about a BSDF: files dropped or opened, discs, cuts, and the file of one that was computed."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response

from clerestory.bsdf.band import DIRECTIONS
from clerestory.bsdf.klems import KLEMS_BASES
from clerestory.errors import ClerestoryError
from clerestory.studio.answers import answer, refused
from clerestory.studio.bsdf.answers import curve, cut, discs, incidence_of, told
from clerestory.studio.bsdf.files import FORMATS, file_of
from clerestory.studio.bsdf.shelf import BsdfShelf
from clerestory.studio.doors.fields import Field
from clerestory.studio.doors.folder import inside
from clerestory.studio.doors.requests import Asked, Call, call
from clerestory.studio.doors.shapes import (
    INTEGER,
    NUMBER,
    TABLE,
    TEXT,
    MisshapenError,
    listed,
    maybe,
    named,
    record,
    word,
)

_KEY = Field(TEXT, "Key of an open BSDF, as the answer that opened it says")
_LOOK = {
    "key": _KEY,
    "elevation_deg": Field(NUMBER, "Elevation that the light comes from, above positive [°, -90..90]", example=40.0),
    "azimuth_deg": Field(NUMBER, "Azimuth that the light comes from, about the upright [°, -90..90]", 0.0),
    "side": Field(word("front", "back"), "Side that the light meets", "front"),
    "band": Field(TEXT, "Band of the spectrum, as the BSDF has it", "visible"),
}
_BLOCK = record(
    {"normal": NUMBER, "mean": NUMBER, "most": NUMBER},
    also={
        "incident_basis": TEXT,
        "outgoing_basis": TEXT,
        "tree_rank": INTEGER,
        "log2_resolution": INTEGER,
        "leaves": INTEGER,
    },
)
_OPENED = record(
    {
        "key": TEXT,
        "name": TEXT,
        "manufacturer": TEXT,
        "thickness_mm": maybe(NUMBER),
        "exact": maybe(TEXT),
        "bands": named(named(_BLOCK)),
        "about": TABLE,
        "assumed": listed(TEXT),
        "findings": listed(record({"severity": word("error", "warning", "note"), "where": TEXT, "text": TEXT})),
    }
)
_POINT = listed(NUMBER, least=2, most=2)
_DISC = {"word": TEXT, "cells": listed(listed(_POINT)), "values": listed(maybe(NUMBER))}
_DISCS = record(
    {
        "incident": record(_DISC),
        "picked": INTEGER,
        "point": _POINT,
        "outgoing": listed(record({**_DISC, "share": NUMBER, "mean": NUMBER, "standard_error": maybe(NUMBER)})),
    }
)
_CURVE = record(
    {"elevation_deg": listed(NUMBER), "curves": listed(record({"word": TEXT, "values": listed(maybe(NUMBER))}))}
)
_CUT = record(
    {
        "angle_deg": listed(NUMBER),
        "from_deg": NUMBER,
        "curves": listed(record({"word": TEXT, "values": listed(maybe(NUMBER))})),
    }
)


async def dropped(request: Request) -> Response:
    """Opens a BSDF's file that was dropped on the page: its content is the body."""
    shelf: BsdfShelf = request.app.state.shelf
    content, name = await request.body(), request.query_params.get("name", "file.xml")

    def read() -> dict[str, Any]:
        key = shelf.read(content, name)
        return told(key, shelf.get(key))

    try:
        return answer(await anyio.to_thread.run_sync(read, limiter=request.app.state.threads))
    except ClerestoryError as error:
        return refused(422, str(error), "file")


def opened(request: Request, asked: Asked) -> dict[str, Any]:
    """Opens a file of the studio's folder, by `path`; or tells again of one that is open, by `key`."""
    shelf: BsdfShelf = request.app.state.shelf
    if "key" in asked:
        return told(asked["key"], shelf.get(asked["key"]))
    if "path" not in asked:
        raise MisshapenError("path", "path must be given, got no key either; choose a file of the folder")
    folder, limit = request.app.state.settings.folder, request.app.state.settings.most_upload_bytes
    path = inside(folder, asked["path"])
    if not path.is_file() or path.stat().st_size > limit:
        raise ClerestoryError(f"path must be a file of at most {limit} bytes, got {asked['path']!r}")
    key = shelf.read(path.read_bytes(), path.name)
    return told(key, shelf.get(key))


def disc(request: Request, asked: Asked) -> dict[str, Any]:
    """Where light of one incidence goes."""
    return discs(request.app.state.shelf.get(asked.pop("key")).bsdf, **asked)


def section(request: Request, asked: Asked) -> dict[str, Any]:
    """A cut through the light of one incidence."""
    return cut(request.app.state.shelf.get(asked.pop("key")).bsdf, **asked)


def incidence(_: Request, asked: Asked) -> dict[str, Any]:
    """Where light comes from that travels along a point of a disc."""
    return incidence_of(**asked)


def xml(request: Request, asked: Asked) -> Response:
    """The BSDF as LBNL's XML."""
    bsdf = request.app.state.shelf.get(asked["key"]).bsdf
    return Response(file_of(bsdf, "xml"), media_type="application/xml", headers={"cache-control": "no-store"})


def against(request: Request, asked: Asked) -> dict[str, Any]:
    """Shares that pass and come back against the elevation of the light."""
    return curve(request.app.state.shelf.get(asked.pop("key")).bsdf, **asked)


def file(request: Request, asked: Asked) -> Response:
    """The BSDF as a file that another program reads."""
    bsdf = request.app.state.shelf.get(asked["key"]).bsdf
    given: dict[str, Any] = {name: asked[name] for name in ("name", "manufacturer", "thickness_mm") if name in asked}
    if asked.get("basis"):
        bsdf = bsdf.in_basis(asked["basis"])
    content = file_of(replace(bsdf, **given), asked["format"], band=asked["band"], direction=asked["direction"])
    return Response(content, media_type="application/octet-stream", headers={"cache-control": "no-store"})


ROUTES = [
    Call(
        "/api/bsdf",
        dropped,
        upload="application/octet-stream",
        query={"name": Field(TEXT, "Name of the file, which ends in .xml or .nc", "file.xml")},
        gives=_OPENED,
    ),
    call(
        "/api/bsdf/open",
        opened,
        {
            "path": Field(TEXT, "Path in the studio's folder, with / between names", None, example="glazing.xml"),
            "key": Field(TEXT, "Key of a BSDF that is open", None),
        },
        gives=_OPENED,
    ),
    call("/api/bsdf/discs", disc, _LOOK, gives=_DISCS),
    call(
        "/api/bsdf/cut",
        section,
        {**_LOOK, "plane_deg": Field(NUMBER, "Plane through the normal, turned from the upright [°, -90..90]", 0.0)},
        gives=_CUT,
    ),
    call(
        "/api/bsdf/incidence",
        incidence,
        {
            "x": Field(NUMBER, "To the right from the middle of a disc [° from the normal, -90..90]", example=10.0),
            "y": Field(NUMBER, "Up from the middle of a disc [° from the normal, -90..90]", example=10.0),
        },
        gives=record({"elevation_deg": NUMBER, "azimuth_deg": NUMBER}),
    ),
    call(
        "/api/bsdf/curve",
        against,
        {name: field for name, field in _LOOK.items() if name != "elevation_deg"},
        gives=_CURVE,
    ),
    call(
        "/api/bsdf/file",
        file,
        {
            "key": _KEY,
            "format": Field(word(*FORMATS), "Ending of the file", "xml"),
            "basis": Field(word(*KLEMS_BASES), "Klems basis to turn it into; without it as it is", None),
            "band": Field(TEXT, "Band of a matrix for Radiance (mtx)", "visible"),
            "direction": Field(word(*DIRECTIONS), "Block of a matrix for Radiance (mtx)", "transmission_front"),
            "name": Field(TEXT, "Name of the product, instead of its own", None),
            "manufacturer": Field(TEXT, "Likewise", None),
            "thickness_mm": Field(NUMBER, "Likewise [mm]", None),
        },
        gives=TEXT,
        media="application/octet-stream",
    ),
    call("/api/bsdf/xml", xml, {"key": _KEY}, gives=TEXT, media="application/xml"),
]
