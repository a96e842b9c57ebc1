"""A BSDF in a room file and in a Radiance scene."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.bsdf.elements import uneven_bsdf, uneven_tree_bsdf

from clerestory import Band, Bsdf, ClerestoryError, KlemsBlock, LaserCutPanel, read_room, save, write_room
from clerestory.bsdf import klems_basis, radiance_snippet
from clerestory.glazing_table import glazing_tables, write_glazing
from clerestory.room.toml_table import Table

SOUTH = [[0, 0, 1], [0, 0, 2], [1, 0, 2], [1, 0, 1]]


def test_the_up_of_a_window_lies_in_its_plane() -> None:
    bsdf = uneven_bsdf("klems_quarter")
    assert "6 0 a.xml 0 0 1 ." in radiance_snippet(bsdf, "a.xml", SOUTH)
    tilted = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 1]]
    words = radiance_snippet(bsdf, "a.xml", tilted).splitlines()[2].split()
    assert [float(word) for word in words[3:6]] == pytest.approx([0.0, np.sqrt(0.5), np.sqrt(0.5)])
    flat = [[0, 0, 3], [0, 1, 3], [1, 1, 3], [1, 0, 3]]
    assert "a.xml 0 1 0 ." in radiance_snippet(bsdf, "a.xml", flat)
    assert "a.xml 1 0 0 ." in radiance_snippet(bsdf, "a.xml", flat, up=(1.0, 0.0, 5.0))
    text = radiance_snippet(bsdf, "a.xml", SOUTH, name="w")
    assert "w_bsdf polygon w\n0\n0\n12\n  0 0 1\n" in text
    for wrong in ({"up": (0.0, 1.0, 0.0)}, {"name": "two words"}):
        with pytest.raises(ClerestoryError):
            radiance_snippet(bsdf, "a.xml", SOUTH, **wrong)
    with pytest.raises(ClerestoryError, match="polygon"):
        radiance_snippet(bsdf, "a.xml", SOUTH[:2])


def test_a_peak_is_taken_out_where_light_passes_straight_on() -> None:
    basis = klems_basis("klems_full")
    clear = Band(KlemsBlock(np.diag(0.8 / basis.projected_solid_angle)))
    assert "void aBSDF" in radiance_snippet(Bsdf(name="clear", visible=clear), "a.xml", SOUTH)
    assert "void BSDF" in radiance_snippet(uneven_bsdf(), "a.xml", SOUTH)
    assert "void BSDF" in radiance_snippet(uneven_tree_bsdf(), "a.xml", SOUTH)
    assert "void aBSDF" in radiance_snippet(uneven_tree_bsdf(), "a.xml", SOUTH, peak_extraction=True)


def test_a_room_file_names_a_bsdf(tmp_path: Path) -> None:
    uneven_bsdf("klems_quarter").to_xml(tmp_path / "shade.xml")
    (tmp_path / "room.toml").write_text(
        """
[shoebox]
width_m = 3.0
depth_m = 4.0
height_m = 3.0
[[shoebox.opening]]
name = "w"
width_m = 1.0
height_m = 1.0
sill_m = 1.0
glazing = "shade"
[glazings.shade]
kind = "bsdf"
file = "shade.xml"
"""
    )
    room = read_room(tmp_path / "room.toml")
    bsdf = room.windows[0].glazing
    assert isinstance(bsdf, Bsdf)
    assert bsdf.glazing().spreads
    write_room(room, tmp_path / "again.toml")
    again = read_room(tmp_path / "again.toml").windows[0].glazing
    assert isinstance(again, Bsdf)
    np.testing.assert_array_equal(again.visible.transmission_front.values, bsdf.visible.transmission_front.values)
    with pytest.raises(ClerestoryError, match="in a file"):
        write_glazing(uneven_bsdf(), str)


def test_the_exact_element_stands_in_a_window_unless_blurred(tmp_path: Path) -> None:
    panel = LaserCutPanel(spacing_mm=3.0, thickness_mm=10.0)
    tables = uneven_bsdf("klems_quarter")
    save(replace(tables, exact=panel).to_dataset(), tmp_path / "panel.nc")
    named = glazing_tables(
        Table(
            {
                "exact": {"kind": "bsdf", "file": "panel.nc"},
                "blurred": {"kind": "bsdf", "file": "panel.nc", "blurred": True},
                "wrong": {"kind": "bsdf", "file": "panel.nc", "blurred": "very"},
            },
            "[glazings]",
        ),
        tmp_path,
    )
    assert not named("exact").glazing().spreads
    assert named("blurred").glazing().spreads
    assert named("exact").blurred_glazing().spreads
    with pytest.raises(ClerestoryError, match="blurred"):
        named("wrong")
