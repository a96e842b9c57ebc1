"""Klems matrices combined: closed forms, laws, and exact stacks."""

import numpy as np
import pytest

from clerestory import ClerestoryError, Gap, Medium, Pane, Stack
from clerestory.bsdf import Band, Bsdf, KlemsBlock
from clerestory.bsdf.klems import klems_basis
from clerestory.bsdf.layers import layered_band, layered_bsdf
from clerestory.glass import slab

BASIS = klems_basis("klems_full")
SOLID = BASIS.projected_solid_angle
N = 1.52


def polar_means(of_angle):
    """Means over each patch, by projected solid angle, of what depends on the angle of incidence alone."""
    node, weight = np.polynomial.legendre.leggauss(12)
    sine2 = np.sin(BASIS.bounds[:, :2]) ** 2
    at = 0.5 * (sine2[:, :1] + sine2[:, 1:]) + 0.5 * (sine2[:, 1:] - sine2[:, :1]) * node
    return of_angle(np.degrees(np.arcsin(np.sqrt(at)))) @ weight / 2.0


def pane_band(absorption_per_mm=0.0):
    """A pane of 4 mm averaged over patches: diagonal blocks."""

    def shares(word):
        return polar_means(
            lambda theta: getattr(slab(theta, N, absorption_per_mm=absorption_per_mm, thickness_mm=4.0), word)
        )

    transmission, reflection = (KlemsBlock(np.diag(shares(word) / SOLID)) for word in ("transmittance", "reflectance"))
    return Band(transmission, transmission, reflection, reflection)


def rough_band(seed, share):
    """A reciprocal layer that scatters every which way and differs on its two sides."""
    rng = np.random.default_rng(seed)

    def reciprocal():
        values = rng.random((145, 145)) ** 4
        return KlemsBlock(0.5 * (values + values[np.ix_(BASIS.opposite, BASIS.opposite)].T))

    transmission, reflection, behind = reciprocal().values, reciprocal().values, reciprocal().values
    most = max((SOLID @ (transmission + r)).max() for r in (reflection, behind))
    scale = share / most
    front = KlemsBlock(scale * transmission)
    return Band(front, front.reversed(), KlemsBlock(scale * reflection), KlemsBlock(scale * behind))


def blocks(band):
    return {name: block.values for name, block in band}


def test_one_layer_is_itself():
    band = rough_band(1, 0.9)
    found = layered_band([band])
    for name, values in blocks(found.band).items():
        np.testing.assert_allclose(values, blocks(band)[name], atol=1e-15)
    np.testing.assert_allclose(
        found.absorptance_front[0],
        1.0 - SOLID @ (band.transmission_front.values + band.reflection_front.values),
        atol=1e-14,
    )


def test_an_opening_before_or_behind_changes_nothing():
    opening = Band(
        KlemsBlock(np.diag(1.0 / SOLID)),
        KlemsBlock(np.diag(1.0 / SOLID)),
        KlemsBlock(np.zeros((145, 145))),
        KlemsBlock(np.zeros((145, 145))),
    )
    band = rough_band(2, 0.9)
    for layers in ([opening, band], [band, opening], [opening, band, opening]):
        found = layered_band(layers)
        for name, values in blocks(found.band).items():
            np.testing.assert_allclose(values, blocks(band)[name], atol=1e-12)
        own = layers.index(band)
        others = np.delete(found.absorptance_front, own, axis=0)
        np.testing.assert_allclose(others, 0.0, atol=1e-12)


def test_power_is_shared_out_whole_from_either_side():
    found = layered_band([rough_band(3, 0.95), pane_band(0.05), rough_band(4, 0.7), rough_band(5, 1.0)])
    band = found.band
    front = SOLID @ (band.transmission_front.values + band.reflection_front.values) + found.absorptance_front.sum(
        axis=0
    )
    back = SOLID @ (band.transmission_back.values + band.reflection_back.values) + found.absorptance_back.sum(axis=0)
    np.testing.assert_allclose(front, 1.0, atol=1e-12)
    np.testing.assert_allclose(back, 1.0, atol=1e-12)
    assert found.absorptance_front.min() >= 0.0


def test_layers_of_reciprocal_layers_are_reciprocal():
    band = layered_band([rough_band(6, 0.95), rough_band(7, 0.9), pane_band(0.02)]).band
    np.testing.assert_allclose(band.transmission_back.values, band.transmission_front.reversed().values, atol=1e-13)
    for block in (band.reflection_front, band.reflection_back):
        np.testing.assert_allclose(block.values, block.reversed().values, atol=1e-13)


def test_reflections_between_are_followed_one_by_one():
    """Two layers summed by hand: light that goes to and fro k times, for k up to 40."""
    first, second = rough_band(8, 0.8), rough_band(9, 0.8)
    found = layered_band([first, second])
    a, b = blocks(first), blocks(second)
    inward = SOLID[:, None] * a["transmission_front"]
    through, kept = np.zeros((145, 145)), np.zeros(145)
    own = 1.0 - SOLID @ (b["transmission_front"] + b["reflection_front"])
    for _ in range(40):
        through += b["transmission_front"] @ inward
        kept += own @ inward
        back = SOLID[:, None] * (b["reflection_front"] @ inward)
        inward = SOLID[:, None] * (a["reflection_back"] @ back)
    np.testing.assert_allclose(found.band.transmission_front.values, through, atol=1e-12)
    np.testing.assert_allclose(found.absorptance_front[1], kept, atol=1e-12)


def test_order_and_sides_matter():
    """Turning the stack round exchanges front and back; exchanging the layers alone does something else."""
    first, second = rough_band(10, 0.9), rough_band(11, 0.6)

    def turned(band):
        return Band(band.transmission_back, band.transmission_front, band.reflection_back, band.reflection_front)

    found = layered_band([first, second])
    behind = layered_band([turned(second), turned(first)])
    np.testing.assert_allclose(found.band.transmission_front.values, behind.band.transmission_back.values, atol=1e-13)
    np.testing.assert_allclose(found.band.reflection_back.values, behind.band.reflection_front.values, atol=1e-13)
    np.testing.assert_allclose(found.absorptance_front, behind.absorptance_back[::-1], atol=1e-13)
    exchanged = layered_band([second, first])
    assert np.abs(exchanged.band.transmission_front.values - found.band.transmission_front.values).max() > 1e-3


def test_matrices_of_panes_agree_with_the_exact_stack():
    """Averaged between layers, as matrices are: what is left is the mean of products over a patch."""
    medium = Medium(n=N, absorption_per_mm=0.02)
    stack = Stack([Pane(thickness_mm=4.0, medium=medium)] * 2)
    found = layered_band([pane_band(0.02)] * 2)

    def exact(word):
        def at(theta):
            shares = stack.angular(elevation_deg=theta.ravel(), polarisation="averaged")
            values = shares.layer_absorptance[0] if word == "first" else shares[word]
            return values.values[:, 0].reshape(theta.shape)

        return polar_means(at)

    # one patch of each ring stands for all
    transmission, reflection = (
        SOLID @ found.band.transmission_front.values,
        SOLID @ found.band.reflection_front.values,
    )
    for ours, expected in (
        (transmission, exact("transmittance")),
        (reflection, exact("reflectance")),
        (found.absorptance_front[0], exact("first")),
    ):
        inner = BASIS.ring < 8
        np.testing.assert_allclose(ours[inner], expected[inner], atol=2.5e-3)
        # from 75° to the horizon shares change over the patch by all they can
        np.testing.assert_allclose(ours, expected, atol=0.04)
    np.testing.assert_allclose(transmission[:9], exact("transmittance")[:9], atol=1e-5)


def test_a_stack_of_beams_is_averaged_as_it_stands():
    """Its columns are the means of the exact stack over their patches, polarisation and all; solar beside visible."""
    medium = Medium(n=N, absorption_per_mm=0.02)
    stack = Stack([Pane(thickness_mm=4.0, medium=medium), Gap(width_mm=12.0), Pane(thickness_mm=4.0, medium=medium)])
    found = stack.bsdf(basis="klems_full")

    def exact(theta):
        shares = stack.angular(elevation_deg=theta.ravel())
        return shares.transmittance.values[:, 0].reshape(theta.shape)

    np.testing.assert_allclose(found.visible.transmission_front.hemispherical(), polar_means(exact), atol=2e-3)
    assert found.exact is stack
    assert found.thickness_mm == 20.0
    assert found.solar is not None
    averaged = stack.bsdf(basis="klems_full", polarisation="averaged", bands=("visible",))
    lost = found.visible.transmission_front.hemispherical() - averaged.visible.transmission_front.hemispherical()
    assert lost[BASIS.ring == 6].min() > 0.02


def test_a_stack_with_a_bsdf_is_multiplied():
    shade = Bsdf(name="shade", visible=rough_band(13, 0.8), thickness_mm=1.0)
    pane = Pane(thickness_mm=4.0, medium=Medium(n=N))
    stack = Stack([pane, Gap(width_mm=12.0), shade])
    found = stack.bsdf()
    expected = layered_band([pane.bsdf(bands=("visible",)).visible, shade.visible]).band
    for name, values in blocks(found.visible).items():
        np.testing.assert_allclose(values, blocks(expected)[name], atol=1e-12)
    assert found.thickness_mm == 17.0
    assert found.exact is None
    assert stack.glazing().spreads
    with pytest.raises(ClerestoryError, match="rank must be left out where a layer spreads light"):
        stack.bsdf(rank=4)
    with pytest.raises(ClerestoryError, match=r"layers\[1\] spreads light"):
        stack.angular(elevation_deg=0.0)


def test_bsdfs_combine_in_the_bands_they_share():
    glass = Bsdf(name="glass", visible=pane_band(), solar=pane_band(0.05), thickness_mm=4.0)
    shade = Bsdf(name="shade", visible=rough_band(12, 0.5), thickness_mm=1.0)
    found = layered_bsdf([glass, shade], gaps_mm=12.0)
    assert list(found.bands) == ["visible"]
    assert found.bsdf.name == "glass + shade"
    assert found.bsdf.thickness_mm == 17.0
    assert found.bsdf.solar is None
    both = layered_bsdf([glass, glass])
    assert both.bands["solar"].absorptance_front.sum() > both.bands["visible"].absorptance_front.sum() + 1.0
    with pytest.raises(ClerestoryError, match="layers must be at least one"):
        layered_bsdf([])
    with pytest.raises(ClerestoryError, match="layers must be at least one"):
        layered_band([])
