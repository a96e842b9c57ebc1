"""How long panels of a shape took to be followed exactly, so that a dragged slider is answered at once."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Iterator
from dataclasses import fields
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from clerestory.panels import Panel

#: An answer that takes longer is no answer at once [s].
AT_ONCE_S = 0.012
#: Shapes that are remembered.
_MOST = 256


class Pace:
    """Seconds by the shape of a panel: its kind, and which of its arguments are not at their default."""

    def __init__(self) -> None:
        self._seconds: dict[tuple[str, ...], float] = {}
        self._lock = threading.Lock()

    def is_quick(self, panel: Panel) -> bool:
        """Whether panels of this shape were followed at once whenever they were; one not met before is not."""
        with self._lock:
            return self._seconds.get(_shape(panel), 1.0) <= AT_ONCE_S

    @contextlib.contextmanager
    def timed(self, panel: Panel) -> Iterator[None]:
        """Remembers how long what is done within takes: the longest, slowly forgotten."""
        start = time.perf_counter()
        yield
        took, shape = time.perf_counter() - start, _shape(panel)
        with self._lock:
            if len(self._seconds) >= _MOST:
                self._seconds.clear()
            self._seconds[shape] = max(took, 0.5 * self._seconds.get(shape, 0.0))


def _shape(panel: Panel) -> tuple[str, ...]:
    given = (f.name for f in fields(panel) if f.init and getattr(panel, f.name) != f.default)
    return (panel.kind, *given, str(len(panel.native_profile.facets()[1])))
