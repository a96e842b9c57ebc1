"""Lists of numbers as words of the command line: ``0:85:5`` or ``0,30,60``."""

from __future__ import annotations

import numpy as np

from clerestory.errors import ClerestoryError

#: More than this is a slip of the keyboard.
_MOST = 100_000


def number_list(name: str, text: str) -> list[float]:
    """Numbers of a list.

    Parameters
    ----------
    name : str
        What to call it in an error.
    text : str
        Parts between commas; each a number, or ``start:stop:step``, where stop counts if a whole number of steps meets
        it.

    Raises
    ------
    ClerestoryError
        If a part is neither, or a step does not lead from start to stop.
    """
    return [number for part in text.split(",") for number in _part(name, part.strip())]


def _part(name: str, part: str) -> list[float]:
    try:
        numbers = [float(word) for word in part.split(":")]
    except ValueError:
        numbers = []
    if not np.all(np.isfinite(numbers)) or len(numbers) not in (1, 3):
        raise ClerestoryError(f"{name} must be numbers or start:stop:step between commas, got {part!r}; try 0:85:5")
    if len(numbers) == 1:
        return numbers
    start, stop, step = numbers
    if step == 0.0 or (stop - start) / step < 0.0:
        raise ClerestoryError(f"the step of {name} must lead from {start:g} to {stop:g}, got {step:g}; try 0:85:5")
    # a stop that rounding misses by a hair is met
    count = int(np.floor((stop - start) / step * (1 + 1e-12) + 1e-9)) + 1
    if count > _MOST:
        raise ClerestoryError(f"{name} must have at most {_MOST} values, got {count}; take a larger step")
    return [start + step * place for place in range(count)]
