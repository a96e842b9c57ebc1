"""Blocks that a file or a measurement lacks: filled by reciprocity, or by zero."""

from __future__ import annotations

import warnings

import numpy as np

from clerestory.bsdf.band import DIRECTIONS, Band, Block
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.told import BsdfWarning
from clerestory.bsdf.tree_block import TreeBlock
from clerestory.errors import ClerestoryError

#: What light that takes the same paths the other way is called.
_TURNED_ROUND = {"transmission_front": "transmission_back", "transmission_back": "transmission_front"}


def words(direction: str) -> str:
    """``transmission_front`` as LBNL's files call it: ``Transmission Front``."""
    return direction.replace("_", " ").title()


def complete(band: Band, where: str, *, stacklevel: int = 3) -> Band:
    """The band with all four blocks; each one made up is told as a :class:`BsdfWarning`.

    Parameters
    ----------
    band : Band
    where : str
        What the warning begins with.

    Notes
    -----
    A missing transmission is the other one turned round (theory/bsdf.md, eq. 5); what cannot be known is zero.
    """
    known = dict(band)
    for direction in DIRECTIONS:
        if direction in known:
            continue
        given = known.get(_TURNED_ROUND.get(direction, ""))
        turned = None if given is None else _turned_round(given)
        if turned is not None:
            warnings.warn(
                f"{where} has no {words(direction)}: it is taken from the other side by reciprocity",
                BsdfWarning,
                stacklevel=stacklevel,
            )
            known[direction] = turned
        else:
            warnings.warn(f"{where} has no {words(direction)}: it is taken as zero", BsdfWarning, stacklevel=stacklevel)
            known[direction] = nothing_like(next(iter(known.values())))
    return Band(**known)


def nothing_like(block: Block) -> Block:
    """A block of the kind of another that sends no light anywhere."""
    if isinstance(block, TreeBlock):
        return TreeBlock(block.rank, np.zeros(1))
    return KlemsBlock(np.zeros_like(block.values), block.incident, block.outgoing)


def _turned_round(block: Block) -> Block | None:
    try:
        return block.reversed()
    except ClerestoryError:
        return None
