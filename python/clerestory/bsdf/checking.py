"""What may be wrong with a BSDF, in plain words."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from clerestory.bsdf.band import Band, Block
from clerestory.bsdf.completing import words
from clerestory.bsdf.klems import Floats, KlemsBasis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.rebasing import in_basis
from clerestory.bsdf.shirley_chiu import square_to_disc
from clerestory.bsdf.tree_block import TreeBlock

if TYPE_CHECKING:
    from clerestory.bsdf.bsdf import Bsdf

#: Power beyond what arrives that measurements may show, and that no reader should take.
_A_LITTLE, _TOO_MUCH = 1e-3, 1e-2
#: Share of a block's power that may go otherwise than reciprocity says: tolerated, and grave however small the power.
_RECIPROCAL, _MUCH = 0.02, 0.1


@dataclass(frozen=True)
class Finding:
    """One thing that may be wrong.

    Attributes
    ----------
    severity : {"error", "warning", "note"}
        An error makes results wrong, a warning may, a note is good to know.
    where : str
        The band and the block.
    text : str
        What it is, with its value.
    """

    severity: Literal["error", "warning", "note"]
    where: str
    text: str

    def __str__(self) -> str:
        return f"{self.severity}: {self.where}: {self.text}"


def check(bsdf: Bsdf) -> list[Finding]:
    """What :meth:`Bsdf.check` returns."""
    found = [finding for name, band in bsdf.bands for finding in _of_band(name, band)]
    if bsdf.solar is None:
        found.append(Finding("note", "solar", "there is no solar band, which WINDOW and EnergyPlus need"))
    if bsdf.thickness_mm is None:
        found.append(Finding("note", "thickness_mm", "is unknown, and some programs do not read files without it"))
    order = ("error", "warning", "note")
    return sorted(found, key=lambda finding: order.index(finding.severity))


def _of_band(name: str, band: Band) -> Iterator[Finding]:
    blocks = dict(band)
    for direction, block in blocks.items():
        yield from _negative(f"{name} {words(direction)}", block)
    for side in ("front", "back"):
        pair = blocks.get(f"transmission_{side}"), blocks.get(f"reflection_{side}")
        yield from _energy(f"{name} {side}", side, blocks, *pair)
    yield from _reciprocity(name, blocks)
    transmission = blocks.get("transmission_front")
    if transmission is not None:
        yield from _on_the_diagonal(f"{name} Transmission Front", transmission)


def _negative(where: str, block: Block) -> Iterator[Finding]:
    values = block.values if isinstance(block, KlemsBlock) else block.leaves.value
    count = int((values < 0.0).sum())
    if count:
        yield Finding("error", where, f"{count} of {values.size} values are negative, down to {values.min():.3g} 1/sr")


def _energy(
    where: str, side: str, blocks: dict[str, Block], transmission: Block | None, reflection: Block | None
) -> Iterator[Finding]:
    parts = [block for block in (transmission, reflection) if block is not None]
    if not parts:
        return
    sums = _sums(parts)
    most, place = float(sums.max()), int(np.argmax(sums))
    if most <= 1.0 + _A_LITTLE:
        return
    text = f"more leaves than arrives: {most:.4f} of it at {_incidence(parts[0], place)}"
    other = blocks.get("reflection_back" if side == "front" else "reflection_front")
    if transmission is not None and reflection is not None and other is not None and most > 1.0 + _TOO_MUCH:
        swapped = float(_sums([transmission, other]).max())
        if swapped <= 1.0 + _A_LITTLE:
            text += f"; with the other side's reflection it would be {swapped:.4f}: front and back may be exchanged"
    yield Finding("error" if most > 1.0 + _TOO_MUCH else "warning", where, text)


def _sums(parts: list[Block]) -> Floats:
    """Share that leaves by all parts, for each incident patch of the first or cell of the finest."""
    first = parts[0]
    if isinstance(first, KlemsBlock):
        return np.asarray(sum(in_basis(part, first.incident).hemispherical() for part in parts))
    grids = [part.hemispherical() for part in parts]
    fine = max(len(grid) for grid in grids)
    total = np.zeros((fine,) * grids[0].ndim)
    for grid in grids:
        for axis in range(grid.ndim):
            grid = np.repeat(grid, fine // grid.shape[axis], axis=axis)
        total += grid
    return total


def _incidence(block: Block, place: int) -> str:
    """Where the light of a patch or a cell comes from, in words."""
    if isinstance(block, KlemsBlock):
        theta, phi = block.incident.centre_deg[place]
        return f"incident patch {place + 1} (θ {theta:g}°, φ {phi:g}° of the direction of travel)"
    cells = 2**block.depth
    if block.rank == 3:
        return f"θ {np.degrees(np.arcsin(1.0 - 2.0 * (place + 0.5) / cells)):.0f}°"
    x, y = square_to_disc((np.array(divmod(place, cells)) + 0.5) / cells)
    theta = np.degrees(np.arcsin(min(1.0, float(np.hypot(x, y)))))
    return f"θ {theta:.0f}°, φ {np.degrees(np.arctan2(y, x)) % 360.0:.0f}° of the direction of travel"


def _reciprocity(name: str, blocks: dict[str, Block]) -> Iterator[Finding]:
    # trees are compared patch by patch: their cells need not be the same
    pairs = [
        (f"{name} Transmission", blocks.get("transmission_front"), blocks.get("transmission_back")),
        (f"{name} Reflection Front", blocks.get("reflection_front"), blocks.get("reflection_front")),
        (f"{name} Reflection Back", blocks.get("reflection_back"), blocks.get("reflection_back")),
    ]
    for where, block, other in pairs:
        if block is None or other is None:
            continue
        # an element taken as free of azimuth has no reciprocity to lose but that of its sums
        if isinstance(block, TreeBlock) and block.rank == 3:
            continue
        basis = block.incident if isinstance(block, KlemsBlock) else "klems_half"
        one, two = in_basis(block, basis), in_basis(other, basis)
        if one.incident.opposite is None:
            continue
        lost, share = _lost(one, two.reversed())
        if lost > _RECIPROCAL:
            text = (
                f"{100.0 * lost:.0f} % of the power goes otherwise than reciprocity says "
                f"(of light from everywhere, {100.0 * share:.1f} % of it all)"
            )
            means = f"; mean shares {one.mean():.3f} and {two.mean():.3f}" if block is not other else ""
            grave = share > _RECIPROCAL or lost > _MUCH
            yield Finding("warning" if grave else "note", where, text + means)


def _lost(one: KlemsBlock, two: KlemsBlock) -> tuple[float, float]:
    """Power in which two blocks differ, as a share of what they send and of what arrives from everywhere."""
    weight = one.outgoing.projected_solid_angle[:, None] * one.incident.projected_solid_angle[None, :] / np.pi
    difference = float(0.5 * (np.abs(one.values - two.values) * weight).sum())
    power = float(0.5 * ((np.abs(one.values) + np.abs(two.values)) * weight).sum())
    return (difference / power if power > 0.0 else 0.0), difference


def _on_the_diagonal(where: str, block: Block) -> Iterator[Finding]:
    """Light that goes straight on stands on the diagonal; in files with another convention, opposite to it."""
    klems = block if isinstance(block, KlemsBlock) else in_basis(block, "klems_half")
    basis: KlemsBasis = klems.incident
    if basis.opposite is None or klems.outgoing != basis:
        return
    outside = np.flatnonzero(basis.opposite != np.arange(len(basis)))
    share = basis.projected_solid_angle[outside]
    straight = float((klems.values[outside, outside] * share**2).sum() / share.sum())
    turned = float((klems.values[basis.opposite[outside], outside] * share**2).sum() / share.sum())
    if turned > 0.05 and turned > 3.0 * straight:
        yield Finding(
            "warning",
            where,
            f"{100.0 * turned:.0f} % of the light leaves opposite to where it was going and {100.0 * straight:.0f} % "
            "straight on: the file may not negate incident vectors as LBNL's format does",
        )
