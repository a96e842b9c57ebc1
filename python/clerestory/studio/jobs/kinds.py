"""What a kind of long job is asked with, and what becomes of its answers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from starlette.requests import Request

from clerestory.studio.doors.fields import Fields
from clerestory.studio.doors.requests import Asked
from clerestory.studio.doors.shapes import Shape


@dataclass(frozen=True)
class Kind:
    """A kind of job.

    Parameters
    ----------
    fields : Fields
        What it is asked with, besides ``kind``.
    check : callable
        Makes of what was asked the arguments of the function of :mod:`clerestory.studio.jobs.work`; what is wrong is
        told before the job waits in line.
    partial, result : Shape
        Of what the page gets on the way and in the end.
    finish : callable, optional
        Makes of the application's state and the result what the page gets.
    heard : callable, optional
        Makes of the application's state, the arguments and what there is so far what the page gets of it.
    is_slow : bool, default False
        Whether it may take minutes: a process is then left for others.
    ends_alone : bool, default False
        Whether it ends when nobody follows it any more, as when its page is closed.
    """

    fields: Fields
    check: Callable[[Request, Asked], Asked]
    partial: Shape
    result: Shape
    finish: Callable[[Any, Any], Any] | None = None
    heard: Callable[[Any, Asked, Any], Any] | None = None
    is_slow: bool = False
    ends_alone: bool = False
