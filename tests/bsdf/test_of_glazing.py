"""From panels to BSDFs: accounts, reciprocity, convergence, agreement with the exact beams, up and down."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from clerestory import (
    Bsdf,
    ClerestoryError,
    Glass,
    KlemsBlock,
    LaserCutPanel,
    Medium,
    Pane,
    PrismaticPanel,
    Stack,
    TreeBlock,
    bsdf_of,
)
from clerestory.bsdf import klems_basis

ACRYLIC = Medium(n=1.49)
Floats = NDArray[np.float64]


def cut(**changes: Any) -> LaserCutPanel:
    """A laser-cut panel without absorption, D/W = 0.3, its cuts of no width."""
    drawn: dict[str, Any] = {"spacing_mm": 1.8, "thickness_mm": 6.0, "cut_width_mm": 0.0, "medium": ACRYLIC}
    return LaserCutPanel(**drawn | changes)


def powers(bsdf: Bsdf) -> dict[str, Floats]:
    """Share sent from each incident patch into each outgoing one, (outgoing, incident)."""
    shares = {}
    for direction, block in bsdf.visible:
        assert isinstance(block, KlemsBlock)
        shares[direction] = block.values * block.outgoing.projected_solid_angle[:, None]
    return shares


def patch_turn(name: str, *, x: float, y: float) -> NDArray[np.int64]:
    """The patch of (x, y) times these signs, for each patch."""
    basis = klems_basis(name).native
    return basis.find(basis.centres[:, :2] * np.array([x, y]))


@pytest.fixture(scope="module")
def quarter() -> Bsdf:
    return cut().bsdf("klems_quarter", tolerance=1e-6)


def test_lossless_columns_send_out_all_light(quarter: Bsdf) -> None:
    share = powers(quarter)
    for side in ("front", "back"):
        out = share[f"transmission_{side}"].sum(axis=0) + share[f"reflection_{side}"].sum(axis=0)
        assert np.abs(out - 1.0).max() < 1e-9
    assert quarter.attrs["visible_residual"] < 1e-5
    assert not [finding for finding in quarter.check() if finding.severity != "note"]


def test_an_absorbing_asymmetric_panel_is_reciprocal() -> None:
    panel = PrismaticPanel(
        pitch_mm=1.0,
        lower_deg=20.0,
        upper_deg=60.0,
        base_mm=1.0,
        ridges="back",
        medium=Medium(n=1.49, absorption_per_mm=0.05),
    )
    bsdf = panel.bsdf("klems_quarter", accuracy=0.2, tolerance=1e-3, polarisation="averaged")
    value = {direction: block.values for direction, block in bsdf.visible if isinstance(block, KlemsBlock)}
    turned = patch_turn("klems_quarter", x=-1.0, y=-1.0)
    for one, other in [
        ("transmission_front", "transmission_back"),
        ("reflection_front", "reflection_front"),
        ("reflection_back", "reflection_back"),
    ]:
        backwards = value[other][np.ix_(turned, turned)].T
        assert np.abs(value[one] - backwards).max() < 1e-9 * value[one].max()
    out = powers(bsdf)["transmission_front"].sum(axis=0) + powers(bsdf)["reflection_front"].sum(axis=0)
    assert (out < 0.97).all()
    # upside down: y reversed in both names; it matters, for the prism is not symmetric
    down = PrismaticPanel(
        pitch_mm=1.0,
        lower_deg=60.0,
        upper_deg=20.0,
        base_mm=1.0,
        ridges="back",
        medium=Medium(n=1.49, absorption_per_mm=0.05),
    ).bsdf("klems_quarter", accuracy=0.2, tolerance=1e-3, polarisation="averaged")
    flipped = patch_turn("klems_quarter", x=1.0, y=-1.0)
    ours, theirs = powers(bsdf)["transmission_front"], powers(down)["transmission_front"]
    assert np.abs(ours - theirs[np.ix_(flipped, flipped)]).sum(axis=0).max() < 0.06
    assert np.abs(ours - theirs).sum(axis=0).max() > 0.3


def test_a_panel_inside_out_exchanges_front_and_back() -> None:
    prism: dict[str, Any] = {"pitch_mm": 1.0, "lower_deg": 35.0, "upper_deg": 35.0, "base_mm": 1.0, "medium": ACRYLIC}
    how: dict[str, Any] = {"accuracy": 0.2, "tolerance": 1e-3, "polarisation": "averaged"}
    inside = powers(PrismaticPanel(**prism, ridges="back").bsdf("klems_quarter", **how))
    outside = powers(PrismaticPanel(**prism, ridges="front").bsdf("klems_quarter", **how))
    for kind in ("transmission", "reflection"):
        exchanged = np.abs(inside[f"{kind}_front"] - outside[f"{kind}_back"]).sum(axis=0).max()
        assert exchanged < 0.06
    assert np.abs(inside["reflection_front"] - outside["reflection_front"]).sum(axis=0).max() > 0.3


def test_full_columns_are_converged() -> None:
    panel = cut()
    coarse, fine = panel.bsdf(polarisation="averaged"), panel.bsdf(polarisation="averaged", accuracy=1e-4)
    for side in ("front", "back"):
        off = sum(
            np.abs(powers(coarse)[f"{kind}_{side}"] - powers(fine)[f"{kind}_{side}"]).sum(axis=0)
            for kind in ("transmission", "reflection")
        )
        assert np.max(off) < 0.002


def test_patches_hold_what_the_exact_beams_send(quarter: Bsdf) -> None:
    panel, basis, rng = cut(), klems_basis("klems_quarter"), np.random.default_rng(2)
    native = basis.native
    for patch in (0, 3, 24, 38):
        # directions evenly over the patch, by projected solid angle
        drawn = rng.uniform(-1.0, 1.0, (100_000, 2))
        drawn = drawn[np.hypot(drawn[:, 0], drawn[:, 1]) < 1.0]
        drawn = drawn[native.find(drawn) == patch][:225]
        z = np.sqrt(1.0 - (drawn**2).sum(axis=1))
        elevation, azimuth = np.degrees(np.arcsin(-drawn[:, 1])), np.degrees(np.arctan2(drawn[:, 0], z))
        deflected = np.array(
            [
                panel.angular(elevation_deg=e, azimuth_deg=a).transmittance_deflected.item()
                for e, a in zip(elevation, azimuth, strict=True)
            ]
        )
        mirrored = patch_turn("klems_quarter", x=1.0, y=-1.0)[patch]
        share = powers(quarter)["transmission_front"][mirrored, patch]
        if mirrored != patch:
            assert abs(deflected.mean() - share) < 4.0 * deflected.std() / 15.0 + 1e-3


def test_trees_and_matrices_send_out_the_same(quarter: Bsdf) -> None:
    tree = cut().bsdf(rank=4, log2_resolution=4)
    block = tree.visible.transmission_front
    assert isinstance(block, TreeBlock)
    assert len(block.preorder) < 16**4 / 4
    assert not [finding for finding in tree.check() if finding.severity == "error"]
    # the mean over all directions, by projected solid angle
    basis = klems_basis("klems_quarter")
    klems = quarter.visible.transmission_front
    assert isinstance(klems, KlemsBlock)
    mean = (klems.hemispherical() * basis.projected_solid_angle).sum() / np.pi
    leaves = block.leaves
    assert (leaves.value * leaves.width**4).sum() * np.pi == pytest.approx(mean, abs=2e-3)


def test_rank_3_is_for_panes() -> None:
    pane = Pane(thickness_mm=4.0, medium=Medium(n=1.52))
    tree = pane.bsdf(rank=3, log2_resolution=5)
    assert isinstance(tree.visible.transmission_front, TreeBlock)
    incident = np.array([[0.3, -0.4, np.sqrt(0.75)]])
    spread = tree.blurred_glazing().spread(incident)[0]
    assert spread == pytest.approx(1.0, abs=2e-3)
    with pytest.raises(ClerestoryError, match="same turned about their normal"):
        cut().bsdf(rank=3)


def test_rough_cuts_are_drawn_with_standard_errors() -> None:
    panel = cut(spacing_mm=6.0, cut_width_mm=0.3, cut_diffuse=0.3)
    bsdf = panel.bsdf("klems_quarter", draws=1600, seed=1)
    block = bsdf.visible.transmission_front
    assert isinstance(block, KlemsBlock)
    assert block.standard_error is not None
    assert (block.standard_error > 0.0).all()
    again = panel.bsdf("klems_quarter", draws=1600, seed=2).visible.transmission_front
    assert isinstance(again, KlemsBlock)
    assert again.standard_error is not None
    well_met = block.values > 5.0 * block.standard_error
    quotient = (block.values - again.values)[well_met] / np.hypot(block.standard_error, again.standard_error)[well_met]
    assert 0.7 < np.sqrt(np.mean(quotient**2)) < 1.4


def test_bands_tell_glass_that_absorbs_heat() -> None:
    pane = Pane(thickness_mm=6.0, medium=Medium.named("soda_lime_clear"))
    bsdf = pane.bsdf("klems_quarter", bands=("visible", "solar", "x", "z"))
    normal = {name: band.transmission_front.hemispherical()[0] for name, band in bsdf.bands}  # type: ignore[union-attr]
    # 6 mm clear float: 0.88 of the light, 0.77 of the sun's heat pass
    assert normal["visible"] == pytest.approx(0.88, abs=0.015)
    assert normal["solar"] == pytest.approx(0.77, abs=0.03)
    assert bsdf.attrs["solar_share_known"] > 0.98


def test_anything_that_fills_a_window_has_a_bsdf() -> None:
    stack = Stack((Glass(transmittance=0.88), cut(spacing_mm=6.0), Glass(transmittance=0.88)))
    bsdf = stack.bsdf("klems_quarter", accuracy=0.02, name="between panes")
    assert bsdf_of(cut(), basis="klems_quarter").exact == cut()
    assert bsdf.name == "between panes"
    assert bsdf.exact is stack
    out = sum(powers(bsdf)[f"{kind}_front"].sum(axis=0) for kind in ("transmission", "reflection"))
    assert np.all(out < 1.0)
    assert np.all(out > 0.7)


def test_mistakes_are_named() -> None:
    with pytest.raises(ClerestoryError, match="rank must be left out if basis is given"):
        cut().bsdf("klems_full", rank=4)
    with pytest.raises(ClerestoryError, match="log2_resolution must be at most 7"):
        cut().bsdf(rank=4, log2_resolution=8)
    with pytest.raises(ClerestoryError, match="bands must hold 'visible'"):
        cut().bsdf(bands=("solar",))
    with pytest.raises(ClerestoryError, match="basis"):
        cut().bsdf("klems_third")
