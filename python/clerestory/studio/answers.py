"""JSON answers: arrays as lists, what is no number as null, mistakes beside the field that made them."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from typing import Any

import numpy as np
from starlette.responses import Response

from clerestory.errors import ClerestoryError

#: Digits kept of what is drawn; answers that are compared keep all.
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def plain(value: Any) -> Any:
    """Values that JSON has, from arrays, tuples and mappings of them."""
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {str(name): plain(one) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    return value


def written(value: Any) -> str:
    """``value`` as the text of JSON."""
    try:
        return json.dumps(value, default=_plain_array, allow_nan=False, separators=(",", ":"))
    except (TypeError, ValueError):
        # some number is none and becomes null, or some name is no text: a look at each
        return json.dumps(plain(value), allow_nan=False, separators=(",", ":"))


def _plain_array(value: Any) -> Any:
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else plain(value)


def answer(value: Any, status: int = 200) -> Response:
    """``value`` as JSON."""
    text = written(value)
    return Response(text, status, media_type="application/json", headers={"cache-control": "no-store"})


def refused(status: int, message: str, field: str | None = None) -> Response:
    """An answer that says what is wrong, and which field is."""
    return answer({"errors": [{"field": field, "message": " ".join(message.split())}]}, status)


def field_of(error: ClerestoryError, fields: Any) -> str | None:
    """The field that an error is about: its message begins with the name, as all messages of the API do.

    Parameters
    ----------
    error : ClerestoryError
    fields : mapping
        What was asked with. Names within its tables are looked for too.
    """
    known = _names(fields)
    return next((word for word in _NAME.findall(str(error))[:8] if word in known), None)


def _names(value: Any, depth: int = 0) -> set[str]:
    if not isinstance(value, Mapping) or depth > 4:
        return set()
    return {str(name) for name in value}.union(*(_names(one, depth + 1) for one in value.values()))
