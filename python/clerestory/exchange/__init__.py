"""Files of other programs: annual illuminance, sensor points, Radiance matrices, Ladybug Tools' folders and models."""

from clerestory.exchange.annual_ill import read_ill, write_ill
from clerestory.exchange.coefficients_matrix import write_coefficients
from clerestory.exchange.hbjson import read_hbjson
from clerestory.exchange.ladybug_results import write_ladybug_results
from clerestory.exchange.points_file import read_pts, write_pts
from clerestory.exchange.radiance_matrix import read_matrix, write_matrix

__all__ = [
    "read_hbjson",
    "read_ill",
    "read_matrix",
    "read_pts",
    "write_coefficients",
    "write_ill",
    "write_ladybug_results",
    "write_matrix",
    "write_pts",
]
