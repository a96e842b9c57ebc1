"""Clerestory: design, characterise and simulate light-redirecting windows."""

from clerestory._native import __version__
from clerestory.errors import ClerestoryError
from clerestory.measured_glass import MeasuredGlass, measured_glass, medium_of_pane
from clerestory.medium import Medium, medium_names
from clerestory.medium_laws import AbsorptionSpectrum, Dispersion

__all__ = [
    "AbsorptionSpectrum",
    "ClerestoryError",
    "Dispersion",
    "MeasuredGlass",
    "Medium",
    "__version__",
    "measured_glass",
    "medium_names",
    "medium_of_pane",
]
