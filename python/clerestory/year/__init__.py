"""A year of daylight: a room with several glazings through the weather of a place, measured, compared and reported."""

from clerestory.year.calculation import YearCalculation
from clerestory.year.evaluate import evaluate
from clerestory.year.export import EXPORTS, export_year
from clerestory.year.report import write_year
from clerestory.year.run import State, run_year
from clerestory.year.settings import Blinds, Measures
from clerestory.year.study import YearStudy, read_year, year_of

__all__ = [
    "EXPORTS",
    "Blinds",
    "Measures",
    "State",
    "YearCalculation",
    "YearStudy",
    "evaluate",
    "export_year",
    "read_year",
    "run_year",
    "write_year",
    "year_of",
]
