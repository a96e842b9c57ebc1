"""Figures: every function takes data, knows no physics and returns a matplotlib Figure."""

from clerestory.plots.bsdf_cut import bsdf_cut
from clerestory.plots.bsdf_discs import bsdf_discs
from clerestory.plots.bsdf_shares import bsdf_shares
from clerestory.plots.carpet import carpet
from clerestory.plots.deflected_fraction import deflected_fraction
from clerestory.plots.dispersion import dispersion
from clerestory.plots.metric_plans import metric_plans
from clerestory.plots.radial import radial
from clerestory.plots.regression import regression
from clerestory.plots.room_ceiling import room_ceiling
from clerestory.plots.room_plan import room_plan
from clerestory.plots.room_section import room_section
from clerestory.plots.section import section
from clerestory.plots.sky_dome import sky_dome
from clerestory.plots.variant_dots import variant_dots
from clerestory.plots.weather_carpet import weather_carpet

__all__ = [
    "bsdf_cut",
    "bsdf_discs",
    "bsdf_shares",
    "carpet",
    "deflected_fraction",
    "dispersion",
    "metric_plans",
    "radial",
    "regression",
    "room_ceiling",
    "room_plan",
    "room_section",
    "section",
    "sky_dome",
    "variant_dots",
    "weather_carpet",
]
