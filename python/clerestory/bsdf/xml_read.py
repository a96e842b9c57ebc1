"""LBNL's XML, read from whichever program wrote it."""

from __future__ import annotations

import hashlib
import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from clerestory.bsdf.band import Band, Block
from clerestory.bsdf.bsdf import Bsdf
from clerestory.bsdf.completing import complete, words
from clerestory.bsdf.klems import KlemsBasis, basis_of_lbnl_name
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.told import BsdfWarning
from clerestory.bsdf.xml_place import Place, root_of, shortened
from clerestory.bsdf.xml_tree import finite, tree_of
from clerestory.bsdf.xml_write import MATERIAL, NAMES
from clerestory.errors import ClerestoryError

#: Share of the incident power that a block may send away: measurements scatter a little beyond 1.
MOST_SHARE = 1.01

_STRUCTURES = ("Columns", "Rows", "TensorTree3", "TensorTree4")
_DIRECTIONS = {
    words(name).casefold(): name
    for name in ("transmission_front", "transmission_back", "reflection_front", "reflection_back")
}
_MILLIMETRES = {
    "millimeter": 1.0,
    "mm": 1.0,
    "centimeter": 10.0,
    "cm": 10.0,
    "meter": 1e3,
    "m": 1e3,
    "inch": 25.4,
    "foot": 304.8,
}


def read_xml(path: str | os.PathLike[str], *, strict: bool = True) -> Bsdf:
    """The BSDF of an XML file; arguments, result and errors as of :func:`clerestory.read_bsdf`."""
    where = Path(path)
    root = root_of(where)
    if root.name != "WindowElement":
        root.wrong("must be WindowElement, as LBNL's programs write it")
    layers = root.need("Optical").all("Layer")
    if not layers:
        root.need("Optical").wrong("must hold a Layer")
    if len(layers) > 1:
        _tell(f"{where} has {len(layers)} layers: the first is read")
    layer = layers[0]
    structure = _structure(layer.need("DataDefinition").need("IncidentDataStructure"))
    bases = {} if structure.startswith("Tensor") else _bases(layer.need("DataDefinition"))
    found: dict[str, dict[str, Block]] = {}
    for data in layer.all("WavelengthData"):
        band = _band(data.need("Wavelength"))
        if band is None:
            continue
        for block in data.all("WavelengthDataBlock"):
            direction = _direction(block.need("WavelengthDataDirection"))
            if direction in found.setdefault(band, {}):
                block.wrong(f"must give each direction of a band once, got {words(direction)} of {NAMES[band]} again")
            found[band][direction] = _block(block, structure, bases, strict)
    if not found.get("visible"):
        layer.wrong("must hold WavelengthData of the wavelength Visible with a WavelengthDataBlock")
    bands: dict[str, Any] = {
        name: complete(_made(layer, blocks), f"{where}: {NAMES[name]}", stacklevel=4)
        for name, blocks in found.items()
        if blocks
    }
    return Bsdf(**_material(layer, where), **bands)


def _tell(text: str) -> None:
    warnings.warn(text, BsdfWarning, stacklevel=4)


def _made(layer: Place, blocks: dict[str, Block]) -> Band:
    try:
        return Band(**blocks)
    except ClerestoryError as cause:
        layer.wrong(f"must hold blocks that go together: {cause}")


def _structure(place: Place) -> str:
    known = {name.casefold(): name for name in _STRUCTURES}
    if place.text.casefold() not in known:
        place.wrong(f"must be one of {', '.join(_STRUCTURES)}, got {shortened(place.text)}")
    return known[place.text.casefold()]


def _band(place: Place) -> str | None:
    known = {name.casefold(): band for band, name in NAMES.items()}
    band = known.get(place.text.casefold())
    if band is None:
        unit = place.element.get("unit", "")
        found = f"{place.file}: {place.path} {shortened(place.text)} {unit}".rstrip()
        _tell(f"{found} is not among {', '.join(NAMES.values())}: left out")
    return band


def _direction(place: Place) -> str:
    wanted = " ".join(place.text.split()).casefold()
    if wanted not in _DIRECTIONS:
        place.wrong(f"must be one of {', '.join(map(words, _DIRECTIONS.values()))}, got {shortened(place.text)}")
    return _DIRECTIONS[wanted]


def _bases(definition: Place) -> dict[str, KlemsBasis]:
    """The bases that a file defines, by the names it gives them; LBNL's own are known."""
    bases = {}
    for place in definition.all("AngleBasis"):
        name = place.need("AngleBasisName").text
        known, rings = basis_of_lbnl_name(name), place.all("AngleBasisBlock")
        if not rings:
            if known is None:
                place.wrong("must hold an AngleBasisBlock for each ring of a basis of its own")
            continue
        edges = [0.0]
        counts = []
        for ring in rings:
            bounds = ring.need("ThetaBounds")
            low, high = bounds.need("LowerTheta").number(), bounds.need("UpperTheta").number()
            if abs(low - edges[-1]) > 1e-6:
                bounds.need("LowerTheta").wrong(f"must be where the ring before it ends ({edges[-1]:g}), got {low:g}")
            edges.append(high)
            count = ring.need("nPhis").number()
            if count != int(count):
                ring.need("nPhis").wrong(f"must be a whole number, got {count:g}")
            counts.append(int(count))
        if abs(edges[-1] - 90.0) < 1e-6:
            edges[-1] = 90.0
        try:
            own = KlemsBasis(" ".join(name.split()) or "own", tuple(edges), tuple(counts))
        except ClerestoryError as cause:
            place.wrong(f"must hold rings of a hemisphere: {cause}")
        if known is not None and (own.theta_deg, own.counts) != (known.theta_deg, known.counts):
            place.wrong(
                f"must have the rings of {known.lbnl_name} ({len(known)} patches) to bear its name, "
                f"got {list(edges)} with {counts}"
            )
        bases[name.casefold()] = known or own
    return bases


def _basis(place: Place, bases: dict[str, KlemsBasis]) -> KlemsBasis:
    basis = bases.get(place.text.casefold()) or basis_of_lbnl_name(place.text)
    if basis is None:
        place.wrong(f"must name a basis of DataDefinition or LBNL's, got {shortened(place.text)}")
    return basis


def _block(place: Place, structure: str, bases: dict[str, KlemsBasis], strict: bool) -> Block:
    data = place.need("ScatteringData")
    if structure.startswith("Tensor"):
        basis = place.find("AngleBasis")
        if basis is not None and basis.text.casefold() != "lbnl/shirley-chiu":
            basis.wrong(f"must be LBNL/Shirley-Chiu for a tree, got {shortened(basis.text)}")
        tree = tree_of(data, int(structure[-1]))
        if strict:
            _in_range(data, tree.leaves.value, float(np.max(tree.hemispherical())))
        return tree
    row, column = _basis(place.need("RowAngleBasis"), bases), _basis(place.need("ColumnAngleBasis"), bases)
    values = finite(data, (data.element.text or "").replace(",", " ").split())
    if len(values) != len(row) * len(column):
        data.wrong(
            f"must hold {len(row)} × {len(column)} = {len(row) * len(column)} values for {row.lbnl_name} and "
            f"{column.lbnl_name}, got {len(values)}"
        )
    matrix = values.reshape(len(row), len(column))
    klems = KlemsBlock(matrix, column, row) if structure == "Columns" else KlemsBlock(matrix.T, row, column)
    if strict:
        _in_range(data, klems.values, float(klems.hemispherical().max()))
    return klems


def _in_range(place: Place, values: Any, most: float) -> None:
    if values.min() < 0.0:
        place.wrong(f"must hold no negative values, got {values.min():g}; strict=False reads it all the same")
    if most > MOST_SHARE:
        place.wrong(
            f"must send away no more than {MOST_SHARE:g} of the power that comes in, got {most:.4g}; "
            "strict=False reads it all the same"
        )


def _material(layer: Place, where: Path) -> dict[str, Any]:
    """Name, manufacturer, thickness and whatever else the file says of the product."""
    attrs: dict[str, Any] = {"file": where.name, "sha256": hashlib.sha256(where.read_bytes()).hexdigest()}
    material = layer.find("Material")
    texts = {child: (material.find(child) if material else None) for child in ("Name", "Manufacturer", "Thickness")}
    thickness = texts["Thickness"]
    millimetres = None
    if thickness is not None and thickness.text:
        unit = thickness.element.get("unit", "Millimeter")
        if unit.casefold() not in _MILLIMETRES:
            thickness.wrong(f"must be in one of {', '.join(_MILLIMETRES)}, got {shortened(unit)}")
        millimetres = thickness.number() * _MILLIMETRES[unit.casefold()]
        if not 0.0 < millimetres < 1e6:
            _tell(f"{where}: {thickness.path} is {thickness.text!r}: the thickness is taken as unknown")
            millimetres = None
    for name, element in MATERIAL.items():
        place = material.find(element) if material else None
        if place is not None and place.text:
            attrs[name] = place.number()
    name, maker = (
        " ".join(place.text.split()) if place is not None else "" for place in (texts["Name"], texts["Manufacturer"])
    )
    return {
        "name": name or where.stem or "unnamed",
        "manufacturer": maker or "unspecified",
        "thickness_mm": millimetres,
        "attrs": attrs,
    }
