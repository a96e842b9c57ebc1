"""What a case is made of, as one hash: inputs, the files they refer to, and the program."""

from __future__ import annotations

import hashlib
import json
import platform
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from clerestory._native import __version__


@cache
def build() -> dict[str, str]:
    """The program: version, digest of its Python files, digest of the compiled half and the platform of that."""
    package = Path(__file__).parents[1]
    sources = hashlib.sha256()
    for path in sorted(package.rglob("*.py")):
        sources.update(
            path.relative_to(package).as_posix().encode() + b"\0" + path.read_bytes().replace(b"\r\n", b"\n")
        )
    native = hashlib.sha256()
    for path in sorted(package.glob("_native.*")):
        if path.suffix != ".pyi":
            native.update(path.read_bytes())
    return {
        "version": __version__,
        "sources": sources.hexdigest()[:16],
        "native": native.hexdigest()[:16],
        "platform": f"{platform.system()} {platform.machine()}",
    }


def same_build(one: Mapping[str, str], other: Mapping[str, str]) -> bool:
    """Whether two programs are one: the compiled halves are compared on one platform alone."""
    keys = ["version", "sources"] + (["native"] if one["platform"] == other["platform"] else [])
    return all(one[key] == other[key] for key in keys)


def files_of(tables: Any, where: Path) -> dict[str, str]:
    """Every file that the tables name, and that is there: path as written → digest of its content.

    Notes
    -----
    Any text that is the path of a file counts; files that a TOML file names count with it.
    """
    found: dict[str, str] = {}
    for text in _texts(tables):
        path = where / text
        try:
            if text in found or not text.strip() or not path.is_file():
                continue
            at = path.stat()
        except (OSError, ValueError):
            continue
        found[text] = _digest(path, at.st_mtime_ns, at.st_size)
        if path.suffix.lower() == ".toml":
            within = tomllib.loads(path.read_text(encoding="utf-8", errors="replace")) if _is_toml(path) else {}
            found |= {f"{text} → {name}": digest for name, digest in files_of(within, path.parent).items()}
    return dict(sorted(found.items()))


def key_of(kind: str, tables: Mapping[str, Any], files: Mapping[str, str]) -> str:
    """The hash of a case, 24 hexadecimal digits: equal for equal inputs to one program, and for nothing else."""
    whole = {"kind": kind, "tables": tables, "files": files, "build": build()}
    text = json.dumps(whole, sort_keys=True, separators=(",", ":"), default=str, ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()[:24]


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        if len(value) < 1024 and "\n" not in value:
            yield value
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from _texts(item)
    elif isinstance(value, (list, tuple)):
        for item in value:
            yield from _texts(item)


@lru_cache(maxsize=1024)
def _digest(path: Path, _changed: int, _size: int) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _is_toml(path: Path) -> bool:
    try:
        tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
        return False
    return True
