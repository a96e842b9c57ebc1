"""A laser-cut panel drawn bar by bar, traced face by face, against the exact panel in the same window."""

import numpy as np
from numpy.typing import NDArray

from clerestory import _native

SPACING, CUT, THICKNESS = 0.5e-3, 0.05e-3, 0.6e-3
"""Bars of the panel [m]: so fine that its edges do not matter."""
N = 1.49
LOW, HIGH = np.array([0.5, 0.8]), np.array([2.5, 1.2])
"""Corners of the window in x and z [m], in the wall y = 0 of a black room of 3 x 2 x 2 m."""
SIZE = (3.0, 2.0, 2.0)


def rows(*points: tuple[float, float, float]) -> NDArray[np.float64]:
    return np.array(points, dtype=float)


def window_outline() -> NDArray[np.float64]:
    (x0, z0), (x1, z1) = LOW, HIGH
    return rows((x0, 0, z0), (x0, 0, z1), (x1, 0, z1), (x1, 0, z0))


def black_room() -> _native.SceneBuilder:
    x, y, z = SIZE
    black = _native.Material(0.0)
    builder = _native.SceneBuilder()
    builder.polygon("floor", rows((0, 0, 0), (x, 0, 0), (x, y, 0), (0, y, 0)), black)
    builder.polygon("ceiling", rows((0, 0, z), (0, y, z), (x, y, z), (x, 0, z)), black)
    builder.polygon("north", rows((0, y, 0), (x, y, 0), (x, y, z), (0, y, z)), black)
    builder.polygon("west", rows((0, 0, 0), (0, y, 0), (0, y, z), (0, 0, z)), black)
    builder.polygon("east", rows((x, 0, 0), (x, 0, z), (x, y, z), (x, y, 0)), black)
    south = rows((0, 0, 0), (0, 0, z), (x, 0, z), (x, 0, 0))
    builder.polygon("south", south, black, [window_outline()])
    return builder


def drawn_bars() -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Corners and outward triangles of all bars, which stand from y = -THICKNESS to 0."""
    count = round((HIGH[1] - LOW[1]) / SPACING)
    base = LOW[1] + SPACING * np.arange(count)
    corner = np.array([[(i >> k) & 1 for k in range(3)] for i in range(8)], dtype=float)
    size = np.array([HIGH[0] - LOW[0], THICKNESS, SPACING - CUT])
    start = np.stack([np.full(count, LOW[0]), np.full(count, -THICKNESS), base + CUT / 2], axis=1)
    vertices = start[:, None, :] + corner * size
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = np.array([t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))], dtype=np.int64)
    all_triangles = triangles[None] + 8 * np.arange(count)[:, None, None]
    return vertices.reshape(-1, 3), all_triangles.reshape(-1, 3)


def exact_glazing() -> _native.Glazing:
    profile = _native.Profile.laser_cut(
        spacing_mm=[SPACING * 1e3],
        thickness_mm=THICKNESS * 1e3,
        cut_width_mm=CUT * 1e3,
        cut_tilt_deg=[0.0],
        cut_depth_mm=None,
        cut_radius_mm=None,
        cut_slope_deg=0.0,
        cut_diffuse=0.0,
    )
    panel = _native.PanelOptics(
        profile,
        n=np.full((1, profile.highest_medium), N),
        absorption_per_mm=np.zeros((1, profile.highest_medium)),
        weights=np.ones(1),
        polarisation="averaged",
        tolerance=1e-6,
        most_pieces=256,
    )
    return panel.glazing()


def test_bars_drawn_one_by_one_are_the_exact_panel() -> None:
    basis = _native.SkyBasis("tregenza145")
    points, normals = rows((1.5, 0.3, 1.0)), rows((0.0, -1.0, 0.0))

    def traced(builder: _native.SceneBuilder, window_samples: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Shares of an even luminance from above and from below: direct, redirected and their errors."""
        scene = builder.build()
        sums = []
        for seed in range(4):
            r = _native.daylight_coefficients(
                scene, points, normals, basis, rounds=2, nodes=1, window_samples=window_samples, seed=seed
            )
            sky = [r[part][0, :-1].sum() for part in ("direct", "redirected")]
            ground = [r[part][0, -1] for part in ("direct", "redirected")]
            sums.append([*sky, *ground])
        table = np.array(sums)
        return table.mean(axis=0), table.std(axis=0, ddof=1) / np.sqrt(len(table))

    drawn = black_room()
    vertices, triangles = drawn_bars()
    drawn.interface("bars", vertices, triangles, (1.0, 0.0), (N, 0.0))
    exact = black_room()
    exact.window("panel", window_outline(), exact_glazing())
    value, error = traced(drawn, 1 << 16)
    expected, expected_error = traced(exact, 1 << 14)
    # redirected light from above and below, and direct light, are all there to be told apart
    assert (expected > 0.05).all()
    assert (error < 0.02 * value.sum()).all()
    # bars end at the sides of the window, a panel does not, and it has no depth: a two-hundredth of the light
    np.testing.assert_array_less(np.abs(value - expected), 4 * np.hypot(error, expected_error) + 0.005 * expected.sum())
