"""Files of the one folder that the page can open."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError

#: Endings that some view opens, and how many files of them a listing holds.
ENDINGS = {
    ".toml": "toml",
    ".xml": "bsdf",
    ".nc": "netcdf",
    ".svg": "drawing",
    ".dxf": "drawing",
    ".epw": "weather",
    ".wea": "weather",
}
MOST_FILES = 2000


def inside(folder: Path, asked: Any, name: str = "path") -> Path:
    """A file or folder within ``folder``.

    Parameters
    ----------
    folder : Path
        Resolved.
    asked : str
        Relative to it, with ``/`` between names.

    Raises
    ------
    ClerestoryError
        If it leads outside, also by way of a symbolic link, or is not there. What lies outside is not told.
    """
    if not isinstance(asked, str) or not asked or "\0" in asked or "\\" in asked or ":" in asked:
        raise ClerestoryError(f"{name} must be a file of the studio's folder, got {asked!r}; choose one of the list")
    try:
        found = (folder / asked).resolve(strict=True)
        is_inside = not Path(asked).is_absolute() and found.is_relative_to(folder)
    except (OSError, RuntimeError, ValueError):
        is_inside = False
    if not is_inside:
        raise ClerestoryError(
            f"{name} must be a file of the studio's folder, got {asked[:80]!r}; choose one of the list"
        )
    return found


def listed(folder: Path) -> list[dict[str, Any]]:
    """Files that some view opens, by path relative to the folder, at most 4 folders deep."""
    found: list[dict[str, Any]] = []
    for place, folders, names in os.walk(folder):
        depth = len(Path(place).relative_to(folder).parts)
        folders[:] = sorted(one for one in folders if not one.startswith(".") and depth < 4)
        for name in sorted(names):
            kind = ENDINGS.get(Path(name).suffix.lower())
            path = Path(place) / name
            if kind is None or not path.resolve().is_relative_to(folder):
                continue
            found.append({"path": path.relative_to(folder).as_posix(), "kind": kind})
            if len(found) >= MOST_FILES:
                return found
    return found
