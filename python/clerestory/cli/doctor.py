"""``clerestory doctor``: what is installed, for a report of a fault."""

from __future__ import annotations

import json
import os
import platform
import sys
from importlib.metadata import PackageNotFoundError, version
from typing import Annotated, Any

import typer

#: Optional packages and what they are for.
EXTRAS = {
    "distributed": "sweeps on many machines",
    "optuna": "design",
    "mitsuba": "race against Mitsuba 3",
    "pyradiance": "race against Radiance",
    "hypothesis": "tests",
    "pytest": "tests",
}
REQUIRED = ("numpy", "xarray", "netCDF4", "matplotlib", "pandas", "pvlib", "typer", "rich", "ezdxf", "svgelements")


def doctor(as_json: Annotated[bool, typer.Option("--json", help="Print JSON instead of a table.")] = False) -> None:
    """Print versions, CPU features, threads and the optional extras found."""
    found = examination()
    if as_json:
        typer.echo(json.dumps(found, indent=2))
        return
    from rich.console import Console
    from rich.table import Table

    table = Table(show_header=False, box=None)
    for name, value in found.items():
        if isinstance(value, dict):
            value = "\n".join(f"{key} {item or 'not installed'}" for key, item in value.items())
        elif isinstance(value, list):
            value = " ".join(value) or "none"
        table.add_row(name.replace("_", " "), str(value))
    Console().print(table)


def examination() -> dict[str, Any]:
    """What :func:`doctor` prints."""
    from clerestory import __version__, _native

    return {
        "clerestory": __version__,
        "native_module": str(_native.__file__),
        "python": sys.version.split()[0],
        "platform": platform.platform(),
        "processor": platform.processor() or platform.machine(),
        "cpu_features": cpu_features(),
        "processors": os.cpu_count() or 1,
        "threads": threads(),
        "packages": {name: _version(name) for name in REQUIRED},
        "extras": {name: _version(name) for name in EXTRAS},
    }


def cpu_features() -> list[str]:
    """Vector instructions of this processor that matter here, as numpy detects them."""
    import numpy as np

    features = np.show_config(mode="dicts")["SIMD Extensions"]  # type: ignore[call-overload, index, unused-ignore]
    return sorted({*features.get("baseline", []), *features.get("found", [])})


def threads() -> int:
    """Threads that rays run on: ``RAYON_NUM_THREADS``, or the processors this process may use."""
    asked = os.environ.get("RAYON_NUM_THREADS", "")
    if asked.isdigit() and int(asked) > 0:
        return int(asked)
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None
