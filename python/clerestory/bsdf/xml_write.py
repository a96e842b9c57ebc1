"""LBNL's XML, written so that Radiance, WINDOW and EnergyPlus's tools read it."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

import numpy as np

from clerestory._native import __version__
from clerestory.bsdf.band import Band
from clerestory.bsdf.bsdf import BANDS
from clerestory.bsdf.completing import complete, words
from clerestory.bsdf.klems import KlemsBasis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.told import BsdfWarning
from clerestory.bsdf.tree_block import TreeBlock
from clerestory.errors import ClerestoryError
from clerestory.saving import write_text

if TYPE_CHECKING:
    import os
    from pathlib import Path

    from clerestory.bsdf.band import Block
    from clerestory.bsdf.bsdf import Bsdf

NAMES = {"visible": "Visible", "solar": "Solar", "x": "CIE-X", "z": "CIE-Z"}
"""What LBNL's files call each band."""

#: Source and detector of each band, as LBNL's programs call them.
_SPECTRA = {
    "visible": ("CIE Illuminant D65 1nm.ssp", "ASTM E308 1931 Y.dsp"),
    "solar": ("CIE Illuminant D65 1nm.ssp", "None"),
    "x": ("CIE Illuminant D65 1nm.ssp", "ASTM E308 1931 X.dsp"),
    "z": ("CIE Illuminant D65 1nm.ssp", "ASTM E308 1931 Z.dsp"),
}

MATERIAL = {
    "conductivity_w_mk": "ThermalConductivity",
    "emissivity_front": "EmissivityFront",
    "emissivity_back": "EmissivityBack",
    "transmittance_infrared": "TIR",
}
"""Entries of ``Bsdf.attrs`` that the file has a place for, and the names of those."""

_HEAD = (
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<WindowElement xmlns="http://windows.lbl.gov" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" '
    'xsi:schemaLocation="http://windows.lbl.gov/BSDF-v1.4.xsd">',
)


def write_xml(bsdf: Bsdf, path: str | os.PathLike[str]) -> Path:
    """What :meth:`Bsdf.to_xml` does."""
    return write_text(path, xml_text(bsdf))


def xml_text(bsdf: Bsdf) -> str:
    """The file's text; the same BSDF makes the same text.

    Raises
    ------
    ClerestoryError
        If the thickness is unknown, or the bands are of different kinds.
    """
    if bsdf.thickness_mm is None:
        raise ClerestoryError("thickness_mm must be given to write XML, got None; dataclasses.replace(bsdf, …) adds it")
    bands = {}
    for name, band in bsdf.bands:
        bands[name] = complete(band, f"{name} of {bsdf.name!r}", stacklevel=6)
    if "solar" not in bands:
        warnings.warn(
            f"{bsdf.name!r} has no solar band: the visible one is written in its place, as some readers need it",
            BsdfWarning,
            stacklevel=5,
        )
        bands["solar"] = bands["visible"]
    if len({(band.is_tree, getattr(next(iter(band))[1], "rank", 0)) for band in bands.values()}) > 1:
        raise ClerestoryError("bands must be all Klems matrices or all trees of one rank in one file; convert some")
    return "\n".join(_lines(bsdf, bands)) + "\n"


def _lines(bsdf: Bsdf, bands: dict[str, Band]) -> Iterator[str]:
    yield from _HEAD
    yield f"<!-- Written by Clerestory {__version__}. Front is the outside. -->"
    yield "<WindowElementType>System</WindowElementType>"
    yield "<FileType>BSDF</FileType>"
    yield "<Optical>"
    yield "<Layer>"
    yield "\t<Material>"
    yield f"\t\t<Name>{_plain(bsdf.name)}</Name>"
    yield f"\t\t<Manufacturer>{_plain(bsdf.manufacturer)}</Manufacturer>"
    yield f'\t\t<Thickness unit="Millimeter">{bsdf.thickness_mm:.9g}</Thickness>'
    yield "\t\t<DeviceType>Other</DeviceType>"
    for name, element in MATERIAL.items():
        if isinstance(bsdf.attrs.get(name), (int, float)):
            yield f"\t\t<{element}>{bsdf.attrs[name]:.9g}</{element}>"
    yield "\t</Material>"
    yield "\t<DataDefinition>"
    blocks = [block for band in bands.values() for _, block in band]
    rank = next((block.rank for block in blocks if isinstance(block, TreeBlock)), None)
    yield f"\t\t<IncidentDataStructure>{'Columns' if rank is None else f'TensorTree{rank}'}</IncidentDataStructure>"
    for basis in _bases(blocks):
        yield from _angle_basis(basis)
    yield "\t</DataDefinition>"
    for name in BANDS:
        if name in bands:
            for direction, block in bands[name]:
                yield from _data(name, direction, block)
    yield "</Layer>"
    yield "</Optical>"
    yield "</WindowElement>"


def _plain(text: str) -> str:
    """Text of one line, without what XML gives a meaning or cannot hold."""
    return escape("".join(letter for letter in " ".join(text.split()) if letter.isprintable())) or "unspecified"


def _bases(blocks: list[Block]) -> list[KlemsBasis]:
    found: dict[str, KlemsBasis] = {}
    for block in blocks:
        for basis in (block.incident, block.outgoing) if isinstance(block, KlemsBlock) else ():
            if found.setdefault(basis.lbnl_name, basis) != basis:
                raise ClerestoryError(f"basis {basis.name!r} must have the same rings in all blocks; rename one")
    return list(found.values())


def _angle_basis(basis: KlemsBasis) -> Iterator[str]:
    yield "\t\t<AngleBasis>"
    yield f"\t\t\t<AngleBasisName>{_plain(basis.lbnl_name)}</AngleBasisName>"
    for low, high, count in zip(basis.theta_deg, basis.theta_deg[1:], basis.counts, strict=False):
        middle = 0.0 if count == 1 else 0.5 * (low + high)
        yield "\t\t\t<AngleBasisBlock>"
        yield f"\t\t\t\t<Theta>{middle:g}</Theta>"
        yield f"\t\t\t\t<nPhis>{count}</nPhis>"
        yield "\t\t\t\t<ThetaBounds>"
        yield f"\t\t\t\t\t<LowerTheta>{low:.9g}</LowerTheta>"
        yield f"\t\t\t\t\t<UpperTheta>{high:.9g}</UpperTheta>"
        yield "\t\t\t\t</ThetaBounds>"
        yield "\t\t\t</AngleBasisBlock>"
    yield "\t\t</AngleBasis>"


def _data(band: str, direction: str, block: Block) -> Iterator[str]:
    source, detector = _SPECTRA[band]
    yield "\t<WavelengthData>"
    yield "\t\t<LayerNumber>System</LayerNumber>"
    yield f'\t\t<Wavelength unit="Integral">{NAMES[band]}</Wavelength>'
    yield f"\t\t<SourceSpectrum>{source}</SourceSpectrum>"
    yield f"\t\t<DetectorSpectrum>{detector}</DetectorSpectrum>"
    yield "\t\t<WavelengthDataBlock>"
    yield f"\t\t\t<WavelengthDataDirection>{words(direction)}</WavelengthDataDirection>"
    if isinstance(block, KlemsBlock):
        yield f"\t\t\t<ColumnAngleBasis>{_plain(block.incident.lbnl_name)}</ColumnAngleBasis>"
        yield f"\t\t\t<RowAngleBasis>{_plain(block.outgoing.lbnl_name)}</RowAngleBasis>"
    else:
        yield "\t\t\t<AngleBasis>LBNL/Shirley-Chiu</AngleBasis>"
    kind = "BTDF" if direction.startswith("transmission") else "BRDF"
    yield f"\t\t\t<ScatteringDataType>{kind}</ScatteringDataType>"
    yield "\t\t\t<ScatteringData>"
    yield matrix_text(block) if isinstance(block, KlemsBlock) else tree_text(block)
    yield "\t\t\t</ScatteringData>"
    yield "\t\t</WavelengthDataBlock>"
    yield "\t</WavelengthData>"


def matrix_text(block: KlemsBlock) -> str:
    """Values with commas between them, a line for each outgoing patch [1/sr]."""
    return ",\n".join(",".join(_number(value) for value in row) for row in block.values.tolist())


def tree_text(tree: TreeBlock) -> str:
    """Braces within braces, each leaf in its own [1/sr]."""
    lines: list[str] = []
    size, left = 2**tree.rank, [1]
    for value, is_inner in zip(tree.preorder.tolist(), np.isnan(tree.preorder).tolist(), strict=True):
        indent = " " * (len(left) - 1)
        left[-1] -= 1
        if is_inner:
            lines.append(indent + "{")
            left.append(size)
            continue
        lines.append(f"{indent}{{ {_number(value)} }}")
        while len(left) > 1 and left[-1] == 0:
            left.pop()
            lines.append(" " * (len(left) - 1) + "}")
    return "\n".join(lines)


def _number(value: float) -> str:
    return f"{value:.9g}"
