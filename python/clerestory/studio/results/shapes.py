"""Shapes of what is answered about results."""

from __future__ import annotations

from clerestory.studio.doors.shapes import FLAG, INTEGER, NUMBER, TABLE, TEXT, listed, maybe, named, record, word

_NUMBERS = listed(maybe(NUMBER))
_KIND = word("year", "room", "sweep", "design", "panel")
_FIGURE = record(
    {
        "name": TEXT,
        "label": TEXT,
        "unit": TEXT,
        "about": TEXT,
        "sense": INTEGER,
        "is_share": FLAG,
        "cells": listed(record({"value": maybe(NUMBER), "error": maybe(NUMBER), "text": TEXT})),
        "best": listed(INTEGER),
    }
)
TOLD = record(
    {
        "key": TEXT,
        "kind": _KIND,
        "what": TEXT,
        "name": TEXT,
        "path": TEXT,
        "title": TEXT,
        "variants": listed(TEXT),
        "glazings": listed(listed(TEXT)),
        "metrics": listed(record({"key": TEXT, "label": TEXT, "unit": TEXT, "about": TEXT})),
        "planes": listed(record({"name": TEXT, "count": INTEGER, "is_grid": FLAG})),
        "figures": listed(_FIGURE),
        "has_hours": FLAG,
        "rows": INTEGER,
        "measures": TABLE,
        "provenance": listed(record({"label": TEXT, "text": TEXT})),
        "source": maybe(TEXT),
    }
)
LISTED = record(
    {
        "results": listed(
            record({"path": TEXT, "kind": TEXT, "what": TEXT, "title": TEXT, "detail": TEXT, "date": TEXT})
        ),
        "years": listed(
            record({"path": TEXT, "kind": TEXT, "what": TEXT, "title": TEXT, "detail": TEXT, "date": TEXT})
        ),
    }
)
_PLAN = {
    "label": TEXT,
    "unit": TEXT,
    "about": TEXT,
    "level": maybe(NUMBER),
    "plane": TEXT,
    "low": NUMBER,
    "high": NUMBER,
    "is_logarithmic": FLAG,
    "x": _NUMBERS,
    "y": _NUMBERS,
    "outline": listed(listed(NUMBER)),
    "windows": listed(record({"name": TEXT, "points": listed(listed(NUMBER))})),
    "sensors": listed(maybe(INTEGER)),
    "variants": listed(
        record(
            {
                "label": TEXT,
                "values": _NUMBERS,
                "errors": maybe(_NUMBERS),
                "mean": maybe(NUMBER),
                "least": maybe(NUMBER),
                "most": maybe(NUMBER),
            }
        )
    ),
}
PLAN = record(_PLAN)
HOUR = record(
    {
        **_PLAN,
        "time": TEXT,
        "sun": maybe(record({"altitude_deg": NUMBER, "azimuth_deg": NUMBER})),
        "blinds_closed": named(listed(TEXT)),
        "in_use": FLAG,
    }
)
SECTION = record(
    {
        "label": TEXT,
        "unit": TEXT,
        "level": maybe(NUMBER),
        "is_logarithmic": FLAG,
        "distance_m": _NUMBERS,
        "variants": listed(
            record({"label": TEXT, "mean": _NUMBERS, "least": _NUMBERS, "most": _NUMBERS, "error": maybe(_NUMBERS)})
        ),
    }
)
CARPET = record(
    {
        "series": word("mean", "least", "sensor"),
        "unit": TEXT,
        "low": NUMBER,
        "high": NUMBER,
        "ticks": listed(NUMBER),
        "days": listed(TEXT),
        "step_h": NUMBER,
        "rows": INTEGER,
        "in_use": listed(maybe(INTEGER)),
        "variants": listed(record({"label": TEXT, "values": _NUMBERS, "blinds": maybe(_NUMBERS)})),
        "sunrise": maybe(_NUMBERS),
        "sunset": maybe(_NUMBERS),
    }
)
MONTHS = record(
    {
        "months": listed(TEXT),
        "unit": TEXT,
        "variants": listed(record({"label": TEXT, "daylit": _NUMBERS, "in_use": _NUMBERS})),
    }
)
CASES = record(
    {
        "columns": listed(
            record(
                {
                    "name": TEXT,
                    "label": TEXT,
                    "unit": TEXT,
                    "role": word("parameter", "figure", "note"),
                    "is_number": FLAG,
                    "values": listed({"anyOf": [NUMBER, TEXT, {"type": "null"}]}),
                },
                also={"errors": _NUMBERS},
            )
        ),
        "rows": INTEGER,
        "rows_in_all": INTEGER,
        "start": record({"x": TEXT, "y": listed(TEXT), "by": TEXT}),
    },
    also={
        "front": listed(INTEGER),
        "best": maybe(INTEGER),
        "objectives": listed(record({"figure": TEXT, "aim": TEXT})),
        "unbeaten": listed(TEXT),
    },
)
