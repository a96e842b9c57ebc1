"""The files that a year leaves: NetCDF, CSV, and one page that holds everything it shows."""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from jinja2 import Environment, PackageLoader, StrictUndefined

from clerestory.room.plan_outline import plan_attributes
from clerestory.saving import write_text, write_whole
from clerestory.year import pictures
from clerestory.year.assumptions import assumptions, errors_told
from clerestory.year.compared import compared, table_rows
from clerestory.year.figures import asked_for, text_of, value_of
from clerestory.year.study import YearStudy


def write_year(study: YearStudy, results: Mapping[str, xr.Dataset], folder: str | os.PathLike[str]) -> list[Path]:
    """Writes what a year came down to, each file whole or not at all.

    Parameters
    ----------
    study : YearStudy
    results : mapping of label → Dataset of `run_year`
    folder : path-like
        Made if it is not there.

    Returns
    -------
    list of Path
        `year.nc` with everything, `metrics.csv` with one row a figure and variant, and `report.html`.
    """
    target = Path(folder)
    together = compared(results)
    return [
        write_whole(target / "year.nc", lambda draft: _save(together.assign_attrs(_made_from(study)), draft)),
        write_text(target / "metrics.csv", _csv(results, together.attrs)),
        write_text(target / "report.html", report_text(study, results, together.attrs)),
    ]


def report_text(study: YearStudy, results: Mapping[str, xr.Dataset], attributes: Mapping[str, Any]) -> str:
    """The report as one HTML page that needs nothing else: no script, no font, no picture from elsewhere."""
    environment = Environment(
        loader=PackageLoader("clerestory.year", "."),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    first = next(iter(results))
    rows = [
        {
            "figure": asdict(figure),
            "cells": [
                {
                    "variant": label,
                    "value": None if (pair := value_of(found, figure)) is None else repr(pair[0]),
                    "text": text_of(found, figure),
                }
                for label, found in results.items()
            ],
        }
        for figure in asked_for(results)
    ]
    page: str = environment.get_template("report.html.j2").render(
        study=study,
        variants=list(results),
        base=first,
        rows=rows,
        comparison=pictures.comparison(results),
        sections=list(pictures.sections(study, results)),
        plans=list(pictures.plans(study, results)),
        carpets=list(pictures.carpets(results)),
        beams=list(pictures.beams(study)),
        assumptions=assumptions(study),
        errors=errors_told(results),
        attributes={name: attributes[name] for name in ("clerestory_version", "date")},
        hours=int(next(iter(results.values()))["in_use"].sum()),
    )
    return page


def _made_from(study: YearStudy) -> dict[str, str]:
    room = next(iter(study.variants.values()))
    return {**plan_attributes(room, study.text), "measures": json.dumps(asdict(study.measures))}


def _save(together: xr.Dataset, draft: Path) -> None:
    squeezed = {name: {"zlib": True, "complevel": 4} for name in together.data_vars if together[name].size > 10_000}
    together.to_netcdf(draft, engine="netcdf4", encoding=squeezed)


def _csv(results: Mapping[str, xr.Dataset], attributes: Mapping[str, Any]) -> str:
    written = io.StringIO()
    for name, value in attributes.items():
        written.write(f"# {name}: {value}\n")
    rows = table_rows(results)
    table = csv.DictWriter(written, fieldnames=list(rows[0]), lineterminator="\n")
    table.writeheader()
    table.writerows({**row, "value": np.format_float_positional(row["value"], trim="-")} for row in rows)
    return written.getvalue()
