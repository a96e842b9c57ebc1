"""Where illuminance is asked for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from clerestory.errors import ClerestoryError
from clerestory.room.surface import Surface, check_name
from clerestory.room.window import normal_of
from clerestory.rules import Points, not_negative, number, points, positive


@dataclass(frozen=True, kw_only=True, eq=False)
class Sensors:
    """Points with a normal each.

    Parameters
    ----------
    points_m : array_like, shape (s, 3) [m]
    normals : array_like, shape (s, 3) or (3,), default up
        Of any length but zero; kept as unit vectors.
    name : str, default "sensors"
    row, column : array_like of int, shape (s,), optional
        Place of each sensor in a grid, so that it can be drawn as a plan.
    area_m2 : float, optional
        What each sensor stands for.
    """

    points_m: Points
    normals: Points = (0.0, 0.0, 1.0)  # type: ignore[assignment]
    name: str = "sensors"
    row: npt.NDArray[np.int64] | None = None
    column: npt.NDArray[np.int64] | None = None
    area_m2: float | None = None

    def __post_init__(self) -> None:
        name = check_name(self.name)
        places = points(f"points_m of {name!r}", self.points_m)
        if len(places) == 0:
            raise ClerestoryError(f"points_m of {name!r} must hold at least one point, got none")
        try:
            given = np.asarray(self.normals, dtype=np.float64)
            given = np.broadcast_to(given, places.shape) if given.ndim == 1 else given
        except (TypeError, ValueError) as cause:
            raise ClerestoryError(f"normals of {name!r} must be 3 numbers, or 3 for each point: {cause}") from cause
        normals = points(f"normals of {name!r}", given)
        if normals.shape != places.shape:
            raise ClerestoryError(
                f"normals of {name!r} must be one for each of its {len(places)} points, got {len(normals)}"
            )
        length = np.linalg.norm(normals, axis=1)
        if (length == 0.0).any():
            raise ClerestoryError(f"normals of {name!r} must have a length, got 0 at point {int(np.argmin(length))}")
        object.__setattr__(self, "points_m", places)
        for place in ("row", "column"):
            if getattr(self, place) is not None:
                object.__setattr__(self, place, np.asarray(getattr(self, place), dtype=np.int64))
        # unit vectors stay as they are, to the last digit
        length[np.abs(length - 1.0) < 1e-12] = 1.0
        object.__setattr__(self, "normals", normals / length[:, None])

    def __len__(self) -> int:
        return len(self.points_m)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Sensors)
            and self.name == other.name
            and np.array_equal(self.points_m, other.points_m)
            and np.allclose(self.normals, other.normals, rtol=0.0, atol=1e-15)
        )

    def __hash__(self) -> int:
        return hash((self.name, self.points_m.tobytes()))

    def on(self, _surfaces: Sequence[Surface]) -> Sensors:
        """The sensors themselves: they need no surface."""
        return self


@dataclass(frozen=True, kw_only=True)
class SensorGrid:
    """A regular grid over a surface or at a height above it, centred.

    Parameters
    ----------
    spacing_m : float
        Between neighbours.
    height_m : float, default 0.8
        Above the surface, along its normal; for the floor, the work plane.
    surface : str, default "floor"
        Name of a planar surface of the room.
    offset_m : float, optional
        Least distance from the outline; default half the spacing.
    facing : "away" or "towards", default "away"
        Whether the sensors look away from the surface or towards it.
    flip : bool, default False
        The grid lies on the other side of the surface: its normal is that of its outline, anticlockwise.
    name : str, default the surface's name
    """

    spacing_m: float
    height_m: float = 0.8
    surface: str = "floor"
    offset_m: float | None = None
    facing: str = "away"
    flip: bool = False
    name: str | None = None

    def __post_init__(self) -> None:
        positive("spacing_m", self.spacing_m)
        not_negative("height_m", self.height_m)
        check_name(self.surface)
        if self.offset_m is not None:
            not_negative("offset_m", self.offset_m)
        if self.facing not in ("away", "towards"):
            raise ClerestoryError(f"facing must be away or towards, got {self.facing!r}")

    def on(self, surfaces: Sequence[Surface]) -> Sensors:
        """The sensors over their surface.

        Raises
        ------
        ClerestoryError
            If there is no such surface, or no sensor fits.
        """
        found = next((surface for surface in surfaces if surface.name == self.surface), None)
        if found is None:
            known = ", ".join(surface.name for surface in surfaces)
            raise ClerestoryError(f"surface of a sensor grid must be one of {known}, got {self.surface!r}")
        corners = np.array(found.outline_m)
        normal = normal_of(corners) * (-1.0 if self.flip else 1.0)
        across = corners[1] - corners[0]
        across /= np.linalg.norm(across)
        along = np.cross(normal_of(corners), across)
        flat = np.stack([(corners - corners[0]) @ across, (corners - corners[0]) @ along], axis=1)
        margin = self.spacing_m / 2.0 if self.offset_m is None else self.offset_m
        lines = [_positions(flat[:, k].min(), flat[:, k].max(), self.spacing_m, margin) for k in (0, 1)]
        row, column = np.meshgrid(np.arange(len(lines[1])), np.arange(len(lines[0])), indexing="ij")
        places = np.stack([lines[0][column.ravel()], lines[1][row.ravel()]], axis=1)
        keep = inside_outline(places, flat) & (_distance(places, flat) >= margin - 1e-9)
        if not keep.any():
            raise ClerestoryError(
                f"spacing_m and offset_m of the grid on {self.surface!r} must leave room for a sensor, "
                f"got {self.spacing_m:g} and {margin:g}"
            )
        places = places[keep]
        # a hair above the surface where the sensors lie on it
        height = max(self.height_m, 1e-6)
        return Sensors(
            points_m=corners[0] + places[:, :1] * across + places[:, 1:] * along + height * normal,
            normals=normal if self.facing == "away" else -normal,
            name=self.name or self.surface,
            row=row.ravel()[keep],
            column=column.ravel()[keep],
            area_m2=number("area", self.spacing_m**2),
        )


def _positions(low: float, high: float, spacing: float, margin: float) -> Points:
    steps = int(np.floor((high - low - 2.0 * margin) / spacing + 1e-9))
    if steps < 0:
        return np.empty(0)
    return np.asarray((low + high) / 2.0 + spacing * (np.arange(steps + 1) - steps / 2.0))


def inside_outline(places: Points, corners: Points) -> npt.NDArray[np.bool_]:
    """Which places of a plane lie within an outline, by the even-odd rule."""
    inside = np.zeros(len(places), dtype=bool)
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        crosses = (a[1] > places[:, 1]) != (b[1] > places[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            at = a[0] + (places[:, 1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
        inside ^= crosses & (places[:, 0] < at)
    return inside


def _distance(places: Points, corners: Points) -> Points:
    """From each place to the nearest edge."""
    nearest = np.full(len(places), np.inf)
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        edge = b - a
        share = np.clip((places - a) @ edge / (edge @ edge), 0.0, 1.0)
        nearest = np.minimum(nearest, np.linalg.norm(places - a - share[:, None] * edge, axis=1))
    return nearest
