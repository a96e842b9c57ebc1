"""The results and year files of the studio's folder, each told by what it holds."""

from __future__ import annotations

import json
import os
import tomllib
from collections import OrderedDict
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.studio.results.kinds import KINDS, kind_of
from clerestory.studio.results.reader import Reader
from clerestory.studio.results.shelf import signature

#: Folders that hold the pieces of a result, which opens as a whole.
_PIECES = ("pieces", "cases", "failed", "screen")
_MOST, _DEPTH, _MOST_TOML, _MOST_JSON = 300, 4, 2**20, 2**20
#: Files that a listing looks into; of those beside a summary the summary stands for all.
_ENDINGS = (".nc", ".csv", ".json", ".toml")
_NAMES = {".csv": ("results.csv", "history.csv", "angular.csv"), ".json": ("summary.json",)}


class Listing:
    """What a folder holds, looked into once for each state of a file."""

    def __init__(self) -> None:
        self._seen: OrderedDict[str, dict[str, Any] | None] = OrderedDict()

    def of(self, folder: Path, reader: Reader) -> dict[str, Any]:
        """Results and year files.

        Returns
        -------
        dict
            ``results``: ``path``, ``kind``, ``title``, ``detail`` and ``date`` of each; ``years``: ``path`` and
            ``title`` of each file that ``clerestory year`` runs.
        """
        results: list[dict[str, Any]] = []
        years: list[dict[str, Any]] = []
        for path in _candidates(folder):
            name = path.relative_to(folder).as_posix()
            told = self._told(path, reader)
            if told is not None:
                (years if told["kind"] == "year file" else results).append({"path": name, **told})
            if len(results) + len(years) >= _MOST:
                break
        return {"results": _wholes(results), "years": years}

    def _told(self, path: Path, reader: Reader) -> dict[str, Any] | None:
        try:
            mark = signature(path)
        except OSError:
            return None
        if mark not in self._seen:
            self._seen[mark] = _look(path, reader)
            while len(self._seen) > 4 * _MOST:
                self._seen.popitem(last=False)
        return self._seen[mark]


def _candidates(folder: Path) -> list[Path]:
    found: list[Path] = []
    for place, folders, names in os.walk(folder):
        depth = len(Path(place).relative_to(folder).parts)
        stores = sorted(one for one in folders if one.endswith(".zarr"))
        folders[:] = sorted(
            one
            for one in folders
            if not one.startswith(".") and one not in _PIECES and one not in stores and depth < _DEPTH
        )
        found += [Path(place) / one for one in stores if not one.startswith(".")]
        for name in sorted(names):
            ending = Path(name).suffix.lower()
            if ending in _ENDINGS and not name.startswith(".") and name in _NAMES.get(ending, (name,)):
                found.append(Path(place) / name)
    return [one for one in found if one.resolve().is_relative_to(folder)][: 4 * _MOST]


def _look(path: Path, reader: Reader) -> dict[str, Any] | None:
    ending = path.suffix.lower()
    try:
        if ending == ".toml":
            return _year_file(path)
        if ending == ".json":
            return _summary(path)
        found = reader.read(path, path.name, heads=True)
        kind = kind_of(found, path.name)
    except (ClerestoryError, OSError, ValueError, RecursionError):
        return None
    sizes = found.sizes
    title = str(found.attrs.get("study") or found.attrs.get("room") or "")
    if kind == "year":
        detail = [str(one) for one in found["variant"].values.tolist()] if "variant" in sizes else []
    elif kind == "panel":
        title, detail = _panel_title(found.attrs), [f"{sizes.get('elevation', sizes.get('row', 0))} elevations"]
    elif kind in ("sweep", "design") and "case" in sizes:
        detail = [f"{sizes['case']} cases"]
    elif "sky" in sizes and "sky" in found.coords:
        detail = [str(one) for one in found["sky"].values.tolist()]
    else:
        detail = []
    date = str(found.attrs.get("date", ""))[:10]
    return {"kind": kind, "what": KINDS[kind], "title": title, "detail": ", ".join(detail)[:200], "date": date}


def _year_file(path: Path) -> dict[str, Any] | None:
    if path.stat().st_size > _MOST_TOML:
        return None
    tables = tomllib.loads(path.read_text(encoding="utf-8"))
    if not isinstance(tables.get("weather"), dict) or not ({"shoebox", "room", "surface"} & set(tables)):
        return None
    title = str(tables.get("title") or tables.get("name") or path.stem)
    return {"kind": "year file", "what": "", "title": title, "detail": "", "date": ""}


def _summary(path: Path) -> dict[str, Any] | None:
    if path.stat().st_size > _MOST_JSON:
        return None
    told = json.loads(path.read_bytes())
    if not isinstance(told, dict) or not told:
        return None
    if "objectives" in told and "design" in told and (path.parent / "history.csv").is_file():
        objectives = [str(one.get("figure")) for one in told["objectives"] if isinstance(one, dict)]
        detail, title, kind = ", ".join(objectives)[:200], str(told["design"]), "design"
    elif all(isinstance(one, dict) and "daylight_factor_percent" in one for one in told.values()):
        detail, title, kind = ", ".join(map(str, told))[:200], path.parent.name, "room"
    else:
        return None
    return {"kind": kind, "what": KINDS[kind], "title": title, "detail": detail, "date": ""}


def _panel_title(attrs: Any) -> str:
    try:
        return str(json.loads(attrs.get("panel", "{}")).get("kind", ""))
    except (ValueError, AttributeError):
        return ""


def _wholes(results: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Without the parts of what is listed as a whole: the files of a room's summary, the tables of a store."""
    kept = []
    kinds = {(str(Path(one["path"]).parent), one["kind"]): one for one in results}
    for one in results:
        place, name = str(Path(one["path"]).parent), Path(one["path"]).name
        is_part = (
            (one["kind"] in ("coefficients", "illuminance", "factor") and kinds.get((place, "room"), one) is not one)
            or (name == "results.csv" and any(other["path"] == f"{place}/results.zarr" for other in results))
            or (name == "history.csv" and any(other["path"] == f"{place}/summary.json" for other in results))
            or (name == "angular.csv" and any(other["path"] == f"{place}/angular.nc" for other in results))
        )
        if not is_part:
            kept.append(one)
    return kept
