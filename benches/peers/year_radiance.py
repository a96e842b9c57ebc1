"""Radiance's `gendaymtx` and `dctimestep`, as pyradiance ships them."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import numpy as np
import pyradiance
from numpy.typing import NDArray
from room_reference import cpu_seconds

_BIN = Path(pyradiance.__file__).parent / "bin"
#: From Radiance's radiance to luminance [lm/W].
EFFICACY = 179.0
Singles = NDArray[np.float32]


def _run(command: list[str | Path], out: Path) -> float:
    environment = os.environ | {"RAYPATH": str(_BIN.parent / "lib")}

    def work() -> None:
        with out.open("wb") as file:
            subprocess.run(command, stdout=file, stderr=subprocess.DEVNULL, check=True, env=environment)

    return cpu_seconds(work, children=True)[0]


def sky_matrix(weather: Path, factor: int, out: Path) -> float:
    """CPU seconds of `gendaymtx` without the sun, in binary; the matrix is the file."""
    return _run([_BIN / "gendaymtx", "-m", str(factor), "-s", "-of", "-c", "1", "1", "1", weather], out)


def read_sky_matrix(path: Path) -> Singles:
    """Luminances of a matrix of `gendaymtx`, (time, patch), the ground last [cd/m²]."""
    table = _body(path)
    rows = int(next(line for line in path.read_bytes()[:2000].split(b"\n") if line.startswith(b"NROWS="))[6:])
    patches = table.reshape(rows, -1, 3)[:, :, 1] * np.float32(EFFICACY)
    return np.ascontiguousarray(np.roll(patches, -1, axis=0).T)


def write_coefficients(coefficients: NDArray[np.float64], path: Path) -> None:
    """Coefficients in Radiance's order, the ground first, as a binary matrix of three equal colours."""
    ordered = np.roll(coefficients, 1, axis=1).astype(np.float32)
    header = f"#?RADIANCE\nNROWS={ordered.shape[0]}\nNCOLS={ordered.shape[1]}\nNCOMP=3\nBigEndian=0\nFORMAT=float\n\n"
    path.write_bytes(header.encode() + np.repeat(ordered[:, :, None], 3, axis=2).tobytes())


def product(coefficients: Path, sky: Path, out: Path) -> tuple[float, Singles]:
    """CPU seconds of `dctimestep` and the illuminances, (sensor, time)."""
    seconds = _run([_BIN / "dctimestep", "-h", "-of", coefficients, sky], out)
    rows = int(next(line for line in coefficients.read_bytes()[:200].split(b"\n") if line.startswith(b"NROWS="))[6:])
    values = np.frombuffer(out.read_bytes(), dtype=np.float32).reshape(rows, -1, 3)[:, :, 1]
    return seconds, values * np.float32(EFFICACY)


def _body(path: Path) -> Singles:
    content = path.read_bytes()
    return np.frombuffer(content[content.index(b"\n\n") + 2 :], dtype=np.float32)
