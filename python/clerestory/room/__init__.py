"""Rooms: surfaces, windows, what stands before them, and sensors."""

from clerestory.room.material import Material
from clerestory.room.obstruction import FacingBuilding, LightShelf, Louvres, Overhang
from clerestory.room.opening import Opening, Part
from clerestory.room.scene import Room
from clerestory.room.sensors import SensorGrid, Sensors
from clerestory.room.shoebox import Shoebox
from clerestory.room.surface import Interface, Mesh, Surface
from clerestory.room.window import Window

__all__ = [
    "FacingBuilding",
    "Interface",
    "LightShelf",
    "Louvres",
    "Material",
    "Mesh",
    "Opening",
    "Overhang",
    "Part",
    "Room",
    "SensorGrid",
    "Sensors",
    "Shoebox",
    "Surface",
    "Window",
]
