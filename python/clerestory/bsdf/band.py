"""The four blocks of a BSDF in one band of wavelengths."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import TypeAlias

from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.tree_block import TreeBlock
from clerestory.errors import ClerestoryError

Block: TypeAlias = KlemsBlock | TreeBlock


@dataclass(frozen=True)
class Band:
    """Where light of one band of wavelengths goes, for each side it arrives on.

    Parameters
    ----------
    transmission_front, transmission_back, reflection_front, reflection_back : KlemsBlock or TreeBlock, optional
        Front is the outside (NOTATION.md): ``transmission_front`` is what light from outside does in the room. None:
        not known.
    """

    transmission_front: Block | None = None
    transmission_back: Block | None = None
    reflection_front: Block | None = None
    reflection_back: Block | None = None

    def __post_init__(self) -> None:
        for name, block in self:
            if not isinstance(block, (KlemsBlock, TreeBlock)):
                raise ClerestoryError(f"{name} must be a KlemsBlock, a TreeBlock or None, got {type(block).__name__}")
        kinds = {(type(block), getattr(block, "rank", 0)) for _, block in self}
        if len(kinds) > 1:
            raise ClerestoryError("blocks of a band must be all Klems matrices or all trees of one rank; convert some")
        if not kinds:
            raise ClerestoryError("a band must have at least one block, got none; give transmission_front")

    def __iter__(self) -> Iterator[tuple[str, Block]]:
        """Name and block of those that are known, in the order of the parameters."""
        for each in fields(self):
            block = getattr(self, each.name)
            if block is not None:
                yield each.name, block

    @property
    def is_tree(self) -> bool:
        """Whether the blocks are tensor trees."""
        return any(isinstance(block, TreeBlock) for _, block in self)


DIRECTIONS = tuple(each.name for each in fields(Band))
"""Names of the four blocks."""
