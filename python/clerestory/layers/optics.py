"""The compiled stack behind a question: its layers at each wavelength that counts."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.layers.gap import Gap
from clerestory.medium import Medium
from clerestory.panels.optics import ARC_CHORDS, POLARISATIONS, WINDOW_PIECES, checked_tolerance
from clerestory.panels.panel import Panel
from clerestory.panels.wavelengths import Samples, samples
from clerestory.rules import one_of

if TYPE_CHECKING:
    from clerestory.glazing import Glazing, Stack


def stack_optics(
    stack: Stack, *, wavelength_nm: float | None, polarisation: str, tolerance: float
) -> tuple[_native.Stack, Samples]:
    """The stack at one wavelength, or at those that stand for daylight as the eye weighs it.

    Raises
    ------
    ClerestoryError
        If the wavelength is outside the range of a medium, or a layer spreads light.
    """
    one_of("polarisation", polarisation, POLARISATIONS)
    checked_tolerance(tolerance)
    at = samples(stack_media(stack), wavelength_nm)
    how = How(polarisation == "resolved", tolerance, WINDOW_PIECES)
    return stack_at(stack, at, how), at


@dataclass(frozen=True)
class How:
    """How closely light is followed: polarisation between layers, share left over in a panel, pieces followed there."""

    is_resolved: bool
    tolerance: float
    most_pieces: int


def stack_at(stack: Stack, at: Samples, how: How) -> _native.Stack:
    """The stack with its media (:func:`stack_media`) as given at each of several wavelengths.

    Each wavelength goes through all layers by itself: the mean of products is not the product of means.
    """
    spectrum = [_layers(stack, at, row, how) for row in range(len(at.weights))]
    return _native.Stack(spectrum, weights=list(at.weights), is_resolved=how.is_resolved)


def stack_media(stack: Stack) -> tuple[Medium, ...]:
    """The media of all panels among the layers, in their order."""
    from clerestory.glazing import Stack

    media: tuple[Medium, ...] = ()
    for layer in stack.glazings:
        if isinstance(layer, Panel):
            media += tuple(layer.media)
        elif isinstance(layer, Stack):
            media += stack_media(layer)
    return media


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


def _layers(stack: Stack, at: Samples, row: int, how: How) -> list[_native.Glazing]:
    from clerestory.glazing import Stack

    found, column = [], 0
    for layer in stack.glazings:
        if isinstance(layer, Panel | Stack):
            # its columns of the table of media
            count = len(layer.media if isinstance(layer, Panel) else stack_media(layer))
            own = slice(column, column + count)
            column += count
            one = Samples((), (1.0,), at.n[row : row + 1, own], at.absorption_per_mm[row : row + 1, own])
            found.append(_panel(layer, one, how) if isinstance(layer, Panel) else stack_at(layer, one, how).glazing())
        else:
            found.append(layer.glazing())
    return found


def _panel(panel: Panel, at: Samples, how: How) -> _native.Glazing:
    """A panel, within which polarisation is always resolved: the word is about what goes from layer to layer."""
    profile = panel.native_profile
    if profile.is_smooth and not profile.is_straight:
        profile = profile.flattened(ARC_CHORDS)
    return _native.PanelOptics(
        profile,
        n=np.ascontiguousarray(at.n),
        absorption_per_mm=np.ascontiguousarray(at.absorption_per_mm),
        weights=np.ones(1),
        polarisation="resolved",
        tolerance=how.tolerance,
        most_pieces=how.most_pieces,
    ).glazing()
