"""Opaque surfaces and boundaries between media."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from clerestory.errors import ClerestoryError
from clerestory.room.material import Material
from clerestory.rules import not_negative, points, within

Outline = tuple[tuple[float, float, float], ...]


def as_outline(name: str, value: Any) -> Outline:
    """Corners of a polygon, at least three."""
    array = points(name, value)
    if len(array) < 3:
        raise ClerestoryError(f"{name} must have at least 3 corners, got {len(array)}")
    return tuple((float(x), float(y), float(z)) for x, y, z in array)


@dataclass(frozen=True, kw_only=True)
class Surface:
    """An opaque planar polygon.

    Parameters
    ----------
    name : str
        Of its own in the room.
    outline_m : array_like, shape (n, 3) [m]
        Corners in order, either way round; both sides reflect.
    material : Material
    holes_m : sequence of array_like, default ()
        Corners of openings within the outline.
    """

    name: str
    outline_m: Outline
    material: Material
    holes_m: tuple[Outline, ...] = ()

    def __post_init__(self) -> None:
        name = check_name(self.name)
        object.__setattr__(self, "outline_m", as_outline(f"outline_m of {name!r}", self.outline_m))
        holes = tuple(as_outline(f"holes_m[{k}] of {name!r}", hole) for k, hole in enumerate(self.holes_m))
        object.__setattr__(self, "holes_m", holes)
        check_material(name, self.material)


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh:
    """An opaque body or sheet of triangles.

    Parameters
    ----------
    name : str
    vertices_m : array_like, shape (v, 3) [m]
    triangles : array_like of int, shape (t, 3)
        Rows of ``vertices_m``.
    material : Material
    """

    name: str
    vertices_m: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int64]
    material: Material

    def __post_init__(self) -> None:
        _keep_mesh(self)
        check_material(self.name, self.material)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mesh) and self.material == other.material and _same_mesh(self, other)

    def __hash__(self) -> int:
        return hash((self.name, self.material, self.vertices_m.tobytes(), self.triangles.tobytes()))


@dataclass(frozen=True, kw_only=True, eq=False)
class Interface:
    """A smooth boundary between two media: the face of a prism, a block, a light guide, a bar of a panel.

    Parameters
    ----------
    name : str
    vertices_m : array_like, shape (v, 3) [m]
    triangles : array_like of int, shape (t, 3)
        The front is the side from which the corners run anticlockwise.
    front_index, back_index : float, at least 1
        Refractive index of the medium on either side; air is 1.
    front_absorption_per_m, back_absorption_per_m : float, default 0
        Absorption on the way through either medium [1/m].
    """

    name: str
    vertices_m: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int64]
    back_index: float
    front_index: float = 1.0
    front_absorption_per_m: float = 0.0
    back_absorption_per_m: float = 0.0

    def __post_init__(self) -> None:
        _keep_mesh(self)
        for side in ("front", "back"):
            within(f"{side}_index of {self.name!r}", getattr(self, f"{side}_index"), 1.0, 5.0)
            not_negative(f"{side}_absorption_per_m of {self.name!r}", getattr(self, f"{side}_absorption_per_m"))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Interface) and self.media == other.media and _same_mesh(self, other)

    def __hash__(self) -> int:
        return hash((self.name, self.media, self.vertices_m.tobytes(), self.triangles.tobytes()))

    @property
    def media(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Index and absorption [1/m] of front and back."""
        return (
            (self.front_index, self.front_absorption_per_m),
            (self.back_index, self.back_absorption_per_m),
        )


def check_name(name: Any) -> str:
    """A name that can be written on one line."""
    if not isinstance(name, str) or not name.strip() or "\n" in name:
        raise ClerestoryError(f"name must be a word or more on one line, got {name!r}")
    return name


def check_material(name: str, material: Any) -> None:
    """Fails unless the thing of that name has a material."""
    if not isinstance(material, Material):
        raise ClerestoryError(f"material of {name!r} must be a Material(diffuse_reflectance=…), got {material!r}")


def _keep_mesh(mesh: Mesh | Interface) -> None:
    name = check_name(mesh.name)
    vertices = points(f"vertices_m of {name!r}", mesh.vertices_m)
    try:
        triangles = np.asarray(mesh.triangles)
    except ValueError as cause:
        raise ClerestoryError(f"triangles of {name!r} must be rows of 3 whole numbers: {cause}") from cause
    if triangles.ndim != 2 or triangles.shape[1] != 3 or not np.issubdtype(triangles.dtype, np.integer):
        raise ClerestoryError(
            f"triangles of {name!r} must be rows of 3 whole numbers, got shape {triangles.shape} of {triangles.dtype}"
        )
    if len(triangles) == 0:
        raise ClerestoryError(f"triangles of {name!r} must hold at least one, got none")
    if triangles.min() < 0 or triangles.max() >= len(vertices):
        raise ClerestoryError(
            f"triangles of {name!r} must count from 0 to {len(vertices) - 1}, got {triangles.min()}..{triangles.max()}"
        )
    vertices, triangles = vertices.copy(), triangles.astype(np.int64)
    vertices.flags.writeable = triangles.flags.writeable = False
    object.__setattr__(mesh, "vertices_m", vertices)
    object.__setattr__(mesh, "triangles", triangles)


def _same_mesh(one: Mesh | Interface, other: Mesh | Interface) -> bool:
    return (
        one.name == other.name
        and np.array_equal(one.vertices_m, other.vertices_m)
        and np.array_equal(one.triangles, other.triangles)
    )
