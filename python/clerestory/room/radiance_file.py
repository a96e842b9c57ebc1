"""Polygons and materials from a Radiance scene file."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass
from clerestory.room.material import Material
from clerestory.room.surface import Surface
from clerestory.room.window import Window
from clerestory.rules import Points

_PHOTOPIC = np.array([0.265, 0.670, 0.065])
"""Weights of red, green and blue in Radiance's luminance."""


@dataclass(frozen=True)
class Primitive:
    """One primitive of a Radiance file: its modifier, type, name, words and numbers, and the line it begins on."""

    modifier: str
    kind: str
    name: str
    words: tuple[str, ...]
    numbers: tuple[float, ...]
    line: int


def read_radiance(
    path: str | os.PathLike[str], *, materials: dict[str, Material] | None = None
) -> tuple[list[Surface], list[Window]]:
    """Surfaces and windows of a Radiance scene file.

    Parameters
    ----------
    path : path-like
        With polygons; plastic, metal, mirror and glass are understood. Seams that cut holes become holes.
    materials : dict of name → Material, optional
        Instead of those of the file, by modifier; for every modifier that is not understood.

    Returns
    -------
    surfaces : list of Surface
    windows : list of Window
        The polygons of glass, corners as in the file.

    Raises
    ------
    ClerestoryError
        If the file cannot be read or is no Radiance scene, names a shape or material that is not understood, or holds
        no polygon; the message gives file and line.
    """
    file = Path(path)
    try:
        text = file.read_text(encoding="utf-8")
    except OSError as cause:
        raise ClerestoryError(f"{file} must be a readable file: {cause.strerror}") from cause
    except UnicodeDecodeError as cause:
        raise ClerestoryError(f"{file.name} must be a Radiance scene, got bytes that are no text") from cause
    defined: dict[str, Primitive] = {}
    surfaces: list[Surface] = []
    windows: list[Window] = []
    for primitive in _primitives(text, file.name):
        where = f"{file.name}, line {primitive.line}"
        if primitive.kind in {"plastic", "metal", "mirror", "glass"} or primitive.name in (materials or {}):
            defined[primitive.name] = primitive
            continue
        if primitive.kind != "polygon":
            raise ClerestoryError(
                f"{where}: primitives must be polygons of plastic, metal, mirror or glass, got {primitive.kind} "
                f"{primitive.name!r}; name its material in materials, or leave it out"
            )
        corners = np.array(primitive.numbers)
        if len(corners) < 9 or len(corners) % 3:
            raise ClerestoryError(
                f"{where}: polygon {primitive.name!r} must have 3 numbers a corner, got {len(corners)}"
            )
        outline, *holes = _loops(corners.reshape(-1, 3))
        taken = {surface.name for surface in surfaces} | {window.name for window in windows}
        name = next(
            title
            for k in range(1, len(taken) + 2)
            if (title := primitive.name if k == 1 else f"{primitive.name} {k}") not in taken
        )
        chosen = (materials or {}).get(primitive.modifier)
        source = defined.get(primitive.modifier)
        if chosen is None and source is None:
            raise ClerestoryError(f"{where}: material {primitive.modifier!r} must be defined before it is used")
        if chosen is None and source is not None and source.kind == "glass":
            windows.append(Window(name=name, outline_m=outline, glazing=_glass(source, where)))  # type: ignore[arg-type]
            continue
        surfaces.append(
            Surface(
                name=name,
                outline_m=outline,  # type: ignore[arg-type]
                holes_m=tuple(holes),  # type: ignore[arg-type]
                material=chosen or _material(source, where),  # type: ignore[arg-type]
            )
        )
    if not surfaces and not windows:
        raise ClerestoryError(f"{file.name} must hold at least one polygon, got none")
    return surfaces, windows


def _primitives(text: str, name: str) -> Iterator[Primitive]:
    tokens = _tokens(text, name)
    for modifier, line in tokens:
        head = [modifier]
        try:
            head += [next(tokens)[0], next(tokens)[0]]
            if head[1] == "alias":
                raise ClerestoryError(f"{name}, line {line}: alias is not understood; write the material out")
            words = tuple(next(tokens)[0] for _ in range(int(next(tokens)[0])))
            if int(next(tokens)[0]) != 0:
                raise ClerestoryError(f"{name}, line {line}: the second count of {head[2]!r} must be 0")
            numbers = tuple(float(next(tokens)[0]) for _ in range(int(next(tokens)[0])))
        except (StopIteration, RuntimeError, ValueError) as cause:
            if isinstance(cause, ClerestoryError):
                raise
            raise ClerestoryError(
                f"{name}, line {line}: a primitive must be modifier, type, name and three counted lists, "
                f"got {' '.join(head)!r} …"
            ) from cause
        if not np.isfinite(numbers).all():
            raise ClerestoryError(f"{name}, line {line}: numbers of {head[2]!r} must be finite")
        yield Primitive(head[0], head[1], head[2], words, numbers, line)


def _tokens(text: str, name: str) -> Iterator[tuple[str, int]]:
    for line, content in enumerate(text.splitlines(), 1):
        if content.lstrip().startswith("!"):
            raise ClerestoryError(
                f"{name}, line {line}: commands are not run; write their output to a file and read that"
            )
        for token in content.split("#", 1)[0].split():
            yield token, line


def _loops(corners: Points) -> list[Points]:
    """Outline and holes of a polygon: edges that are run both ways are seams."""
    keys = [tuple(corner) for corner in corners.round(9).tolist()]
    edges = [(a, b) for a, b in zip(keys, [*keys[1:], keys[0]], strict=True) if a != b]
    following: dict[tuple[float, ...], list[tuple[float, ...]]] = {}
    for a, b in edges:
        if (b, a) not in edges:
            following.setdefault(a, []).append(b)
    loops = []
    while following:
        start = next(iter(following))
        loop, here = [], start
        while here in following:
            loop.append(here)
            there = following[here].pop()
            if not following[here]:
                del following[here]
            here = there
        loops.append(np.array(loop))
    areas = [float(np.linalg.norm(np.cross(loop, np.roll(loop, -1, axis=0)).sum(axis=0))) for loop in loops]
    return [loops[index] for index in np.argsort(areas)[::-1]]


def _material(source: Primitive, where: str) -> Material:
    least = {"plastic": 5, "metal": 5, "mirror": 3}[source.kind]
    if len(source.numbers) < least:
        raise ClerestoryError(
            f"{where}: {source.kind} {source.name!r} must have {least} numbers, got {len(source.numbers)}"
        )
    colour = float(_PHOTOPIC @ source.numbers[:3])
    if source.kind == "mirror":
        return Material(diffuse_reflectance=0.0, specular_reflectance=colour)
    specular = source.numbers[3]
    if source.kind == "metal":
        return Material(diffuse_reflectance=colour * (1.0 - specular), specular_reflectance=colour * specular)
    return Material(diffuse_reflectance=colour * (1.0 - specular), specular_reflectance=specular)


def _glass(source: Primitive, where: str) -> Glass:
    """The file gives the share that survives one crossing of the pane, t; at normal incidence all inner reflections
    together let T = (1 − r)² t / (1 − r² t²) through, r = ((n − 1) / (n + 1))²."""
    if len(source.numbers) < 3:
        raise ClerestoryError(f"{where}: glass {source.name!r} must have 3 numbers, got {len(source.numbers)}")
    through = float(_PHOTOPIC @ source.numbers[:3])
    n = source.numbers[3] if len(source.numbers) > 3 else 1.52
    r = ((n - 1.0) / (n + 1.0)) ** 2
    return Glass(transmittance=(1.0 - r) ** 2 * through / (1.0 - r * r * through * through))
