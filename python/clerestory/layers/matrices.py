"""A stack as a BSDF: averaged from beams where all layers have them, multiplied matrices where one spreads light."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from clerestory.bsdf.bsdf import Bsdf
from clerestory.bsdf.klems import KLEMS_BASES
from clerestory.bsdf.of_glazing import MOST_PIECES, Averaging, _of_bands, bsdf_of
from clerestory.bsdf.wavebands import band_samples
from clerestory.errors import ClerestoryError
from clerestory.glazing import Glazing, Stack
from clerestory.layers.optics import How, stack_at, stack_media
from clerestory.panels.optics import POLARISATIONS, checked_tolerance, whole
from clerestory.panels.panel import Panel
from clerestory.rules import one_of

if TYPE_CHECKING:
    from clerestory.bsdf.layers import LayeredBsdf


def spreads(layer: Glazing) -> bool:
    """Whether light leaves a layer other than in beams that can be followed."""
    if isinstance(layer, Stack):
        return any(spreads(each) for each in layer.glazings)
    if isinstance(layer, Panel):
        return not layer.native_profile.is_smooth
    return layer.glazing().spreads


def stack_bsdf(
    stack: Stack,
    averaging: Averaging,
    *,
    bands: Sequence[str],
    wavelengths: int,
    polarisation: str,
    tolerance: float,
    name: str | None,
    manufacturer: str,
) -> Bsdf:
    """What :meth:`Stack.bsdf` returns."""
    if any(spreads(layer) for layer in stack.glazings):
        if averaging.rank is not None:
            raise ClerestoryError(
                f"rank must be left out where a layer spreads light, got {averaging.rank}; layers combine as matrices"
            )
        whole_stack = layered_stack(stack, basis=averaging.basis, bands=bands, wavelengths=wavelengths).bsdf
        return replace(whole_stack, name=name or whole_stack.name, manufacturer=manufacturer)
    one_of("polarisation", polarisation, POLARISATIONS)
    how = How(polarisation == "resolved", checked_tolerance(tolerance), MOST_PIECES)
    media = stack_media(stack)
    return _of_bands(
        lambda band: band_samples(media, band, whole("wavelengths", wavelengths, 1)),
        lambda at: stack_at(stack, at, how).glazing(),
        averaging,
        bands,
        name=name or _name(stack),
        manufacturer=manufacturer,
        thickness_mm=_thickness_mm(stack),
        exact=stack,
    )


def layered_stack(
    stack: Stack, *, basis: str, bands: Sequence[str] = ("visible",), wavelengths: int = 1
) -> LayeredBsdf:
    """The layers of a stack as matrices, combined, and what each absorbs (:class:`~clerestory.bsdf.LayeredBsdf`)."""
    from clerestory.bsdf.layers import layered_bsdf

    one_of("basis", basis, KLEMS_BASES)
    layers = [_layer(layer, basis, bands, wavelengths) for layer in stack.glazings]
    gaps_mm = sum(gap.width_mm for gap in stack.gaps if gap is not None)
    return layered_bsdf(layers, basis=basis, name=_name(stack), gaps_mm=gaps_mm)


def _layer(layer: Glazing, basis: str, bands: Sequence[str], wavelengths: int) -> Bsdf:
    if isinstance(layer, Bsdf):
        return layer
    if isinstance(layer, Panel | Stack):
        how: dict[str, Any] = {"basis": basis, "bands": bands, "wavelengths": wavelengths}
        return layer.bsdf(**how)
    return bsdf_of(layer, basis=basis)


def _name(stack: Stack) -> str:
    return " + ".join(getattr(layer, "name", None) or type(layer).__name__ for layer in stack.glazings)


def _thickness_mm(stack: Stack) -> float | None:
    """Of the whole, if it is known of every layer."""
    sizes = [gap.width_mm for gap in stack.gaps if gap is not None]
    for layer in stack.glazings:
        if isinstance(layer, Stack):
            size = _thickness_mm(layer)
        elif isinstance(layer, Panel):
            low, high = layer.native_profile.depth_range_mm
            size = high - low
        else:
            size = getattr(layer, "thickness_mm", None)
        if size is None:
            return None
        sizes.append(size)
    return sum(sizes)
