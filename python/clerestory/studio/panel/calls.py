"""Questions about a panel: answered at once, or as jobs."""

from __future__ import annotations

from typing import Any

import tomli_w
from starlette.requests import Request

from clerestory.panels import Panel, panel_from_dict
from clerestory.studio.doors.fields import Field
from clerestory.studio.doors.requests import Asked, call
from clerestory.studio.doors.shapes import FLAG, INTEGER, NUMBER, TABLE, TEXT, listed, maybe, record, word
from clerestory.studio.panel.answers import lobes_of, section_of
from clerestory.studio.panel.drawn import panel_of
from clerestory.studio.panel.kinds import media, panel_kinds, presets
from clerestory.studio.toml_kinds import toml_of

#: The panel of a question.
PANEL = Field(
    TABLE,
    "A panel: its `kind` and the arguments of that kind by name, as in its TOML file",
    example={"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 6.0},
)
ELEVATION = Field(NUMBER, "Elevation that the light comes from, above positive [°, -90..90]", example=40.0)
AZIMUTH = Field(NUMBER, "Azimuth that the light comes from, about the upright [°, -90..90]", 0.0)
SIDE = Field(word("front", "back"), "Side that the light meets", "front")
_INCIDENCE = {
    "panel": PANEL,
    "elevation_deg": ELEVATION,
    "azimuth_deg": AZIMUTH,
    "side": SIDE,
    "wavelength_nm": Field(NUMBER, "Wavelength [nm]; without it the panel's own, for visible light", None),
}
_LOBE = record(
    {
        "power": NUMBER,
        "side": word("front", "back"),
        "elevation_deg": NUMBER,
        "azimuth_deg": NUMBER,
        "total_reflections": INTEGER,
        "direction": listed(NUMBER, least=3, most=3),
    }
)
#: How light divides, by the names of :meth:`Panel.angular`.
SHARES = (
    "transmittance",
    "reflectance",
    "absorptance",
    "transmittance_deflected",
    "transmittance_undeflected",
    "residual",
)
_OUTLINES = listed(listed(listed(NUMBER, least=2, most=2)))
_STRIP = record(
    {
        "corners": listed(listed(NUMBER, least=2, most=2), least=4, most=4),
        "power": NUMBER,
        "total_reflections": INTEGER,
        "leaves": FLAG,
    }
)
_SECTION = record(
    dict.fromkeys(("pitch_mm", "front_mm", "back_mm", "low_mm", "high_mm"), NUMBER)
    | dict.fromkeys(("solids", "films", "surfaces"), _OUTLINES)
    | {"is_smooth": FLAG, "strips": listed(_STRIP)}
)
_SLIDER = record(
    {
        "name": TEXT,
        "low": NUMBER,
        "high": NUMBER,
        "step": NUMBER,
        "unit": TEXT,
        "start": maybe(NUMBER),
        "sets": NUMBER,
        "group": TEXT,
        "repeats": FLAG,
    }
)
_CHOICE = record({"name": TEXT, "words": listed(TEXT), "start": TEXT, "group": TEXT})
_KIND = record(
    {
        "kind": TEXT,
        "sliders": listed(_SLIDER),
        "choices": listed(_CHOICE),
        "texts": listed(record({"name": TEXT, "source": TEXT, "start": TEXT})),
        "medium": TEXT,
    }
)
_KINDS = record(
    {
        "kinds": listed(_KIND),
        "media": listed(TEXT),
        "presets": listed(record({"name": TEXT, "group": TEXT, "panel": TABLE})),
    }
)
_ALL_SHARES = record(dict.fromkeys(SHARES, NUMBER))
_LOBES = record(
    {
        "lobes": listed(_LOBE),
        "count": INTEGER,
        "shares": _ALL_SHARES,
        "standard_errors": maybe(_ALL_SHARES),
        "rays": maybe(INTEGER),
        "is_full": FLAG,
        "is_smooth": FLAG,
    }
)


def asked_panel(request: Request, asked: Asked) -> Panel:
    """The panel of a request, checked by its own dataclass."""
    return panel_of(asked["panel"], request.app.state.settings.folder)


def section(request: Request, asked: Asked) -> dict[str, Any]:
    """The section of a panel with the beams of one slice of light."""
    return section_of(asked_panel(request, asked), **{name: asked[name] for name in asked if name != "panel"})


def lobes(request: Request, asked: Asked) -> dict[str, Any]:
    """The beams that leave a panel, and how the light divides."""
    return lobes_of(asked_panel(request, asked), **{name: asked[name] for name in asked if name != "panel"})


def to_toml(request: Request, asked: Asked) -> dict[str, Any]:
    """A panel as the text of its file, which `clerestory panel FILE.toml` and `read_panel` read."""
    return {"text": tomli_w.dumps(asked_panel(request, asked).to_dict())}


def from_toml(_: Request, asked: Asked) -> dict[str, Any]:
    """A panel from the text of its file."""
    return {"panel": panel_from_dict(toml_of(asked["text"])).to_dict()}


def kinds(_: Request, asked: Asked) -> dict[str, Any]:
    """The kinds of panels with their sliders, the media, and panels to start from."""
    return {"kinds": panel_kinds(), "media": media(), "presets": presets()}


ROUTES = [
    call("/api/panel/kinds", kinds, {}, gives=_KINDS),
    call("/api/panel/section", section, _INCIDENCE, gives=_SECTION),
    call(
        "/api/panel/lobes",
        lobes,
        {
            **_INCIDENCE,
            "detail": Field(word("full", "quick"), "All beams, or an answer at once, if need be by rays", "full"),
            "most": Field(INTEGER, "Lobes in the answer at most, the strongest", None),
        },
        gives=_LOBES,
    ),
    call("/api/panel/toml", to_toml, {"panel": PANEL}, gives=record({"text": TEXT})),
    call(
        "/api/panel/read",
        from_toml,
        {"text": Field(TEXT, "Text of a panel's TOML file", example='kind = "pane"\nthickness_mm = 4.0\n')},
        gives=record({"panel": TABLE}),
    ),
]
