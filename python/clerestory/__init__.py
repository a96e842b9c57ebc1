"""Clerestory: design, characterise and simulate light-redirecting windows."""

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from clerestory._native import __version__

if TYPE_CHECKING:
    from clerestory.annual_illuminance import annual_illuminance
    from clerestory.annual_sun import annual_sun_coefficients, sun_placement_difference
    from clerestory.bsdf import Band, Bsdf, BsdfWarning, KlemsBlock, TreeBlock
    from clerestory.bsdf.of_glazing import bsdf_of
    from clerestory.bsdf.reading import read_bsdf
    from clerestory.coefficients import SensorWarning, daylight_coefficients
    from clerestory.compare import Comparison, compare
    from clerestory.design import read_design, run_design
    from clerestory.drawing.line import Face, Outline
    from clerestory.errors import ClerestoryError
    from clerestory.exchange import read_hbjson
    from clerestory.glazing import Glass, Open, PlainTransmittance, Slab, Stack, TregenzaSharples
    from clerestory.illuminance import average_by_group, daylight_factor, illuminance, sun_illuminance, uniformity
    from clerestory.layers.gap import Gap
    from clerestory.measured import read_measured
    from clerestory.measured_glass import MeasuredGlass, measured_glass, medium_of_pane
    from clerestory.medium import Medium, medium_names
    from clerestory.medium_laws import AbsorptionSpectrum, Dispersion
    from clerestory.metrics.annual_light_exposure import annual_light_exposure
    from clerestory.metrics.annual_sunlight_exposure import annual_sunlight_exposure
    from clerestory.metrics.annual_uniformity import annual_uniformity
    from clerestory.metrics.blinds import blinds_closed, with_blinds
    from clerestory.metrics.continuous_daylight_autonomy import continuous_daylight_autonomy
    from clerestory.metrics.daylight_autonomy import daylight_autonomy
    from clerestory.metrics.daylight_provision import daylight_provision
    from clerestory.metrics.daylit import daylit_hours
    from clerestory.metrics.glare_prone_hours import glare_prone_hours
    from clerestory.metrics.lighting_energy import ElectricLighting, lighting_energy
    from clerestory.metrics.schedule import Schedule, occupied_hours
    from clerestory.metrics.spatial_daylight_autonomy import spatial_daylight_autonomy
    from clerestory.metrics.useful_daylight_illuminance import useful_daylight_illuminance
    from clerestory.metrics.useful_depth import distance_from_window_wall, useful_depth
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
    from clerestory.sky import CieSky, PerezSky, sky_basis
    from clerestory.sun import sun_position
    from clerestory.sun_coefficients import SunWarning, sun_coefficients
    from clerestory.sun_paths import sun_paths
    from clerestory.sunlight import direct_normal_illuminance_lx
    from clerestory.sweep import read_sweep, run_sweep
    from clerestory.weather import (
        Weather,
        diffuse_horizontal_illuminance_lx,
        read_epw,
        read_wea,
        sky_matrix,
        sun_normal_illuminance_lx,
    )
    from clerestory.year import YearStudy, read_year, run_year, write_year

__all__ = [
    "AbsorptionSpectrum",
    "Band",
    "Bsdf",
    "BsdfWarning",
    "CieSky",
    "ClerestoryError",
    "Comparison",
    "Dispersion",
    "ElectricLighting",
    "ExtrudedPanel",
    "Face",
    "Facet",
    "FacingBuilding",
    "Gap",
    "Glass",
    "Interface",
    "KlemsBlock",
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
    "PerezSky",
    "PlainTransmittance",
    "PrismaticPanel",
    "Profile",
    "Room",
    "Schedule",
    "SensorGrid",
    "SensorWarning",
    "Sensors",
    "Site",
    "Slab",
    "Stack",
    "SunWarning",
    "Surface",
    "TreeBlock",
    "TregenzaSharples",
    "Weather",
    "Window",
    "YearStudy",
    "__version__",
    "annual_illuminance",
    "annual_light_exposure",
    "annual_sun_coefficients",
    "annual_sunlight_exposure",
    "annual_uniformity",
    "average_by_group",
    "blinds_closed",
    "bsdf_of",
    "compare",
    "continuous_daylight_autonomy",
    "daylight_autonomy",
    "daylight_coefficients",
    "daylight_factor",
    "daylight_provision",
    "daylit_hours",
    "diffuse_horizontal_illuminance_lx",
    "direct_normal_illuminance_lx",
    "distance_from_window_wall",
    "glare_prone_hours",
    "illuminance",
    "lighting_energy",
    "measured_glass",
    "medium_names",
    "medium_of_pane",
    "occupied_hours",
    "panel_from_dict",
    "read_bsdf",
    "read_design",
    "read_epw",
    "read_hbjson",
    "read_measured",
    "read_meshes",
    "read_panel",
    "read_profile",
    "read_radiance",
    "read_room",
    "read_sweep",
    "read_wea",
    "read_year",
    "run_design",
    "run_sweep",
    "run_year",
    "save",
    "sky_basis",
    "sky_matrix",
    "spatial_daylight_autonomy",
    "sun_coefficients",
    "sun_illuminance",
    "sun_normal_illuminance_lx",
    "sun_paths",
    "sun_placement_difference",
    "sun_position",
    "uniformity",
    "useful_daylight_illuminance",
    "useful_depth",
    "with_blinds",
    "write_room",
    "write_year",
]

#: Where each name comes from: its module is imported when the name is first used, so that few wait for many.
_PLACES = {
    "Band": "clerestory.bsdf",
    "Bsdf": "clerestory.bsdf",
    "BsdfWarning": "clerestory.bsdf",
    "KlemsBlock": "clerestory.bsdf",
    "TreeBlock": "clerestory.bsdf",
    "annual_illuminance": "clerestory.annual_illuminance",
    "annual_sun_coefficients": "clerestory.annual_sun",
    "sun_placement_difference": "clerestory.annual_sun",
    "bsdf_of": "clerestory.bsdf.of_glazing",
    "read_bsdf": "clerestory.bsdf.reading",
    "SensorWarning": "clerestory.coefficients",
    "daylight_coefficients": "clerestory.coefficients",
    "Comparison": "clerestory.compare",
    "compare": "clerestory.compare",
    "Face": "clerestory.drawing.line",
    "Outline": "clerestory.drawing.line",
    "ClerestoryError": "clerestory.errors",
    "Glass": "clerestory.glazing",
    "Open": "clerestory.glazing",
    "PlainTransmittance": "clerestory.glazing",
    "Slab": "clerestory.glazing",
    "Stack": "clerestory.glazing",
    "TregenzaSharples": "clerestory.glazing",
    "average_by_group": "clerestory.illuminance",
    "daylight_factor": "clerestory.illuminance",
    "illuminance": "clerestory.illuminance",
    "sun_illuminance": "clerestory.illuminance",
    "uniformity": "clerestory.illuminance",
    "Gap": "clerestory.layers.gap",
    "read_measured": "clerestory.measured",
    "MeasuredGlass": "clerestory.measured_glass",
    "measured_glass": "clerestory.measured_glass",
    "medium_of_pane": "clerestory.measured_glass",
    "Medium": "clerestory.medium",
    "medium_names": "clerestory.medium",
    "AbsorptionSpectrum": "clerestory.medium_laws",
    "Dispersion": "clerestory.medium_laws",
    "ElectricLighting": "clerestory.metrics.lighting_energy",
    "Schedule": "clerestory.metrics.schedule",
    "annual_light_exposure": "clerestory.metrics.annual_light_exposure",
    "annual_sunlight_exposure": "clerestory.metrics.annual_sunlight_exposure",
    "annual_uniformity": "clerestory.metrics.annual_uniformity",
    "blinds_closed": "clerestory.metrics.blinds",
    "continuous_daylight_autonomy": "clerestory.metrics.continuous_daylight_autonomy",
    "daylight_autonomy": "clerestory.metrics.daylight_autonomy",
    "daylight_provision": "clerestory.metrics.daylight_provision",
    "daylit_hours": "clerestory.metrics.daylit",
    "distance_from_window_wall": "clerestory.metrics.useful_depth",
    "glare_prone_hours": "clerestory.metrics.glare_prone_hours",
    "lighting_energy": "clerestory.metrics.lighting_energy",
    "occupied_hours": "clerestory.metrics.schedule",
    "spatial_daylight_autonomy": "clerestory.metrics.spatial_daylight_autonomy",
    "useful_daylight_illuminance": "clerestory.metrics.useful_daylight_illuminance",
    "useful_depth": "clerestory.metrics.useful_depth",
    "with_blinds": "clerestory.metrics.blinds",
    "ExtrudedPanel": "clerestory.panels",
    "LaserCutPanel": "clerestory.panels",
    "Pane": "clerestory.panels",
    "Panel": "clerestory.panels",
    "PrismaticPanel": "clerestory.panels",
    "panel_from_dict": "clerestory.panels",
    "read_panel": "clerestory.panels",
    "Facet": "clerestory.profile",
    "Profile": "clerestory.profile",
    "read_profile": "clerestory.profile",
    "FacingBuilding": "clerestory.room",
    "Interface": "clerestory.room",
    "LightShelf": "clerestory.room",
    "Louvres": "clerestory.room",
    "Material": "clerestory.room",
    "Mesh": "clerestory.room",
    "Opening": "clerestory.room",
    "Overhang": "clerestory.room",
    "Part": "clerestory.room",
    "Room": "clerestory.room",
    "SensorGrid": "clerestory.room",
    "Sensors": "clerestory.room",
    "Surface": "clerestory.room",
    "Window": "clerestory.room",
    "read_meshes": "clerestory.room.mesh_file",
    "read_radiance": "clerestory.room.radiance_file",
    "read_room": "clerestory.room.toml_file",
    "write_room": "clerestory.room.toml_text",
    "save": "clerestory.saving",
    "Site": "clerestory.site",
    "CieSky": "clerestory.sky",
    "PerezSky": "clerestory.sky",
    "sky_basis": "clerestory.sky",
    "sun_paths": "clerestory.sun_paths",
    "sun_position": "clerestory.sun",
    "SunWarning": "clerestory.sun_coefficients",
    "sun_coefficients": "clerestory.sun_coefficients",
    "direct_normal_illuminance_lx": "clerestory.sunlight",
    "Weather": "clerestory.weather",
    "diffuse_horizontal_illuminance_lx": "clerestory.weather",
    "read_epw": "clerestory.weather",
    "read_wea": "clerestory.weather",
    "sky_matrix": "clerestory.weather",
    "sun_normal_illuminance_lx": "clerestory.weather",
    "read_design": "clerestory.design",
    "run_design": "clerestory.design",
    "read_hbjson": "clerestory.exchange",
    "read_sweep": "clerestory.sweep",
    "run_sweep": "clerestory.sweep",
    "YearStudy": "clerestory.year",
    "read_year": "clerestory.year",
    "run_year": "clerestory.year",
    "write_year": "clerestory.year",
}


def __getattr__(name: str) -> Any:
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(_PLACES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


class _Package(ModuleType):
    """A package in which importing a module does not hide the function of the same name."""

    def __setattr__(self, name: str, value: object) -> None:
        if not (isinstance(value, ModuleType) and name in _PLACES):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package
