"""EnergyPlus's objects as files: epJSON and IDF."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.saving import write_text

Objects = Mapping[str, Mapping[str, Mapping[str, Any]]]

#: Fields of each class after the name, in the order of an IDF; EnergyPlus, *Input Output Reference*.
_LAYERS = ("outside_layer", "layer_2", "layer_3", "layer_4", "layer_5")
_FIELDS: dict[str, tuple[str, ...]] = {
    "Construction:ComplexFenestrationState": (
        "basis_type",
        "basis_symmetry_type",
        "window_thermal_model",
        "basis_matrix_name",
        "solar_optical_complex_front_transmittance_matrix_name",
        "solar_optical_complex_back_reflectance_matrix_name",
        "visible_optical_complex_front_transmittance_matrix_name",
        "visible_optical_complex_back_transmittance_matrix_name",
        *(
            f"{place}{word}"
            for number, layer in enumerate(_LAYERS, 1)
            for place in ((layer, f"gap_{number}") if number < len(_LAYERS) else (layer,))
            for word in (
                "_name",
                "_directional_front_absorptance_matrix_name",
                "_directional_back_absorptance_matrix_name",
            )
        ),
    ),
    "WindowThermalModel:Params": ("standard", "thermal_model", "sdscalar", "deflection_model"),
    "WindowMaterial:Glazing": (
        "optical_data_type",
        "window_glass_spectral_data_set_name",
        "thickness",
        "solar_transmittance_at_normal_incidence",
        "front_side_solar_reflectance_at_normal_incidence",
        "back_side_solar_reflectance_at_normal_incidence",
        "visible_transmittance_at_normal_incidence",
        "front_side_visible_reflectance_at_normal_incidence",
        "back_side_visible_reflectance_at_normal_incidence",
        "infrared_transmittance_at_normal_incidence",
        "front_side_infrared_hemispherical_emissivity",
        "back_side_infrared_hemispherical_emissivity",
        "conductivity",
    ),
    "WindowMaterial:Gas": ("gas_type", "thickness"),
    "WindowMaterial:Gap": ("thickness", "gas_or_gas_mixture_", "pressure"),
}


def write_energyplus(objects: Objects, path: str | os.PathLike[str]) -> Path:
    """Writes objects to an epJSON or an IDF file, whole or not at all.

    Parameters
    ----------
    objects : mapping
        Class → name → fields, of :func:`clerestory.bsdf.energyplus_objects`.
    path : path
        ``.epJSON`` or ``.json``, or ``.idf``.

    Returns
    -------
    Path
        Of the file. It holds these objects alone, to be copied into a model or included.

    Raises
    ------
    ClerestoryError
        If the ending is another, or the file cannot be written.
    """
    ending = Path(path).suffix.lower()
    if ending in (".epjson", ".json"):
        return write_text(path, json.dumps(objects, indent=1) + "\n")
    if ending == ".idf":
        return write_text(path, idf_text(objects))
    raise ClerestoryError(f"path must end in .epJSON or .idf, got {str(path)!r}; choose one")


def idf_text(objects: Objects) -> str:
    """The objects as an IDF writes them."""
    parts = []
    for kind, named in objects.items():
        for name, fields in named.items():
            lines = _matrix(fields) if kind == "Matrix:TwoDimension" else _plain(kind, fields)
            parts.append(f"{kind},\n  {name},                    !- Name\n" + "\n".join(lines) + "\n")
    return "\n".join(parts)


def _plain(kind: str, fields: Mapping[str, Any]) -> list[str]:
    order = _FIELDS[kind]
    last = max(place for place, field in enumerate(order) if field in fields)
    return [
        f"  {_word(fields.get(field))}{';' if place == last else ','}  !- {field.replace('_', ' ').strip()}"
        for place, field in enumerate(order[: last + 1])
    ]


def _matrix(fields: Mapping[str, Any]) -> list[str]:
    rows, columns = fields["number_of_rows"], fields["number_of_columns"]
    words = [_word(value["value"]) for value in fields["values"]]
    lines = [f"  {rows},  !- Number of Rows", f"  {columns},  !- Number of Columns"]
    for row in range(rows):
        end = ";" if row == rows - 1 else ","
        lines.append("  " + ",".join(words[row * columns : (row + 1) * columns]) + end)
    return lines


def _word(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.9g}" if isinstance(value, float) else str(value)
