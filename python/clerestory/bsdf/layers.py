"""Klems matrices one behind the other: all reflections between them, and what each layer absorbs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from clerestory.bsdf.band import Band
from clerestory.bsdf.bsdf import BANDS, Bsdf
from clerestory.bsdf.completing import complete
from clerestory.bsdf.klems import Floats, KlemsBasis, klems_basis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.rebasing import in_basis
from clerestory.errors import ClerestoryError


@dataclass(frozen=True, eq=False)
class LayeredBand:
    """Layers in one band of wavelengths.

    Attributes
    ----------
    band : Band
        The four blocks of all layers together, Klems matrices of one basis.
    absorptance_front, absorptance_back : ndarray, shape (layer, incident patch) [0..1]
        Share of the light arriving on the whole stack in each patch that each layer absorbs, the outermost layer first.
    """

    band: Band
    absorptance_front: Floats
    absorptance_back: Floats


@dataclass(frozen=True, eq=False)
class LayeredBsdf:
    """Layers as one BSDF, and what each of them absorbs.

    Attributes
    ----------
    bsdf : Bsdf
        Of all layers together, in the bands that every layer has.
    bands : dict of str to LayeredBand
        The same with absorptances, by name of the band.
    """

    bsdf: Bsdf
    bands: dict[str, LayeredBand]


def layered_band(bands: Sequence[Band], *, basis: str | KlemsBasis = "klems_full") -> LayeredBand:
    """Layers combined with all reflections between them.

    Parameters
    ----------
    bands : sequence of Band
        Of one layer each, the outermost first. Trees and other bases are brought to ``basis``; a block that is missing
        is filled as in files (by reciprocity or as zero, told as a warning).
    basis : str or KlemsBasis, default "klems_full"

    Returns
    -------
    LayeredBand

    Raises
    ------
    ClerestoryError
        If there is no layer, or no basis has that name.

    Notes
    -----
    theory/layers.md, eqs. 8 to 10; J. H. Klems, ASHRAE Transactions 100(1), 1994.
    """
    if not bands:
        raise ClerestoryError("layers must be at least one, got none; give the outermost first")
    rings = klems_basis(basis)
    layers = [_Blocks.of(band, rings) for band in bands]
    before, behind = [layers[0]], [layers[-1]]
    for layer in layers[1:]:
        before.append(before[-1].then(layer))
    for layer in layers[-2::-1]:
        behind.insert(0, layer.then(behind[0]))
    whole = before[-1]
    front, back = [], []
    nothing, all_of_it = np.zeros((len(rings),) * 2), np.eye(len(rings))
    for i, layer in enumerate(layers):
        # light from outside: on its way in before this layer, and back behind it; then light from the room
        inward, returning = all_of_it, nothing
        outward, turned = all_of_it, nothing
        if i > 0:
            inward = before[i - 1].onward(behind[i])
            turned = before[i - 1].reflected_back(behind[i].outward(before[i - 1]))
        if i + 1 < len(layers):
            returning = behind[i + 1].reflected_front(before[i].onward(behind[i + 1]))
            outward = behind[i + 1].outward(before[i])
        front.append(layer.kept_front @ inward + layer.kept_back @ returning)
        back.append(layer.kept_back @ outward + layer.kept_front @ turned)
    return LayeredBand(whole.band(), np.array(front), np.array(back))


def layered_bsdf(
    layers: Sequence[Bsdf], *, basis: str | KlemsBasis = "klems_full", name: str | None = None, gaps_mm: float = 0.0
) -> LayeredBsdf:
    """BSDFs of layers combined into one.

    Parameters
    ----------
    layers : sequence of Bsdf
        The outermost first.
    basis : str or KlemsBasis, default "klems_full"
    name : str, optional
        By default the names of the layers.
    gaps_mm : float, default 0 [mm]
        Of all gaps together: part of the thickness.

    Returns
    -------
    LayeredBsdf
        In the bands that all layers have; the thickness is known if that of every layer is.

    Raises
    ------
    ClerestoryError
        If there is no layer, or no basis has that name.
    """
    if not layers:
        raise ClerestoryError("layers must be at least one, got none; give the outermost first")
    bands: dict[str, LayeredBand] = {}
    for word in BANDS:
        of_layers = [getattr(layer, word) for layer in layers]
        if all(band is not None for band in of_layers):
            bands[word] = layered_band(of_layers, basis=basis)
    thickness = [layer.thickness_mm for layer in layers if layer.thickness_mm is not None]
    known = len(thickness) == len(layers)
    bsdf = Bsdf(
        name=name or " + ".join(layer.name for layer in layers),
        thickness_mm=sum(thickness) + gaps_mm if known else None,
        attrs={"layers": ", ".join(layer.name for layer in layers)},
        visible=bands["visible"].band,
        solar=bands["solar"].band if "solar" in bands else None,
        x=bands["x"].band if "x" in bands else None,
        z=bands["z"].band if "z" in bands else None,
    )
    return LayeredBsdf(bsdf, bands)


@dataclass(frozen=True, eq=False)
class _Blocks:
    """Four matrices [1/sr] of one basis, (outgoing, incident), and its projected solid angles [sr]."""

    transmission_front: Floats
    transmission_back: Floats
    reflection_front: Floats
    reflection_back: Floats
    rings: KlemsBasis

    @classmethod
    def of(cls, band: Band, rings: KlemsBasis) -> _Blocks:
        blocks = dict(complete(band, "a layer", stacklevel=5))
        return cls(**{name: in_basis(block, rings).values for name, block in blocks.items()}, rings=rings)

    @property
    def solid(self) -> Floats:
        return self.rings.projected_solid_angle

    def band(self) -> Band:
        blocks = (self.transmission_front, self.transmission_back, self.reflection_front, self.reflection_back)
        return Band(*(KlemsBlock(np.maximum(values, 0.0), self.rings, self.rings) for values in blocks))

    @property
    def kept_front(self) -> Floats:
        """Share of light from outside that is absorbed, by incident patch."""
        return np.asarray(1.0 - self.solid @ (self.transmission_front + self.reflection_front))

    @property
    def kept_back(self) -> Floats:
        return np.asarray(1.0 - self.solid @ (self.transmission_back + self.reflection_back))

    def then(self, inner: _Blocks) -> _Blocks:
        """This and what lies behind it, light between them reflected to and fro (theory/layers.md, eq. 8)."""
        inward, outward = self.onward(inner), inner.outward(self)
        return _Blocks(
            inner.transmission_front @ inward,
            self.transmission_back @ outward,
            self.reflection_front + self.transmission_back @ inner.reflected_front(inward),
            inner.reflection_back + inner.transmission_front @ self.reflected_back(outward),
            self.rings,
        )

    def onward(self, inner: _Blocks) -> Floats:
        """Irradiances going inward between this and ``inner``, for light from outside (theory/layers.md, eq. 9)."""
        to_and_fro = (self.reflection_back * self.solid) @ (inner.reflection_front * self.solid)
        radiance = np.linalg.solve(np.eye(len(self.rings)) - to_and_fro, self.transmission_front)
        return np.asarray(self.solid[:, None] * radiance)

    def outward(self, outer: _Blocks) -> Floats:
        """Irradiances that travel outward between ``outer`` and this, of light from the room."""
        to_and_fro = (self.reflection_front * self.solid) @ (outer.reflection_back * self.solid)
        radiance = np.linalg.solve(np.eye(len(self.rings)) - to_and_fro, self.transmission_back)
        return np.asarray(self.solid[:, None] * radiance)

    def reflected_front(self, irradiance: Floats) -> Floats:
        """Irradiances that this sends back of those that arrive on its front."""
        return np.asarray(self.solid[:, None] * (self.reflection_front @ irradiance))

    def reflected_back(self, irradiance: Floats) -> Floats:
        return np.asarray(self.solid[:, None] * (self.reflection_back @ irradiance))
