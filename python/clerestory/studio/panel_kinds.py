"""The kinds of panels as the page offers them: sizes with units, and the limits between which a slider moves them.

The limits are those of drawing boards, not of physics: a file or a link may hold any value that the panel takes.
"""

from __future__ import annotations

from typing import Any

from clerestory.medium import medium_names


def _slider(name: str, low: float, high: float, step: float, unit: str, start: float) -> dict[str, Any]:
    return {"name": name, "low": low, "high": high, "step": step, "unit": unit, "start": start}


def panel_kinds() -> list[dict[str, Any]]:
    """For each kind its sliders (``low``, ``high``, ``step``, ``unit``, ``start``), choices and media."""
    return [
        {
            "kind": "laser-cut",
            "sliders": [
                _slider("spacing_mm", 1.0, 20.0, 0.1, "mm", 6.0),
                _slider("thickness_mm", 1.0, 20.0, 0.1, "mm", 6.0),
                _slider("cut_width_mm", 0.0, 1.0, 0.01, "mm", 0.0),
                _slider("cut_tilt_deg", -45.0, 45.0, 0.5, "°", 0.0),
            ],
            "choices": [],
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
            "choices": [{"name": "ridges", "words": ["front", "back"], "start": "front"}],
            "medium": "pmma",
        },
        {
            "kind": "pane",
            "sliders": [_slider("thickness_mm", 1.0, 40.0, 0.1, "mm", 4.0)],
            "choices": [],
            "medium": "soda_lime_clear",
        },
    ]


def media() -> list[str]:
    """Names of the media to choose from."""
    return list(medium_names())
