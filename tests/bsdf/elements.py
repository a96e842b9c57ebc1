"""Window elements that look different from every side, for the tests."""

import numpy as np

from clerestory import Band, Bsdf, KlemsBlock, TreeBlock
from clerestory.bsdf import klems_basis
from clerestory.bsdf.tree_turning import preorder_of_grid


def uneven_block(
    seed: int, incident: str = "klems_full", outgoing: str = "klems_full", share: float = 0.5
) -> KlemsBlock:
    """A matrix without any symmetry whose columns send away between a half and the whole of ``share``."""
    rng = np.random.default_rng(seed)
    into, out = klems_basis(incident), klems_basis(outgoing)
    values = rng.random((len(out), len(into))) ** 8
    values *= share * (0.5 + 0.5 * rng.random(len(into))) / (out.projected_solid_angle @ values)
    return KlemsBlock(values, into, out)


def uneven_tree(seed: int, rank: int = 4, levels: int = 2, share: float = 0.5) -> TreeBlock:
    """A tree without any symmetry; every second branch is finer than the rest."""
    grid = np.random.default_rng(seed).random((2**levels,) * rank) ** 4
    values = preorder_of_grid(grid / grid.mean(axis=(-1, -2), keepdims=True) * share / np.pi)
    coarse, walk, nan = 0.0, [np.nan], np.flatnonzero(np.isnan(values))
    for child, (start, end) in enumerate(zip(nan[1:], [*nan[2:], len(values)], strict=True)):
        part = values[start:end]
        coarse = float(np.nanmean(part))
        walk.extend(part if child % 2 else [coarse])
    return TreeBlock(rank, walk) if levels == 2 else TreeBlock(rank, values)


def uneven_bsdf(basis: str = "klems_full", seed: int = 0) -> Bsdf:
    """All four blocks different, visible and solar."""
    bands = [
        Band(*(uneven_block(seed + 10 * band + part, basis, basis, 0.4 + 0.05 * part) for part in range(4)))
        for band in range(2)
    ]
    return Bsdf(name="Uneven & <odd>", manufacturer="Nobody", thickness_mm=6.5, visible=bands[0], solar=bands[1])


def uneven_tree_bsdf(rank: int = 4) -> Bsdf:
    """Likewise as trees."""
    visible = Band(*(uneven_tree(part, rank, share=0.3 + 0.05 * part) for part in range(4)))
    solar = Band(*(uneven_tree(10 + part, rank, share=0.3) for part in range(4)))
    return Bsdf(name="Tree", thickness_mm=3.0, visible=visible, solar=solar)
