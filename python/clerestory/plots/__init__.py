"""Figures: every function takes data, knows no physics and returns a matplotlib Figure."""

from clerestory.plots.deflected_fraction import deflected_fraction
from clerestory.plots.dispersion import dispersion
from clerestory.plots.radial import radial
from clerestory.plots.regression import regression
from clerestory.plots.section import section

__all__ = ["deflected_fraction", "dispersion", "radial", "regression", "section"]
