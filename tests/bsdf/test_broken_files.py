"""Hostile and broken BSDF files get one clear message each; nothing else ever comes out of the reader."""

import contextlib
import re
import warnings
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.bsdf.elements import uneven_bsdf, uneven_tree_bsdf

from clerestory import ClerestoryError, read_bsdf
from clerestory.bsdf.xml_write import xml_text

KLEMS = xml_text(uneven_bsdf("klems_quarter"))
TREE = xml_text(uneven_tree_bsdf(3))
FIRST = r"(?s)(<ScatteringData>\s*)([^\s,<]+)"
BOMB = (
    '<?xml version="1.0"?><!DOCTYPE z [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>'
    "<WindowElement>&b;</WindowElement>"
)


def first_value(word: str, text: str = KLEMS) -> str:
    return re.sub(FIRST, rf"\g<1>{word}", text, count=1)


def tree(data: str) -> str:
    return re.sub(
        r"(?s)<ScatteringData>.*?</ScatteringData>", f"<ScatteringData>{data}</ScatteringData>", TREE, count=1
    )


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", ("XML",)),
        ("not xml at all", ("XML",)),
        (BOMB, ("document type",)),
        (KLEMS[:3000], ("well-formed", "line")),
        ('<?xml version="1.0" encoding="klingon"?><WindowElement/>', ("encoding",)),
        ("<WindowElement/>", ("WindowElement", "Optical")),
        ('<?xml version="1.0"?><Window/>', ("WindowElement",)),
        (first_value("-0.5"), ("WavelengthData[1]/WavelengthDataBlock/ScatteringData", "negative", "-0.5")),
        (first_value("nan"), ("ScatteringData", "finite", "nan")),
        (first_value("1e999"), ("finite",)),
        (first_value("1_0"), ("numbers", "1_0")),
        (first_value("zero"), ("numbers", "'zero'")),
        (first_value("99"), ("1.01",)),
        (first_value("0.1, 0.1"), ("41 × 41", "1682")),
        (KLEMS.replace("Columns", "Diagonals"), ("IncidentDataStructure", "'Diagonals'")),
        (KLEMS.replace("Transmission Front", "Sideways", 1), ("WavelengthDataDirection", "'Sideways'")),
        (KLEMS.replace("Transmission Back", "Transmission Front", 1), ("once",)),
        (KLEMS.replace(">Visible<", ">Invisible<"), ("Visible",)),
        (KLEMS.replace("<ColumnAngleBasis>LBNL/Klems Quarter", "<ColumnAngleBasis>Mine", 1), ("basis", "'Mine'")),
        (KLEMS.replace("<UpperTheta>27<", "<UpperTheta>30<"), ("LowerTheta", "27")),
        (KLEMS.replace("<nPhis>12<", "<nPhis>13<", 1), ("LBNL/Klems Quarter", "41")),
        (KLEMS.replace("<nPhis>12<", "<nPhis>1e300<", 1), ("AngleBasis",)),
        (KLEMS.replace('unit="Millimeter"', 'unit="Furlong"'), ("Thickness", "Furlong")),
        (KLEMS.replace(">6.5</Thickness>", ">thick</Thickness>"), ("Thickness", "'thick'")),
        (tree("{ 1"), ("close",)),
        (tree("{ 1 } }"), ("outermost",)),
        (tree("{ 1 2 3 }"), ("2^(3 k)",)),
        (tree("{ {1} {1} }"), ("8 braces", "fewer")),
        (tree("{" + "{ 1 }" * 9 + "}"), ("8 braces", "more")),
        (tree("{ 1 { 1 } }"), ("not both",)),
        (tree("1"), ("in a brace",)),
        (tree("}"), ("open",)),
        (tree(""), ("nothing",)),
        (tree("{" * 100_000), ("no deeper",)),
        (tree("{ -1 }"), ("negative",)),
        (tree("{ 0.5 }"), ("1.01",)),
    ],
)
def test_each_fault_is_told_in_one_line(text: str, words: tuple[str, ...], tmp_path: Path) -> None:
    path = tmp_path / "file.xml"
    path.write_text(text)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises(ClerestoryError) as told:
            read_bsdf(path)
    message = str(told.value)
    assert "\n" not in message
    assert len(message) < 600
    assert str(path) in message
    assert [word for word in words if word not in message] == []


def test_a_file_that_is_not_there_is_told(tmp_path: Path) -> None:
    for path in (tmp_path / "none.xml", tmp_path):
        with pytest.raises(ClerestoryError, match="must be a file to read"):
            read_bsdf(path)


def test_huge_files_are_not_read(tmp_path: Path) -> None:
    path = tmp_path / "huge.xml"
    with path.open("wb") as file:
        file.truncate(600 * 2**20)
    with pytest.raises(ClerestoryError, match="512 MB"):
        read_bsdf(path)


def test_faulty_values_are_read_when_asked(tmp_path: Path) -> None:
    path = tmp_path / "file.xml"
    path.write_text(first_value("-40"))
    found = read_bsdf(path, strict=False)
    assert any(finding.severity == "error" and "negative" in finding.text for finding in found.check())


SMALL = re.sub(r"(?s)\t<WavelengthData>(?:(?!</WavelengthData>).)*Solar.*?</WavelengthData>\n", "", TREE)


@settings(max_examples=150)
@given(data=st.data())
def test_no_change_of_a_file_brings_out_another_error(data: st.DataObject, tmp_path: Path) -> None:
    content = bytearray(data.draw(st.sampled_from([SMALL.encode(), KLEMS.encode()[:30_000] + KLEMS.encode()[-400:]])))
    for _ in range(data.draw(st.integers(1, 6))):
        place = data.draw(st.integers(0, len(content) - 1))
        length = data.draw(st.integers(0, 200))
        kind = data.draw(st.sampled_from(["replace", "remove", "repeat", "number"]))
        if kind == "replace":
            content[place : place + length] = data.draw(st.binary(max_size=40))
        elif kind == "remove":
            del content[place : place + length]
        elif kind == "repeat":
            content[place:place] = content[place : place + length] * data.draw(st.integers(1, 4))
        else:
            content[place:place] = data.draw(
                st.sampled_from([b" -1 ", b"1e400", b"nan", b"{", b"}", b",", b"<", b"&lt;"])
            )
    path = tmp_path / "changed.xml"
    path.write_bytes(bytes(content))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with contextlib.suppress(ClerestoryError):
            read_bsdf(path)
