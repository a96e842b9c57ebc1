"""A Mitsuba 3 loop in the reference room: cosine-sampled paths that gather into the patch of the sky they reach."""

from __future__ import annotations

import json
import sys
from functools import partial
from pathlib import Path

import mitsuba as mi
import numpy as np
from room_reference import TRANSMITTANCE, Floats, cpu_seconds, rectangles_m, sensor_points_m

from clerestory import sky_basis

_VARIANT = "llvm_ad_rgb"


def race(paths_per_sensor: list[int], basis: str) -> list[tuple[float, Floats]]:
    """Least CPU seconds and coefficients (runs, sensors, patches) for each number of paths; kernels compile before."""
    mi.set_variant(_VARIANT)
    import drjit as dr

    scene = mi.load_dict(_scene())
    sensors = sensor_points_m()
    patches = sky_basis(basis)
    rings = _rings(np.asarray(patches.bounds))
    columns = len(patches.centres)
    # a pane of n = 1.52 with the absorption that gives its transmittance
    glass = mi.Float(_glass(np.linspace(0.0, 1.0, 1025)).astype(np.float32))
    edges = mi.Float(rings[0].astype(np.float32))
    first, count, start, width = (mi.Float(column.astype(np.float32)) for column in rings[1:])

    def trace(paths: int, seed: int) -> np.ndarray:
        total = paths * len(sensors)
        sampler = mi.load_dict({"type": "independent"})
        sampler.seed(seed, total)
        sensor = dr.arange(mi.UInt32, total) // paths
        at = mi.Point3f(*(dr.gather(mi.Float, mi.Float(sensors[:, k].astype(np.float32)), sensor) for k in range(3)))
        ray = mi.Ray3f(at, mi.warp.square_to_cosine_hemisphere(sampler.next_2d()))

        def body(ray, active, share, sampler):
            hit = scene.ray_intersect(ray, active)
            inside = active & hit.is_valid()
            reflectance = hit.bsdf().eval_diffuse_reflectance(hit, inside).x
            local = mi.warp.square_to_cosine_hemisphere(sampler.next_2d(active))
            onward = hit.spawn_ray(hit.to_world(local))
            # survival by reflectance: a path keeps its whole weight
            inside &= sampler.next_1d(active) < reflectance
            ended = active & hit.is_valid() & ~inside
            share = dr.select(ended, 0.0, share)
            ray = dr.select(inside, onward, ray)
            return ray, inside, share, sampler

        state = (ray, dr.full(mi.Bool, True, total), dr.full(mi.Float, 1.0, total), sampler)
        ray, _, share, sampler = dr.while_loop(state, lambda r, a, s, p: a, body)
        d = ray.d
        at_glass = dr.clip(dr.abs(d.y), 0.0, 1.0) * 1024.0
        cell = dr.minimum(mi.UInt32(at_glass), 1023)
        rest = at_glass - mi.Float(cell)
        through = dr.lerp(dr.gather(mi.Float, glass, cell), dr.gather(mi.Float, glass, cell + 1), rest)
        # ring by the sine of its lower altitude, sector by azimuth clockwise from north
        ring = mi.UInt32(0)
        for k in range(1, len(rings[0])):
            ring = dr.select(d.z >= dr.gather(mi.Float, edges, mi.UInt32(k)), mi.UInt32(k), ring)
        azimuth = dr.atan2(d.x, d.y) - dr.gather(mi.Float, start, ring)
        turns = azimuth / dr.gather(mi.Float, width, ring)
        many = dr.gather(mi.Float, count, ring)
        sector = dr.floor(turns - many * dr.floor(turns / many))
        patch = mi.UInt32(dr.gather(mi.Float, first, ring) + dr.minimum(sector, many - 1.0))
        patch = dr.select(d.z < 0.0, mi.UInt32(columns - 1), patch)
        sums = dr.zeros(mi.Float, len(sensors) * columns)
        dr.scatter_reduce(dr.ReduceOp.Add, sums, share * through, sensor * columns + patch)
        return np.pi * np.array(sums, dtype=np.float64).reshape(len(sensors), columns) / paths

    results = []
    for paths in paths_per_sensor:
        trace(paths, 1)
        runs = [cpu_seconds(partial(trace, paths, seed)) for seed in (2, 3)]
        results.append((min(seconds for seconds, _ in runs), np.array([found for _, found in runs])))
    return results


def _scene() -> dict:
    scene: dict = {"type": "scene"}
    for name, reflectance, corners in rectangles_m():
        a, b, c, d = (np.array(corner) for corner in corners)
        # the rectangle spans -1..1 in x and y
        to_world = np.eye(4)
        to_world[:3, 0], to_world[:3, 1] = (b - a) / 2.0, (d - a) / 2.0
        to_world[:3, 2] = np.cross(to_world[:3, 0], to_world[:3, 1])
        to_world[:3, 3] = (a + c) / 2.0
        bsdf = {"type": "diffuse", "reflectance": {"type": "rgb", "value": reflectance}}
        transform = mi.ScalarTransform4f(to_world)
        scene[name] = {"type": "rectangle", "to_world": transform, "bsdf": {"type": "twosided", "bsdf": bsdf}}
    return scene


def _rings(bounds: Floats) -> tuple[np.ndarray, ...]:
    """Sine of the lower altitude, first patch, sectors, where the first starts, and width of each ring."""
    low = np.sin(bounds[:-1, 0])
    edges, first, count = np.unique(np.round(low, 9), return_index=True, return_counts=True)
    width = bounds[first, 3] - bounds[first, 2]
    return edges, first, count, bounds[first, 2], width


def _glass(cos_i: Floats) -> Floats:
    n = 1.52
    cos_t = np.sqrt(1.0 - (1.0 - cos_i**2) / n**2)

    def slab(inner: float | Floats) -> Floats:
        s = ((cos_i - n * cos_t) / (cos_i + n * cos_t)) ** 2
        p = ((n * cos_i - cos_t) / (n * cos_i + cos_t)) ** 2
        return sum(0.5 * inner * (1 - r) ** 2 / (1 - (r * inner) ** 2) for r in (s, p))

    low, high = 0.0, 1.0
    r0 = ((n - 1.0) / (n + 1.0)) ** 2
    for _ in range(60):
        inner = (low + high) / 2.0
        found = inner * (1 - r0) ** 2 / (1 - (r0 * inner) ** 2)
        low, high = (inner, high) if found < TRANSMITTANCE else (low, inner)
    return slab(inner ** (1.0 / cos_t))


def main() -> None:
    """Writes what a list of races gives beside the file that asks for it."""
    asked = Path(sys.argv[1])
    basis, paths = json.loads(asked.read_text())
    results = race(paths, basis)
    np.savez(asked.with_suffix(".npz"), seconds=[s for s, _ in results], coefficients=[c for _, c in results])


if __name__ == "__main__":
    main()
