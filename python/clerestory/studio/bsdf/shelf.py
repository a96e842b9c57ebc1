"""BSDFs that the page has opened, kept while they are looked at."""

from __future__ import annotations

import hashlib
import re
import tempfile
import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from clerestory.bsdf import Bsdf, BsdfWarning
from clerestory.bsdf.checking import Finding
from clerestory.bsdf.reading import read_bsdf
from clerestory.errors import ClerestoryError
from clerestory.rules import one_of
from clerestory.studio.shelf import Shelf

#: BSDFs kept at once; the one looked at longest ago goes first.
_KEPT = 12


@dataclass(frozen=True, eq=False)
class Opened:
    """A BSDF and what its reader had to assume."""

    bsdf: Bsdf
    assumed: tuple[str, ...] = ()

    @cached_property
    def findings(self) -> list[Finding]:
        """What may be wrong with it, looked for once."""
        return self.bsdf.check()


class BsdfShelf(Shelf[Opened]):
    """A few opened BSDFs by a key that the same content always has."""

    def __init__(self) -> None:
        super().__init__(_KEPT, "key must be that of a BSDF that is open: open the file again")

    def read(self, content: bytes, name: str) -> str:
        """Reads a file's content and keeps it; even one whose numbers cannot be, so that its faults can be told.

        Raises
        ------
        ClerestoryError
            If it is no BSDF; the message begins with the name of the file.
        """
        shown = re.sub(r"[^\w.() -]", "_", Path(name.replace("\\", "/")).name)[-100:] or "file.xml"
        one_of("the ending of a BSDF's file", Path(shown).suffix.lower(), (".xml", ".nc"))
        key = hashlib.sha256(content).hexdigest()[:20]
        if self.find(key) is not None:
            return key
        with tempfile.TemporaryDirectory(prefix="clerestory-") as folder:
            path = Path(folder) / shown
            path.write_bytes(content)
            try:
                opened = opened_from(path)
            except ClerestoryError as error:
                raise ClerestoryError(str(error).replace(str(path), shown)) from None
        told = tuple(text.replace(str(path), shown) for text in opened.assumed)
        return self.put(key, Opened(opened.bsdf, told))


def opened_from(path: Path) -> Opened:
    """The BSDF of a file, with what was assumed."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always", BsdfWarning)
        bsdf = read_bsdf(path, strict=False)
    return Opened(bsdf, tuple(str(one.message) for one in told if issubclass(one.category, BsdfWarning)))
