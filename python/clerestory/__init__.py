"""Clerestory: design, characterise and simulate light-redirecting windows."""

from clerestory._native import __version__
from clerestory.compare import Comparison, compare
from clerestory.errors import ClerestoryError
from clerestory.measured import read_measured
from clerestory.measured_glass import MeasuredGlass, measured_glass, medium_of_pane
from clerestory.medium import Medium, medium_names
from clerestory.medium_laws import AbsorptionSpectrum, Dispersion
from clerestory.panels import ExtrudedPanel, LaserCutPanel, Pane, Panel, PrismaticPanel, panel_from_dict, read_panel
from clerestory.profile import Facet, Profile
from clerestory.saving import save

__all__ = [
    "AbsorptionSpectrum",
    "ClerestoryError",
    "Comparison",
    "Dispersion",
    "ExtrudedPanel",
    "Facet",
    "LaserCutPanel",
    "MeasuredGlass",
    "Medium",
    "Pane",
    "Panel",
    "PrismaticPanel",
    "Profile",
    "__version__",
    "compare",
    "measured_glass",
    "medium_names",
    "medium_of_pane",
    "panel_from_dict",
    "read_measured",
    "read_panel",
    "save",
]
