"""What a BSDF holds, in a few numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from clerestory.bsdf.completing import words
from clerestory.bsdf.tree_block import TreeBlock

if TYPE_CHECKING:
    from clerestory.bsdf.band import Block
    from clerestory.bsdf.bsdf import Bsdf


def summary(bsdf: Bsdf) -> dict[str, Any]:
    """Product, bands and blocks: basis, and the shares that leave at normal incidence, at most and on average.

    Returns
    -------
    dict
        Of text and numbers alone; shares are 0..1, ``mean`` is for light from everywhere (theory/bsdf.md, eq. 4).
    """
    return {
        "name": bsdf.name,
        "manufacturer": bsdf.manufacturer,
        "thickness_mm": bsdf.thickness_mm,
        "exact": None if bsdf.exact is None else type(bsdf.exact).__name__,
        "bands": {name: {direction: _block(block) for direction, block in band} for name, band in bsdf.bands},
        "about": bsdf.attrs,
    }


def _block(block: Block) -> dict[str, Any]:
    shares = block.hemispherical()
    numbers = {
        "normal": float(block.hemispherical_at(np.array([1e-6, 1e-6]))),
        "mean": block.mean(),
        "most": float(shares.max()),
    }
    if isinstance(block, TreeBlock):
        return {"tree_rank": block.rank, "log2_resolution": block.depth, "leaves": len(block.leaves.value), **numbers}
    return {"incident_basis": block.incident.name, "outgoing_basis": block.outgoing.name, **numbers}


def lines(bsdf: Bsdf) -> list[str]:
    """The summary for the screen."""
    found = summary(bsdf)
    thickness = "thickness unknown" if bsdf.thickness_mm is None else f"{bsdf.thickness_mm:g} mm"
    text = [f"{bsdf.name} by {bsdf.manufacturer}, {thickness}"]
    if found["exact"]:
        text.append(f"with the exact element: {found['exact']}")
    text.append(f"{'':30s}{'normal':>9s}{'mean':>9s}{'most':>9s}")
    for band, blocks in found["bands"].items():
        for direction, block in blocks.items():
            kind = (
                f"tree of rank {block['tree_rank']}, 2^{block['log2_resolution']} a side, {block['leaves']} leaves"
                if "tree_rank" in block
                else " → ".join(dict.fromkeys([block["incident_basis"], block["outgoing_basis"]]))
            )
            numbers = "".join(f"{block[name]:9.4f}" for name in ("normal", "mean", "most"))
            text.append(f"{words(direction) + ', ' + band:30s}{numbers}  {kind}")
    return text
