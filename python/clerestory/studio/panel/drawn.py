"""Panels that the page draws: outlines by their points, SVG path data, or a drawing of the studio's folder."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from clerestory.drawing.line import Outline
from clerestory.errors import ClerestoryError
from clerestory.medium import Medium
from clerestory.panels import ExtrudedPanel, Panel, panel_from_dict
from clerestory.profile import Profile, read_profile
from clerestory.rules import one_of
from clerestory.studio.doors.folder import inside
from clerestory.studio.doors.shapes import MisshapenError

#: The kind that only the page knows: where its section comes from, and the media in it.
DRAWN = "drawn"
#: Where a section can come from → the field that tells it.
SOURCES = {"points": "points", "svg": "path_data", "file": "file"}
_FIELDS = ("kind", "source", "pitch_mm", "joins", "media", *SOURCES.values())
#: Characters of a text field, and bytes of a drawing's file.
_LONGEST, _LARGEST = 40_000, 4 * 2**20


def panel_of(values: Mapping[str, Any], folder: Path) -> Panel:
    """The panel of a question.

    Parameters
    ----------
    values : mapping
        As of :func:`clerestory.panel_from_dict`; or ``kind`` "drawn" with ``pitch_mm``, ``joins``, ``media``,
        ``source`` and what the source needs: ``points`` (an outline a line, ``z,y`` of each point in mm, a third number
        is the bulge of the piece that begins there, ``2:`` before the first the medium inside), ``path_data`` (SVG, in
        mm) or ``file`` (.svg or .dxf of ``folder``).
    folder : Path
        The only one whose files are read.

    Raises
    ------
    ClerestoryError
        If the panel breaks a rule; of a drawing the field is told.
    """
    if values.get("kind") != DRAWN:
        return panel_from_dict(values)
    for name in values:
        one_of("a key of the drawn panel", name, _FIELDS)
    source = one_of("source", values.get("source", "points"), SOURCES)
    pitch, joins = values.get("pitch_mm"), values.get("joins", "film")
    field = SOURCES[source]
    text = values.get(field, "")
    if not isinstance(text, str) or len(text) > _LONGEST:
        raise MisshapenError(field, f"{field} must be text of at most {_LONGEST} characters")
    ways: dict[str, Callable[[], Profile]] = {
        "points": lambda: Profile.from_outlines(outlines_of(text), pitch_mm=pitch, joins=joins),  # type: ignore[arg-type]
        "svg": lambda: Profile.from_svg_path(text, pitch_mm=pitch, joins=joins),  # type: ignore[arg-type]
        "file": lambda: _of_file(text, folder, pitch, joins),
    }
    try:
        profile = ways[source]()
    except ClerestoryError as error:
        named = next((name for name in ("pitch_mm", "joins") if str(error).startswith(name)), field)
        raise MisshapenError(named, str(error).replace(str(folder / text), text)) from None
    media = values.get("media", ["pmma"])
    if not isinstance(media, list) or len(media) > 255:
        raise MisshapenError("media", "media must be a list of at most 255 media")
    return ExtrudedPanel(
        profile=profile, media=tuple(Medium.from_dict(one) if isinstance(one, dict) else one for one in media)
    )


def outlines_of(text: str) -> list[Outline]:
    """Outlines of lines of points; what follows # is passed over."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        words = re.split(r"[\s;]+", line.partition("#")[0].strip())
        if words == [""]:
            continue
        medium = 1
        if words[0].endswith(":"):
            medium = _whole(number, words.pop(0)[:-1])
        points = [_numbers(number, word) for word in words]
        if len(points) > 1 and points[0][:2] == points[-1][:2]:
            points.pop()
        found.append(Outline([(z, y) for z, y, _ in points], medium, [bulge for _, _, bulge in points]))
    if not found:
        raise ClerestoryError("points must hold an outline, got none; try 0,0 6,0 6,5.7 0,5.7")
    return found


def _whole(line: int, word: str) -> int:
    if not word.isdecimal() or int(word) > 255:
        raise ClerestoryError(f"points, line {line}: the medium before : must be 0 to 255, got {word[:20]!r}")
    return int(word)


def _numbers(line: int, word: str) -> tuple[float, float, float]:
    try:
        numbers = [float(one) for one in word.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) not in (2, 3):
        raise ClerestoryError(
            f"points, line {line}: a point must be z,y or z,y,bulge in mm, got {word[:20]!r}; separate points by blanks"
        )
    return numbers[0], numbers[1], numbers[2] if len(numbers) == 3 else 0.0


def _of_file(text: str, folder: Path, pitch: Any, joins: Any) -> Profile:
    path = inside(folder, text, "file")
    if not path.is_file() or path.stat().st_size > _LARGEST:
        raise ClerestoryError(f"file must be a drawing of at most {_LARGEST} bytes, got {text!r}")
    return read_profile(path, pitch_mm=pitch, joins=joins)
