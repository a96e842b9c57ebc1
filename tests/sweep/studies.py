"""Studies that the tests run: quick panels, and slower ones to be interrupted."""

from pathlib import Path
from typing import Any

from clerestory.sweep.plan import Sweep, sweep_of

PANEL = {"kind": "laser-cut", "spacing_mm": 4.0, "thickness_mm": 6.0, "medium": {"n": 1.49}}


def quick(where: Path = Path(), **changes: Any) -> Sweep:
    """Six panels, one of which cannot be made."""
    tables: dict[str, Any] = {
        "kind": "panel",
        "base": {"panel": dict(PANEL), "light": {"elevation_deg": [30, 50]}},
        "parameters": {
            "panel.spacing_mm": [3.0, 4.0],
            "panel.cut_width_mm": {"values": [0.0, 0.5, 3.5]},
            "light.tolerance": {"values": [1e-2]},
        },
    }
    return sweep_of(tables | changes, where=where, name="quick.toml")


def slow(cases: int, rays: int = 60_000) -> dict[str, Any]:
    """Tables of a study whose cases take a few tenths of a second each, by rays of their own."""
    return {
        "kind": "panel",
        "base": {"panel": dict(PANEL), "light": {"elevation_deg": [30, 50], "method": "monte_carlo", "rays": rays}},
        "parameters": {"light.seed": {"range": {"start": 1, "stop": cases, "step": 1}}},
    }
