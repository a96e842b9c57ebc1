"""Clerestory: design, characterise and simulate light-redirecting windows."""

from clerestory._native import __version__
from clerestory.coefficients import SensorWarning, daylight_coefficients
from clerestory.compare import Comparison, compare
from clerestory.drawing.line import Face, Outline
from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass, Open, PlainTransmittance, Slab, TregenzaSharples
from clerestory.illuminance import average_by_group, daylight_factor, illuminance, uniformity
from clerestory.measured import read_measured
from clerestory.measured_glass import MeasuredGlass, measured_glass, medium_of_pane
from clerestory.medium import Medium, medium_names
from clerestory.medium_laws import AbsorptionSpectrum, Dispersion
from clerestory.panels import ExtrudedPanel, LaserCutPanel, Pane, Panel, PrismaticPanel, panel_from_dict, read_panel
from clerestory.profile import Facet, Profile, read_profile
from clerestory.room import (
    FacingBuilding,
    Interface,
    LightShelf,
    Louvres,
    Material,
    Mesh,
    Opening,
    Overhang,
    Part,
    Room,
    SensorGrid,
    Sensors,
    Surface,
    Window,
)
from clerestory.room.mesh_file import read_meshes
from clerestory.room.radiance_file import read_radiance
from clerestory.room.toml_file import read_room
from clerestory.room.toml_text import write_room
from clerestory.saving import save
from clerestory.site import Site
from clerestory.sky import CieSky, sky_basis
from clerestory.sun import sun_position
from clerestory.sunlight import direct_normal_illuminance_lx

__all__ = [
    "AbsorptionSpectrum",
    "CieSky",
    "ClerestoryError",
    "Comparison",
    "Dispersion",
    "ExtrudedPanel",
    "Face",
    "Facet",
    "FacingBuilding",
    "Glass",
    "Interface",
    "LaserCutPanel",
    "LightShelf",
    "Louvres",
    "Material",
    "MeasuredGlass",
    "Medium",
    "Mesh",
    "Open",
    "Opening",
    "Outline",
    "Overhang",
    "Pane",
    "Panel",
    "Part",
    "PlainTransmittance",
    "PrismaticPanel",
    "Profile",
    "Room",
    "SensorGrid",
    "SensorWarning",
    "Sensors",
    "Site",
    "Slab",
    "Surface",
    "TregenzaSharples",
    "Window",
    "__version__",
    "average_by_group",
    "compare",
    "daylight_coefficients",
    "daylight_factor",
    "direct_normal_illuminance_lx",
    "illuminance",
    "measured_glass",
    "medium_names",
    "medium_of_pane",
    "panel_from_dict",
    "read_measured",
    "read_meshes",
    "read_panel",
    "read_profile",
    "read_radiance",
    "read_room",
    "save",
    "sky_basis",
    "sun_position",
    "uniformity",
    "write_room",
]
