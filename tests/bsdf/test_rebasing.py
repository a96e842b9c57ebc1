"""Blocks in other bases: the power of every incident direction is kept."""

import numpy as np
import pytest
from tests.bsdf.elements import uneven_block, uneven_tree

from clerestory import KlemsBlock
from clerestory.bsdf import KLEMS_BASES, klems_basis
from clerestory.bsdf.overlap import cells_in_patches, overlap
from clerestory.bsdf.rebasing import in_basis


@pytest.mark.parametrize("name", KLEMS_BASES)
@pytest.mark.parametrize("other", KLEMS_BASES)
def test_overlaps_add_to_the_patches(name: str, other: str) -> None:
    shared = overlap(klems_basis(name), klems_basis(other))
    assert shared.sum(axis=1) == pytest.approx(klems_basis(name).projected_solid_angle, rel=1e-12)
    assert shared.sum(axis=0) == pytest.approx(klems_basis(other).projected_solid_angle, rel=1e-12)


def test_a_coarser_matrix_has_the_power_of_the_finer() -> None:
    fine = uneven_block(7)
    for name in KLEMS_BASES[1:]:
        coarse = in_basis(fine, name)
        share = overlap(klems_basis(name), fine.incident) / klems_basis(name).projected_solid_angle[:, None]
        assert coarse.hemispherical() == pytest.approx(share @ fine.hemispherical(), rel=1e-12)
        assert coarse.mean() == pytest.approx(fine.mean(), rel=1e-12)
    assert in_basis(fine, "klems_full") is fine


def test_reciprocity_is_kept_and_errors_shrink() -> None:
    block = uneven_block(8)
    assert in_basis(block.reversed(), "klems_quarter").values == pytest.approx(
        in_basis(block, "klems_quarter").reversed().values, rel=1e-12
    )
    noisy = KlemsBlock(block.values, standard_error=0.1 * block.values)
    coarse = in_basis(noisy, "klems_quarter")
    assert coarse.standard_error is not None
    assert (coarse.standard_error <= 0.1 * coarse.values + 1e-12).all()


@pytest.mark.parametrize("rank", [3, 4])
def test_a_tree_has_its_power_as_a_matrix(rank: int) -> None:
    tree = uneven_tree(3, rank)
    basis = klems_basis("klems_quarter")
    matrix = in_basis(tree, basis)
    assert matrix.mean() == pytest.approx(tree.mean(), rel=2e-3)
    # some patches by a quadrature of their own
    rng = np.random.default_rng(1)

    def inside(patch: int, count: int) -> np.ndarray:
        low, high, first, last = basis.bounds[patch]
        sine = np.sqrt(rng.uniform(np.sin(low) ** 2, np.sin(high) ** 2, count))
        phi = rng.uniform(first, last, count)
        return np.stack([sine * np.cos(phi), sine * np.sin(phi)], axis=-1)

    for into, out in [(0, 0), (3, 5), (10, 30), (38, 34), (35, 20)]:
        drawn = tree.at(inside(into, 200_000), inside(out, 200_000))
        error = drawn.std() / np.sqrt(drawn.size)
        assert abs(matrix.values[out, into] - drawn.mean()) < 4.0 * error + 0.005 * drawn.mean()


def test_points_of_the_square_find_their_patches() -> None:
    basis = klems_basis("klems_full")
    assert np.asarray(cells_in_patches(basis, 3).sum(axis=0)) == pytest.approx(np.pi / 64)
    assert np.asarray(cells_in_patches(basis, 0).sum(axis=1)) == pytest.approx(basis.projected_solid_angle, rel=4e-3)
