"""What the page asks for: JSON objects, checked for shape here and for sense by the API's own dataclasses."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from clerestory.errors import ClerestoryError
from clerestory.studio.answers import answer, field_of, refused
from clerestory.studio.doors.fields import Fields, checked, shape_of
from clerestory.studio.doors.shapes import TABLE, MisshapenError, Shape

Asked = dict[str, Any]

#: Deepest nesting of lists and tables in a request, and most entries of one of them.
_DEEPEST, _LONGEST = 16, 4096


class Call(Route):
    """An endpoint that says what it takes and what it gives.

    Parameters
    ----------
    path, endpoint
        As of a Starlette route. The first sentence of the endpoint's docstring tells what it is for.
    method : str, default "POST"
    takes : Shape, optional
        Of the JSON that is sent; or, with ``upload``, nothing.
    upload : str, optional
        Media type of a file that is sent instead.
    query : Fields, optional
        Of the address.
    gives : Shape, optional
        Of the JSON that is answered.
    media : str, default "application/json"
        Media type of the answer.
    """

    def __init__(
        self,
        path: str,
        endpoint: Callable[[Request], Any],
        *,
        method: str = "POST",
        takes: Shape | None = None,
        upload: str | None = None,
        query: Fields | None = None,
        gives: Shape = TABLE,
        media: str = "application/json",
    ) -> None:
        super().__init__(path, endpoint, methods=[method])
        # what asks for the head of an answer asks for no answer
        self.methods = {method}
        self.method, self.takes, self.upload, self.query = method, takes, upload, query or {}
        self.gives, self.media = gives, media


def call(
    path: str,
    work: Callable[[Request, Asked], Any],
    fields: Fields,
    *,
    gives: Shape = TABLE,
    media: str = "application/json",
    is_heavy: bool = False,
) -> Call:
    """A question: a JSON object of ``fields``, answered in a thread with what ``work`` makes of it; mistakes as 422.

    Heavy ones, of more than some 20 ms, wait in a line of their own, so that the light ones do not wait for them.
    """
    endpoint = asking(work, lambda asked: checked(fields, asked), is_heavy=is_heavy)
    return Call(path, endpoint, takes=shape_of(fields), gives=gives, media=media)


def asking(
    work: Callable[[Request, Asked], Any],
    check: Callable[[Asked], Asked] = lambda asked: asked,
    *,
    is_heavy: bool = False,
) -> Callable[[Request], Any]:
    """An endpoint that answers a checked JSON object with what ``work`` makes of it."""

    def answered(request: Request, asked: Asked) -> Response:
        found = work(request, dict(asked))
        return found if isinstance(found, Response) else answer(found)

    async def endpoint(request: Request) -> Response:
        asked: Asked = {}
        try:
            asked = check(await body(request))
            state = request.app.state
            async with state.heavy if is_heavy else state.threads:
                if await request.is_disconnected():
                    # nobody waits for it any more
                    return Response(status_code=204)
                return await anyio.to_thread.run_sync(answered, request, asked)
        except MisshapenError as error:
            return refused(422, str(error), error.field)
        except ClerestoryError as error:
            return refused(422, str(error), field_of(error, asked))

    endpoint.__name__ = work.__name__
    endpoint.__doc__ = work.__doc__
    return endpoint


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
    bounded(value)
    return value


def _no_constant(word: str) -> Any:
    raise ValueError(word)


def bounded(value: Any, depth: int = 0) -> None:
    """Checks that a value nests and lists no more than any real request does."""
    if depth > _DEEPEST:
        raise ClerestoryError(f"a request must nest at most {_DEEPEST} deep, got more")
    if isinstance(value, (list, dict)):
        if len(value) > _LONGEST:
            raise ClerestoryError(f"a list of a request must have at most {_LONGEST} entries, got {len(value)}")
        for one in value.values() if isinstance(value, dict) else value:
            bounded(one, depth + 1)
    elif isinstance(value, (int, float)) and not math.isfinite(_double(value)):
        raise ClerestoryError("a number of a request must be one that a computer's 64 bits hold, got a larger one")


def _double(value: float) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf


def table(asked: Asked, name: str) -> Asked:
    """A field that must be a JSON object."""
    value = asked[name]
    if not isinstance(value, dict):
        raise ClerestoryError(f"{name} must be a table, got {type(value).__name__}")
    return value
