"""Sensor points as text: six numbers a line, place and direction, which `rtrace` and its kin read."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.room.sensors import Sensors
from clerestory.saving import write_text


def write_pts(sensors: Sensors | xr.Dataset, path: str | os.PathLike[str]) -> Path:
    """Writes points and directions, one sensor a line: x y z dx dy dz, in metres.

    Parameters
    ----------
    sensors : Sensors, or Dataset with the coordinates of sensors
        A result such as that of `daylight_coefficients`.
    path : path-like

    Raises
    ------
    ClerestoryError
        If the Dataset has no sensors, or the file cannot be written.
    """
    if isinstance(sensors, Sensors):
        rows = np.hstack([sensors.points_m, sensors.normals])
    else:
        names = ["x_m", "y_m", "z_m", "normal_x", "normal_y", "normal_z"]
        missing = [name for name in names if name not in sensors.coords]
        if missing:
            raise ClerestoryError(f"sensors must have the coordinates {', '.join(names)}, got no {missing[0]}")
        rows = np.stack([sensors[name].values for name in names], axis=1)
    return write_text(path, "".join(" ".join(f"{value:.9g}" for value in row) + "\n" for row in rows))


def read_pts(path: str | os.PathLike[str], *, name: str | None = None) -> Sensors:
    """Sensors from such a file; lines that begin with ``#`` and empty ones are left out.

    Parameters
    ----------
    path : path-like
    name : str, optional
        Of the group; default the file's name without ending.

    Raises
    ------
    ClerestoryError
        If the file cannot be read or a line does not have six numbers.
    """
    file = Path(path)
    try:
        lines = file.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as cause:
        raise ClerestoryError(f"{file} must be a readable text file, got: {cause}") from None
    rows = []
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        try:
            row = [float(word) for word in line.replace(",", " ").split()]
        except ValueError:
            row = []
        if len(row) != 6:
            raise ClerestoryError(f"{file.name}, line {number}: must be six numbers, x y z dx dy dz, got {line[:60]!r}")
        rows.append(row)
    if not rows:
        raise ClerestoryError(f"{file.name} must hold at least one point, got none")
    table = np.array(rows)
    return Sensors(points_m=table[:, :3], normals=table[:, 3:], name=name or file.stem)
