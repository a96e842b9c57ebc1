"""The kinds of panels as the page offers them: sizes with units, the limits between which a slider moves them, presets.

The limits are those of drawing boards, not of physics: a file or a link may hold any value that the panel takes.
"""

from __future__ import annotations

from typing import Any

from clerestory.medium import medium_names
from clerestory.studio.panel.drawn import DRAWN

#: Outlines that a drawing starts from: slats with a bevel towards the sky.
_SLATS = "0,0 6,0 6,5.7 1,5.7 0,4.7"


def _slider(
    name: str,
    low: float,
    high: float,
    step: float,
    unit: str,
    start: float | None,
    *,
    group: str = "",
    repeats: bool = False,
    sets: float | None = None,
) -> dict[str, Any]:
    """``start`` None: left out until it is asked for, then ``sets``; ``repeats``: may be a list."""
    return {
        "name": name,
        "low": low,
        "high": high,
        "step": step,
        "unit": unit,
        "start": start,
        "sets": start if sets is None else sets,
        "group": group,
        "repeats": repeats,
    }


def panel_kinds() -> list[dict[str, Any]]:
    """For each kind its sliders (``low``, ``high``, ``step``, ``unit``, ``start`` …), choices, texts and media."""
    return [
        {
            "kind": "laser-cut",
            "sliders": [
                _slider("spacing_mm", 1.0, 20.0, 0.1, "mm", 6.0, repeats=True),
                _slider("thickness_mm", 1.0, 20.0, 0.1, "mm", 6.0),
                _slider("cut_width_mm", 0.0, 1.0, 0.01, "mm", 0.0),
                _slider("cut_tilt_deg", -45.0, 45.0, 0.5, "°", 0.0, repeats=True),
                _slider("cut_depth_mm", 0.5, 20.0, 0.1, "mm", None, group="shape", repeats=True, sets=4.0),
                _slider("cut_radius_mm", -60.0, 60.0, 0.5, "mm", None, group="shape", sets=15.0),
                _slider("cut_slope_deg", 0.0, 15.0, 0.1, "°", 0.0, group="surface"),
                _slider("cut_diffuse", 0.0, 1.0, 0.01, "", 0.0, group="surface"),
            ],
            "choices": [],
            "texts": [],
            "medium": "pmma",
        },
        {
            "kind": "prismatic",
            "sliders": [
                _slider("pitch_mm", 0.5, 20.0, 0.1, "mm", 4.0),
                _slider("lower_deg", 1.0, 90.0, 0.5, "°", 45.0),
                _slider("upper_deg", 1.0, 90.0, 0.5, "°", 80.0),
                _slider("base_mm", 0.0, 20.0, 0.1, "mm", 3.0),
            ],
            "choices": [{"name": "ridges", "words": ["front", "back"], "start": "front", "group": ""}],
            "texts": [],
            "medium": "pmma",
        },
        {
            "kind": "pane",
            "sliders": [_slider("thickness_mm", 1.0, 40.0, 0.1, "mm", 4.0)],
            "choices": [],
            "texts": [],
            "medium": "soda_lime_clear",
        },
        {
            "kind": DRAWN,
            "sliders": [_slider("pitch_mm", 0.5, 40.0, 0.1, "mm", 6.0)],
            "choices": [
                {"name": "source", "words": ["points", "svg", "file"], "start": "points", "group": ""},
                {"name": "joins", "words": ["film", "vanish"], "start": "film", "group": ""},
            ],
            "texts": [
                {"name": "points", "source": "points", "start": _SLATS},
                {"name": "path_data", "source": "svg", "start": "M0,0 H6 V-5.7 H0 Z"},
            ],
            "medium": "pmma",
        },
    ]


def presets() -> list[dict[str, Any]]:
    """Panels to start from: ``name``, ``group`` and ``panel``."""
    acrylic = {"n": 1.49}
    series = [
        (f"{ratio:g}", {"kind": "laser-cut", "spacing_mm": round(6.0 * ratio, 2), "thickness_mm": 6.0})
        for ratio in (0.3, 0.5, 0.7)
    ]
    prism = {"kind": "prismatic", "pitch_mm": 4.0, "base_mm": 3.0, "ridges": "front", "medium": "pmma"}
    return [
        *({"name": name, "group": "laser-cut", "panel": {**panel, "medium": acrylic}} for name, panel in series),
        {"name": "45°/45°", "group": "prismatic", "panel": {**prism, "lower_deg": 45.0, "upper_deg": 45.0}},
        {"name": "45°/80°", "group": "prismatic", "panel": {**prism, "lower_deg": 45.0, "upper_deg": 80.0}},
        {
            "name": "4 mm",
            "group": "pane",
            "panel": {"kind": "pane", "thickness_mm": 4.0, "medium": "soda_lime_clear"},
        },
    ]


def media() -> list[str]:
    """Names of the media to choose from."""
    return list(medium_names())
