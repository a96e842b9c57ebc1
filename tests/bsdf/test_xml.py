"""LBNL's XML: what is written is read again, and what other programs write is read as well."""

import dataclasses
import re
import warnings
from pathlib import Path

import numpy as np
import pytest
from tests.bsdf.elements import uneven_block, uneven_bsdf, uneven_tree, uneven_tree_bsdf

from clerestory import Band, Bsdf, BsdfWarning, ClerestoryError, KlemsBlock, read_bsdf
from clerestory.bsdf import KlemsBasis, klems_basis

BLINDS = Path(__file__).parents[1] / "data" / "bsdf" / "blinds_tensortree3.xml"


def same(one: Bsdf, two: Bsdf) -> None:
    assert [name for name, _ in one.bands] == [name for name, _ in two.bands]
    for (_, band), (_, other) in zip(one.bands, two.bands, strict=True):
        for (direction, block), (again, found) in zip(band, other, strict=True):
            assert direction == again
            if isinstance(block, KlemsBlock):
                assert (found.incident, found.outgoing) == (block.incident, block.outgoing)
                assert found.values == pytest.approx(block.values, rel=1e-8)
            else:
                assert found.rank == block.rank
                assert found.preorder == pytest.approx(block.preorder, rel=1e-8, nan_ok=True)


@pytest.mark.parametrize("bsdf", [uneven_bsdf("klems_quarter"), uneven_tree_bsdf(3), uneven_tree_bsdf(4)])
def test_what_is_written_is_read_again(bsdf: Bsdf, tmp_path: Path) -> None:
    bsdf = dataclasses.replace(bsdf, x=bsdf.solar, z=bsdf.visible, attrs={"emissivity_front": 0.9})
    with warnings.catch_warnings():
        warnings.simplefilter("error", BsdfWarning)
        path = bsdf.to_xml(tmp_path / "element.xml")
        found = Bsdf.from_xml(path)
    same(bsdf, found)
    assert (found.name, found.manufacturer, found.thickness_mm) == (bsdf.name, bsdf.manufacturer, bsdf.thickness_mm)
    assert found.attrs["emissivity_front"] == 0.9
    assert bsdf.to_xml(tmp_path / "again.xml").read_text() == path.read_text()


def test_rings_of_one_s_own_and_blocks_of_two_bases(tmp_path: Path) -> None:
    own = KlemsBasis("Nine rings", tuple(range(0, 91, 10)), (1, 8, 8, 8, 8, 8, 8, 8, 4))
    quarter = klems_basis("klems_quarter")
    rng = np.random.default_rng(1)
    into = KlemsBlock(rng.random((41, 61)) / 5.0, own, quarter)
    back = KlemsBlock(rng.random((61, 41)) / 5.0, quarter, own)
    mirror = KlemsBlock(rng.random((61, 61)) / 20.0, own, own)
    band = Band(into, back, mirror, KlemsBlock(np.zeros((41, 41)), quarter, quarter))
    bsdf = Bsdf(name="two bases", thickness_mm=1.0, visible=band, solar=band)
    same(bsdf, read_bsdf(bsdf.to_xml(tmp_path / "own.xml")))


def test_a_file_of_genbsdf_with_a_stray_line_before_it() -> None:
    assert BLINDS.read_text().startswith("Recover using")
    blinds = read_bsdf(BLINDS)
    assert (blinds.thickness_mm, blinds.manufacturer) == (pytest.approx(48.591), "Manufacturer")
    assert {block.rank for _, block in blinds.visible} == {3}
    # what checkBSDF of Radiance 6.0a says of the peaks of this file: front and back are the reverse of Radiance's
    assert blinds.visible.transmission_front.hemispherical().max() == pytest.approx(0.3465, abs=1e-4)
    assert blinds.visible.reflection_back.hemispherical().max() == pytest.approx(0.3782, abs=1e-4)


def text_of(bsdf: Bsdf, folder: Path) -> str:
    return bsdf.to_xml(folder / "element.xml").read_text()


def read_text(text: str, folder: Path, **options: bool) -> Bsdf:
    path = folder / "changed.xml"
    path.write_text(text)
    return read_bsdf(path, **options)


def test_rows_of_incident_patches_are_turned(tmp_path: Path) -> None:
    bsdf = uneven_bsdf("klems_quarter")
    turned = {
        name: Band(
            **{direction: KlemsBlock(block.values.T, "klems_quarter", "klems_quarter") for direction, block in band}
        )
        for name, band in bsdf.bands
    }
    text = text_of(dataclasses.replace(bsdf, **turned), tmp_path).replace("Columns", "Rows")
    same(bsdf, read_text(text, tmp_path, strict=False))


@pytest.mark.parametrize("namespace", ['xmlns="http://windows.lbl.gov"', 'xmlns="urn:another"', ""])
def test_namespaces_blanks_and_capitals_do_not_matter(namespace: str, tmp_path: Path) -> None:
    bsdf = uneven_bsdf("klems_quarter")
    text = text_of(bsdf, tmp_path).replace('xmlns="http://windows.lbl.gov"', namespace)
    text = text.replace(",", "   ").replace("Transmission Front", " transmission  front ").replace("Klems Q", "klems q")
    text = re.sub(r"(?s)<AngleBasis>.*</AngleBasis>\n", "", text)
    same(bsdf, read_text("Recover using: nothing\n\n" + text, tmp_path))


def test_grids_in_a_tree_run_with_the_last_coordinate_fastest(tmp_path: Path) -> None:
    grid = np.random.default_rng(2).random((4,) * 4) / 4.0
    text = text_of(uneven_tree_bsdf(4), tmp_path)
    inside = "{ " + " ".join(f"{value:.9g}" for value in grid.ravel()) + " }"
    text = re.sub(
        r"(?s)<ScatteringData>.*?</ScatteringData>", f"<ScatteringData>{inside}</ScatteringData>", text, count=1
    )
    tree = read_text(text, tmp_path).visible.transmission_front
    place = np.random.default_rng(3).random((200, 4))
    cell = (place * 4).astype(int)
    assert tree.value_at(place) == pytest.approx(grid[tuple(cell.T)], rel=1e-8)


def test_what_is_missing_is_made_up_and_told(tmp_path: Path) -> None:
    front = uneven_block(3, "klems_quarter", "klems_quarter")
    bsdf = Bsdf(name="half known", thickness_mm=1.0, visible=Band(transmission_front=front))
    with pytest.warns(BsdfWarning) as told:
        text = text_of(bsdf, tmp_path)
    said = " ".join(str(one.message) for one in told)
    for word in ("Transmission Back", "reciprocity", "Reflection Front", "zero", "no solar band"):
        assert word in said
    found = read_text(text, tmp_path)
    assert found.visible.transmission_back.values == pytest.approx(front.reversed().values, rel=1e-8)
    assert not found.visible.reflection_back.values.any()
    without = re.sub(r"(?s)\t<WavelengthData>(?:(?!</WavelengthData>).)*Solar.*?</WavelengthData>\n", "", text)
    without = re.sub(
        r"(?s)\t\t<WavelengthDataBlock>\s*<WavelengthDataDirection>Transmission Back.*?Block>\n", "", without
    )
    without = re.sub(r"<Thickness.*</Thickness>", "<Thickness></Thickness>", without)
    without = re.sub(r"<Manufacturer>.*</Manufacturer>", "<Manufacturer></Manufacturer>", without)
    with pytest.warns(BsdfWarning, match="Transmission Back"):
        found = read_text(without, tmp_path)
    assert (found.solar, found.thickness_mm, found.manufacturer) == (None, None, "unspecified")


def test_a_tree_turned_round_twice_is_itself() -> None:
    tree = uneven_tree(5)
    back = tree.reversed()
    rng = np.random.default_rng(7)
    into, out = rng.uniform(-0.7, 0.7, (2, 300, 2))
    assert (back.at(into, out) == tree.at(-out, -into)).all()
    assert back.reversed().preorder == pytest.approx(tree.preorder, nan_ok=True)
    flat = uneven_tree(5, rank=3)
    assert flat.reversed().mean() == pytest.approx(flat.mean(), rel=0.02)


def test_without_a_thickness_nothing_is_written(tmp_path: Path) -> None:
    bsdf = dataclasses.replace(uneven_bsdf("klems_quarter"), thickness_mm=None)
    with pytest.raises(ClerestoryError, match="thickness_mm"):
        bsdf.to_xml(tmp_path / "element.xml")
    assert not list(tmp_path.iterdir())
