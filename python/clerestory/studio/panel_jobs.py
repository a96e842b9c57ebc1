"""The long jobs about a panel, as they are asked for."""

from __future__ import annotations

from typing import Any

from starlette.requests import Request

from clerestory.bsdf import Bsdf
from clerestory.bsdf.klems import KLEMS_BASES
from clerestory.studio.bsdf_shelf import Opened
from clerestory.studio.fields import Field
from clerestory.studio.job_kinds import Kind
from clerestory.studio.klems_key import klems_key
from clerestory.studio.panel_calls import AZIMUTH, ELEVATION, PANEL, SIDE, asked_panel
from clerestory.studio.requests import Asked
from clerestory.studio.shapes import word


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


_INCIDENCE = {"panel": PANEL, "elevation_deg": ELEVATION, "azimuth_deg": AZIMUTH, "side": SIDE}
KINDS: dict[str, Kind] = {
    "angular": Kind({"panel": PANEL, "azimuth_deg": AZIMUTH, "side": SIDE}, _of_panel, ends_alone=True),
    "walk": Kind(
        {"panel": PANEL, "elevation_deg": ELEVATION, "azimuth_deg": AZIMUTH, "side": SIDE}, _of_panel, ends_alone=True
    ),
    "dispersion": Kind(
        {"panel": PANEL, "elevation_deg": ELEVATION, "azimuth_deg": AZIMUTH, "side": SIDE}, _of_panel, ends_alone=True
    ),
    "klems": Kind(
        {
            "panel": PANEL,
            "basis": Field(word(*KLEMS_BASES), "Patches of the hemisphere", KLEMS_BASES[0]),
            "accuracy": Field(word("fine", "rays"), "As closely as a file needs it, or by random draws", "fine"),
        },
        _of_panel,
        _shelved,
        _partly_shelved,
        is_slow=True,
        ends_alone=True,
    ),
}
