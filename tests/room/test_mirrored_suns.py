"""The sun by way of mirrors and windows: against rays sent forward from it, a stack of panels, and energy."""

import warnings

import numpy as np
import pytest

from clerestory.glazing import Glass, Open, Stack
from clerestory.panels import LaserCutPanel
from clerestory.room import LightShelf, Louvres, Material, Mesh, Opening, Part, Room, Sensors, Surface, Window
from clerestory.sun import direction_of
from clerestory.sun_coefficients import SunWarning, sun_coefficients

MIRROR = Material(diffuse_reflectance=0.0, specular_reflectance=0.85)
#: The middle of the room: light that travels away from it falls on the inner side of a wall.
INSIDE = np.array([2.0, 2.5, 1.5])
PANEL = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0)


def black_room(*parts, obstructions=(), **shape):
    return Room.shoebox(
        **{"width_m": 4.0, "depth_m": 5.0, "height_m": 3.0, "floor": 0.0, "walls": 0.0, "ceiling": 0.0} | shape,
        openings=[Opening(width_m=3.0, height_m=2.0, sill_m=0.8, parts=list(parts))],
        obstructions=obstructions,
    )


def on_rectangle(surface, steps, lots):
    """Jittered grids of points just inside a rectangle of the room, lot by lot, what they face, and its area."""
    corner, right, _, up = (np.asarray(point) for point in surface.outline_m)
    cells = np.stack(np.meshgrid(np.arange(steps), np.arange(steps)), axis=-1).reshape(-1, 2)
    u = (cells + np.random.default_rng(1).uniform(size=(lots, steps * steps, 2))).reshape(-1, 2) / steps
    across = np.cross(right - corner, up - corner)
    area = float(np.linalg.norm(across))
    normal = across / area * np.sign(across @ (INSIDE - corner))
    points = corner + u[:, :1] * (right - corner) + u[:, 1:] * (up - corner) + 1e-6 * normal
    return points, np.tile(normal, (len(points), 1)), area


def flux_on(room, name, altitude_deg, azimuth_deg, steps=20, lots=8, rounds=16):
    """Flux on a rectangle over the sun's normal illuminance [m²], and its standard error.

    The sensors of a round share its points of the disc: rounds see to the penumbra, lots to the edges.
    """
    points, normals, area = on_rectangle(next(one for one in room.surfaces if one.name == name), steps, lots)
    sensors = Sensors(points_m=points, normals=normals)
    found = sun_coefficients(room, sensors, altitude_deg=altitude_deg, azimuth_deg=azimuth_deg, rounds=rounds)
    means = (found.direct + found.redirected).values[:, 0].reshape(lots, -1).mean(axis=1)
    return area * means.mean(), area * means.std(ddof=1) / np.sqrt(lots)


def with_mirrors(room, *names):
    """The room with some of its surfaces mirrors."""
    surfaces = [
        Surface(name=one.name, outline_m=one.outline_m, holes_m=one.holes_m, material=MIRROR)
        if one.name in names
        else one
        for one in room.surfaces
    ]
    return Room(surfaces=tuple(surfaces), windows=room.windows)


def sent_forward(room, altitude_deg, azimuth_deg, count, middle, radius):
    """Flux on every surface by rays sent from the sun's disc through a ball, absorbed where they are not turned."""
    rng = np.random.default_rng(2)
    towards = direction_of(np.array([altitude_deg]), np.array([azimuth_deg]))[0]
    across = np.cross(towards, [0.0, 0.0, 1.0])
    across /= np.linalg.norm(across)
    up = np.cross(across, towards)

    def disc(reach):
        r, angle = reach * np.sqrt(rng.uniform(size=(count, 1))), rng.uniform(0.0, 2.0 * np.pi, (count, 1))
        return r * np.cos(angle) * across + r * np.sin(angle) * up

    origins = np.asarray(middle) + disc(radius) + 50.0 * towards
    directions = -towards + disc(np.radians(0.533 / 2.0))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    normals = {one.name: np.cross(*np.diff(np.asarray(one.outline_m)[:3], axis=0)) for one in room.surfaces}
    mirrors = {one.name: one.material.specular_reflectance for one in room.surfaces}
    windows = {one.name: one for one in room.windows}
    landed = dict.fromkeys(room.scene.surfaces, 0)
    for turn in range(24):
        distance, met = room.scene.closest(origins, directions)
        onward_origins, onward_directions = [], []
        for index, name in enumerate(room.scene.surfaces):
            here = met == index
            if not here.any():
                continue
            points, along = origins[here] + distance[here, None] * directions[here], directions[here]
            if name in windows:
                z = np.cross(*np.diff(np.asarray(windows[name].outline_m)[:3], axis=0))
                z /= np.linalg.norm(z)
                x = np.cross([0.0, 0.0, 1.0], z)
                axes = np.stack([x, np.cross(z, x), z])
                turned = windows[name].glazing.glazing().scatter(along @ axes.T, seed=100 * turn + index)
                kept = ~np.isnan(turned[:, 0])
                leaving = turned[kept] @ axes
            else:
                kept = rng.uniform(size=len(points)) < mirrors[name]
                normal = normals[name] / np.linalg.norm(normals[name])
                from_inside = ((points - INSIDE) @ normal) * (along @ normal) > 0.0
                landed[name] += int((~kept & from_inside).sum())
                leaving = along[kept] - 2.0 * (along[kept] @ normal)[:, None] * normal
            onward_origins.append(points[kept] + 1e-9 * leaving)
            onward_directions.append(leaving)
        if not onward_origins:
            break
        origins, directions = np.concatenate(onward_origins), np.concatenate(onward_directions)
    each = np.pi * radius**2 / count
    return {name: (each * hits, each * np.sqrt(hits)) for name, hits in landed.items()}


@pytest.mark.parametrize(("altitude", "azimuth", "mirror"), [(35.0, 150.0, "left"), (25.0, 200.0, "right")])
def test_rays_sent_from_the_sun_land_where_sensors_look_for_it(altitude, azimuth, mirror):
    """A panel above glass, a mirror shelf on both sides of them, a mirrored wall: the flux on every black wall."""
    shelf = LightShelf(height_m=1.9, outside_m=0.7, inside_m=0.5, width_m=3.6, material=MIRROR)
    parts = (Part(glazing=PANEL, height_m=0.8), Part(glazing=Glass(transmittance=0.8)))
    room = with_mirrors(black_room(*parts, obstructions=[shelf]), mirror)
    sent = sent_forward(room, altitude, azimuth, 600_000, (2.0, 0.0, 1.7), 2.6)
    for name in {"floor", "ceiling", "back", "left", "right"} - {mirror}:
        flux, error = sent[name]
        looked, looked_error = flux_on(room, name, altitude, azimuth)
        both = np.hypot(error, looked_error)
        assert both < 0.02 * flux + 0.002, f"{name}: too noisy to judge"
        assert abs(looked - flux) <= 4.5 * both, f"{name}: {looked:.4f}, sent {flux:.4f} ± {both:.4f}"
    # the floor of the room is not lit through the shelf alone: what it throws up is a good part of the whole
    assert sent["ceiling"][0] > 1.0


def test_flux_on_the_ceiling_is_what_the_shelf_mirrors():
    """All that a shelf under a tall window mirrors goes up through it: ρ times its area times sin α."""
    shelf = LightShelf(height_m=0.8, outside_m=0.4, width_m=2.0, material=MIRROR)
    room = black_room(Part(glazing=Open()), obstructions=[shelf])
    flux, error = flux_on(room, "ceiling", 55.0, 180.0, steps=48, rounds=8)
    expected = 0.85 * 0.4 * 2.0 * np.sin(np.radians(55.0))
    assert error < 0.02 * expected
    assert abs(flux - expected) < 4.5 * error


def test_louvres_of_mirrors_hand_the_sun_on_between_them():
    """What passes close slats was turned n or n + 1 times, up or down, in the shares that a section gives."""
    depth, pitch = 0.1, 0.05
    louvres = Louvres(bottom_m=0.4, top_m=3.4, count=61, depth_m=depth, distance_m=0.2, width_m=20.0, material=MIRROR)
    room = black_room(Part(glazing=Open()), obstructions=[louvres])
    for altitude in (35.0, 60.0):
        # along the slats' depth a ray falls so many pitches, and turns at every slat it would cross
        fall = depth * np.tan(np.radians(altitude)) / pitch
        turns, beyond = int(fall), fall - int(fall)
        through = 3.0 * 2.0 * np.cos(np.radians(altitude))
        odd, even = (turns, turns + 1) if turns % 2 else (turns + 1, turns)
        shares = {turns: 1.0 - beyond, turns + 1: beyond}
        expected = {"ceiling": 0.85**odd * shares[odd] * through, "floor": 0.85**even * shares[even] * through}
        for name, flux_expected in expected.items():
            flux, error = flux_on(room, name, altitude, 180.0, steps=12, rounds=2)
            # window and room cut a slat's beam at their rims
            assert flux == pytest.approx(flux_expected, abs=4.5 * error + 0.06), (altitude, name)


def test_two_panels_in_a_row_are_a_stack():
    """Panel before panel as two windows do together what the stack of both does to unpolarised light."""
    inner = [(4.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 3.0), (4.0, 0.0, 3.0)]
    outer = [(x, -0.001, z) for x, _, z in inner]
    room = Room(
        windows=(
            Window(name="inner", outline_m=inner, glazing=PANEL),
            Window(name="outer", outline_m=outer, glazing=PANEL),
        )
    )
    lobes = Stack((PANEL, PANEL)).lobes(elevation_deg=35.0, polarisation="averaged")
    sine, cosine = np.sin(np.radians(35.0)), np.cos(np.radians(35.0))
    up, down = (
        float(lobes.power.where((lobes.side == "back") & (sign * lobes.elevation_deg > 0.0), 0.0).sum())
        for sign in (1.0, -1.0)
    )
    normals = [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0), (0.0, -1.0, 0.0)]
    sensors = Sensors(points_m=[[2.0, 0.05, 1.5]] * 3, normals=normals)
    found = sun_coefficients(room, sensors, altitude_deg=35.0, azimuth_deg=180.0, rounds=32)
    # a stack counts all of one direction as direct if any of it is
    assert float(found.redirected[0, 0]) > 0.05
    np.testing.assert_allclose(
        (found.direct + found.redirected)[:, 0], [down * sine, up * sine, (up + down) * cosine], atol=2e-3
    )


def test_barrel_of_few_facets_is_followed_and_of_many_is_told_of():
    """What is not looked for is not left out in silence."""

    def with_barrel(count):
        angles = np.linspace(0.0, np.pi, count + 1)
        rim = [(x, -3.0 - 0.3 * np.cos(a), 1.0 + 0.3 * np.sin(a)) for a in angles for x in (0.0, 4.0)]
        triangles = [(2 * k + i, 2 * k + j, 2 * k + m) for k in range(count) for i, j, m in ((0, 1, 3), (0, 3, 2))]
        room = black_room(Part(glazing=Open()))
        barrel = Mesh(name="barrel", vertices_m=rim, triangles=triangles, material=MIRROR)
        return Room(surfaces=room.surfaces, windows=room.windows, meshes=(barrel,))

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        fluxes = [flux_on(with_barrel(count), "ceiling", 40.0, 180.0, steps=12, rounds=4) for count in (48, 96)]
    # coarse and fine facets approach the same barrel
    assert fluxes[0][0] > 0.02
    assert abs(fluxes[0][0] - fluxes[1][0]) < 4.5 * np.hypot(fluxes[0][1], fluxes[1][1]) + 0.02 * fluxes[0][0]
    sensor = Sensors(points_m=[[2.0, 2.0, 0.8]])
    with pytest.warns(SunWarning, match="mirror 'barrel', of 600 facets and over 256 directions, is not looked for"):
        sun_coefficients(with_barrel(300), sensor, altitude_deg=40.0, azimuth_deg=180.0, rounds=2)


def test_what_is_too_weak_to_be_followed_is_reported():
    """Between dull mirrors beams soon fall below the least strength; a shelf alone leaves nothing out."""
    weak = Material(diffuse_reflectance=0.0, specular_reflectance=0.005)
    shelf = LightShelf(height_m=0.8, outside_m=0.4, material=MIRROR)
    facing = [LightShelf(height_m=h, outside_m=2.0, name=f"shelf {h}", material=weak) for h in (0.8, 1.0)]
    sensor = Sensors(points_m=[[2.0, 2.0, 0.8]])
    alone, between = (
        sun_coefficients(
            black_room(Part(glazing=Open()), obstructions=shelves), sensor, altitude_deg=40.0, azimuth_deg=180.0
        ).cut_off
        for shelves in ([shelf], facing)
    )
    assert alone.dims == ("sun",)
    assert float(alone[0]) == 0.0
    assert 0.0 < float(between[0]) <= 2e-4
