"""Klems matrices and tensor trees as they are kept."""

import numpy as np
import pytest
from tests.bsdf.elements import uneven_bsdf, uneven_tree_bsdf

from clerestory import Band, Bsdf, ClerestoryError, KlemsBlock, TreeBlock
from clerestory.bsdf import KLEMS_BASES, KlemsBasis, klems_basis
from clerestory.bsdf.shirley_chiu import disc_to_square, square_to_disc

SIZES = {"klems_full": 145, "klems_half": 77, "klems_quarter": 41}
NAN = np.nan


@pytest.mark.parametrize("name", KLEMS_BASES)
def test_patches_cover_the_hemisphere(name: str) -> None:
    basis = klems_basis(name)
    assert len(basis) == SIZES[name]
    assert basis.projected_solid_angle.sum() == pytest.approx(np.pi, rel=1e-12)
    assert basis.solid_angle.sum() == pytest.approx(2.0 * np.pi, rel=1e-12)
    assert (basis.find(*basis.centre.T) == np.arange(len(basis))).all()
    assert (basis.find(*-basis.centre[1:].T) == basis.opposite[1:]).all()


def test_bins_turn_from_x_to_y() -> None:
    basis = klems_basis("klems_full")
    assert basis.find(np.sin(np.radians(10.0)), 0.0) == 1
    assert basis.find(0.0, np.sin(np.radians(10.0))) == 3
    assert basis.find(0.0, -np.sin(np.radians(80.0))) == 145 - 3


def test_a_lambertian_sheet_sends_its_share_everywhere() -> None:
    half = KlemsBlock(np.full((41, 145), 0.5 / np.pi), "klems_full", "klems_quarter")
    assert half.hemispherical() == pytest.approx(0.5)
    assert half.mean() == pytest.approx(0.5)
    tree = TreeBlock(4, [NAN, *[0.5 / np.pi] * 16])
    assert tree.hemispherical() == pytest.approx(0.5)
    assert tree.hemispherical_at([[0.3, -0.2]]) == pytest.approx(0.5)


def test_turning_light_round_twice_changes_nothing() -> None:
    block = KlemsBlock(np.random.default_rng(1).random((77, 145)), "klems_full", "klems_half")
    back = block.reversed()
    assert (back.incident.name, back.outgoing.name) == ("klems_half", "klems_full")
    assert back.at([-0.5, 0.1], [0.2, -0.6]) == block.at([-0.2, 0.6], [0.5, -0.1])
    assert (back.reversed().values == block.values).all()


def test_a_tree_is_read_in_halves() -> None:
    children = np.arange(16.0)
    tree = TreeBlock(4, np.r_[NAN, children])
    place = (np.arange(16)[:, None] >> np.arange(4)) & 1
    assert (tree.value_at(0.25 + 0.5 * place) == children).all()
    deep = TreeBlock(3, np.r_[NAN, NAN, np.arange(8.0), np.full(7, 9.0)])
    assert deep.depth == 2
    assert deep.value_at([0.3, 0.2, 0.4]) == 5.0
    assert deep.value_at([0.8, 0.2, 0.4]) == 9.0
    assert (deep.leaves.width**3).sum() == pytest.approx(1.0)


def test_sums_over_a_tree_agree_with_sums_along_a_line_of_sight() -> None:
    rng = np.random.default_rng(2)

    def grow(level: int) -> list[float]:
        if level == 0 or rng.random() < 0.6:
            return [rng.random()]
        return [NAN, *(value for _ in range(16) for value in grow(level - 1))]

    tree = TreeBlock(4, [NAN, *(value for _ in range(16) for value in grow(2))])
    grid = tree.hemispherical()
    cells = (np.stack(np.meshgrid(*[np.arange(len(grid))] * 2, indexing="ij"), -1) + 0.5) / len(grid)
    assert tree.hemispherical_at(square_to_disc(cells)) == pytest.approx(grid)
    # a quadrature of its own over the outgoing square
    fine = square_to_disc((np.stack(np.meshgrid(*[np.arange(64)] * 2, indexing="ij"), -1) + 0.5).reshape(-1, 2) / 64)
    point = np.array([0.31, -0.44])
    assert np.pi * tree.at(point, fine).mean() == pytest.approx(float(tree.hemispherical_at(point)))


def test_disc_and_square_are_one_another_and_keep_areas() -> None:
    square = np.random.default_rng(3).random((500, 2))
    disc = square_to_disc(square)
    assert disc_to_square(disc) == pytest.approx(square)
    step = 1e-6
    du, dv = (square_to_disc(square + step * np.eye(2)[k]) - disc for k in range(2))
    assert np.abs(du[:, 0] * dv[:, 1] - du[:, 1] * dv[:, 0]) / step**2 == pytest.approx(np.pi, rel=1e-3)
    assert disc_to_square([1.0, 0.0]) == pytest.approx([1.0, 0.5])
    assert disc_to_square([0.0, 1.0]) == pytest.approx([0.5, 1.0])


@pytest.mark.parametrize(
    ("make", "word"),
    [
        (lambda: KlemsBlock(np.zeros((145, 144))), "shape"),
        (lambda: KlemsBlock(np.full((145, 145), np.inf)), "finite"),
        (lambda: KlemsBlock(np.zeros((145, 145)), "klems_third"), "incident_basis"),
        (lambda: KlemsBasis("own", (0, 40, 30, 90), (1, 8, 8)), "rise"),
        (lambda: KlemsBasis("own", (0, 40, 90), (1, 0)), "counts"),
        (lambda: TreeBlock(4, [NAN, 1.0]), "missing"),
        (lambda: TreeBlock(4, [1.0, 1.0]), "more"),
        (lambda: TreeBlock(5, [1.0]), "rank"),
        (lambda: TreeBlock(3, [np.inf]), "finite"),
        (lambda: TreeBlock(3, [*[NAN] * 13, *[1.0] * (1 + 7 * 13)]), "deep"),
        (lambda: Band(), "at least one"),
        (lambda: Band(transmission_front=TreeBlock(3, [0.0]), reflection_front=TreeBlock(4, [0.0])), "all"),
        (lambda: Bsdf(name="", visible=Band(TreeBlock(3, [0.0]))), "name"),
        (lambda: Bsdf(name="x", manufacturer=" ", visible=Band(TreeBlock(3, [0.0]))), "manufacturer"),
        (lambda: Bsdf(name="x", visible=Band(TreeBlock(3, [0.0])), thickness_mm=0.0), "thickness_mm"),
    ],
)
def test_what_cannot_be_is_refused_by_name(make: object, word: str) -> None:
    with pytest.raises(ClerestoryError, match=word):
        make()


@pytest.mark.parametrize("bsdf", [uneven_bsdf("klems_half"), uneven_tree_bsdf(3), uneven_tree_bsdf(4)])
def test_a_window_has_the_values_of_the_file(bsdf: Bsdf) -> None:
    native = bsdf.glazing()
    rng = np.random.default_rng(6)
    assert native.spreads
    for direction, block in bsdf.visible:
        from_front, through = direction.endswith("front"), direction.startswith("transmission")

        def along(z: float) -> np.ndarray:
            sine, phi = np.sqrt(rng.random(300)), 2.0 * np.pi * rng.random(300)
            return np.stack([sine * np.cos(phi), sine * np.sin(phi), z * np.sqrt(1.0 - sine**2)], axis=1)

        into = along(1.0 if from_front else -1.0)
        out = along(1.0 if from_front == through else -1.0)
        assert native.bsdf(into, out) == pytest.approx(block.at(into[:, :2], out[:, :2]), rel=1e-12)


def test_rings_of_a_file_s_own_fill_a_window() -> None:
    own = KlemsBasis("own", (0.0, 30.0, 90.0), (1, 4))
    block = KlemsBlock(np.full((5, 5), 0.4 / np.pi), own, own)
    native = Bsdf(name="x", visible=Band(block, block, block, block)).glazing()
    assert native.spread(np.array([[0.0, 0.6, 0.8]])) == pytest.approx(0.8)
    with pytest.raises(ClerestoryError, match="negative"):
        Bsdf(name="x", visible=Band(KlemsBlock(-block.values, own, own), block, block, block)).glazing()
    with pytest.raises(ClerestoryError, match="no more than"):
        Bsdf(name="x", visible=Band(KlemsBlock(3.0 * block.values, own, own), block, block, block)).glazing()
