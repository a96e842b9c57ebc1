"""All variants in one Dataset, and as a table."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from clerestory.provenance import provenance
from clerestory.year.figures import asked_for, value_of

APART = ("variant", "glazings", "date")
"""Attributes that differ between variants."""


def compared(results: Mapping[str, xr.Dataset]) -> xr.Dataset:
    """The results of all variants along a dimension "variant", sensors and times as they are.

    Parameters
    ----------
    results : mapping of label → Dataset of `run_year`

    Returns
    -------
    Dataset, dims ("variant", …)
        Attributes that are the same for all; the glazings of each in the coordinate `glazings`.
    """
    labels = list(results)
    every = [found.drop_attrs(deep=False) for found in results.values()]
    joined = xr.concat(every, dim=xr.Variable("variant", np.array(labels, dtype=object)), data_vars="all")
    for name in joined.data_vars:
        joined[name].attrs = dict(next(iter(results.values()))[name].attrs)
        joined[name].attrs.pop("at_least", None)
    first = next(iter(results.values()))
    shared = {
        name: value
        for name, value in first.attrs.items()
        if name not in APART and all(found.attrs.get(name) == value for found in results.values())
    }
    joined = joined.assign_coords(
        glazings=("variant", [str(found.attrs.get("glazings")) for found in results.values()])
    )
    return joined.assign_attrs({**shared, **provenance()})


def table_rows(results: Mapping[str, xr.Dataset]) -> list[dict[str, Any]]:
    """One row a figure and variant: metric, label, unit, variant, value, standard error."""
    rows = []
    for figure in asked_for(results):
        for variant, found in results.items():
            pair = value_of(found, figure)
            if pair is not None:
                value, error = pair
                rows.append(
                    {
                        "metric": figure.name,
                        "label": figure.label,
                        "unit": figure.unit,
                        "variant": variant,
                        "value": value,
                        "standard_error": None if math.isnan(error) else error,
                    }
                )
    return rows
