"""A BSDF as EnergyPlus's complex fenestration: one construction with its matrices and materials."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from clerestory.bsdf.band import Band
from clerestory.bsdf.completing import complete
from clerestory.bsdf.klems import Floats, KlemsBasis
from clerestory.bsdf.klems_block import KlemsBlock
from clerestory.bsdf.rebasing import in_basis
from clerestory.bsdf.told import BsdfWarning
from clerestory.errors import ClerestoryError
from clerestory.rules import positive, within

if TYPE_CHECKING:
    from clerestory.bsdf.bsdf import Bsdf

#: EnergyPlus's own values for a layer of which nothing is known.
_DEFAULTS = {
    "conductivity_w_mk": 0.9,
    "emissivity_front": 0.84,
    "emissivity_back": 0.84,
    "transmittance_infrared": 0.0,
}


@dataclass(frozen=True, kw_only=True)
class EnergyPlusLayer:
    """One layer of a construction: its heat, and what sunlight it absorbs.

    Parameters
    ----------
    name : str
    thickness_mm : float
    absorptance_front, absorptance_back : array of shape (patch,), 0..1
        Share of the sunlight arriving on the whole construction in each patch that this layer absorbs.
    conductivity_w_mk : float [W/(m K)], default 0.9
    emissivity_front, emissivity_back : float, 0..1, default 0.84
        Hemispherical, far infrared.
    transmittance_infrared : float, 0..1, default 0
    """

    name: str
    thickness_mm: float
    absorptance_front: npt.ArrayLike
    absorptance_back: npt.ArrayLike
    conductivity_w_mk: float = _DEFAULTS["conductivity_w_mk"]
    emissivity_front: float = _DEFAULTS["emissivity_front"]
    emissivity_back: float = _DEFAULTS["emissivity_back"]
    transmittance_infrared: float = _DEFAULTS["transmittance_infrared"]

    def __post_init__(self) -> None:
        positive("thickness_mm", self.thickness_mm)
        positive("conductivity_w_mk", self.conductivity_w_mk)
        for name in ("emissivity_front", "emissivity_back"):
            # EnergyPlus takes neither 0 nor 1
            within(name, getattr(self, name), 1e-6, 1.0 - 1e-6)
        within("transmittance_infrared", self.transmittance_infrared, 0.0, 1.0)


@dataclass(frozen=True, kw_only=True)
class EnergyPlusGap:
    """The gas between two layers.

    Parameters
    ----------
    thickness_mm : float
    gas : {"Air", "Argon", "Krypton", "Xenon"}, default "Air"
    """

    thickness_mm: float
    gas: str = "Air"

    def __post_init__(self) -> None:
        from clerestory.rules import one_of

        positive("thickness_mm", self.thickness_mm)
        one_of("gas", self.gas, ("Air", "Argon", "Krypton", "Xenon"))


def energyplus_objects(
    bsdf: Bsdf,
    *,
    construction: str | None = None,
    basis: str | KlemsBasis | None = None,
    layers: Sequence[EnergyPlusLayer] | None = None,
    gaps: Sequence[EnergyPlusGap] = (),
) -> dict[str, dict[str, dict[str, Any]]]:
    """Objects of EnergyPlus for a window with this BSDF, as a dictionary in the form of epJSON.

    Parameters
    ----------
    bsdf : Bsdf
        Of the whole window; trees are averaged over the patches of ``basis``.
    construction : str, optional
        Name of the ``Construction:ComplexFenestrationState``, by default that of the BSDF.
    basis : str or KlemsBasis, optional
        By default the visible band's own, or ``"klems_full"`` for trees.
    layers : sequence of EnergyPlusLayer, optional
        From the outside to the room. By default one layer that absorbs what the BSDF neither transmits nor reflects,
        with the heat data of ``bsdf.attrs`` (``conductivity_w_mk``, ``emissivity_front`` …) or EnergyPlus's defaults.
    gaps : sequence of EnergyPlusGap
        One fewer than there are layers.

    Returns
    -------
    dict
        Class → name → fields. Matrices have a row for each outgoing and a column for each incident patch, in 1/sr.
        What EnergyPlus calls the visible back *transmittance* matrix is, in its calculation, the visible back
        *reflectance*, and that is what is given.

    Raises
    ------
    ClerestoryError
        If the thickness is unknown, layers and gaps do not go together, or the BSDF gives more than it takes.

    Notes
    -----
    EnergyPlus, *Input Output Reference*, Construction:ComplexFenestrationState. In EnergyPlus up to 26.1 light from the
    diffuse sky and ground goes through the transposed matrix, sunlight through the right one (docs/how-to/bsdf.md).
    """
    name = _plain(construction or bsdf.name)
    solar_band = bsdf.solar
    if solar_band is None:
        warnings.warn(f"{bsdf.name!r} has no solar band: the visible one stands in for it", BsdfWarning, stacklevel=2)
        solar_band = bsdf.visible
    if basis is None:
        first = next(iter(bsdf.visible))[1]
        basis = first.incident if isinstance(first, KlemsBlock) else "klems_full"
    visible, solar = _in_basis(bsdf.visible, basis, "visible"), _in_basis(solar_band, basis, "solar")
    rings = solar["transmission_front"].incident
    layers = [_one_layer(bsdf, name, solar)] if layers is None else list(layers)
    if not 1 <= len(layers) <= 5:
        raise ClerestoryError(f"layers must be 1 to 5, got {len(layers)}; join some")
    if len(gaps) != len(layers) - 1:
        raise ClerestoryError(f"gaps must be one fewer than layers ({len(layers)}), got {len(gaps)}")
    matrices: dict[str, dict[str, Any]] = {}

    def matrix(suffix: str, values: Floats) -> str:
        rows, columns = values.shape
        numbers = [{"value": float(f"{value:.9g}")} for value in values.ravel().tolist()]
        matrices[f"{name} {suffix}"] = {"number_of_rows": rows, "number_of_columns": columns, "values": numbers}
        return f"{name} {suffix}"

    fields: dict[str, Any] = {
        "basis_type": "LBNLWINDOW",
        "basis_symmetry_type": "None",
        "window_thermal_model": f"{name} thermal",
        "basis_matrix_name": matrix("basis", _rings(rings)),
        "solar_optical_complex_front_transmittance_matrix_name": matrix("TfSol", solar["transmission_front"].values),
        "solar_optical_complex_back_reflectance_matrix_name": matrix("RbSol", solar["reflection_back"].values),
        "visible_optical_complex_front_transmittance_matrix_name": matrix(
            "TfVis", visible["transmission_front"].values
        ),
        "visible_optical_complex_back_transmittance_matrix_name": matrix("RbVis", visible["reflection_back"].values),
    }
    objects: dict[str, dict[str, dict[str, Any]]] = {
        "Construction:ComplexFenestrationState": {name: fields},
        "WindowThermalModel:Params": {
            f"{name} thermal": {
                "standard": "ISO15099",
                "thermal_model": "ISO15099",
                "sdscalar": 1.0,
                "deflection_model": "NoDeflection",
            }
        },
        "WindowMaterial:Glazing": {},
    }
    for number, layer in enumerate(layers, 1):
        place = "outside_layer" if number == 1 else f"layer_{number}"
        fields[f"{place}_name"] = layer.name
        for side in ("front", "back"):
            absorbed = _absorptance(getattr(layer, f"absorptance_{side}"), len(rings), f"{layer.name} {side}")
            fields[f"{place}_directional_{side}_absorptance_matrix_name"] = matrix(
                f"layer {number} {side} absorptance", absorbed[None, :]
            )
        objects["WindowMaterial:Glazing"][layer.name] = {
            "optical_data_type": "BSDF",
            "thickness": layer.thickness_mm / 1000.0,
            "infrared_transmittance_at_normal_incidence": layer.transmittance_infrared,
            "front_side_infrared_hemispherical_emissivity": layer.emissivity_front,
            "back_side_infrared_hemispherical_emissivity": layer.emissivity_back,
            "conductivity": layer.conductivity_w_mk,
        }
        if number <= len(gaps):
            _add_gap(objects, fields, f"{name} gap {number}", number, gaps[number - 1])
    objects["Matrix:TwoDimension"] = matrices
    return objects


def _in_basis(band: Band, basis: str | KlemsBasis, where: str) -> dict[str, KlemsBlock]:
    return {direction: in_basis(block, basis) for direction, block in complete(band, where, stacklevel=4)}


def _plain(name: str) -> str:
    """A name without the marks that end a field, and no longer than EnergyPlus takes."""
    return " ".join("".join(" " if letter in ",;!" else letter for letter in name).split())[:70] or "BSDF"


def _one_layer(bsdf: Bsdf, name: str, solar: dict[str, KlemsBlock]) -> EnergyPlusLayer:
    if bsdf.thickness_mm is None:
        raise ClerestoryError(
            "thickness_mm must be given for EnergyPlus, got None; dataclasses.replace(bsdf, …) adds it"
        )
    heat = {key: float(bsdf.attrs.get(key, default)) for key, default in _DEFAULTS.items()}
    if missing := [key for key in _DEFAULTS if key not in bsdf.attrs]:
        warnings.warn(
            f"{bsdf.name!r} says nothing of {', '.join(missing)}: EnergyPlus's defaults stand in; attrs may hold them",
            BsdfWarning,
            stacklevel=3,
        )
    absorbed = {
        side: 1.0 - solar[f"transmission_{side}"].hemispherical() - solar[f"reflection_{side}"].hemispherical()
        for side in ("front", "back")
    }
    return EnergyPlusLayer(
        name=f"{name} layer",
        thickness_mm=bsdf.thickness_mm,
        absorptance_front=absorbed["front"],
        absorptance_back=absorbed["back"],
        **heat,
    )


def _absorptance(given: npt.ArrayLike, patches: int, where: str) -> Floats:
    absorbed = np.asarray(given, dtype=np.float64)
    if absorbed.shape != (patches,):
        raise ClerestoryError(f"absorptance of {where} must have one value a patch ({patches}), got {absorbed.shape}")
    if not np.isfinite(absorbed).all() or absorbed.min() < -0.01 or absorbed.max() > 1.0 + 1e-9:
        raise ClerestoryError(
            f"absorptance of {where} must lie in 0..1, got {absorbed.min():.4g}..{absorbed.max():.4g}"
        )
    if absorbed.min() < -1e-6:
        warnings.warn(f"absorptance of {where} is down to {absorbed.min():.2g}: 0 is given", BsdfWarning, stacklevel=3)
    return np.asarray(np.clip(absorbed, 0.0, 1.0))


def _rings(basis: KlemsBasis) -> Floats:
    """Polar angle [degrees] and number of azimuths of each ring, from which EnergyPlus makes the edges again."""
    edges = np.asarray(basis.theta_deg)
    middle = 0.5 * (edges[:-1] + edges[1:])
    middle[0] = 0.0
    if basis.counts[0] != 1 or (len(middle) > 1 and abs(0.5 * middle[1] - edges[1]) > 1e-6):
        raise ClerestoryError(f"basis {basis.name!r} must have rings as LBNL's have them for EnergyPlus; give basis=")
    return np.stack([middle, np.asarray(basis.counts, dtype=np.float64)], axis=1)


def _add_gap(
    objects: dict[str, dict[str, dict[str, Any]]], fields: dict[str, Any], name: str, number: int, gap: EnergyPlusGap
) -> None:
    fields[f"gap_{number}_name"] = name
    metres = gap.thickness_mm / 1000.0
    objects.setdefault("WindowMaterial:Gas", {})[f"{name} gas"] = {"gas_type": gap.gas, "thickness": metres}
    objects.setdefault("WindowMaterial:Gap", {})[name] = {
        "thickness": metres,
        "gas_or_gas_mixture_": f"{name} gas",
        "pressure": 101325.0,
    }
