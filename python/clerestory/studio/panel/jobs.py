"""The long jobs about a panel, as they are asked for."""

from __future__ import annotations

from typing import Any

from starlette.requests import Request

from clerestory.bsdf import Bsdf
from clerestory.bsdf.klems import KLEMS_BASES
from clerestory.studio.bsdf.klems_key import klems_key
from clerestory.studio.bsdf.shelf import Opened
from clerestory.studio.doors.fields import Field
from clerestory.studio.doors.requests import Asked
from clerestory.studio.doors.shapes import INTEGER, NUMBER, TEXT, Shape, listed, maybe, record, word
from clerestory.studio.jobs.kinds import Kind
from clerestory.studio.panel.calls import AZIMUTH, ELEVATION, PANEL, SHARES, SIDE, asked_panel


def _of_panel(request: Request, asked: Asked) -> Asked:
    return {**asked, "panel": asked_panel(request, asked).to_dict()}


def _shelved(state: Any, bsdf: Bsdf) -> dict[str, Any]:
    """Keeps a BSDF beside those that were opened."""
    return {"key": state.shelf.put(klems_key(bsdf), Opened(bsdf))}


def _partly_shelved(state: Any, _: Asked, partial: dict[str, Any]) -> dict[str, Any]:
    bsdf = partial.pop("bsdf", None)
    if bsdf is not None:
        state.shelf.put(partial["key"], Opened(bsdf))
    return partial


_ANGULAR_FIELDS = {"panel": PANEL, "azimuth_deg": AZIMUTH, "side": SIDE}
_INCIDENCE = {"panel": PANEL, "elevation_deg": ELEVATION, "azimuth_deg": AZIMUTH, "side": SIDE}
_KLEMS_FIELDS = {
    "panel": PANEL,
    "basis": Field(word(*KLEMS_BASES), "Patches of the hemisphere", KLEMS_BASES[0]),
    "accuracy": Field(word("fine", "rays"), "As closely as a file needs it, or by random draws", "fine"),
}

_COLUMN = listed(maybe(NUMBER))
#: Columns of a table over elevation; those of rays have standard errors, those of beams what was not followed.
_TABLE = record(
    {"elevation_deg": listed(NUMBER)},
    also=dict.fromkeys((*SHARES, *(f"{name}_standard_error" for name in SHARES)), _COLUMN),
)
_EACH_SHARE = record(dict.fromkeys(SHARES, NUMBER))
_WALKED = record(
    {
        "shares": _EACH_SHARE,
        "standard_errors": _EACH_SHARE,
        "rays": INTEGER,
        "distribution": record(dict.fromkeys(("edges_deg", "front", "back"), listed(NUMBER))),
        "share_done": NUMBER,
    }
)
_BEAM = record(
    {
        "wavelength_nm": NUMBER,
        "elevation_deg": NUMBER,
        "azimuth_deg": NUMBER,
        "power": NUMBER,
        "side": word("front", "back"),
    }
)
_BEAMS = record({"beams": listed(_BEAM)})
_BSDF_KEY: Shape = {**TEXT, "description": "Of a BSDF that is open, as far as it is known"}
_STAGE = record(
    {},
    also={
        "key": _BSDF_KEY,
        "stage": word("rays", "fine"),
        "left_s": {**NUMBER, "description": "About how long it still takes [s]"},
    },
)
KINDS: dict[str, Kind] = {
    "angular": Kind(_ANGULAR_FIELDS, _of_panel, _TABLE, _TABLE, ends_alone=True),
    "walk": Kind(_INCIDENCE, _of_panel, _WALKED, _WALKED, ends_alone=True),
    "dispersion": Kind(_INCIDENCE, _of_panel, _BEAMS, _BEAMS, ends_alone=True),
    "klems": Kind(
        _KLEMS_FIELDS,
        _of_panel,
        _STAGE,
        record({"key": _BSDF_KEY}),
        _shelved,
        _partly_shelved,
        is_slow=True,
        ends_alone=True,
    ),
}
