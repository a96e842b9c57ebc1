"""Meshes from OBJ, STL and glTF files."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any

import numpy as np

from clerestory.errors import ClerestoryError
from clerestory.room.material import Material
from clerestory.room.surface import Mesh
from clerestory.rules import one_of, positive

FORMATS = (".obj", ".stl", ".gltf", ".glb")
"""Mesh files that can be read; others that trimesh reads may work."""


def read_meshes(
    path: str | os.PathLike[str],
    *,
    materials: dict[str, Material] | None = None,
    material: Material | None = None,
    scale: float = 1.0,
    up_axis: str | None = None,
) -> list[Mesh]:
    """The meshes of a file, each with a material.

    Parameters
    ----------
    path : path-like
        OBJ, STL, glTF or GLB.
    materials : dict of name → Material, optional
        By the name of the object or of its material in the file.
    material : Material, optional
        Of everything that ``materials`` does not name.
    scale : float, default 1
        Metres per unit of the file: 0.001 for millimetres.
    up_axis : "y" or "z", optional
        What is up in the file; default y for glTF, as its standard says, and z otherwise.

    Returns
    -------
    list of Mesh
        One for each object and material, named after the file and both.

    Raises
    ------
    ClerestoryError
        If the file is not what its name says, is empty, holds numbers that are not finite, or an object has no
        material.
    """
    import trimesh

    file = Path(path)
    one_of(f"ending of {file.name}", file.suffix.lower(), FORMATS)
    positive("scale", scale)
    up = one_of("up_axis", up_axis or ("y" if file.suffix.lower() in {".gltf", ".glb"} else "z"), ("y", "z"))
    if not file.is_file():
        raise ClerestoryError(f"{file} must be a readable file, got none there")
    try:
        loaded = _obj(file) if file.suffix.lower() == ".obj" else trimesh.load_scene(file, process=False)
        parts = [
            (str(name), loaded.graph.get(node), loaded.geometry[name])
            for node in loaded.graph.nodes_geometry
            for name in [loaded.graph[node][1]]
        ]
    except Exception as cause:  # the readers of trimesh raise whatever they stumble upon
        raise ClerestoryError(f"{file.name} must be what its name says: {cause}") from cause
    solids = [(name, place[0], shape) for name, place, shape in parts if len(getattr(shape, "faces", ())) > 0]
    if not solids:
        raise ClerestoryError(f"{file.name} must hold triangles, got none")
    made: list[Mesh] = []
    for name, transform, shape in solids:
        inner = _material_name(shape)
        chosen = (materials or {}).get(name) or (materials or {}).get(inner) or material
        if chosen is None:
            raise ClerestoryError(
                f"materials must name {name!r}"
                + (f" or its material {inner!r}" if inner else "")
                + f" of {file.name}, got {', '.join(materials or {}) or 'none'}"
            )
        vertices = scale * (np.asarray(shape.vertices) @ transform[:3, :3].T + transform[:3, 3])
        if up == "y":
            vertices = vertices[:, [0, 2, 1]] * [1.0, -1.0, 1.0]
        taken = {mesh.name for mesh in made}
        title = f"{file.stem}: {name}"
        copy = next(k for k in range(1, len(solids) + 1) if (title if k == 1 else f"{title} {k}") not in taken)
        made.append(
            Mesh(
                name=title if copy == 1 else f"{title} {copy}",
                vertices_m=vertices,
                triangles=np.asarray(shape.faces, dtype=np.int64),
                material=chosen,
            )
        )
    return made


def _obj(file: Path) -> Any:
    """An OBJ file divided by its ``usemtl`` lines; the names alone matter, so its material library need not exist."""
    import trimesh

    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("mtllib")]
    names = {line.split(maxsplit=1)[1].strip() for line in lines if line.startswith("usemtl ")}

    library = "".join(f"newmtl {name}\nKd 1 1 1\n" for name in sorted(names)).encode()
    text = "\n".join(["mtllib names", *lines, ""])
    return trimesh.load_scene(io.StringIO(text), file_type="obj", resolver={"names": library}, process=False)


def _material_name(shape: Any) -> str:
    inner = getattr(getattr(shape, "visual", None), "material", None)
    return str(getattr(inner, "name", "") or "")
