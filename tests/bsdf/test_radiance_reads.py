"""Radiance's own library reads our XML and finds the same numbers at the same directions, on the same side."""

import os
import re
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.bsdf.ask_radiance import ask
from tests.bsdf.elements import uneven_block, uneven_bsdf, uneven_tree_bsdf

from clerestory import Band, Bsdf, read_bsdf
from clerestory.bsdf import KLEMS_BASES, in_basis, radiance_snippet
from clerestory.room.window import normal_of

pyradiance = pytest.importorskip("pyradiance")

#: Radiance counts polar angles from its front, the room side: light from outside comes from below its horizon.
SIDES = {
    "transmission_front": ("outside", "room"),
    "transmission_back": ("room", "outside"),
    "reflection_front": ("outside", "outside"),
    "reflection_back": ("room", "room"),
}


SOUTH = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [1.0, 0.0, 1.0]])
TILTED = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]])


def toward(theta: float, phi: float, place: str) -> tuple[list[float], np.ndarray]:
    """Radiance's polar angles of a vector that points from the element to a place, and its (x, y)."""
    sine = np.sin(np.radians(theta))
    xy = sine * np.array([np.cos(np.radians(phi)), np.sin(np.radians(phi))])
    return [theta if place == "room" else 180.0 - theta, phi], xy


def element(kind: str) -> Bsdf:
    return uneven_tree_bsdf(int(kind[-1])) if kind.startswith("tree") else uneven_bsdf(kind)


@pytest.mark.parametrize("kind", [*KLEMS_BASES, "tree3", "tree4"])
def test_values_and_shares_are_found_where_they_were_put(kind: str, tmp_path: Path) -> None:
    bsdf = element(kind)
    rng = np.random.default_rng(4)
    queries, values, hemispheres, shares = [], [], [], []
    for direction, block in bsdf.visible:
        source, target = SIDES[direction]
        for _ in range(60):
            theta, phi = np.degrees(np.arccos(np.sqrt(rng.random(2)))), 360.0 * rng.random(2)
            into, come = toward(theta[0], phi[0], source)
            out, gone = toward(theta[1], phi[1], target)
            queries.append([*into, *out])
            values.append(float(block.at(-come, gone)))
            hemispheres.append([*into, int(direction.startswith("transmission"))])
            shares.append(float(block.hemispherical_at(-come)))
    found_values, found_shares = ask(bsdf.to_xml(tmp_path / "panel.xml"), queries, hemispheres)
    # Radiance shifts each value by up to 3e-4 of itself, to make cells visible in pictures
    assert found_values == pytest.approx(np.array(values), rel=5e-4, abs=1e-7)
    assert found_shares == pytest.approx(np.array(shares), abs=1e-4)


def radiance_program(name: str, *arguments: object, **options: Any) -> Any:
    """What a program of Radiance prints; it finds its files and its fellows beside it."""
    home = Path(pyradiance.__file__).parent
    places = {
        "PATH": os.pathsep.join([str(home / "bin"), os.environ.get("PATH", "")]),
        "RAYPATH": os.pathsep.join([".", str(home / "lib")]),
    }
    program = next(home.glob(f"bin/{name}*"))
    settings: dict[str, Any] = {"text": True, "check": True, "timeout": 600, "env": os.environ | places, **options}
    return subprocess.run([program, *map(str, arguments)], capture_output=True, **settings).stdout


@pytest.mark.parametrize("kind", [*KLEMS_BASES, "tree3", "tree4"])
def test_check_bsdf_finds_our_peaks_on_our_sides(kind: str, tmp_path: Path) -> None:
    bsdf = element(kind)
    told = radiance_program("checkBSDF", bsdf.to_xml(tmp_path / "panel.xml"))
    rows = {
        "reflection_back": "Interior Refl",
        "reflection_front": "Exterior Refl",
        "transmission_back": "Int->Ext Trans",
        "transmission_front": "Ext->Int Trans",
    }
    for direction, block in bsdf.visible:
        peak = re.search(rf"{rows[direction]}[^%\n]*\s([\d.]+)%", told)
        assert float(peak.group(1)) == pytest.approx(100.0 * block.hemispherical().max(), abs=0.11), direction


@pytest.mark.parametrize("rank", [3, 4])
def test_our_klems_matrix_of_a_tree_is_that_of_bsdf2klems(rank: int, tmp_path: Path) -> None:
    bsdf = uneven_tree_bsdf(rank)
    theirs = tmp_path / "theirs.xml"
    theirs.write_text(radiance_program("bsdf2klems", "-q", "-l", 0, "-n", 100, bsdf.to_xml(tmp_path / "tree.xml")))
    found = read_bsdf(theirs)
    for direction, block in bsdf.visible:
        ours, other = in_basis(block, "klems_quarter"), getattr(found.visible, direction)
        # its 100 samples a pair of patches scatter by a few per cent of an uneven tree
        assert np.abs(ours.values - other.values).mean() < 0.02 * ours.values.mean(), direction
        assert ours.hemispherical() == pytest.approx(other.hemispherical(), abs=0.02), direction


@pytest.mark.parametrize("outline", [SOUTH, TILTED], ids=["upright", "tilted"])
def test_rtrace_finds_the_sun_through_our_window(outline: np.ndarray, tmp_path: Path) -> None:
    # light is traced backwards: Radiance asks the other side, which reciprocity makes the same
    front = uneven_block(3)
    band = Band(transmission_front=front, transmission_back=front.reversed(), reflection_front=uneven_block(4))
    band = replace(band, reflection_back=band.reflection_front)
    bsdf = Bsdf(name="reciprocal", thickness_mm=5.0, visible=band, solar=band)
    bsdf.to_xml(tmp_path / "panel.xml")
    # the element's axes in the world, as NOTATION.md has them
    z = normal_of(outline)
    y = np.array([0.0, 0.0, 1.0]) - z * z[2]
    y /= np.linalg.norm(y)
    axes = np.stack([np.cross(y, z), y, z], axis=1)
    rng, disc_deg = np.random.default_rng(7), 0.533
    for _ in range(4):
        sine, phi = np.sqrt(rng.random(2)), 2.0 * np.pi * rng.random(2)
        into, out = np.stack([sine * np.cos(phi), sine * np.sin(phi), np.sqrt(1.0 - sine**2)], axis=1)
        sun, gone = -axes @ into, axes @ out
        scene = f"void light solar 0 0 3 1e6 1e6 1e6\nsolar source sun 0 0 4 {sun[0]} {sun[1]} {sun[2]} {disc_deg}\n"
        scene += radiance_snippet(bsdf, "panel.xml", outline, peak_extraction=False)
        (tmp_path / "scene.rad").write_text(scene)
        (tmp_path / "scene.oct").write_bytes(radiance_program("oconv", "scene.rad", cwd=tmp_path, text=False))
        eye = outline.mean(axis=0) + 2.0 * gone
        ray = " ".join(map(str, [*eye, *-gone])) + "\n"
        seen = radiance_program("rtrace", "-h", "-ab", 0, "-dj", 0, "-ss", 0, "scene.oct", cwd=tmp_path, input=ray)
        irradiance = 1e6 * 2.0 * np.pi * (1.0 - np.cos(np.radians(disc_deg / 2.0))) * into[2]
        assert float(seen.split()[0]) / irradiance == pytest.approx(
            float(front.at(into[:2], out[:2])), rel=2e-3, abs=1e-7
        )
