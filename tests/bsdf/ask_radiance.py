"""Asks Radiance's library about one BSDF file, in a process of its own: it can crash, and keeps state between files."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np


def ask(xml: Path, queries: list[list[float]], hemispheres: list[list[float]]) -> tuple[np.ndarray, np.ndarray]:
    """Values [1/sr] and hemispherical shares as Radiance finds them.

    Parameters
    ----------
    xml : Path
    queries : list of [theta, phi, theta, phi] in degrees
        Of the vectors that point from the element to where light comes from and where it goes.
    hemispheres : list of [theta, phi, 1 if transmitted else 0]
    """
    question = json.dumps({"xml": str(xml), "queries": queries, "hemispheres": hemispheres})
    answer = subprocess.run(
        [sys.executable, __file__], input=question, capture_output=True, text=True, timeout=600, check=False
    )
    assert answer.returncode == 0, f"Radiance's library ended with {answer.returncode}: {answer.stderr[-500:]}"
    found = json.loads(answer.stdout)
    return np.array(found["values"]), np.array(found["shares"])


def _answer() -> None:
    from pyradiance import bsdf

    question = json.load(sys.stdin)
    read = bsdf.load_file(question["xml"])
    values = [float(bsdf.query(read, *angles)[1]) for angles in question["queries"]]
    kinds = {0: bsdf.SAMPLE_ALL & ~bsdf.SAMPLE_T, 1: bsdf.SAMPLE_ALL & ~bsdf.SAMPLE_R}
    shares = [float(bsdf.direct_hemi(read, theta, phi, kinds[int(way)])) for theta, phi, way in question["hemispheres"]]
    json.dump({"values": values, "shares": shares}, sys.stdout)


if __name__ == "__main__":
    _answer()
