"""What Berkeley Lab's engine says of layers, computed in a process of its own: it can crash and take ours with it."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any


def wincalc(request: dict[str, Any]) -> dict[str, Any]:
    """Results of pywincalc.

    Parameters
    ----------
    request : dict
        ``layers``: paths of .DAT or BSDF .xml files, the outermost first; ``theta_deg``; ``phi_deg`` (0);
        ``methods``; ``basis`` ("FULL", only with BSDF layers); ``matrices`` (bool).

    Returns
    -------
    dict
        Method → a row for each angle with ``front`` and ``back`` (such as "transmission direct_direct"; at the first
        angle "transmission matrix" if asked for) and the ``absorptance`` of each layer of light on the front;
        ``source``: wavelengths [nm] and power of the standard's sunlight.
    """
    answer = subprocess.run(
        [sys.executable, __file__], input=json.dumps(request), capture_output=True, text=True, check=False, timeout=600
    )
    if answer.returncode != 0:
        raise RuntimeError(f"pywincalc ended with {answer.returncode}: {answer.stderr[-2000:]}")
    found: dict[str, Any] = json.loads(answer.stdout.splitlines()[-1])
    return found


def _matrix(square: Any) -> list[list[float]]:
    size = square.size()
    return [[square[row, column] for column in range(size)] for row in range(size)]


def _side(side: Any, has_matrix: bool) -> dict[str, Any]:
    parts = {"transmission": side.transmittance, "reflection": side.reflectance}
    found: dict[str, Any] = {}
    for name, part in parts.items():
        for kind in ("direct_direct", "direct_hemispherical", "diffuse_diffuse"):
            found[f"{name} {kind}"] = getattr(part, kind)
        if has_matrix:
            found[f"{name} matrix"] = [list(row) for row in part.matrix]
    return found


def main() -> None:
    """Reads a request, writes its answer."""
    import pywincalc

    request = json.loads(sys.stdin.read())
    standard = pywincalc.load_standard(str(Path(pywincalc.standard_path) / "W5_NFRC_2003.std"))
    is_bsdf = "basis" in request
    read = {".xml": pywincalc.parse_bsdf_xml_file, ".dat": pywincalc.parse_optics_file}
    layers = [read[Path(path).suffix.lower()](path) for path in request["layers"]]
    basis = getattr(pywincalc.BSDFBasisType, request["basis"]) if is_bsdf else None
    system = pywincalc.GlazingSystem(
        optical_standard=standard,
        solid_layers=layers,
        gap_layers=[pywincalc.Layers.gap(thickness=0.0127)] * (len(layers) - 1),
        width_meters=1.0,
        height_meters=1.0,
        environment=pywincalc.nfrc_shgc_environments(),
        bsdf_hemisphere=pywincalc.BSDFHemisphere.create(basis) if is_bsdf else None,
    )
    answer: dict[str, Any] = {}
    for method in request["methods"]:
        rows = []
        for theta in request["theta_deg"]:
            found = system.optical_method_results(method, theta, request.get("phi_deg", 0.0))
            has_matrix = bool(request.get("matrices")) and theta == request["theta_deg"][0]
            rows.append(
                {
                    "front": _side(found.system_results.front, has_matrix),
                    "back": _side(found.system_results.back, has_matrix),
                    "absorptance": [layer.front.absorptance.total_direct for layer in found.layer_results],
                    "absorptance diffuse": [layer.front.absorptance.total_diffuse for layer in found.layer_results],
                }
            )
        answer[method] = rows
    source = standard.methods["SOLAR"].source_spectrum.values
    answer["source"] = [[1e3 * wavelength for wavelength, _ in source], [power for _, power in source]]
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
