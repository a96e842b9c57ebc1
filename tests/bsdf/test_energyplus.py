"""EnergyPlus's objects: the right fields in the right order, and matrices the right way round."""

import dataclasses
import json
import re
from pathlib import Path

import numpy as np
import pytest
from tests.bsdf.elements import uneven_bsdf, uneven_tree_bsdf

from clerestory import Band, Bsdf, ClerestoryError
from clerestory.bsdf import (
    BsdfWarning,
    EnergyPlusGap,
    EnergyPlusLayer,
    energyplus_objects,
    write_energyplus,
)
from clerestory.bsdf.energyplus_file import _FIELDS

HEAT = {"conductivity_w_mk": 0.19, "emissivity_front": 0.9, "emissivity_back": 0.9, "transmittance_infrared": 0.0}
CLASSES = {
    "Construction:ComplexFenestrationState": "ConstructionComplexFenestrationState",
    "Matrix:TwoDimension": "MatrixTwoDimension",
    "WindowThermalModel:Params": "WindowThermalModelParams",
    "WindowMaterial:Glazing": "WindowMaterialGlazing",
    "WindowMaterial:Gas": "WindowMaterialGas",
    "WindowMaterial:Gap": "WindowMaterialGap",
}


def element() -> Bsdf:
    return dataclasses.replace(uneven_bsdf("klems_quarter"), name="panel", attrs=HEAT)


def matrix(objects: dict, name: str) -> np.ndarray:
    fields = objects["Matrix:TwoDimension"][name]
    values = [value["value"] for value in fields["values"]]
    return np.array(values).reshape(fields["number_of_rows"], fields["number_of_columns"])


def test_matrices_have_a_row_for_each_outgoing_patch() -> None:
    bsdf = element()
    objects = energyplus_objects(bsdf)
    construction = objects["Construction:ComplexFenestrationState"]["panel"]
    for field, block in {
        "solar_optical_complex_front_transmittance_matrix_name": bsdf.solar.transmission_front,
        "solar_optical_complex_back_reflectance_matrix_name": bsdf.solar.reflection_back,
        "visible_optical_complex_front_transmittance_matrix_name": bsdf.visible.transmission_front,
        "visible_optical_complex_back_transmittance_matrix_name": bsdf.visible.reflection_back,
    }.items():
        assert matrix(objects, construction[field]) == pytest.approx(block.values, rel=1e-8)
    rings = matrix(objects, construction["basis_matrix_name"])
    assert rings.tolist() == [[0.0, 1.0], [18.0, 8.0], [36.0, 12.0], [54.0, 12.0], [76.5, 8.0]]
    absorbed = matrix(objects, construction["outside_layer_directional_front_absorptance_matrix_name"])
    solar = bsdf.solar
    rest = 1.0 - solar.transmission_front.hemispherical() - solar.reflection_front.hemispherical()
    assert absorbed == pytest.approx(rest[None, :], abs=1e-8)
    assert objects["WindowMaterial:Glazing"]["panel layer"]["thickness"] == 0.0065


def test_several_layers_stand_in_the_order_of_an_idf(tmp_path: Path) -> None:
    ones = np.full(41, 0.01)
    panes = [
        EnergyPlusLayer(name=f"pane {n}", thickness_mm=4.0, absorptance_front=ones, absorptance_back=2 * ones)
        for n in (1, 2)
    ]
    objects = energyplus_objects(element(), layers=panes, gaps=[EnergyPlusGap(thickness_mm=12.0, gas="Argon")])
    text = write_energyplus(objects, tmp_path / "window.idf").read_text()
    found = re.search(r"Construction:ComplexFenestrationState,(.*?);", text, re.S)
    words = [re.sub(r"!-.*", "", line).strip(" ,") for line in found.group(1).splitlines() if line.strip()]
    assert words[9:12] == ["pane 1", "panel layer 1 front absorptance", "panel layer 1 back absorptance"]
    assert words[12:15] == ["panel gap 1", "", ""]
    assert words[15:] == ["pane 2", "panel layer 2 front absorptance", "panel layer 2 back absorptance"]
    rows = re.search(r"Matrix:TwoDimension,\n  panel TfSol,.*?\n(.*?);", text, re.S).group(1).splitlines()
    assert [line.split(",")[0].strip() for line in rows[:2]] == ["41", "41"]
    assert len(rows) == 43
    again = json.loads(write_energyplus(objects, tmp_path / "window.epJSON").read_text())
    assert again == objects


def test_energyplus_s_own_data_model_takes_the_objects() -> None:
    model = pytest.importorskip("pyenergyplus.model.model")
    objects = energyplus_objects(
        element(),
        layers=[
            EnergyPlusLayer(
                name=str(n), thickness_mm=4.0, absorptance_front=np.zeros(41), absorptance_back=np.zeros(41)
            )
            for n in range(2)
        ],
        gaps=[EnergyPlusGap(thickness_mm=12.0)],
    )
    assert set(objects) == set(CLASSES)
    for kind, named in objects.items():
        known = getattr(model, CLASSES[kind])
        order = list(known.model_fields)
        for fields in named.values():
            assert set(fields) <= set(order), kind
            known.model_validate(fields)
        if kind in _FIELDS:
            mine = [field for field in _FIELDS[kind] if not (field.startswith("gap_") and "directional" in field)]
            assert mine[: len(order)] == [field for field in order if field in mine]


def test_trees_are_averaged_and_missing_words_are_told() -> None:
    with pytest.warns(BsdfWarning, match="conductivity_w_mk"):
        objects = energyplus_objects(uneven_tree_bsdf(), basis="klems_quarter")
    assert matrix(objects, "Tree TfSol").shape == (41, 41)


def test_what_cannot_be_is_refused_by_name() -> None:
    ones = np.ones(41)
    layer = EnergyPlusLayer(name="a", thickness_mm=4.0, absorptance_front=ones, absorptance_back=ones)
    with pytest.raises(ClerestoryError, match="gaps"):
        energyplus_objects(element(), layers=[layer, layer])
    with pytest.raises(ClerestoryError, match="thickness_mm"):
        energyplus_objects(dataclasses.replace(element(), thickness_mm=None))
    with pytest.raises(ClerestoryError, match="one value a patch"):
        energyplus_objects(element(), layers=[dataclasses.replace(layer, absorptance_front=np.ones(40))])
    with pytest.raises(ClerestoryError, match="gas"):
        EnergyPlusGap(thickness_mm=12.0, gas="Neon")
    much = Band(*[dataclasses.replace(block, values=2.0 * block.values) for _, block in element().solar])
    with pytest.raises(ClerestoryError, match="absorptance"):
        energyplus_objects(dataclasses.replace(element(), solar=much))
