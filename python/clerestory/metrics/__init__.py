"""What a year of daylight comes down to: pure functions of illuminances, each with its equation and its source."""

from clerestory.metrics.annual_light_exposure import annual_light_exposure
from clerestory.metrics.annual_sunlight_exposure import annual_sunlight_exposure, sunlit_hours
from clerestory.metrics.annual_uniformity import annual_uniformity
from clerestory.metrics.blinds import blinds_closed, with_blinds
from clerestory.metrics.continuous_daylight_autonomy import continuous_daylight_autonomy
from clerestory.metrics.daylight_autonomy import daylight_autonomy
from clerestory.metrics.daylight_provision import daylight_provision
from clerestory.metrics.daylit import daylit_hours
from clerestory.metrics.glare_prone_hours import glare_prone_hours
from clerestory.metrics.lighting_energy import ElectricLighting, lighting_energy
from clerestory.metrics.schedule import ANALYSIS_HOURS, Schedule, occupied_hours
from clerestory.metrics.spatial_daylight_autonomy import spatial_daylight_autonomy
from clerestory.metrics.useful_daylight_illuminance import useful_daylight_illuminance
from clerestory.metrics.useful_depth import distance_from_window_wall, useful_depth

__all__ = [
    "ANALYSIS_HOURS",
    "ElectricLighting",
    "Schedule",
    "annual_light_exposure",
    "annual_sunlight_exposure",
    "annual_uniformity",
    "blinds_closed",
    "continuous_daylight_autonomy",
    "daylight_autonomy",
    "daylight_provision",
    "daylit_hours",
    "distance_from_window_wall",
    "glare_prone_hours",
    "lighting_energy",
    "occupied_hours",
    "spatial_daylight_autonomy",
    "sunlit_hours",
    "useful_daylight_illuminance",
    "useful_depth",
    "with_blinds",
]
