"""The calls of the studio in words that other programs read: an OpenAPI 3.1 description of its routes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from starlette.routing import BaseRoute

from clerestory import _native
from clerestory.studio.doors.requests import Call
from clerestory.studio.doors.shapes import TEXT, Shape, listed, maybe, record

#: What every refusal holds.
ERRORS = record({"errors": listed(record({"field": maybe(TEXT), "message": TEXT}), least=1)})
_REFUSALS = {
    "401": "No token, or a wrong one, where one is needed",
    "403": "A Host, an Origin or a page that is not the studio's own",
    "404": "There is nothing of this name (any more)",
    "413": "More bytes than a request may hold",
    "422": "What was asked breaks a rule: which field, and what to do",
}


def description(
    routes: Iterable[BaseRoute], *, has_token: bool, schemas: Mapping[str, Shape] | None = None
) -> dict[str, Any]:
    """The OpenAPI description of those routes that are calls.

    Parameters
    ----------
    routes : iterable of routes
    has_token : bool
        Whether each request must carry a token.
    schemas : mapping of str → Shape, optional
        Shapes that answers refer to by name.
    """
    paths: dict[str, Any] = {}
    for one in routes:
        if isinstance(one, Call):
            paths.setdefault(one.path, {})[one.method.lower()] = _operation(one, has_token)
    bearer = {"type": "http", "scheme": "bearer", "description": "The token that the studio printed when it started"}
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "Clerestory studio",
            "version": _native.__version__,
            "description": "The calls of the studio's page. Units stand in the names; axes and signs are those of "
            "NOTATION.md. Every refusal says in words what is wrong, and which field is.",
            "license": {"name": "MIT OR Apache-2.0", "identifier": "MIT OR Apache-2.0"},
        },
        "paths": paths,
        "components": {
            "schemas": {"Errors": ERRORS, **(schemas or {})},
            "responses": {code: _refusal(text) for code, text in _REFUSALS.items()},
            **({"securitySchemes": {"bearer": bearer}} if has_token else {}),
        },
        **({"security": [{"bearer": []}]} if has_token else {}),
    }


def _operation(one: Call, has_token: bool) -> dict[str, Any]:
    keys = re.findall(r"{(\w+)}", one.path)
    codes = (
        ["403", "413"]
        + ["401"] * has_token
        + ["404"] * bool(keys)
        + ["422"] * (one.takes is not None or bool(one.query))
    )
    parameters = [
        {
            "name": name,
            "in": "path",
            "required": True,
            "schema": TEXT,
            "description": "As the answer that began it says",
        }
        for name in keys
    ] + [
        {"name": name, "in": "query", "required": field.is_needed, "schema": field.described}
        for name, field in one.query.items()
    ]
    told = (one.endpoint.__doc__ or "").strip().split("\n\n")[0]
    return {
        "operationId": f"{one.method.lower()}_{re.sub(r'[^a-z0-9]+', '_', one.path.lower()).strip('_')}",
        "summary": " ".join(told.split()),
        "tags": [one.path.split("/")[2].removesuffix(".json")],
        **({"parameters": parameters} if parameters else {}),
        **_body(one),
        "responses": {
            "200": {"description": "What was asked for", "content": {one.media: {"schema": one.gives}}},
            **{code: {"$ref": f"#/components/responses/{code}"} for code in sorted(codes)},
        },
    }


def _body(one: Call) -> dict[str, Any]:
    if one.upload:
        # any bytes: a media type without a schema
        return {"requestBody": {"required": True, "content": {one.upload: {}}}}
    if one.takes is None:
        return {}
    return {"requestBody": {"required": True, "content": {"application/json": {"schema": one.takes}}}}


def _refusal(text: str) -> Shape:
    return {"description": text, "content": {"application/json": {"schema": {"$ref": "#/components/schemas/Errors"}}}}
