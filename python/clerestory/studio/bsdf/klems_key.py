"""A name for the BSDF of a panel that the same panel, basis and accuracy always has."""

from __future__ import annotations

import hashlib
import json

from clerestory.bsdf import Bsdf, KlemsBlock
from clerestory.panels.writing import described


def klems_key(bsdf: Bsdf) -> str:
    """The key by which the page keeps the BSDF of a panel."""
    block = bsdf.visible.transmission_front
    basis = block.incident.name if isinstance(block, KlemsBlock) else ""
    about = json.dumps(
        [basis, sorted(name for name, _ in bsdf.bands), sorted(bsdf.attrs.items(), key=str)], default=str
    )
    text = described(bsdf.exact) + about  # type: ignore[arg-type]
    return f"panel-{hashlib.sha256(text.encode()).hexdigest()[:20]}"
