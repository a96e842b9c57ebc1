"""What must hold for any panel and any direction: energy, reciprocity, mirror symmetry, scale freedom, superposition.

Tolerances are what the solver itself says it does not know: residual and displaced power of both computations.
"""

from dataclasses import fields, replace

import numpy as np
from hypothesis import assume, given, settings
from tests.laws.panels_at_random import ideal_cuts, incidences, panels, panes, polarisations

from clerestory.glass import slab
from clerestory.medium import Medium
from clerestory.panels import LaserCutPanel, PrismaticPanel

LAW = settings(max_examples=15)
TOLERANCE = 1e-3
ROUNDING = 1e-12


def lobes_of(panel, incidence, **how):
    return panel.lobes(**incidence, **({"tolerance": TOLERANCE} | how))


def unknown(*tables):
    attributes = (t.attrs for t in tables)
    return ROUNDING + sum(a["residual"] + a["displaced"] + _walk_error(a) for a in attributes)


def _walk_error(attributes):
    """Five standard errors of what 4096 independent rays finished, half of which go one way."""
    return 5.0 * 0.5 * attributes["walked"] / np.sqrt(4096.0)


def transmittance(lobes, incidence):
    return float(lobes.power.values[lobes.side.values != incidence["side"]].sum())


@given(panel=panels, incidence=incidences, polarisation=polarisations)
@LAW
def test_energy_is_kept_and_no_share_is_negative(panel, incidence, polarisation):
    lobes = lobes_of(panel, incidence, polarisation=polarisation)
    shares = [float(lobes.power.sum()), lobes.attrs["absorbed"], lobes.attrs["residual"]]
    assert abs(sum(shares) - 1.0) <= ROUNDING
    assert lobes.power.values.min() >= 0.0
    assert min(shares) >= -ROUNDING
    assert panel.medium.absorption_per_mm > 0.0 or lobes.attrs["absorbed"] == 0.0


@given(panel=panels, incidence=incidences, polarisation=polarisations)
@LAW
def test_every_lobe_is_a_unit_vector_that_keeps_the_component_along_the_cuts(panel, incidence, polarisation):
    lobes = lobes_of(panel, incidence, polarisation=polarisation)
    along = np.sin(np.radians(incidence["azimuth_deg"])) * np.cos(np.radians(incidence["elevation_deg"]))
    np.testing.assert_allclose(np.linalg.norm(lobes.direction.values, axis=1), 1.0, atol=1e-12)
    np.testing.assert_allclose(lobes.direction.sel(axis="x").values, along, atol=1e-12)


@given(panel=panels, incidence=incidences)
@LAW
def test_no_light_is_polarised_more_than_wholly(panel, incidence):
    lobes = lobes_of(panel, incidence, polarisation="resolved")
    stokes = lobes.stokes.values
    assert (np.linalg.norm(stokes[:, 1:], axis=1) <= stokes[:, 0] + ROUNDING).all()


@given(panel=ideal_cuts | panes, incidence=incidences, polarisation=polarisations)
@LAW
def test_perpendicular_cuts_send_as_much_back_as_there(panel, incidence, polarisation):
    assume(getattr(panel, "cut_tilt_deg", 0.0) == 0.0)
    there = lobes_of(panel, incidence, polarisation=polarisation)
    for lobe, elevation, azimuth, side, power in zip(
        *(there[name].values for name in ("direction", "elevation_deg", "azimuth_deg", "side", "power")), strict=True
    ):
        assume(abs(lobe[2]) > 1e-3)
        reverse = {"elevation_deg": float(elevation), "azimuth_deg": -float(azimuth), "side": str(side)}
        back = lobes_of(panel, reverse, polarisation=polarisation)
        e, a = np.radians(incidence["elevation_deg"]), np.radians(incidence["azimuth_deg"])
        z = np.cos(a) * np.cos(e) * (1.0 if incidence["side"] == "front" else -1.0)
        came = np.array([np.sin(a) * np.cos(e), -np.sin(e), z])
        near = np.linalg.norm(back.direction.values + came, axis=1) < 1e-6
        assert abs(float(back.power.values[near].sum()) - power) <= unknown(there, back)


def upside_down(panel):
    if isinstance(panel, LaserCutPanel):
        return replace(panel, cut_tilt_deg=-panel.cut_tilt_deg)
    if isinstance(panel, PrismaticPanel):
        return replace(panel, lower_deg=panel.upper_deg, upper_deg=panel.lower_deg)
    return panel


@given(panel=panels, incidence=incidences, polarisation=polarisations)
@LAW
def test_a_panel_upside_down_does_to_light_from_below_what_it_does_to_light_from_above(panel, incidence, polarisation):
    below = incidence | {"elevation_deg": -incidence["elevation_deg"]}
    one = lobes_of(panel, incidence, polarisation=polarisation)
    other = lobes_of(upside_down(panel), below, polarisation=polarisation)
    assert abs(transmittance(one, incidence) - transmittance(other, below)) <= unknown(one, other)
    assert abs(one.attrs["absorbed"] - other.attrs["absorbed"]) <= unknown(one, other)


@given(panel=panels, incidence=incidences, polarisation=polarisations)
@LAW
def test_a_panel_a_thousand_times_as_large_does_the_same(panel, incidence, polarisation):
    sizes = {f.name: getattr(panel, f.name) for f in fields(panel) if f.init and f.name.endswith("_mm")}
    medium = Medium(n=panel.medium.n, absorption_per_mm=panel.medium.absorption_per_mm / 1000.0)
    large = replace(panel, medium=medium, **{name: v if v is None else 1000.0 * v for name, v in sizes.items()})
    one, other = (lobes_of(p, incidence, polarisation=polarisation) for p in (panel, large))
    assert abs(transmittance(one, incidence) - transmittance(other, incidence)) <= unknown(one, other)


@given(panel=panes, incidence=incidences)
@LAW
def test_unpolarised_light_is_s_and_p_light_laid_over_each_other(panel, incidence):
    """Power and polarisation behind a pane are half the sum and half the difference of its s and p transmittance."""
    cos_i = np.cos(np.radians(incidence["elevation_deg"])) * np.cos(np.radians(incidence["azimuth_deg"]))
    medium = {"absorption_per_mm": panel.medium.absorption_per_mm, "thickness_mm": panel.thickness_mm}
    s, p = (slab(np.degrees(np.arccos(cos_i)), panel.medium.n, **medium, polarisation=x).transmittance for x in "sp")
    lobes = lobes_of(panel, incidence, polarisation="resolved", tolerance=1e-9)
    stokes = lobes.stokes.values[lobes.side.values != incidence["side"]].sum(axis=0)
    assert abs(stokes[0] - 0.5 * (s + p)) <= unknown(lobes) + 1e-9
    assert abs(np.linalg.norm(stokes[1:]) - 0.5 * abs(s - p)) <= unknown(lobes) + 1e-9
