"""Questions about results: opened from the folder or dropped, plans, sections, carpets, tables of cases."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import anyio
from starlette.requests import Request
from starlette.responses import Response

from clerestory.errors import ClerestoryError
from clerestory.studio.answers import answer, refused
from clerestory.studio.doors.fields import Field
from clerestory.studio.doors.requests import Asked, Call, call
from clerestory.studio.doors.shapes import INTEGER, NUMBER, TEXT, MisshapenError, word
from clerestory.studio.results import cases as result_cases
from clerestory.studio.results import plans as result_plans
from clerestory.studio.results.open import open_content, open_path
from clerestory.studio.results.shapes import CARPET, CASES, HOUR, LISTED, MONTHS, PLAN, SECTION, TOLD
from clerestory.studio.results.shelf import Result
from clerestory.studio.results.told import told
from clerestory.studio.year import carpet as year_carpet

_KEY = Field(TEXT, "Key of an open result, as the answer that opened it says")
_METRIC = Field(TEXT, "Key of a quantity, as the result lists them")
_PLANE = Field(TEXT, "Name of a grid of sensors; the first if none", None)
_SERIES = {
    "key": _KEY,
    "series": Field(word(*year_carpet.SERIES), "Mean or least of the work plane, or one sensor's", "mean"),
    "sensor": Field(INTEGER, "Place of the sensor in the result, from 0, for series sensor", None),
}


async def dropped(request: Request) -> Response:
    """Opens a result's file that was dropped on the page: its content is the body."""
    content, name = await request.body(), request.query_params.get("name", "file")
    state = request.app.state

    def read() -> dict[str, Any]:
        key = open_content(state.results, state.reader, content, name)
        return _in_words(state.results.get(key), lambda one: told(key, one, state.settings.folder))

    try:
        return answer(await anyio.to_thread.run_sync(read, limiter=request.app.state.readers))
    except ClerestoryError as error:
        return refused(422, str(error), "file")


def opened(request: Request, asked: Asked) -> dict[str, Any]:
    """Opens a result of the studio's folder, by `path`; or tells again of one that is open, by `key`."""
    state = request.app.state
    folder = state.settings.folder
    if "key" not in asked and "path" not in asked:
        raise MisshapenError("path", "path must be given, got no key either; choose a result of the folder")
    key = asked["key"] if "key" in asked else open_path(state.results, state.reader, folder, asked["path"])
    return _in_words(state.results.get(key), lambda one: told(key, one, folder))


def listed_results(request: Request, _: Asked) -> dict[str, Any]:
    """The results and the year files of the studio's folder."""
    state = request.app.state
    found: dict[str, Any] = state.listing.of(state.settings.folder, state.reader)
    return found


def _of(work: Callable[..., dict[str, Any]], kinds: tuple[str, ...]) -> Callable[[Request, Asked], dict[str, Any]]:
    """A question about an open result of a few kinds."""

    def asked_of(request: Request, asked: Asked) -> dict[str, Any]:
        result: Result = request.app.state.results.get(asked.pop("key"))
        if result.kind not in kinds:
            raise ClerestoryError(f"key must be that of a result of kind {' or '.join(kinds)}, got a {result.kind}")
        return _in_words(result, lambda one: work(one, **asked))

    asked_of.__name__ = work.__name__
    asked_of.__doc__ = work.__doc__
    return asked_of


def _in_words(result: Result, work: Callable[[Result], dict[str, Any]]) -> dict[str, Any]:
    """A file of anybody's may hold anything under the right names: what cannot be made of it is told."""
    try:
        return work(result)
    except ClerestoryError:
        raise
    except (ArithmeticError, AttributeError, IndexError, KeyError, MemoryError, TypeError, ValueError) as error:
        raise ClerestoryError(
            f"{result.name} does not hold what its kind has ({type(error).__name__}): it may be damaged, or changed by "
            "another program"
        ) from None


_YEAR, _PLANS = ("year",), ("year", "room")
ROUTES = [
    call("/api/result/files", listed_results, {}, gives=LISTED),
    Call(
        "/api/result",
        dropped,
        upload="application/octet-stream",
        query={"name": Field(TEXT, "Name of the file, which ends in .nc, .csv, .json or .zip", "file")},
        gives=TOLD,
    ),
    call(
        "/api/result/open",
        opened,
        {
            "path": Field(TEXT, "Path in the studio's folder, with / between names", None),
            "key": Field(TEXT, "Key of a result that is open", None),
        },
        gives=TOLD,
    ),
    call(
        "/api/result/plan",
        _of(result_plans.plan, _PLANS),
        {"key": _KEY, "metric": _METRIC, "plane": _PLANE},
        gives=PLAN,
    ),
    call(
        "/api/result/difference",
        _of(result_plans.difference, _PLANS),
        {
            "key": _KEY,
            "metric": _METRIC,
            "plane": _PLANE,
            "variant": Field(TEXT, "Label of a variant"),
            "minus": Field(TEXT, "Label of the variant that is taken from it"),
        },
        gives=PLAN,
    ),
    call(
        "/api/result/section",
        _of(result_plans.section, _PLANS),
        {"key": _KEY, "metric": _METRIC, "plane": _PLANE},
        gives=SECTION,
    ),
    call("/api/result/carpet", _of(year_carpet.carpet, _YEAR), _SERIES, gives=CARPET),
    call("/api/result/months", _of(year_carpet.months, _YEAR), _SERIES, gives=MONTHS),
    call(
        "/api/result/hour",
        _of(year_carpet.hour_plan, _YEAR),
        {
            "key": _KEY,
            "day": Field(TEXT, "Date on the wall clock, such as 2023-06-21"),
            "hour": Field(NUMBER, "Hour of the wall clock [h, 0..24]"),
            "plane": _PLANE,
        },
        gives=HOUR,
    ),
    call("/api/result/cases", _of(result_cases.cases, ("sweep", "design", "panel")), {"key": _KEY}, gives=CASES),
]
