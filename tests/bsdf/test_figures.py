"""Figures of BSDFs hold the numbers of their blocks, at the directions they belong to."""

import numpy as np
import pytest
from tests.bsdf.elements import uneven_bsdf, uneven_tree_bsdf

from clerestory import Band, Bsdf, ClerestoryError, KlemsBlock
from clerestory.bsdf import klems_basis
from clerestory.bsdf.cells import outgoing_cells
from clerestory.plots import bsdf_cut, bsdf_discs, bsdf_shares


def area(outline: np.ndarray) -> float:
    x, y = outline.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


@pytest.mark.parametrize("bsdf", [uneven_bsdf("klems_half"), uneven_tree_bsdf(3), uneven_tree_bsdf(4)])
def test_cells_cover_the_disc_and_hold_its_power(bsdf: Bsdf) -> None:
    block, point = bsdf.visible.transmission_front, np.array([0.37, -0.52])
    outlines, values = outgoing_cells(block, point)
    areas = np.array([area(outline) for outline in outlines])
    assert areas.sum() == pytest.approx(np.pi, rel=5e-3)
    assert areas @ values == pytest.approx(float(block.hemispherical_at(point)), rel=1e-2)
    middle = np.array([outline.mean(axis=0) for outline in outlines])
    inside = np.hypot(*(middle - middle.mean(axis=0)).T) < 0.9
    drawn = block.at(point, middle[inside])
    # the mean of its corners lies in a cell unless the cell is bent: all but a few
    assert (np.abs(drawn - values[inside]) < 1e-9).mean() > 0.9


def test_discs_show_the_picked_incidence_and_its_column() -> None:
    bsdf = uneven_bsdf("klems_quarter")
    figure = bsdf_discs(bsdf, elevation_deg=30.0, azimuth_deg=-20.0)
    shares, passed, back = (np.asarray(axes.collections[0].get_array()) for axes in figure.axes[:3])
    column = int(klems_basis("klems_quarter").find(np.sin(np.radians(-20.0)) * np.cos(np.radians(30.0)), -0.5))
    assert shares == pytest.approx(bsdf.visible.transmission_front.hemispherical())
    most = max(getattr(bsdf.visible, f"{way}_front").values[:, column].max() for way in ("transmission", "reflection"))
    for drawn, block in ((passed, bsdf.visible.transmission_front), (back, bsdf.visible.reflection_front)):
        assert drawn == pytest.approx(np.maximum(block.values[:, column], 1e-4 * most))
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert "BSDF [1/sr]" in labels


def test_the_cut_has_the_room_on_the_right() -> None:
    basis = klems_basis("klems_quarter")
    straight = KlemsBlock(np.diag(0.5 / basis.projected_solid_angle), basis, basis)
    dark = KlemsBlock(np.zeros((41, 41)), basis, basis)
    bsdf = Bsdf(name="clear", visible=Band(straight, straight, dark, dark))
    for side, expected in (("front", -40.0), ("back", 180.0 + 40.0)):
        line = bsdf_cut(bsdf, elevation_deg=40.0, side=side).axes[0].lines[0]
        peak = np.degrees(line.get_xdata()[np.asarray(line.get_ydata()) > line.get_ydata().max() - 1e-9])
        assert peak.min() - 1e-6 <= expected <= peak.max() + 1e-6


@pytest.mark.parametrize("bsdf", [uneven_bsdf("klems_quarter"), uneven_tree_bsdf(3)])
def test_shares_stand_at_the_elevation_light_comes_from(bsdf: Bsdf) -> None:
    axes = bsdf_shares(bsdf).axes[0]
    assert len(axes.lines) == 4
    elevation, drawn = axes.lines[2].get_data()
    block = bsdf.visible.reflection_front
    assert drawn[300] == pytest.approx(float(block.hemispherical_at([0.0, -np.sin(np.radians(elevation[300]))])))
    assert "Elevation" in axes.get_xlabel()


def test_what_is_not_known_is_not_drawn() -> None:
    front = Bsdf(name="front", visible=Band(uneven_bsdf("klems_quarter").visible.transmission_front))
    assert len([axes for axes in bsdf_discs(front).axes if not axes.get_ylabel()]) == 2
    with pytest.raises(ClerestoryError, match="back"):
        bsdf_discs(front, side="back")
    with pytest.raises(ClerestoryError, match="band"):
        bsdf_shares(front, band="solar")
    with pytest.raises(ClerestoryError, match="elevation_deg"):
        bsdf_cut(front, elevation_deg=100.0)
