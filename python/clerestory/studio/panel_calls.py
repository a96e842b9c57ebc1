"""Questions about a panel: answered at once, or as jobs."""

from __future__ import annotations

import tempfile
import tomllib
from pathlib import Path
from typing import Any

import tomli_w
from starlette.requests import Request
from starlette.routing import Route

from clerestory.errors import ClerestoryError
from clerestory.panels import Panel, panel_from_dict
from clerestory.studio.panel_answers import lobes_of, section_of
from clerestory.studio.panel_kinds import media, panel_kinds
from clerestory.studio.requests import Asked, asking, known, needed, table

_INCIDENCE = ("elevation_deg", "azimuth_deg", "wavelength_nm")


def asked_panel(asked: Asked) -> Panel:
    """The panel of a request, checked by its own dataclass."""
    return panel_from_dict(table(asked, "panel"))


def _incidence(asked: Asked) -> dict[str, Any]:
    given = {name: asked[name] for name in _INCIDENCE if asked.get(name) is not None}
    return {"elevation_deg": needed(asked, "elevation_deg"), "azimuth_deg": 0.0} | given


def section(_: Request, asked: Asked) -> dict[str, Any]:
    """The section of a panel with the beams of one slice of light."""
    known(asked, ("panel", *_INCIDENCE))
    return section_of(asked_panel(asked), **_incidence(asked))


def lobes(_: Request, asked: Asked) -> dict[str, Any]:
    """The beams that leave a panel, and how the light divides."""
    known(asked, ("panel", *_INCIDENCE, "side"))
    return lobes_of(asked_panel(asked), side=asked.get("side", "front"), **_incidence(asked))


def to_toml(_: Request, asked: Asked) -> dict[str, Any]:
    """A panel as the text of its file, which ``clerestory panel FILE.toml`` and ``read_panel`` read."""
    known(asked, ("panel",))
    return {"text": tomli_w.dumps(asked_panel(asked).to_dict())}


def from_toml(_: Request, asked: Asked) -> dict[str, Any]:
    """A panel from the text of its file."""
    known(asked, ("text",))
    text = needed(asked, "text")
    if not isinstance(text, str):
        raise ClerestoryError(f"text must be that of a TOML file, got {type(text).__name__}")
    try:
        values = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ClerestoryError(f"text must be that of a TOML file: {error}") from None
    return {"panel": panel_from_dict(values).to_dict()}


def kinds(_: Request, asked: Asked) -> dict[str, Any]:
    """The kinds of panels with their sliders, and the media."""
    known(asked, ())
    return {"kinds": panel_kinds(), "media": media()}


def xml_of(bsdf: Any) -> bytes:
    """The bytes of a BSDF's XML."""
    with tempfile.TemporaryDirectory(prefix="clerestory-") as folder:
        written: bytes = bsdf.to_xml(Path(folder) / "bsdf.xml").read_bytes()
    return written


ROUTES = [
    Route("/api/panel/kinds", asking(kinds), methods=["POST"]),
    Route("/api/panel/section", asking(section), methods=["POST"]),
    Route("/api/panel/lobes", asking(lobes), methods=["POST"]),
    Route("/api/panel/toml", asking(to_toml), methods=["POST"]),
    Route("/api/panel/read", asking(from_toml), methods=["POST"]),
]
