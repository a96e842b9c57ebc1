"""The cases in the order of the page."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from tests.validation.claim import Claim

FOLDER = Path(__file__).parent
CASES = (
    "energy",
    "reciprocity",
    "mirror_symmetry",
    "scale_freedom",
    "slab",
    "laser_cut_series",
    "laser_cut_rtrace",
    "laser_cut_total",
    "prism_rtrace",
    "measured_glass",
    "layered_glazing",
    "layered_bsdf",
    "energyplus_shoebox",
    "exact_monte_carlo",
    "float_glass",
    "deflected_fraction",
    "published_diagrams",
    "beam_picture",
    "unobstructed_sensor",
    "sky_component",
    "cie171_openings",
    "cie171_glazed",
    "external_mask",
    "radiance_room",
    "radiance_bsdf_room",
    "sun_through_pane",
    "radiance_mirrors",
    "panel_lights_ceiling",
    "drawn_panel",
    "drawn_stack",
    "year_sky",
    "year_brute_force",
    "year_radiance",
)


def claim(case: str, *, thorough: bool) -> Claim:
    """The outcome of one case, of few or of many panels and directions."""
    found: Claim = import_module(f"tests.validation.{case}.measure").claim(thorough)
    return found
