"""Radiance's `dielectric` on the bars: rtrace as pyradiance ships it."""

from __future__ import annotations

import os
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import pyradiance
from panel_geometry import N, boxes, quads, rays

_BIN = Path(pyradiance.__file__).parent / "bin"


def race(count: int) -> tuple[float, float]:
    """CPU seconds of a million rays, and the deflected transmittance."""
    # of the sky, only the part above and beyond shines
    lines = ["void brightfunc side\n2 if(Dz,if(Dy,1,0),0) .\n0\n0", "side glow up\n0\n0\n4 1 1 1 0"]
    lines += ["up source sky\n0\n0\n4 0 1 0 360", f"void dielectric glass\n0\n0\n5 1 1 1 {N} 0"]
    for i, (low, high) in enumerate(boxes()):
        for j, quad in enumerate(quads(low, high)):
            numbers = " ".join(f"{x:.9g}" for x in quad.ravel())
            lines.append(f"glass polygon f{i}_{j}\n0\n0\n12 {numbers}")
    origins, direction = rays(count)
    table = np.hstack([origins, np.broadcast_to(direction, origins.shape)])
    environment = os.environ | {"RAYPATH": str(Path(pyradiance.__file__).parent / "lib")}
    with tempfile.TemporaryDirectory() as folder:
        scene, octree = Path(folder) / "panel.rad", Path(folder) / "panel.oct"
        scene.write_text("\n".join(lines))
        with octree.open("wb") as out:
            subprocess.run([_BIN / "oconv", scene], stdout=out, check=True, env=environment)
        before = os.times()
        command = [_BIN / "rtrace", "-h", "-ab", "0", "-lr", "80", "-lw", "1e-5", "-fdd", octree]
        done = subprocess.run(command, input=table.tobytes(), capture_output=True, check=True, env=environment)
        after = os.times()
    seconds = after.children_user + after.children_system - before.children_user - before.children_system
    return 1e6 * seconds / count, float(np.frombuffer(done.stdout).reshape(-1, 3)[:, 0].mean())


if __name__ == "__main__":
    began = time.perf_counter()
    print(race(2000), time.perf_counter() - began)
