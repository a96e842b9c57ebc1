"""A BSDF in the window of a room: the sun's light falls where the file says, left and right, up and down."""

import numpy as np
import pytest
from tests.bsdf.elements import uneven_block

from clerestory import Band, Bsdf, KlemsBlock, LaserCutPanel, Material, Room, Sensors, Surface, Window, sun_coefficients
from clerestory.bsdf import klems_basis
from clerestory.bsdf.shirley_chiu import square_to_disc
from clerestory.sun import direction_of

WIDTH, SILL, HEAD = 2.0, 1.0, 2.0
SUN = {"altitude_deg": [35.0], "azimuth_deg": [200.0]}
#: Below, above and to both sides of a window that looks south; normals towards the window's plane.
POINTS = np.array([[0.4, 1.5, 0.0], [-0.9, 1.0, 3.0], [2.5, 2.0, 1.2], [-2.5, 2.0, 1.7]])
NORMALS = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]])


def room(glazing: Bsdf) -> Room:
    outline = [[-WIDTH / 2, 0, SILL], [-WIDTH / 2, 0, HEAD], [WIDTH / 2, 0, HEAD], [WIDTH / 2, 0, SILL]]
    wall = Surface(
        name="wall",
        outline_m=[[-9, 0, 0], [-9, 0, 9], [9, 0, 9], [9, 0, 0]],
        material=Material(diffuse_reflectance=0.0),
    )
    window = Window(name="w", outline_m=outline, glazing=glazing, wall="wall")
    return Room(surfaces=(wall,), windows=(window,), ground_reflectance=0.0)


def expected(block: KlemsBlock) -> np.ndarray:
    """Illuminance of the points per normal illuminance of the sun, direction by direction from the matrix."""
    sun = np.asarray(direction_of(35.0, 200.0)).reshape(3)
    # the element's axes: z into the room is north, y is up, x = y × z is west, which is right as seen from inside
    axes = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    incident = axes @ -sun
    u = (np.arange(700) + 0.5) / 700
    xy = square_to_disc(np.stack(np.meshgrid(u, u, indexing="ij"), axis=-1).reshape(-1, 2))
    share = block.at(np.broadcast_to(incident[:2], xy.shape), xy) * np.pi / len(xy)
    out = np.column_stack([xy, np.sqrt(np.maximum(0.0, 1.0 - (xy**2).sum(axis=1)))]) @ axes
    result = []
    for point, normal in zip(POINTS, NORMALS, strict=True):
        start = point - out * (point[1] / out[:, 1:2])
        through = (np.abs(start[:, 0]) < WIDTH / 2) & (start[:, 2] > SILL) & (start[:, 2] < HEAD)
        falls = np.maximum(0.0, -out @ normal)
        result.append(float((through * share * falls / out[:, 1]).sum()) * incident[2])
    return np.array(result)


@pytest.mark.parametrize("kind", ["without symmetry", "laser-cut"])
def test_the_sun_falls_where_the_matrix_sends_it(kind: str) -> None:
    if kind == "laser-cut":
        bsdf = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0).bsdf("klems_quarter").blurred()
    else:
        front = uneven_block(11, "klems_quarter", "klems_quarter", share=0.4)
        none = KlemsBlock(np.zeros((41, 41)), *[klems_basis("klems_quarter")] * 2)
        bsdf = Bsdf(name="uneven", visible=Band(front, front.reversed(), none, none))
    found = sun_coefficients(room(bsdf), Sensors(points_m=POINTS, normals=NORMALS), rounds=16, **SUN).isel(sun=0)
    total = (found.direct + found.redirected + found.interreflected).to_numpy()
    error = np.sqrt(sum(found[f"{part}_standard_error"].to_numpy() ** 2 for part in ("direct", "redirected")))
    wanted = expected(bsdf.visible.transmission_front)
    assert wanted.max() > 0.01
    assert (error < 0.1 * wanted.max()).all(), "too noisy to judge"
    assert (np.abs(total - wanted) < 4.5 * error + 0.01 * wanted.max()).all(), (total, wanted, error)
