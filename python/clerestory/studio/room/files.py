"""Files that the tables of a room name: within the studio's folder, or not read at all."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.room.toml_file import read_toml

#: Tables that name a file by ``file``, and bytes of one that are read.
_MOST_BYTES = 64 * 2**20


def confined(root: Path, folder: Path, name: Any, what: str) -> Path:
    """A file that a table names, looked for in ``folder``.

    Parameters
    ----------
    root : Path
        The studio's folder, resolved: the file lies in it, by whatever way.
    folder : Path
        Where the file that names it is.
    name : str
        Relative, with ``/`` between names.
    what : str
        Begins the message.

    Raises
    ------
    ClerestoryError
        If it is not there, leads outside (also by a symbolic link), or is too large. What lies outside is not told.
    """
    refused = ClerestoryError(f"{what} must be a file of the studio's folder, got {str(name)[:80]!r}")
    if not isinstance(name, str) or not name or any(letter in name for letter in "\0\\:"):
        raise refused
    if Path(name).is_absolute() or name.startswith("/"):
        raise refused
    try:
        found = (folder / name).resolve(strict=True)
        is_there = found.is_relative_to(root) and found.is_file()
    except (OSError, RuntimeError, ValueError):
        is_there = False
    if not is_there:
        raise refused
    if found.stat().st_size > _MOST_BYTES:
        raise ClerestoryError(f"{what} must be of at most {_MOST_BYTES} bytes, got {name[:80]!r}")
    if found.suffix.lower() in (".gltf", ".glb"):
        _check_parts(root, found, what)
    return found


def files_of(root: Path, folder: Path, tables: dict[str, Any]) -> list[Path]:
    """Every file that the tables of a room name, each checked by `confined`."""
    return [confined(root, folder, name, what) for what, name in _named(tables)]


def with_room_file(root: Path, folder: Path, tables: dict[str, Any]) -> tuple[dict[str, Any], Path]:
    """The tables with those of the room file that a year file may name, and the folder that its files are in."""
    if "room" not in tables:
        return tables, folder
    path = confined(root, folder, tables["room"], "room")
    beneath = {name: table for name, table in read_toml(path).items() if name not in ("calculation", "sky", "variant")}
    return {**beneath, **{name: table for name, table in tables.items() if name != "room"}}, path.parent


def stamp(path: Path) -> tuple[str, int, int]:
    """What changes when a file does."""
    about = os.stat(path)
    return str(path), about.st_mtime_ns, about.st_size


def _named(tables: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    glazings = tables.get("glazings")
    for name, table in glazings.items() if isinstance(glazings, dict) else ():
        if isinstance(table, dict) and "file" in table:
            yield f"file of [glazings.{name}]", table["file"]
    for kind in ("mesh", "radiance"):
        rows = tables.get(kind)
        for index, table in enumerate(rows if isinstance(rows, list) else (), 1):
            if isinstance(table, dict) and "file" in table:
                yield f"file of [[{kind}]] {index}", table["file"]


def _check_parts(root: Path, gltf: Path, what: str) -> None:
    """A glTF file may name others: they too lie in the folder."""
    try:
        content = gltf.read_bytes()
        if gltf.suffix.lower() == ".glb":
            # a header of 12 bytes, then the length and the type of the first piece, which is JSON
            content = content[20 : 20 + int.from_bytes(content[12:16], "little")]
        scene = json.loads(content)
    except (ValueError, RecursionError):
        raise ClerestoryError(f"{what} must be a glTF file, got {gltf.name!r}") from None
    for kind in ("buffers", "images"):
        rows = scene.get(kind) if isinstance(scene, dict) else None
        for row in rows if isinstance(rows, list) else ():
            uri = row.get("uri") if isinstance(row, dict) else None
            if uri is not None and not (isinstance(uri, str) and uri.startswith("data:")):
                # what is written as %2e%2e leads outside as well
                if not isinstance(uri, str) or "%" in uri:
                    raise ClerestoryError(f"{what} must name its {kind} plainly, got {str(uri)[:80]!r}")
                confined(root, gltf.parent, uri, f"{kind} of {what}")
