"""Blocks in another Klems basis, and trees as Klems matrices; the power of each incident direction is kept."""

from __future__ import annotations

import numpy as np

from clerestory.bsdf.band import Block
from clerestory.bsdf.isotropic import of_isotropic
from clerestory.bsdf.klems import Floats, KlemsBasis, klems_basis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.overlap import cells_in_patches, overlap
from clerestory.bsdf.tree_block import TreeBlock


def in_basis(block: Block, basis: str | KlemsBasis) -> KlemsBlock:
    """The block with incident and outgoing patches of a Klems basis.

    Parameters
    ----------
    block : KlemsBlock or TreeBlock
    basis : str or KlemsBasis

    Returns
    -------
    KlemsBlock
        Mean over each incident patch, weighted by projected solid angle; what leaves is shared among the outgoing
        patches by the same measure (theory/bsdf.md, eq. 9). Standard errors are carried as if entries were independent.

    Raises
    ------
    ClerestoryError
        If no basis has that name.
    """
    wanted = klems_basis(basis)
    if isinstance(block, KlemsBlock):
        return _of_klems(block, wanted)
    return of_isotropic(block, wanted) if block.rank == 3 else _of_tree(block, wanted)


def _of_klems(block: KlemsBlock, basis: KlemsBasis) -> KlemsBlock:
    if block.incident == basis and block.outgoing == basis:
        return block
    into = overlap(basis, block.incident) / basis.projected_solid_angle[:, None]
    out = overlap(basis, block.outgoing) / basis.projected_solid_angle[:, None]
    error = None
    if block.standard_error is not None:
        error = np.sqrt(out**2 @ block.standard_error**2 @ (into**2).T)
    return KlemsBlock(out @ block.values @ into.T, basis, basis, error)


def _of_tree(tree: TreeBlock, basis: KlemsBasis) -> KlemsBlock:
    from scipy.sparse import coo_array  # type: ignore[import-untyped]

    corner, width, value = tree.leaves
    levels = np.rint(-np.log2(width)).astype(np.int64)
    total: Floats = np.zeros((len(basis), len(basis)))
    for level in np.unique(levels):
        chosen = levels == level
        cell = np.rint(corner[chosen] * 2.0**level).astype(np.int64)
        into, out = cell[:, 0] * 2**level + cell[:, 1], cell[:, 2] * 2**level + cell[:, 3]
        values = coo_array((value[chosen], (out, into)), shape=(4**level, 4**level)).tocsr()
        patches = cells_in_patches(basis, int(level))
        total += (patches @ values @ patches.T).toarray()
    # each incident direction's power is kept: the mean is over the points that were found in the patch
    found = np.asarray(cells_in_patches(basis, 0).toarray())[:, 0]
    return KlemsBlock(total / basis.projected_solid_angle[:, None] / found[None, :], basis, basis)
