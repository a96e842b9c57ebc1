"""The lines of a text file of weather, in whatever encoding it is found."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from clerestory.errors import ClerestoryError


@dataclass(frozen=True)
class Lines:
    """The lines of a file, with its path for messages."""

    path: Path
    text: list[str]
    notes: tuple[str, ...]

    def wrong(self, line: int, message: str) -> ClerestoryError:
        """An error that says path and line, counted from 1."""
        return ClerestoryError(f"{self.path}:{line}: {message}")

    def number(self, line: int, name: str, text: str) -> float:
        """A field as a number."""
        try:
            return float(text)
        except ValueError:
            raise self.wrong(line, f"{name} must be a number, got {text.strip()!r}") from None


def read_lines(path: str | os.PathLike[str]) -> Lines:
    """Lines of a file in UTF-8, or else in Latin-1, as many weather files are.

    Raises
    ------
    ClerestoryError
        If the file cannot be read, is empty or is no text.
    """
    where = Path(path)
    try:
        content = where.read_bytes()
    except OSError as error:
        raise ClerestoryError(f"{where} must be a file to read, got: {error.strerror or error}") from None
    if not content.strip():
        raise ClerestoryError(f"{where} must be a weather file, got an empty file")
    if b"\0" in content[:4096]:
        raise ClerestoryError(f"{where} must be a text file, got binary data; unpack it if it is an archive")
    notes: tuple[str, ...] = ()
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
        notes = ("text is Latin-1, not UTF-8",)
    return Lines(where, text.splitlines(), notes)
