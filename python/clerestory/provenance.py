"""What a result was made from, written into it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from datetime import UTC, datetime
from typing import Any

from clerestory._native import __version__


def provenance(**made_from: Any) -> dict[str, Any]:
    """Attributes of a Dataset that say how to make it again.

    Parameters
    ----------
    **made_from
        What it rests on. Mappings and lists become JSON, None is left out; the rest must be text or numbers.

    Returns
    -------
    dict
        With ``clerestory_version`` and ``date`` (UTC) before the rest; every value can be written to NetCDF.
    """
    attributes: dict[str, Any] = {
        "clerestory_version": __version__,
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
    }
    for name, value in made_from.items():
        if value is not None:
            attributes[name] = json.dumps(value) if isinstance(value, (Mapping, list)) else value
    return attributes
