"""A Mitsuba 3 walk through the bars: Fresnel decides at random, as the walk of the package does."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

import mitsuba as mi
import numpy as np
from panel_geometry import N, boxes, quads, rays


def _obj(path: Path) -> None:
    vertices, faces = [], []
    for low, high in boxes():
        for quad in quads(low, high):
            start = 4 * (len(vertices) // 4) + 1
            vertices += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in quad]
            faces += [f"f {start} {start + 1} {start + 2}", f"f {start} {start + 2} {start + 3}"]
    path.write_text("\n".join(vertices + faces) + "\n")


def race(variant: str, count: int) -> tuple[float, float]:
    """CPU seconds of a million rays, and the deflected transmittance."""
    mi.set_variant(variant)
    import drjit as dr

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "panel.obj"
        _obj(path)
        bsdf = {"type": "dielectric", "int_ior": N, "ext_ior": 1.0}
        panel = {"type": "obj", "filename": str(path), "face_normals": True, "bsdf": bsdf}
        scene = mi.load_dict({"type": "scene", "panel": panel})
    origins, direction = rays(count)

    # LLVM 17 or newer is needed on some processors; DRJIT_LIBLLVM_PATH names it
    def walk(seed: int) -> np.ndarray:
        sampler = mi.load_dict({"type": "independent"})
        sampler.seed(seed, count)
        ray = mi.Ray3f(mi.Point3f(*origins.T.astype(np.float32)), mi.Vector3f(*(float(x) for x in direction)))
        context = mi.BSDFContext()

        def body(ray, active, depth, sampler):
            hit = scene.ray_intersect(ray, active)
            active &= hit.is_valid()
            sample, _ = hit.bsdf().sample(context, hit, sampler.next_1d(active), sampler.next_2d(active), active)
            ray = dr.select(active, hit.spawn_ray(hit.to_world(sample.wo)), ray)
            depth += 1
            return ray, active & (depth < 2000), depth, sampler

        state = (ray, dr.full(mi.Bool, True, count), dr.zeros(mi.UInt32, count), sampler)
        ray, _, _, sampler = dr.while_loop(state, lambda r, a, d, s: a, body)
        return np.array(ray.d)

    walk(0)
    before = os.times()
    d = walk(1).reshape(3, -1)
    after = os.times()
    seconds = after.user + after.system - before.user - before.system
    return 1e6 * seconds / count, float(np.mean((d[2] > 0) & (d[1] > 0)))


if __name__ == "__main__":
    print(race("llvm_ad_mono", 1_000_000))
