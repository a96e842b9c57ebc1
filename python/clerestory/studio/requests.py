"""What the page asks for: JSON objects, checked for shape here and for sense by the API's own dataclasses."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response

from clerestory.errors import ClerestoryError
from clerestory.rules import one_of
from clerestory.studio.answers import answer, field_of, refused

Asked = dict[str, Any]

#: Deepest nesting of lists and tables in a request, and most numbers of one list.
_DEEPEST, _LONGEST = 8, 4096


async def body(request: Request) -> Asked:
    """The JSON object of a request.

    Raises
    ------
    ClerestoryError
        If it is none, or nests or lists more than any real request does.
    """
    raw = await request.body()
    try:
        value = json.loads(raw, parse_constant=_no_constant)
    except (ValueError, RecursionError):
        raise ClerestoryError("a request must be JSON, got something else") from None
    if not isinstance(value, dict):
        raise ClerestoryError(f"a request must be a JSON object, got {type(value).__name__}")
    _bounded(value, 0)
    return value


def known(asked: Mapping[str, Any], names: tuple[str, ...]) -> None:
    """Every field of a request is one of a few."""
    for name in asked:
        one_of("a field", name, names)


def needed(asked: Mapping[str, Any], name: str) -> Any:
    """A field that must be there."""
    if name not in asked:
        raise ClerestoryError(f"{name} must be given, got {sorted(map(str, asked))}; add it")
    return asked[name]


def table(asked: Mapping[str, Any], name: str) -> Asked:
    """A field that must be a JSON object."""
    value = needed(asked, name)
    if not isinstance(value, dict):
        raise ClerestoryError(f"{name} must be a table, got {type(value).__name__}")
    return value


def asking(work: Callable[[Request, Asked], Any]) -> Callable[[Request], Any]:
    """An endpoint that answers a JSON object with what ``work`` makes of it, in a thread; mistakes as 422."""

    async def endpoint(request: Request) -> Response:
        asked: Asked = {}
        try:
            asked = await body(request)
            limiter = request.app.state.threads
            found = await anyio.to_thread.run_sync(lambda: work(request, asked), limiter=limiter)
        except ClerestoryError as error:
            return refused(422, str(error), field_of(error, asked))
        return found if isinstance(found, Response) else answer(found)

    endpoint.__name__ = work.__name__
    endpoint.__doc__ = work.__doc__
    return endpoint


def _no_constant(word: str) -> Any:
    raise ValueError(word)


def _bounded(value: Any, depth: int) -> None:
    if depth > _DEEPEST:
        raise ClerestoryError(f"a request must nest at most {_DEEPEST} deep, got more")
    if isinstance(value, (list, dict)):
        if len(value) > _LONGEST:
            raise ClerestoryError(f"a list of a request must have at most {_LONGEST} entries, got {len(value)}")
        for one in value.values() if isinstance(value, dict) else value:
            _bounded(one, depth + 1)
