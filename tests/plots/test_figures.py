"""Figures hold the data they were given, whatever they look like."""

from dataclasses import dataclass

import numpy as np
import pytest
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.glass import edmonds_deflected_fraction
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel, Pane, PrismaticPanel
from clerestory.plots import deflected_fraction, dispersion, radial, regression, section
from clerestory.plots.section_outline import outline

ELEVATION = np.arange(0.0, 90.0, 5.0)
LASER_CUT = LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0, medium=Medium(n=1.49))


def test_radial_lines_are_the_table_where_the_light_comes_from():
    table = LASER_CUT.angular(elevation_deg=ELEVATION)
    axes = radial(table).axes[0]
    through, back = axes.lines
    np.testing.assert_array_equal(through.get_ydata(), table.transmittance.values[:, 0])
    np.testing.assert_array_equal(back.get_ydata(), table.reflectance.values[:, 0])
    # from the left on the front, higher for light from above
    np.testing.assert_allclose(through.get_xdata(), np.radians(180.0 - ELEVATION))


def test_radial_of_both_sides_is_one_diagram():
    tables = [LASER_CUT.angular(elevation_deg=[-60.0, 0.0, 60.0], side=side) for side in ("front", "back")]
    lines = radial(*tables, quantities=["transmittance"]).axes[0].lines
    np.testing.assert_allclose(np.degrees(lines[0].get_xdata()), [240.0, 180.0, 120.0])
    np.testing.assert_allclose(np.degrees(lines[1].get_xdata()), [-60.0, 0.0, 60.0])


def test_radial_bands_are_two_standard_errors():
    table = LASER_CUT.angular(elevation_deg=ELEVATION).assign(
        transmittance_standard_error=(("elevation", "azimuth"), np.full((ELEVATION.size, 1), 0.05))
    )
    axes = radial(table, quantities=["transmittance"]).axes[0]
    heights = axes.collections[0].get_paths()[0].vertices[:, 1]
    assert heights.max() == pytest.approx(table.transmittance.values.max() + 0.1)


def test_radial_refuses_what_is_not_one_line():
    table = LASER_CUT.angular(elevation_deg=ELEVATION, azimuth_deg=[0.0, 30.0])
    with pytest.raises(ClerestoryError, match="one azimuth, got 2"):
        radial(table)
    with pytest.raises(ClerestoryError, match="one table a side"):
        radial(table, table)
    with pytest.raises(ClerestoryError, match="quantity must be a variable"):
        radial(table.isel(azimuth=[0]), quantities=["brightness"])


def test_deflected_fraction_is_the_quotient_and_the_formula_is_dashed():
    table = LASER_CUT.angular(elevation_deg=ELEVATION)
    expected = edmonds_deflected_fraction(ELEVATION, 1.49, spacing_mm=3.0, thickness_mm=6.0)
    solid, dashed, _ = deflected_fraction({0.5: table}, formula={0.5: expected}).axes[0].lines
    quotient = table.transmittance_deflected / table.transmittance
    np.testing.assert_array_equal(solid.get_ydata(), quotient.values[:, 0])
    np.testing.assert_array_equal(dashed.get_ydata(), expected)
    assert solid.get_color() == dashed.get_color()
    assert dashed.is_dashed()


def test_dispersion_shows_every_wavelength_of_the_strongest_beams():
    panel = PrismaticPanel(pitch_mm=1, lower_deg=45, upper_deg=45, base_mm=1, ridges="back", medium="polycarbonate")
    wavelengths = [450.0, 550.0, 650.0]
    lobes = {w: panel.lobes(elevation_deg=40.0, wavelength_nm=w) for w in wavelengths}
    figure = dispersion(lobes, most_beams=1)
    points = np.asarray(figure.axes[0].collections[0].get_offsets())
    np.testing.assert_array_equal(np.sort(points[:, 1]), wavelengths)
    strongest = {w: float(table.elevation_deg[0]) for w, table in lobes.items()}
    found = {w: e for e, w in points}
    assert found == pytest.approx(strongest)
    assert len(set(np.round(list(found.values()), 6))) == 3


def test_dispersion_refuses_to_draw_nothing():
    lobes = {550.0: LASER_CUT.lobes(elevation_deg=20.0)}
    with pytest.raises(ClerestoryError, match="least_power"):
        dispersion(lobes, least_power=1.5)


@dataclass
class Pairs:
    reference: np.ndarray
    values: np.ndarray
    r_squared: float = 0.987
    slope: float = 1.02
    intercept: float = -0.01
    rms: float = 0.003


def test_regression_tells_what_it_is_given():
    pairs = Pairs(np.array([0.1, 0.5, 0.9]), np.array([0.1, 0.52, 0.88]))
    axes = regression(pairs).axes[0]
    _, line, dots = axes.lines
    np.testing.assert_array_equal(dots.get_xdata(), pairs.reference)
    np.testing.assert_array_equal(dots.get_ydata(), pairs.values)
    np.testing.assert_allclose(line.get_ydata(), -0.01 + 1.02 * line.get_xdata())
    assert "R² = 0.9870\nslope = 1.0200\nrms = 0.0030" in [text.get_text() for text in axes.texts]


def _area(polygons):
    return sum(0.5 * abs(np.dot(p[:, 0], np.roll(p[:, 1], 1)) - np.dot(p[:, 1], np.roll(p[:, 0], 1))) for p in polygons)


@pytest.mark.parametrize(
    ("panel", "share"),
    [
        (Pane(thickness_mm=4.0), 1.0),
        (LASER_CUT, 1.0),
        (LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0, cut_width_mm=0.3), 0.9),
        (LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0, cut_width_mm=0.3, cut_tilt_deg=12.0), 0.9),
        (LaserCutPanel(spacing_mm=3.0, thickness_mm=6.0, cut_width_mm=0.3, cut_depth_mm=3.0), 0.95),
        # ridges as high as half the pitch, half of it air
        (PrismaticPanel(pitch_mm=2.0, lower_deg=45, upper_deg=45, base_mm=1.0), 0.75),
        (PrismaticPanel(pitch_mm=2.0, lower_deg=45, upper_deg=45, base_mm=1.0, ridges="back"), 0.75),
    ],
)
def test_outline_fills_what_is_solid(panel, share):
    profile = panel.native_profile
    low, high = 0.3 * profile.pitch_mm, 4.3 * profile.pitch_mm
    front, back = profile.depth_range_mm
    assert _area(outline(profile, low, high).solids) == pytest.approx(share * (back - front) * (high - low))


def _strips():
    corners = [
        [(-2, 4), (-2, 5), (0, 2), (0, 1)],
        [(0, 1), (0, 2), (6, 1), (6, 0)],
        [(6, 0), (6, 1), (8, -1), (8, -2)],
    ]
    return xr.Dataset(
        {"corners": (("strip", "corner", "axis"), np.array(corners, float)), "power": ("strip", [1.0, 0.9, 0.8])},
        attrs={"elevation_deg": 50.0},
    )


def test_section_draws_each_strip_and_labels_what_leaves():
    figure = section(LASER_CUT, _strips())
    axes = figure.axes[0]
    strips = axes.collections[-1]
    np.testing.assert_array_equal(strips.get_array(), [0.8, 0.9, 1.0])
    # within the panel as given; outside longer, in the same direction
    inside = strips.get_paths()[1].vertices[:4]
    np.testing.assert_array_equal(inside, [(0, 1), (0, 2), (6, 1), (6, 0)])
    leaving = strips.get_paths()[0].vertices[:4]
    np.testing.assert_array_equal(leaving[:2], [(6, 0), (6, 1)])
    way = leaving[3] - leaving[0]
    assert way[1] / way[0] == pytest.approx(-1.0)
    assert np.linalg.norm(way) > 10.0
    assert {"6 mm", "3 mm", "80 %", "outside", "room"} <= {text.get_text() for text in axes.texts}
    assert axes.get_aspect() == 1.0


def test_section_without_light_is_the_panel_alone():
    assert section(LASER_CUT).axes[0].get_title() == ""
    assert len(section(LASER_CUT).axes) == 1
