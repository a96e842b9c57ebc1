"""Stacks of layers: what each keeps, polarisation between them, gaps, and what is refused."""

import json
import tomllib
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from clerestory import (
    ClerestoryError,
    Gap,
    Glass,
    LaserCutPanel,
    Medium,
    Open,
    Pane,
    PlainTransmittance,
    PrismaticPanel,
    Slab,
    Stack,
)
from clerestory.glass import slab
from clerestory.glazing_table import glazing_tables, write_glazing
from clerestory.room.toml_table import Table

CLEAR = Medium(n=1.52)
TINTED = Medium(n=1.52, absorption_per_mm=0.08)
PANE, DARK = Pane(thickness_mm=4.0, medium=CLEAR), Pane(thickness_mm=6.0, medium=TINTED)
#: Cuts of no width, so that the exact solver has little to do.
PANEL = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, cut_width_mm=0.0, medium=Medium(n=1.49))
ROUGH = LaserCutPanel(spacing_mm=4.0, thickness_mm=6.0, cut_width_mm=0.3, cut_slope_deg=1.0)
INCIDENCE = np.arange(0.0, 86.0, 5.0)


def account(found: xr.Dataset) -> xr.DataArray:
    return found.transmittance + found.reflectance + found.layer_absorptance.sum("layer") + found.residual


@pytest.mark.parametrize("side", ["front", "back"])
@pytest.mark.parametrize("polarisation", ["resolved", "averaged"])
def test_shares_of_panes_add_to_one(side, polarisation):
    found = Stack([DARK, PANE, DARK]).angular(elevation_deg=INCIDENCE, side=side, polarisation=polarisation)
    np.testing.assert_allclose(account(found), 1.0, atol=1e-14)
    assert (found.layer_absorptance[:, 1] >= 0.0).all()
    xr.testing.assert_allclose(found.layer_absorptance.sum("layer"), found.absorptance)


def test_lossless_panes_transmit_by_the_series_of_all_faces():
    """m panes without loss transmit (1 − R) / (1 + (2m − 1) R) of each polarisation, R of one face (Stokes, 1862)."""
    for panes in (1, 2, 3):
        found = Stack([PANE] * panes).angular(elevation_deg=INCIDENCE).transmittance[:, 0]
        # one pane has (1 − R) / (1 + R)
        expected = 0.0
        for polarisation in ("s", "p"):
            one = slab(INCIDENCE, 1.52, polarisation=polarisation).transmittance
            face = (1.0 - one) / (1.0 + one)
            expected += 0.5 * (1.0 - face) / (1.0 + (2 * panes - 1) * face)
        np.testing.assert_allclose(found, expected, atol=1e-13)


def test_polarisation_between_panes_is_worth_points():
    double = Stack([PANE, PANE])
    resolved, averaged = (
        double.angular(elevation_deg=[0.0, 70.0], polarisation=word).transmittance.values[:, 0]
        for word in ("resolved", "averaged")
    )
    assert resolved[0] == pytest.approx(averaged[0], abs=1e-12)
    assert resolved[1] - averaged[1] == pytest.approx(0.0378, abs=1e-4)


def test_the_outer_layer_is_one_from_either_side():
    """A dark pane outside a clear one absorbs whichever side the light comes from; turned round, it is layer 2."""
    outside, inside = Stack([DARK, PANE]), Stack([PANE, DARK])
    for side, other in (("front", "back"), ("back", "front")):
        kept = outside.absorptances(elevation_deg=60.0, side=side)[:, 0, 0].values
        assert kept[0] > 0.2
        assert kept[1] == pytest.approx(0.0, abs=1e-12)
        turned = inside.absorptances(elevation_deg=60.0, side=other)[::-1, 0, 0].values
        np.testing.assert_allclose(kept, turned, atol=1e-13)


@pytest.mark.parametrize("azimuth_deg", [0.0, 35.0])
def test_beams_of_a_panel_between_panes_add_to_one(azimuth_deg):
    stack = Stack([DARK, Gap(width_mm=10.0), PANEL, Gap(width_mm=10.0), PANE])
    lobes = stack.lobes(elevation_deg=40.0, azimuth_deg=azimuth_deg)
    whole = lobes.power.sum() + lobes.layer_absorptance.sum() + lobes.attrs["residual"]
    assert float(whole) == pytest.approx(1.0, abs=1e-12)
    assert abs(lobes.attrs["residual"]) < 1e-5
    upwards = lobes.power[(lobes.side == "back") & (lobes.elevation_deg > 0.0)]
    assert float(upwards.sum()) > 0.2
    shares = stack.angular(elevation_deg=40.0, azimuth_deg=azimuth_deg)
    assert float(shares.transmittance_deflected[0, 0]) == pytest.approx(float(upwards.sum()), abs=1e-12)
    np.testing.assert_allclose(shares.layer_absorptance[:, 0, 0], lobes.layer_absorptance, atol=1e-12)


def test_a_panel_in_a_stack_of_openings_is_the_panel():
    """Stokes vectors and all, whichever way the planes of incidence lie."""
    alone = PANEL.lobes(elevation_deg=50.0, azimuth_deg=20.0)
    among = Stack([Open(), PANEL, Open()]).lobes(elevation_deg=50.0, azimuth_deg=20.0)
    np.testing.assert_allclose(among.power, alone.power, atol=1e-9)
    np.testing.assert_allclose(among.stokes, alone.stokes, atol=1e-9)


def test_light_goes_back_the_way_it_came():
    """Reciprocity of a stack that turns light: as much from the room along a lobe reversed as along the lobe."""
    prism = PrismaticPanel(pitch_mm=10.0, lower_deg=60.0, upper_deg=30.0, base_mm=2.0, ridges="back", medium=CLEAR)
    for panel in (PANEL, prism):
        stack = Stack([PANE, panel, DARK])
        there = stack.lobes(elevation_deg=25.0, azimuth_deg=15.0)
        strongest = there.isel(lobe=int(np.argmax(np.where(there.side == "back", there.power, 0.0))))
        back = stack.lobes(
            elevation_deg=float(strongest.elevation_deg), azimuth_deg=-float(strongest.azimuth_deg), side="back"
        )
        leaving = back.direction.values @ np.array(
            [np.sin(np.radians(15.0)) * np.cos(np.radians(25.0)), -np.sin(np.radians(25.0)),
             np.cos(np.radians(15.0)) * np.cos(np.radians(25.0))]
        )  # fmt: skip
        same = int(np.argmin(leaving))
        assert leaving[same] == pytest.approx(-1.0, abs=1e-6)
        # power over the cosine of where it came from is what is reciprocal
        cos_in, cos_out = np.cos(np.radians(15.0)) * np.cos(np.radians(25.0)), abs(float(strongest.direction[2]))
        if panel is PANEL:
            assert cos_in == pytest.approx(cos_out)
            assert float(back.power[same]) == pytest.approx(float(strongest.power), abs=2e-6)


STEEP = PrismaticPanel(pitch_mm=2.0, lower_deg=45.0, upper_deg=80.0, base_mm=3.0, medium=CLEAR)
FLAT = PrismaticPanel(pitch_mm=2.0, lower_deg=60.0, upper_deg=20.0, base_mm=3.0, ridges="back", medium=CLEAR)
ODD = {"behind": [PANE, STEEP], "between": [DARK, FLAT, PANE], "two": [STEEP, FLAT]}


@pytest.mark.parametrize("side", ["front", "back"])
@pytest.mark.parametrize("layers", ODD.values(), ids=ODD)
def test_prisms_of_odd_angles_keep_the_account(layers, side):
    """To rounding, layer by layer; what is not known is stated and small."""
    stack = Stack(layers)
    lobes = stack.lobes(elevation_deg=30.0, azimuth_deg=-25.0, side=side)
    whole = lobes.power.sum() + lobes.layer_absorptance.sum() + lobes.attrs["residual"]
    assert float(whole) == pytest.approx(1.0, abs=1e-11)
    assert lobes.power.values.min() >= 0.0
    assert abs(lobes.attrs["residual"]) < 2e-5
    assert 0.0 < lobes.attrs["walked"] < 0.1
    assert lobes.attrs["walked_standard_error"] < 3e-4
    along = np.sin(np.radians(-25.0)) * np.cos(np.radians(30.0))
    np.testing.assert_allclose(lobes.direction.sel(axis="x"), along, atol=1e-9)
    shares = stack.angular(elevation_deg=30.0, azimuth_deg=-25.0, side=side)
    assert float(account(shares)[0, 0]) == pytest.approx(1.0, abs=1e-11)
    np.testing.assert_allclose(shares.layer_absorptance[:, 0, 0], lobes.layer_absorptance, atol=1e-11)


@pytest.mark.parametrize("layers", ODD.values(), ids=ODD)
def test_light_goes_back_through_odd_angles(layers):
    """Reciprocity: the share of a lobe there is that back, times how much wider in k_y it is (panels.md, eq. 11)."""
    stack = Stack(layers)

    def lobes(direction):
        x, y, z = direction
        return stack.lobes(
            elevation_deg=float(np.degrees(np.arcsin(-y))),
            azimuth_deg=float(np.degrees(np.arctan2(x, abs(z)))),
            side="front" if z > 0.0 else "back",
        )

    def raised(direction, step):
        x, y, z = direction[0], direction[1] + step, direction[2]
        return np.array([x, y, np.copysign(np.sqrt(1.0 - x * x - y * y), z)])

    came, step = np.array([0.2, -0.5, 0.0]), 1e-5
    came[2] = np.sqrt(1.0 - came @ came)
    there, beside = lobes(came), [lobes(raised(came, way)) for way in (-step, step)]
    compared = 0
    for lobe, power in zip(there.direction.values[:8], there.power.values[:8], strict=True):
        near = [np.flatnonzero(np.linalg.norm(one.direction.values - lobe, axis=1) < 20.0 * step) for one in beside]
        if any(len(found) != 1 for found in near) or abs(lobe[2]) < 0.1:
            continue
        ends = [one.direction.values[found[0], 1] for one, found in zip(beside, near, strict=True)]
        wider = abs(ends[1] - ends[0]) / (2.0 * step)
        back = lobes(-lobe)
        same = np.linalg.norm(back.direction.values + came, axis=1) < 1e-6
        unknown = [abs(one.attrs["residual"]) + 4.5 * one.attrs["walked_standard_error"] for one in (there, back)]
        assert abs(power - wider * back.power.values[same].sum()) < unknown[0] + wider * unknown[1]
        compared += 1
    assert compared >= 2


def test_each_wavelength_goes_through_all_layers():
    """Two panes that each pass another half of the spectrum pass less together than their visible means say."""
    red = Medium.tabulated([380.0, 560.0, 580.0, 780.0], [1.5] * 4, absorption_per_mm=[1.0, 1.0, 0.0, 0.0])
    blue = Medium.tabulated([380.0, 560.0, 580.0, 780.0], [1.5] * 4, absorption_per_mm=[0.0, 0.0, 1.0, 1.0])
    layers = [Pane(thickness_mm=4.0, medium=medium) for medium in (red, blue)]
    together = float(Stack(layers).angular(elevation_deg=0.0).transmittance[0, 0])
    apart = [float(layer.angular(elevation_deg=0.0).transmittance[0, 0]) for layer in layers]
    assert min(apart) > 0.15
    assert together < 0.3 * apart[0] * apart[1]
    spectral = Stack(layers).angular(elevation_deg=[0.0, 60.0], wavelength_nm=[450.0, 650.0])
    assert spectral.transmittance.dims == ("elevation", "azimuth", "wavelength")
    assert float(spectral.transmittance.max()) < 0.02


def test_uniform_light_is_the_mean_over_the_hemisphere():
    """A pane by itself against sums over a fine grid of angles."""
    found = Stack([DARK]).hemispherical()
    theta = np.radians(np.arange(0.05, 90.0, 0.1))
    shares = slab(np.degrees(theta), 1.52, absorption_per_mm=0.08, thickness_mm=6.0)
    weight = np.sin(2.0 * theta) / np.sin(2.0 * theta).sum()
    assert float(found.transmittance) == pytest.approx(float(weight @ shares.transmittance), abs=1e-5)
    assert float(found.layer_absorptance[0]) == pytest.approx(float(weight @ shares.absorptance), abs=1e-5)
    assert float(account(found)) == pytest.approx(1.0, abs=1e-12)


def test_gaps_are_kept_and_seen_through():
    argon = Gap(width_mm=16.0, gas="argon")
    with_gap, without = Stack([PANE, argon, PANE, DARK]), Stack([PANE, PANE, DARK])
    assert with_gap.gaps == (argon, None)
    assert with_gap.glazings == without.layers == without.glazings
    a, b = (stack.angular(elevation_deg=60.0) for stack in (with_gap, without))
    assert a.transmittance.item() == b.transmittance.item()
    assert json.loads(a.attrs["layers"])[1] == {"kind": "gap", "width_mm": 16.0, "gas": "argon"}


@pytest.mark.parametrize(
    ("mistake", "message"),
    [
        (lambda: Stack([]), "at least one glazing"),
        (lambda: Stack([Gap(width_mm=5.0), PANE]), r"layers\[0\] must be a glazing, since a gap"),
        (lambda: Stack([PANE, Gap(width_mm=5.0)]), r"layers\[1\] must be a glazing, since a gap"),
        (lambda: Stack([PANE, Gap(width_mm=5.0), Gap(width_mm=5.0), PANE]), r"layers\[2\] must be a glazing"),
        (lambda: Stack([PANE, "glass"]), r"layers\[1\] must be a glazing"),
        (lambda: Gap(width_mm=0.0), "width_mm must be greater than 0"),
        (lambda: Gap(width_mm=5.0, gas="neon"), "gas must be one of air, argon"),
        (lambda: Stack([PANE]).angular(elevation_deg=0.0, polarisation="none"), "polarisation must be one of"),
        (lambda: Stack([PANE]).lobes(elevation_deg=0.0, side="left"), "side must be one of"),
        (lambda: Stack([PANE]).hemispherical(rings=0), "rings must be a whole number of at least 1"),
        (lambda: Stack([PANE, ROUGH]).lobes(elevation_deg=30.0), r"layers\[1\] must have smooth and clear cuts"),
    ],
)  # fmt: skip
def test_mistakes_say_name_rule_and_value(mistake, message):
    with pytest.raises(ClerestoryError, match=message):
        mistake()


def test_plain_layers_stack_too():
    """Layers known by formula alone: shares multiply where nothing is reflected."""
    found = Stack([PlainTransmittance(transmittance=0.5), Glass(transmittance=0.88)]).angular(elevation_deg=0.0)
    assert found.transmittance.item() == pytest.approx(0.44, abs=1e-12)
    assert float(found.layer_absorptance[0, 0, 0]) == pytest.approx(0.5 + found.reflectance.item(), abs=1e-12)
    among = Stack([Slab(refractive_index=1.5, thickness_mm=3.0), PANEL]).angular(elevation_deg=30.0)
    assert account(among).item() == pytest.approx(1.0, abs=1e-9)


def test_gaps_stand_among_the_layers_of_a_file():
    text = '[pane]\nkind = "pane"\nthickness_mm = 4\n[window]\nkind = "stack"\n'
    text += 'layers = ["pane", { width_mm = 12, gas = "argon" }, "pane"]\n'
    stack = glazing_tables(Table(tomllib.loads(text), "[glazings]"), Path())("window")
    assert stack == Stack([Pane(thickness_mm=4), Gap(width_mm=12, gas="argon"), Pane(thickness_mm=4)])
    assert write_glazing(stack, lambda layer: "pane") == tomllib.loads(text)["window"]
    wrong = text.replace("width_mm = 12", "width = 12")
    with pytest.raises(ClerestoryError, match=r"a gap among the layers of .*width"):
        glazing_tables(Table(tomllib.loads(wrong), "[glazings]"), Path())("window")
