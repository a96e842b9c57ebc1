"""Weather of a year: what the sun and the sky send down, and files that say so."""

from clerestory.weather.epw import read_epw
from clerestory.weather.wea import read_wea
from clerestory.weather.weather import Weather

__all__ = ["Weather", "read_epw", "read_wea"]
