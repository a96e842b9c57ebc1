"""A Klems matrix of the bars by Radiance's ray tracer: rfluxmtx as pyradiance ships it, one half of it a side."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pyradiance
from numpy.typing import NDArray
from panel_geometry import D_OVER_W, N, boxes, quads

Floats = NDArray[np.float64]

_BIN = Path(pyradiance.__file__).parent / "bin"
#: Ways of asking: rays for each incident patch, and the options of the tracer.
SETTINGS = {
    "tuned": (300, ["-ab", "0", "-lr", "60", "-lw", "1e-4"]),
    "fine": (2000, ["-ab", "0", "-lr", "80", "-lw", "1e-5"]),
}


def _scene() -> str:
    lines = [f"void dielectric glass\n0\n0\n5 1 1 1 {N} 0"]
    for i, (low, high) in enumerate(boxes()):
        for j, quad in enumerate(quads(low, high)):
            numbers = " ".join(f"{x:.9g}" for x in quad.ravel())
            lines.append(f"glass polygon f{i}_{j}\n0\n0\n12 {numbers}")
    return "\n".join(lines)


def _sender(z: float, normal: int) -> str:
    """One period of the plane at this height; rays leave against its normal."""
    y = 0.5 * D_OVER_W
    corners = [(-0.5, -y), (-0.5, y), (0.5, y), (0.5, -y)]
    corners = corners if normal < 0 else corners[::-1]
    numbers = " ".join(f"{x:.9g} {y:.9g} {z:.9g}" for x, y in corners)
    return (
        f"#@rfluxmtx h=kf u=Y\nvoid glow sender_mat\n0\n0\n4 1 1 1 0\nsender_mat polygon sender\n0\n0\n12 {numbers}\n"
    )


def _receivers(folder: Path) -> str:
    return "".join(
        f"#@rfluxmtx h=kf u=Y o={folder / name}.mtx\nvoid glow {name}_mat\n0\n0\n4 1 1 1 0\n"
        f"{name}_mat source {name}\n0\n0\n4 0 0 {z} 180\n"
        for name, z in (("above", 1), ("below", -1))
    )


def _read(path: Path) -> Floats:
    """A matrix of the tracer's: (incident, outgoing), the first of its three equal colours."""
    head, _, body = path.read_bytes().partition(b"\n\n")
    words = dict(line.split(b"=", 1) for line in head.splitlines() if b"=" in line)
    rows, columns = int(words[b"NROWS"]), int(words[b"NCOLS"])
    values = np.array(body.split(), dtype=np.float64)
    return values.reshape(rows, columns, -1)[:, :, 0]


def race(setting: str) -> tuple[float, list[list[list[float]]]]:
    """CPU seconds of both sides, and where light from the front goes: transmitted, reflected (incident, outgoing)."""
    count, options = SETTINGS[setting]
    environment = os.environ | {
        "RAYPATH": str(Path(pyradiance.__file__).parent / "lib"),
        "PATH": str(_BIN) + os.pathsep + os.environ["PATH"],
    }
    seconds, shares = 0.0, []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "panel.rad").write_text(_scene())
        (folder / "receivers.rad").write_text(_receivers(folder))
        for z, normal in ((-0.01, -1), (1.01, 1)):
            (folder / "sender.rad").write_text(_sender(z, normal))
            before = os.times()
            command = ["rfluxmtx", "-v-", "-n", "1", "-fa", "-c", str(count), *options]
            files = [str(folder / f"{part}.rad") for part in ("sender", "receivers", "panel")]
            subprocess.run([_BIN / command[0], *command[1:], *files], check=True, env=environment, capture_output=True)
            after = os.times()
            seconds += after.children_user + after.children_system - before.children_user - before.children_system
            shares.append([_read(folder / f"{part}.mtx").tolist() for part in ("above", "below")])
    return seconds, shares[0]


if __name__ == "__main__":
    found = race(sys.argv[1] if len(sys.argv) > 1 else "tuned")
    print(found[0], np.sum(found[1], axis=(0, 2)))
