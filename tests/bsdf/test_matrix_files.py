"""Radiance's matrix files and NetCDF: what is written is read again, and Radiance's own matrix is ours."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
from tests.bsdf.elements import uneven_block, uneven_bsdf, uneven_tree_bsdf

from clerestory import Band, Bsdf, ClerestoryError, Glass, KlemsBlock, LaserCutPanel, Stack, read_bsdf, save
from clerestory.bsdf import read_radiance_matrix, write_radiance_matrix


@pytest.mark.parametrize("encoding", ["ascii", "float", "double"])
@pytest.mark.parametrize("weighting", ["incident", "none"])
def test_a_matrix_file_is_read_again(encoding: str, weighting: str, tmp_path: Path) -> None:
    block = uneven_block(1, "klems_full", "klems_quarter")
    path = write_radiance_matrix(block, tmp_path / "t.mtx", encoding=encoding, weighting=weighting)
    found = read_radiance_matrix(path, weighting=weighting)
    assert (found.incident.name, found.outgoing.name) == ("klems_full", "klems_quarter")
    assert found.values == pytest.approx(block.values, rel=1e-6 if encoding == "float" else 1e-8)


def rmtxop(*arguments: str) -> bytes:
    pyradiance = pytest.importorskip("pyradiance")
    program = Path(pyradiance.__file__).parent / "bin" / "rmtxop"
    if not program.exists():
        program = program.with_suffix(".exe")
    return subprocess.run([program, *arguments], capture_output=True, check=True, timeout=600).stdout


@pytest.mark.parametrize(
    ("options", "direction"),
    [((), "transmission_front"), (("-rf",), "reflection_back"), (("-rb",), "reflection_front")],
)
@pytest.mark.parametrize("basis", ["klems_full", "klems_half", "klems_quarter"])
def test_radiance_makes_the_same_matrix_of_our_xml(
    options: tuple[str, ...], direction: str, basis: str, tmp_path: Path
) -> None:
    bsdf = uneven_bsdf(basis)
    xml = bsdf.to_xml(tmp_path / "element.xml")
    theirs = tmp_path / "theirs.mtx"
    theirs.write_bytes(rmtxop("-ff", *options, str(xml)))
    assert read_radiance_matrix(theirs).values == pytest.approx(getattr(bsdf.visible, direction).values, rel=1e-5)


def test_radiance_reads_our_matrix(tmp_path: Path) -> None:
    block = uneven_block(2, "klems_quarter", "klems_quarter")
    for encoding in ("ascii", "float", "double"):
        ours = write_radiance_matrix(block, tmp_path / f"{encoding}.mtx", encoding=encoding)
        (tmp_path / "doubled.mtx").write_bytes(rmtxop("-fa", "-s", "2", str(ours)))
        assert read_radiance_matrix(tmp_path / "doubled.mtx").values == pytest.approx(2.0 * block.values, rel=1e-5)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"1 2 3", "header"),
        (b"#?RADIANCE\nNROWS=41\nNCOLS=x\nFORMAT=ascii\n\n", "NCOLS"),
        (b"#?RADIANCE\nNROWS=41\nNCOLS=41\nFORMAT=ascii\n\n1 2", "1681 numbers"),
        (b"#?RADIANCE\nNROWS=41\nNCOLS=41\nFORMAT=rle\n\n", "FORMAT"),
        (b"#?RADIANCE\nNROWS=1\nNCOLS=2\nFORMAT=ascii\n\n1 b", "numbers"),
        (b"#?RADIANCE\nNROWS=1\nNCOLS=2\nFORMAT=ascii\n\n1 2", "Klems"),
        (b"#?RADIANCE\nNROWS=99999999\nNCOLS=99999999\nFORMAT=float\n\n", "no more"),
        (b"#?RADIANCE\nNROWS=41\nNCOLS=41\nFORMAT=ascii\n\n" + b"nan " * 1681, "finite"),
    ],
)
def test_what_is_no_matrix_is_refused(content: bytes, words: str, tmp_path: Path) -> None:
    path = tmp_path / "t.mtx"
    path.write_bytes(content)
    with pytest.raises(ClerestoryError, match=words):
        read_radiance_matrix(path)


@pytest.mark.parametrize("bsdf", [uneven_bsdf("klems_half"), uneven_tree_bsdf(3)])
def test_netcdf_keeps_everything(bsdf: Bsdf, tmp_path: Path) -> None:
    found = read_bsdf(save(bsdf.to_dataset(), tmp_path / "element.nc"))
    assert (found.name, found.manufacturer, found.thickness_mm) == (bsdf.name, bsdf.manufacturer, bsdf.thickness_mm)
    for (_, band), (_, again) in zip(bsdf.bands, found.bands, strict=True):
        for (direction, block), (same, read) in zip(band, again, strict=True):
            assert direction == same
            values = ("values",) if isinstance(block, KlemsBlock) else ("preorder", "rank")
            for name in values:
                np.testing.assert_array_equal(getattr(read, name), getattr(block, name))


def test_netcdf_keeps_the_exact_element_and_the_errors(tmp_path: Path) -> None:
    block = uneven_block(3, "klems_quarter", "klems_quarter")
    noisy = KlemsBlock(block.values, "klems_quarter", "klems_quarter", 0.1 * block.values)
    panel = LaserCutPanel(spacing_mm=3.0, thickness_mm=10.0)
    exact = Stack((Glass(transmittance=0.88), panel))
    bsdf = Bsdf(name="panel", visible=Band(noisy), exact=exact, attrs={"emissivity_front": 0.9, "of": "a test"})
    found = read_bsdf(save(bsdf.to_dataset(), tmp_path / "element.nc"))
    assert found.exact == exact
    assert found.attrs == bsdf.attrs
    np.testing.assert_array_equal(found.visible.transmission_front.standard_error, noisy.standard_error)
    (tmp_path / "no.nc").write_bytes(b"nothing")
    with pytest.raises(ClerestoryError, match="NetCDF"):
        read_bsdf(tmp_path / "no.nc")
