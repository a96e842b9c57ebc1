"""Blocks in another Klems basis, and trees as Klems matrices; the power of each incident direction is kept."""

from __future__ import annotations

import numpy as np

from clerestory.bsdf.band import Block
from clerestory.bsdf.klems import Floats, KlemsBasis, klems_basis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.overlap import cells_in_patches, overlap
from clerestory.bsdf.shirley_chiu import square_to_disc
from clerestory.bsdf.tree_block import TreeBlock

#: Directions of incidence in each patch, by sin²θ and by azimuth, when a tree of rank 3 is averaged.
_INCIDENT = (6, 6)


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
    return _of_isotropic(block, wanted) if block.rank == 3 else _of_tree(block, wanted)


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


def _of_isotropic(tree: TreeBlock, basis: KlemsBasis) -> KlemsBlock:
    side = max(64, 2 ** (tree.depth + 1))
    u = (np.arange(side) + 0.5) / side
    out = square_to_disc(np.stack(np.meshgrid(u, u, indexing="ij"), axis=-1).reshape(-1, 2))
    radius, azimuth = np.hypot(out[:, 0], out[:, 1]), np.arctan2(out[:, 1], out[:, 0])
    total: Floats = np.zeros((len(basis), len(basis)))
    by_theta, by_phi = _INCIDENT
    shares = (np.arange(by_theta) + 0.5) / by_theta, (np.arange(by_phi) + 0.5) / by_phi
    first = np.concatenate([[0], np.cumsum(basis.counts)])
    for ring, count in enumerate(basis.counts):
        sine2 = np.sin(np.radians(basis.theta_deg[ring : ring + 2])) ** 2
        for share in shares[0]:
            sine = np.sqrt(sine2[0] + share * (sine2[1] - sine2[0]))
            power = tree.at([sine, 0.0], out) * np.pi / side**2
            for turn in shares[1]:
                for number in range(count):
                    phi = (number - 0.5 + turn) * 2.0 * np.pi / count + azimuth
                    patch = basis.find(radius * np.cos(phi), radius * np.sin(phi))
                    total[:, first[ring] + number] += np.bincount(patch, weights=power, minlength=len(basis))
    return KlemsBlock(total / (by_theta * by_phi) / basis.projected_solid_angle[:, None], basis, basis)
