"""Radiance's matrix programs take our XML as the T of three-phase: V T D s is what numpy makes of our arrays."""

from pathlib import Path

import numpy as np
import pytest
from tests.bsdf.panels_as_matrices import BASIS, laser_cut, prism

pyradiance = pytest.importorskip("pyradiance")


def write_matrix(path: Path, values: np.ndarray) -> Path:
    """A matrix of grey values as Radiance has it."""
    rows, columns = values.shape
    head = f"#?RADIANCE\nNROWS={rows}\nNCOLS={columns}\nNCOMP=3\nFORMAT=ascii\n\n"
    body = "\n".join("\t".join(f"{v:.9g} {v:.9g} {v:.9g}" for v in row) for row in values)
    path.write_text(head + body + "\n")
    return path


def read_matrix(answer: bytes, rows: int) -> np.ndarray:
    """The first of three equal channels, shape (rows, columns)."""
    return np.array(answer.split(), dtype=float).reshape(rows, -1, 3)[:, :, 0]


@pytest.mark.parametrize("make", [laser_cut, prism])
def test_three_phase_is_our_product(make, tmp_path):
    """Tolerance 1e-5 of the largest: the XML has six digits, dctimestep calculates in single precision."""
    rng = np.random.default_rng(5)
    view, daylight = rng.random((4, 145)), rng.random((145, 9))
    sky = rng.random((9, 3))
    bsdf = make()
    paths = [
        write_matrix(tmp_path / "view.mtx", view),
        bsdf.to_xml(tmp_path / "panel.xml"),
        write_matrix(tmp_path / "daylight.mtx", daylight),
        write_matrix(tmp_path / "sky.mtx", sky),
    ]
    answer = read_matrix(pyradiance.dctimestep(*paths, header=False), len(view))
    block = bsdf.visible.transmission_front
    expected = view @ (block.values * BASIS.projected_solid_angle) @ daylight @ sky
    assert np.abs(answer - expected).max() < 1e-5 * expected.max()
    if make is prism:
        # light the other way round would not pass; a laser-cut panel alone is the same both ways
        other = view @ (block.values.T * BASIS.projected_solid_angle) @ daylight @ sky
        assert np.abs(other - expected).max() > 1e-3 * expected.max()
