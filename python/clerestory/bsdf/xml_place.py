"""Elements of an XML file that know where they stand, so that a mistake can be found again."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from clerestory.errors import ClerestoryError

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

#: Largest file that is read.
MOST_MEGABYTES = 512


def _bare(tag: object) -> str:
    """The name of an element without its namespace; comments have none."""
    return tag.rsplit("}", 1)[-1] if isinstance(tag, str) else ""


class Place:
    """An element and the way to it from the root."""

    def __init__(self, element: Element, path: str, file: str) -> None:
        self.element, self.path, self.file = element, path, file

    @property
    def name(self) -> str:
        """Of the element, without a namespace."""
        return _bare(self.element.tag)

    @property
    def text(self) -> str:
        """What stands in the element, without blanks around it."""
        return (self.element.text or "").strip()

    def wrong(self, rule: str) -> NoReturn:
        """Raises the error of a broken rule, with file and path."""
        raise ClerestoryError(f"{self.file}: {self.path} {rule}")

    def all(self, name: str) -> list[Place]:
        """Children of this name, whatever their namespace."""
        found = [child for child in self.element if _bare(child.tag).casefold() == name.casefold()]
        if len(found) == 1:
            return [Place(found[0], f"{self.path}/{name}", self.file)]
        return [Place(child, f"{self.path}/{name}[{number}]", self.file) for number, child in enumerate(found, 1)]

    def find(self, name: str) -> Place | None:
        """The first child of this name."""
        return next(iter(self.all(name)), None)

    def need(self, name: str) -> Place:
        """The first child of this name, or an error."""
        found = self.find(name)
        if found is None:
            self.wrong(f"must hold an element {name}; it is no BSDF as LBNL's programs write them")
        return found

    def number(self) -> float:
        """The text as a finite number."""
        text = self.text
        try:
            value = float(text.replace("_", "?"))
        except ValueError:
            value = float("nan")
        if not abs(value) < float("inf"):
            self.wrong(f"must be a number, got {shortened(text)}")
        return value


def shortened(text: str) -> str:
    """The text as Python writes it, cut to fit a line."""
    return repr(text if len(text) <= 40 else text[:37] + "…")


def root_of(path: Path) -> Place:
    """The root element of a file, read without following entities or other files.

    Raises
    ------
    ClerestoryError
        If the file cannot be read, is larger than 512 MB, or is no XML.
    """
    from xml.etree.ElementTree import ParseError

    from defusedxml import DefusedXmlException
    from defusedxml.ElementTree import fromstring

    try:
        size = path.stat().st_size
        if size > MOST_MEGABYTES * 2**20:
            raise ClerestoryError(f"{path} must be no larger than {MOST_MEGABYTES} MB, got {size / 2**20:.0f} MB")
        content = path.read_bytes()
    except OSError as error:
        raise ClerestoryError(f"{path} must be a file to read, got: {error.strerror or error}") from None
    begin = _begin(content)
    if begin is None:
        raise ClerestoryError(f"{path} must be XML of LBNL's BSDF format, but no element begins in it")
    try:
        element = fromstring(content[begin:], forbid_dtd=True)
    except DefusedXmlException as refused:
        kind = type(refused).__name__
        raise ClerestoryError(
            f"{path} must hold no document type and no entities of its own ({kind}); remove them"
        ) from None
    except ParseError as error:
        line = content[:begin].count(b"\n") + error.position[0]
        raise ClerestoryError(
            f"{path} must be well-formed XML, got {str(error).split(':')[0]} at line {line}"
        ) from None
    except (LookupError, ValueError) as error:
        raise ClerestoryError(f"{path} must be XML in UTF-8 or another encoding that is known, got: {error}") from None
    return Place(element, _bare(element.tag), str(path))


def _begin(content: bytes) -> int | None:
    """Where XML begins: some programs write a line of text before it."""
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return 0
    starts = [place for mark in (b"<?xml", b"<WindowElement") if (place := content.find(mark)) >= 0]
    return min(starts) if starts else None
