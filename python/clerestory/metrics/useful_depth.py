"""How deep into a room a level of daylight reaches."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import xarray as xr

from clerestory.errors import ClerestoryError
from clerestory.room.scene import Room
from clerestory.room.window import normal_of
from clerestory.rules import number


def useful_depth(values: xr.DataArray, distance_m: npt.ArrayLike, *, threshold: float = 50.0) -> xr.DataArray:
    r"""How far from the window wall the mean of a row of sensors still reaches a level.

    Parameters
    ----------
    values : DataArray, dims ("sensor",)
        Such as `daylight_autonomy` of 300 lx [percent].
    distance_m : array_like, shape (sensor,)
        From the window wall: `distance_from_window_wall`. Sensors at the same distance are a row.
    threshold : float, default 50
        In the unit of ``values``.

    Returns
    -------
    DataArray without dimensions [m]
        Where the mean of the rows falls below the level, going inwards from the row where it is highest, straight lines
        between rows; 0 if no row reaches it; the distance of the last row if all do: then `at_least` is 1.

    Raises
    ------
    ClerestoryError
        If there is not a distance for each sensor, or a value is missing.

    Notes
    -----
    theory/metrics.md, eq. 16.
    """
    level = number("threshold", threshold)
    distance = np.asarray(distance_m, dtype=np.float64)
    if values.dims != ("sensor",) or distance.shape != values.shape:
        raise ClerestoryError(
            f"distance_m must be one for each sensor of values {dict(values.sizes)}, got shape {distance.shape}"
        )
    if not np.isfinite(values.values).all():
        raise ClerestoryError("values must not be missing at a sensor")
    rows, of_row = np.unique(np.round(distance, 6), return_inverse=True)
    mean = np.bincount(of_row, weights=values.values) / np.bincount(of_row)
    depth, last = 0.0, False
    best = int(np.argmax(mean))
    if mean[best] >= level:
        below = np.flatnonzero(mean[best:] < level)
        last = len(below) == 0
        if last:
            depth = float(rows[-1])
        else:
            k = best + int(below[0])
            depth = float(rows[k - 1] + (rows[k] - rows[k - 1]) * (mean[k - 1] - level) / (mean[k - 1] - mean[k]))
    about = str(values.attrs.get("long_name", values.name or "values"))
    units = {"percent": "%"}.get(str(values.attrs.get("units", "")), str(values.attrs.get("units", "")))
    name = f"depth that {about} of {level:g} {units}".rstrip() + " reaches"
    return xr.DataArray(depth, attrs={"units": "m", "long_name": name, "at_least": int(last)}, name="useful_depth")


def distance_from_window_wall(sensors: xr.DataArray | xr.Dataset, room: Room) -> xr.DataArray:
    """How far each sensor stands from the inner face of the nearest wall with a window.

    Parameters
    ----------
    sensors : DataArray or Dataset with the coordinates of sensors
    room : Room
        Windows in the roof are left out. The inner face is where the surface that the sensors belong to begins, or
        the window itself where they belong to none.

    Returns
    -------
    DataArray, dims ("sensor",) [m]

    Raises
    ------
    ClerestoryError
        If the room has no upright window.
    """
    points = np.stack([sensors[f"{axis}_m"].values for axis in "xyz"], axis=1)
    outlines = {surface.name: np.array(surface.outline_m) for surface in room.surfaces}
    groups = sensors["group"].values
    nearest = np.full(len(points), np.inf)
    for window in room.windows:
        corners = np.array(window.outline_m)
        inwards = normal_of(corners) * np.array([1.0, 1.0, 0.0])
        length = float(np.linalg.norm(inwards))
        if length < 0.5:
            continue
        away = (points - corners[0]) @ inwards / length
        for group in np.unique(groups):
            if group in outlines:
                # the reveal lies between the pane and the room
                reveal = max(0.0, float(((outlines[group] - corners[0]) @ inwards).min()) / length)
                away[groups == group] -= reveal
        nearest = np.where(away >= 0.0, np.minimum(nearest, away), nearest)
    if not np.isfinite(nearest).all():
        raise ClerestoryError("room must have an upright window that its sensors stand before, got none")
    return xr.DataArray(
        nearest, dims="sensor", attrs={"units": "m", "long_name": "distance from the window wall"}, name="distance_m"
    )
