"""What a result is, in words: its title, variants, quantities, and what it was made from."""

from __future__ import annotations

import contextlib
import json
from pathlib import Path
from typing import Any

from clerestory.studio.glazing_words import glazing_words
from clerestory.studio.results.cases import cases
from clerestory.studio.results.figures import figures_of_result
from clerestory.studio.results.kinds import KINDS
from clerestory.studio.results.metrics import measures_of, metrics_of
from clerestory.studio.results.plans import labels_of, planes_of
from clerestory.studio.results.shelf import Result

#: Attribute → what it is called, in the order that they are shown.
_NAMES = {
    "study": "Study",
    "variant": "Variant",
    "room": "Room",
    "date": "Computed",
    "clerestory_version": "Version",
    "weather": "Weather",
    "weather_notes": "Weather, note",
    "latitude_deg": "Latitude [°]",
    "longitude_deg": "Longitude, east positive [°]",
    "schedule": "Hours of use",
    "blinds": "Blinds",
    "ground_reflectance": "Ground reflectance",
    "sky": "Sky",
    "panel": "Panel",
    "method": "Method",
    "kind": "Kind of case",
    "basis": "Sky basis",
    "seed": "Seed",
    "rounds": "Rounds",
    "target_relative_error": "Target of the relative error",
    "converged": "Target reached",
    "interrupted": "Ended early",
    "cpu_seconds": "CPU time [s]",
}
_HIDDEN = ("room_outlines", "study_toml", "measures", "sources", "judged_sky")
_LONGEST = 600


def told(key: str, result: Result, folder: Path) -> dict[str, Any]:
    """A result as the page lists it.

    Parameters
    ----------
    key : str
    result : Result
    folder : Path
        The studio's, in which the file that the result was made from is looked for.
    """
    has_variants = result.kind in ("year", "room")
    metrics = metrics_of(result) if has_variants else []
    return {
        "key": key,
        "kind": result.kind,
        "what": KINDS[result.kind],
        "name": result.name,
        "path": result.path,
        "title": str(result.about.get("title") or result.data.attrs.get("study") or "") or _room_title(result),
        "variants": labels_of(result) if has_variants else [],
        "glazings": _glazings(result),
        "metrics": [{"key": one.key, "label": one.label, "unit": one.unit, "about": one.about} for one in metrics],
        "planes": planes_of(result) if has_variants else [],
        "figures": figures_of_result(result) if has_variants else [],
        "has_hours": result.kind == "year",
        "rows": cases(result)["rows_in_all"] if not has_variants else 0,
        "measures": measures_of(result),
        "provenance": provenance_of(result),
        "source": source_of(result, folder),
    }


def provenance_of(result: Result) -> list[dict[str, str]]:
    """What a result was made from, label and text."""
    attrs = {str(name): value for name, value in result.data.attrs.items() if name not in _HIDDEN}
    attrs |= {f"program_{name}": value for name, value in result.about.get("program", {}).items()}
    known = [name for name in _NAMES if name in attrs]
    rest = [name for name in attrs if name not in _NAMES]
    labels = {**{name: _label(name) for name in rest}, **_NAMES}
    return [{"label": labels[name], "text": _text(attrs[name])} for name in (*known, *rest)]


def source_of(result: Result, folder: Path) -> str | None:
    """The file of the studio's folder that the result was made from, found by its text; None if there is none."""
    text = result.data.attrs.get("study_toml")
    if not isinstance(text, str) or not text:
        return None
    from clerestory.studio.doors.folder import listed

    size = len(text.encode())
    for one in listed(folder):
        path = folder / one["path"]
        try:
            is_near = path.suffix.lower() == ".toml" and abs(path.stat().st_size - size) <= text.count("\n")
            if is_near and path.read_text(encoding="utf-8") == text:
                return str(one["path"])
        except (OSError, ValueError):
            continue
    return None


def _glazings(result: Result) -> list[list[str]]:
    if "glazings" not in result.data.coords or result.data["glazings"].dims != ("variant",):
        return []
    told = []
    for text in result.data["glazings"].values.tolist():
        try:
            told.append([glazing_words(str(one)) for one in json.loads(text)])
        except (ValueError, TypeError):
            told.append([str(text)])
    return told


def _room_title(result: Result) -> str:
    if result.kind == "panel":
        return _panel_title(result.data.attrs)
    if result.kind == "room":
        return Path(result.path).parent.name or str(result.data.attrs.get("room", ""))
    return ""


def _panel_title(attrs: Any) -> str:
    try:
        panel = json.loads(attrs.get("panel", "{}"))
        return f"Panel, {panel['kind']}"
    except (ValueError, TypeError, KeyError):
        return ""


def _label(name: str) -> str:
    if name.startswith("calculation_"):
        return f"Calculation, {name.removeprefix('calculation_').replace('_', ' ')}"
    return name.replace("_", " ")[:1].upper() + name.replace("_", " ")[1:]


def _text(value: Any) -> str:
    if isinstance(value, str) and value.startswith("[") and value.endswith("]"):
        with contextlib.suppress(ValueError):
            value = json.loads(value)
    if isinstance(value, float):
        return f"{value:g}"
    text = (
        "; ".join(f"{one:g}" if isinstance(one, float) else str(one) for one in value)
        if isinstance(value, list)
        else str(value)
    )
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"
