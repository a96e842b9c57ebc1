"""The folder of a study: finished results by their hash, and the errors of cases that failed."""

from __future__ import annotations

import json
import shutil
import time
from pathlib import Path
from typing import Any

import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.saving import write_text, write_whole

STALE_AFTER_S = 3600.0
"""A draft left by a process that was killed is removed when it is this old."""


class Store:
    """Results of a study, each a file that is there whole or not at all.

    Parameters
    ----------
    folder : path
        Made when the first result is written.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._cases = folder / "cases"
        self._failed = folder / "failed"

    def path(self, key: str) -> Path:
        """Where a finished result is."""
        return self._cases / f"{key}.nc"

    def keys(self) -> set[str]:
        """Of every finished result."""
        return {path.stem for path in self._cases.glob("*.nc")} if self._cases.is_dir() else set()

    def put(self, key: str, content: bytes) -> None:
        """Keeps a finished result and forgets that the case failed before."""
        write_whole(self.path(key), lambda draft: draft.write_bytes(content))
        (self._failed / f"{key}.json").unlink(missing_ok=True)

    def remove(self, key: str) -> None:
        """Drops a result that is no longer needed."""
        self.path(key).unlink(missing_ok=True)

    def read(self, key: str) -> xr.Dataset:
        """A finished result, in memory."""
        try:
            with xr.open_dataset(self.path(key), engine="netcdf4") as found:
                return found.load()
        except (OSError, ValueError) as cause:
            raise ClerestoryError(f"{self.path(key)} must be a result, got: {cause}; remove it and run again") from None

    def fail(self, key: str, report: dict[str, Any]) -> None:
        """Keeps what went wrong with a case."""
        write_text(self._failed / f"{key}.json", json.dumps(report, indent=2, default=str) + "\n")

    def failure(self, key: str) -> dict[str, Any] | None:
        """What went wrong with a case, or None."""
        path = self._failed / f"{key}.json"
        if not path.is_file():
            return None
        report: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        return report

    def tidy(self) -> None:
        """Removes drafts that processes left when they were killed."""
        old = time.time() - STALE_AFTER_S
        for place in (self.folder, self._cases, self._failed):
            for draft in place.glob(".*.*") if place.is_dir() else ():
                if draft.is_dir() and draft.stat().st_mtime < old:
                    shutil.rmtree(draft, ignore_errors=True)
