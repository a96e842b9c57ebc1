"""A year of skies and suns by gendaymtx."""

from __future__ import annotations

import re
import subprocess
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

EFFICACY = 179.0
"""Radiance's lumens per watt, between its radiance and luminance."""
DISC_SR = np.pi * np.radians(0.533 / 2.0) ** 2


class RadianceYear(NamedTuple):
    """Patches as here, the ground last, and suns, time by time; a sun of no length is below the horizon."""

    luminance: Array
    with_sun: Array
    sun: Array
    sun_lx: Array


def radiance_year(weather: Path, *, hours: int) -> RadianceYear:
    """What gendaymtx makes of an EPW file of whole hours from the beginning of a year without a leap day."""
    import pyradiance

    program = Path(pyradiance.__file__).parent / "bin" / "gendaymtx"
    with tempfile.TemporaryDirectory() as folder:
        suns = Path(folder) / "suns.rad"
        told = {"stderr": subprocess.DEVNULL, "stdout": subprocess.PIPE, "check": True}
        plain = [str(program), "-h", "-c", "1", "1", "1"]
        tables = [
            subprocess.run([*plain, "-m", "1", *kind, "-of", str(weather)], **told).stdout for kind in (["-s"], [])
        ]
        subprocess.run([*plain, "-D", str(suns), "-n", str(weather)], **told)
        text = suns.read_text()
    patches, with_sun = (
        np.roll(np.frombuffer(table, dtype=np.float32).reshape(146, hours, 3)[:, :, 1], -1, axis=0) * EFFICACY
        for table in tables
    )
    # minutes of the year, the middle of each hour
    row = (np.array(re.findall(r"source sun(\d+)", text), dtype=np.int64) - 30) // 60
    numbers = [line.split()[1:4] for line in text.splitlines() if line.startswith(("3 ", "4 "))]
    radiance, towards = np.array(numbers[0::2], dtype=np.float64), np.array(numbers[1::2], dtype=np.float64)
    sun, sun_lx = np.zeros((hours, 3)), np.zeros(hours)
    sun[row] = towards / np.linalg.norm(towards, axis=1, keepdims=True)
    sun_lx[row] = radiance[:, 1] * EFFICACY * DISC_SR
    return RadianceYear(patches.astype(np.float64), with_sun.astype(np.float64), sun, sun_lx)
