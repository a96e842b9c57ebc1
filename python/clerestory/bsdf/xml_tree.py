"""Tensor trees as LBNL's files write them: braces within braces."""

from __future__ import annotations

import re

import numpy as np

from clerestory.bsdf.shirley_chiu import Floats
from clerestory.bsdf.tree_block import DEEPEST, TreeBlock
from clerestory.bsdf.tree_turning import preorder_of_grid
from clerestory.bsdf.xml_place import Place, shortened
from clerestory.errors import ClerestoryError

_WORD = re.compile(r"[{}]|[^\s,{}]+")


def tree_of(place: Place, rank: int) -> TreeBlock:
    """The tree that stands in an element.

    A brace holds its 2**rank children, or the 2**(rank k) values of a grid, the last coordinate running fastest.

    Raises
    ------
    ClerestoryError
        If braces or counts are wrong, or it is deeper than 12 levels.
    """
    size = 2**rank
    walk: list[Floats | float] = []
    left: list[int] = []  # children still to come of each open brace
    grid: list[str] | None = None  # values of the innermost brace, before it is known to hold braces instead
    ended = False
    for found in _WORD.finditer(place.element.text or ""):
        word = found.group()
        if ended:
            place.wrong(f"must end with its outermost brace, got {shortened(word)} after it")
        if word == "{":
            if grid:
                place.wrong("must hold values or braces in a brace, not both")
            if grid is not None:
                walk.append(np.nan)
                left.append(size)
            if left:
                left[-1] -= 1
                if left[-1] < 0:
                    place.wrong(f"must hold {size} braces in each brace of braces, got more")
            if len(left) > DEEPEST:
                place.wrong(f"must be no deeper than {DEEPEST} braces, got more")
            grid = []
        elif word == "}":
            if grid is not None:
                walk.append(_values(place, grid, rank))
                grid = None
            elif not left:
                place.wrong("must open each brace that it closes")
            elif left.pop() != 0:
                place.wrong(f"must hold {size} braces in each brace of braces, got fewer")
            ended = not left
        elif grid is None:
            place.wrong(f"must hold each value in a brace, got {shortened(word)} outside")
        else:
            grid.append(word)
    if not ended:
        place.wrong("must close every brace" if walk or left or grid is not None else "must hold a tree, got nothing")
    try:
        return TreeBlock(rank, np.concatenate([np.atleast_1d(part) for part in walk]))
    except ClerestoryError as cause:
        place.wrong(f"must hold a tree: {cause}")


def _values(place: Place, words: list[str], rank: int) -> Floats:
    values = finite(place, words)
    if len(values) == 1:
        return values
    levels = (len(values).bit_length() - 1) // rank
    if len(values) != 2 ** (rank * levels):
        place.wrong(f"must hold 2^({rank} k) values in a brace, got {len(values)}")
    if levels > DEEPEST:
        place.wrong(f"must be no deeper than {DEEPEST} levels, got {levels}")
    return preorder_of_grid(values.reshape((2**levels,) * rank))


def finite(place: Place, words: list[str]) -> Floats:
    """Words as finite numbers."""
    try:
        values = np.array(words, dtype=np.float64)
        plain = "_" not in "".join(words)
    except ValueError:
        plain = False
    if not plain:
        wrong = next((word for word in words if not _is_number(word)), "")
        place.wrong(f"must hold numbers, got {shortened(wrong)}")
    if not np.isfinite(values).all():
        number = int(np.argmax(~np.isfinite(values)))
        place.wrong(f"must hold finite values, got {words[number]} as number {number + 1}")
    return values


def _is_number(word: str) -> bool:
    try:
        float(word.replace("_", "?"))
    except ValueError:
        return False
    return True
