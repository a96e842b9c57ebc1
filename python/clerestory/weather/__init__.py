"""Weather of a year: what the sun and the sky send down, and files that say so."""

from clerestory.weather.epw import read_epw
from clerestory.weather.light import diffuse_horizontal_illuminance_lx, sky_matrix, sun_normal_illuminance_lx
from clerestory.weather.wea import read_wea
from clerestory.weather.weather import Weather

__all__ = [
    "Weather",
    "diffuse_horizontal_illuminance_lx",
    "read_epw",
    "read_wea",
    "sky_matrix",
    "sun_normal_illuminance_lx",
]
