"""Light goes the same way in Radiance as in our sums and our room: up is up, left is left, and outside is outside."""

from itertools import product
from pathlib import Path

import numpy as np
import pytest
from tests.bsdf.panels_as_matrices import BASIS, inside_out, laser_cut, prism, upside_down
from tests.bsdf.test_three_phase import read_matrix, write_matrix
from tests.bsdf.window_in_radiance import (
    ALTITUDES_DEG,
    CENTRE_M,
    HALF_M,
    NORMALS,
    POINTS_M,
    by_rtrace,
    by_sums,
    daylight_by_rfluxmtx,
    sun,
    view_by_rfluxmtx,
    window_solid_angles,
)

from clerestory import Bsdf, Material, Room, Sensors, Surface, Window, daylight_coefficients, sky_basis

pyradiance = pytest.importorskip("pyradiance")

TURNS = list(product((False, True), repeat=2))
"""Upside down or not, inside out or not."""
RUNS = 8
"""Of our room, whose scatter is the standard error of the mean."""
FROM_BELOW = np.tile(np.array(ALTITUDES_DEG) > 10.0, 2)
"""Sensors that light reaches which travels upwards: where a ceiling would be."""


def turned(bsdf: Bsdf, is_upside_down: bool, is_inside_out: bool) -> Bsdf:
    band = upside_down(bsdf.visible) if is_upside_down else bsdf.visible
    band = inside_out(band) if is_inside_out else band
    return Bsdf(name=bsdf.name, visible=band, solar=band, thickness_mm=bsdf.thickness_mm)


@pytest.fixture(scope="module")
def view() -> np.ndarray:
    return view_by_rfluxmtx()


@pytest.fixture(scope="module")
def daylight() -> np.ndarray:
    return daylight_by_rfluxmtx()


def uneven_sky() -> np.ndarray:
    """Luminance that differs east and west, high and low: ground first, as Radiance counts."""
    basis = sky_basis("tregenza145")
    centres = np.asarray(basis.centres)
    luminance = 1.0 + 0.8 * centres[:, 0] + 0.9 * centres[:, 2]
    luminance[-1] = 0.2
    return luminance[np.asarray(basis.order("radiance"))]


def three_phase(bsdf: Bsdf, view: np.ndarray, daylight: np.ndarray, folder: Path) -> np.ndarray:
    """Irradiance of each sensor by dctimestep, our XML between Radiance's own matrices."""
    paths = [
        write_matrix(folder / "view.mtx", view),
        bsdf.to_xml(folder / "panel.xml"),
        write_matrix(folder / "daylight.mtx", daylight),
        write_matrix(folder / "sky.mtx", uneven_sky()[:, None]),
    ]
    return read_matrix(pyradiance.dctimestep(*paths, header=False), len(view))[:, 0]


def test_radiance_names_the_patches_of_a_view_as_we_do(view):
    """Its 200 000 rays a sensor miss a patch of the window by half a per cent, a wrong patch by all of it."""
    ours = window_solid_angles()
    assert np.abs(view - ours).max() < 0.02 * ours.max()
    mirrored = BASIS.find(-BASIS.centre[:, 0], BASIS.centre[:, 1])
    assert np.abs(view[:, mirrored] - ours).max() > 0.9 * ours.max()


@pytest.mark.parametrize("make", [laser_cut, prism])
def test_a_sun_through_the_material_lights_what_it_should(make):
    """Radiance jitters both directions within their patches to hide the edges, so that a sensor near an edge is off by
    a third and the sum by less; which sensors are lit tells the four ways to hold the element apart."""
    bsdf, travel = make(), sun()
    ours = np.array([by_sums(turned(bsdf, *turn).visible, travel) for turn in TURNS])
    theirs = np.array([by_rtrace(bsdf, travel, is_upside_down=a, is_inside_out=b) for a, b in TURNS])
    likeness = (theirs @ ours.T) / np.outer(np.linalg.norm(theirs, axis=1), np.linalg.norm(ours, axis=1))
    assert np.diag(likeness).min() > 0.995
    assert theirs.sum(axis=1) / ours.sum(axis=1) == pytest.approx(1.0, abs=0.3)
    if make is prism:
        assert (likeness.argmax(axis=1) == np.arange(4)).all()
        assert (likeness - 2.0 * np.eye(4)).max() < 0.98
    else:
        assert (theirs[:, FROM_BELOW].sum(axis=1) > 0.25 * theirs.sum(axis=1)).all()
    # nothing is mirrored left for right
    assert theirs[:, len(ALTITUDES_DEG) :].max() < 0.01 * theirs.max()


def test_a_laser_cut_panel_lights_the_ceiling_in_three_phase(view, daylight, tmp_path):
    """Light of a patch of sky 54° high goes down through an opening and up from a panel."""
    basis = sky_basis("tregenza145")
    order = np.asarray(basis.order("radiance"))
    way = np.asarray(basis.centres)[order]
    patch = int(np.argmax(way @ np.array([0.0, -np.cos(np.radians(54.0)), np.sin(np.radians(54.0))])))
    one = np.zeros_like(daylight)
    one[:, patch] = daylight[:, patch]
    opening = np.diag(1.0 / BASIS.projected_solid_angle)
    through = view @ (opening * BASIS.projected_solid_angle) @ one @ uneven_sky()
    panel = three_phase(laser_cut(), view, one, tmp_path)
    assert through[FROM_BELOW].sum() < 1e-3 * through.sum()
    assert panel[FROM_BELOW].sum() > 0.2 * panel.sum()


@pytest.mark.parametrize("turn", TURNS)
def test_turning_a_prism_changes_the_answer_as_in_our_room(turn, view, daylight, tmp_path):
    """Radiance's matrices are sampled to about a per cent, ours has its standard error; other turns differ by more."""
    bsdf = turned(prism(), *turn)
    theirs = three_phase(bsdf, view, daylight, tmp_path)
    ours, error = by_our_room(bsdf)
    assert (error < 0.02 * ours.max()).all()
    assert (np.abs(ours - theirs) < 4.0 * error + 0.01 * theirs.max()).all()
    for other in TURNS:
        if other != turn:
            wrong = three_phase(turned(prism(), *other), view, daylight, tmp_path)
            assert np.abs(ours - wrong).max() > 4.0 * error.max() + 0.03 * theirs.max()


def by_our_room(bsdf: Bsdf) -> tuple[np.ndarray, np.ndarray]:
    """Irradiance of the sensors behind a black wall and the standard error."""
    corners = CENTRE_M + HALF_M * np.array([[1, 0, -1], [-1, 0, -1], [-1, 0, 1], [1, 0, 1]])
    outline, far = corners.tolist(), 30.0
    black = Material(diffuse_reflectance=0.0)
    around = [(far, 0.0, -far), (-far, 0.0, -far), (-far, 0.0, far), (far, 0.0, far)]
    walls = [Surface(name="wall", outline_m=around, holes_m=[outline], material=black)]
    behind = [(x, far, z) for x, _, z in around]
    walls.append(Surface(name="far wall", outline_m=behind[::-1], material=black))
    for i in range(4):
        sides = [around[i - 1], around[i], behind[i], behind[i - 1]]
        walls.append(Surface(name=f"side {i}", outline_m=sides, material=black))
    room = Room(
        surfaces=tuple(walls),
        windows=(Window(name="window", outline_m=outline, glazing=bsdf),),
        sensors=(Sensors(points_m=POINTS_M.tolist(), normals=NORMALS.tolist()),),
    )
    sky = np.empty(146)
    sky[np.asarray(sky_basis("tregenza145").order("radiance"))] = uneven_sky()
    runs = []
    for seed in range(RUNS):
        found = daylight_coefficients(room, basis="tregenza145", rounds=64, seed=seed)
        runs.append(sum(found[part].values @ sky for part in ("direct", "redirected", "interreflected")))
    return np.mean(runs, axis=0), np.std(runs, axis=0, ddof=1) / np.sqrt(RUNS)
