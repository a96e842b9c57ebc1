"""The compiled stack behind a question: its layers at each wavelength that counts."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.layers.gap import Gap
from clerestory.medium import Medium
from clerestory.panels.optics import ARC_CHORDS, POLARISATIONS, WINDOW_PIECES, checked_tolerance, exact_optics
from clerestory.panels.panel import Panel
from clerestory.panels.wavelengths import Samples, samples
from clerestory.rules import one_of

if TYPE_CHECKING:
    from clerestory.glazing import Glazing, Stack


def stack_optics(
    stack: Stack, *, wavelength_nm: float | None, polarisation: str, tolerance: float
) -> tuple[_native.Stack, Samples]:
    """The stack at one wavelength, or at those that stand for daylight as the eye weighs it.

    Each wavelength goes through all layers by itself: the mean of products is not the product of means.

    Raises
    ------
    ClerestoryError
        If the wavelength is outside the range of a medium, or a layer spreads light.
    """
    one_of("polarisation", polarisation, POLARISATIONS)
    checked_tolerance(tolerance)
    at = samples(_media(stack), wavelength_nm)
    wavelengths = at.wavelength_nm or (None,)
    spectrum = [[_layer(layer, w, polarisation, tolerance) for layer in stack.glazings] for w in wavelengths]
    return _native.Stack(spectrum, weights=list(at.weights), is_resolved=polarisation == "resolved"), at


def refuse_rough(stack: Stack) -> None:
    """Raises if a layer has no exact lobes."""
    for index, layer in enumerate(stack.glazings):
        if isinstance(layer, Panel) and not layer.native_profile.is_smooth:
            raise ClerestoryError(
                f"layers[{index}] must have smooth and clear cuts to be followed exactly, got {layer!r}; "
                "combine BSDFs of the layers, or use the stack in a room, which draws rays"
            )
        nested = getattr(layer, "glazings", None)
        if nested is not None:
            refuse_rough(layer)  # type: ignore[arg-type]


def stack_described(stack: Stack) -> str:
    """The layers as JSON, gaps among them."""
    from clerestory.glazing_table import write_glazing

    def described(layer: Any) -> Any:
        if isinstance(layer, Gap):
            return {"kind": "gap", "width_mm": layer.width_mm, "gas": layer.gas}
        try:
            return write_glazing(layer, described)
        except ClerestoryError:
            return repr(layer)

    return json.dumps([described(layer) for layer in stack.layers])


def layer_name(layer: Glazing) -> str:
    """A word for a layer in a table."""
    return layer.kind if isinstance(layer, Panel) else type(layer).__name__


def _media(stack: Stack) -> tuple[Medium, ...]:
    from clerestory.glazing import Stack

    media: tuple[Medium, ...] = ()
    for layer in stack.glazings:
        if isinstance(layer, Panel):
            media += tuple(layer.media)
        elif isinstance(layer, Stack):
            media += _media(layer)
    return media


def _layer(layer: Glazing, wavelength_nm: float | None, polarisation: str, tolerance: float) -> _native.Glazing:
    from clerestory.glazing import Stack

    if isinstance(layer, Panel):
        # within a panel polarisation is always resolved; the word is about what goes from layer to layer
        optics, _ = exact_optics(
            layer,
            wavelength_nm=wavelength_nm,
            polarisation="resolved",
            tolerance=tolerance,
            arc_chords=ARC_CHORDS,
            most_pieces=WINDOW_PIECES,
        )
        return optics.glazing()
    if isinstance(layer, Stack):
        return stack_optics(layer, wavelength_nm=wavelength_nm, polarisation=polarisation, tolerance=tolerance)[
            0
        ].glazing()
    return layer.glazing()
