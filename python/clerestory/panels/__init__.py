"""Panels: dataclasses in the user's units, checked when they are made, that say where light goes."""

from clerestory.panels.extruded import ExtrudedPanel
from clerestory.panels.laser_cut import LaserCutPanel
from clerestory.panels.pane import Pane
from clerestory.panels.panel import Panel
from clerestory.panels.prismatic import PrismaticPanel
from clerestory.panels.writing import panel_from_dict, read_panel

__all__ = [
    "ExtrudedPanel",
    "LaserCutPanel",
    "Pane",
    "Panel",
    "PrismaticPanel",
    "panel_from_dict",
    "read_panel",
]
