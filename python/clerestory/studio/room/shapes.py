"""The shapes of what is answered about a room."""

from __future__ import annotations

from clerestory.studio.doors.shapes import (
    ANYTHING,
    FLAG,
    INTEGER,
    NUMBER,
    TABLE,
    TEXT,
    Shape,
    listed,
    maybe,
    record,
    word,
)

PLACE = listed(NUMBER, least=3, most=3)
_PLACES = listed(PLACE)
_NUMBERS = listed(NUMBER)
#: Errors are null where one pass says nothing of them.
_ERRORS = listed(maybe(NUMBER))


def _numbers(*names: str) -> dict[str, Shape]:
    return dict.fromkeys(names, NUMBER)


_SLIDER = record(
    {"name": TEXT, "group": TEXT, "path": listed(ANYTHING), **_numbers("low", "high", "step", "start"), "unit": TEXT}
)
KINDS = record(
    {
        "sliders": listed(_SLIDER),
        "glazings": listed(record({"name": TEXT, "label": TEXT, "table": TABLE})),
        "skies": listed(record({"name": TEXT, "label": TEXT, "sky": TABLE})),
        "surfaces": listed(TEXT),
        "start": TABLE,
    }
)
_SURFACE = record(
    {
        "name": TEXT,
        "kind": word("opaque", "window", "interface"),
        "diffuse": maybe(NUMBER),
        "specular": maybe(NUMBER),
        "triangles": listed(listed(NUMBER, least=9, most=9)),
        "outlines": listed(_PLACES),
    }
)
_WINDOW = record({"name": TEXT, "outline_m": _PLACES, "normal": PLACE, "glazing": TEXT, "kind": TEXT})
_INDICES = maybe(listed(INTEGER))
_PLANE = record(
    {
        "name": TEXT,
        "points_m": _PLACES,
        "normals": _PLACES,
        "cells": maybe(listed(listed(PLACE, least=4, most=4))),
        "row": _INDICES,
        "column": _INDICES,
        "rows": maybe(INTEGER),
        "columns": maybe(INTEGER),
        "spacing_m": maybe(NUMBER),
    }
)
_SITE = record({**_numbers("latitude_deg", "longitude_deg", "elevation_m"), "timezone": TEXT})
SCENE = record(
    {
        "name": TEXT,
        "variants": listed(TEXT),
        "bounds_m": listed(PLACE, least=2, most=2),
        "inside_m": listed(PLACE, least=2, most=2),
        "north": PLACE,
        "surfaces": listed(_SURFACE),
        "windows": listed(_WINDOW),
        "planes": listed(_PLANE),
        "plane_names": listed(TEXT),
        "site": maybe(_SITE),
        "tables": TABLE,
    }
)
_SUN_AT = record({**_numbers("hour", "altitude_deg", "azimuth_deg"), "day_of_year": INTEGER, "direction": PLACE})
_LOOP = record({"hour": INTEGER, "points": listed(_SUN_AT)})
_SEASON = record({"label": TEXT, "day_of_year": INTEGER, "points": listed(_SUN_AT)})
SUN = record(
    {
        "time": TEXT,
        **_numbers("altitude_deg", "azimuth_deg"),
        "direction": PLACE,
        "is_up": FLAG,
        "sunrise_h": maybe(NUMBER),
        "sunset_h": maybe(NUMBER),
        "day": listed(_SUN_AT),
    },
    also={"seasons": listed(_SEASON), "analemmas": listed(_LOOP)},
)
_WORD = word("direct", "redirected", "reflected")
_PATH = record(
    {
        "window": TEXT,
        "kind": _WORD,
        "power": NUMBER,
        "points": _PLACES,
        "stages": listed(word("sun", "glazing", "mirror", "diffuse", "interface", "sky")),
        "surfaces": listed(TEXT),
        "segment_power": _NUMBERS,
    }
)
_BEAM = record(
    {
        "source": TEXT,
        "window": TEXT,
        "kind": _WORD,
        **_numbers("power", "illuminance_per_normal"),
        "direction": PLACE,
        "total_reflections": INTEGER,
    }
)
_PATCH = record(
    {
        "surface": TEXT,
        "beam": INTEGER,
        "polygon": _PLACES,
        "source": _PLACES,
        **_numbers("area_m2", "illuminance_per_normal"),
    }
)
_SUNLIT = record({"name": TEXT, **_numbers("cos_incidence", "sunlit_share", "entering"), "blocked_by": maybe(TEXT)})
PATHS = record(
    {
        **_numbers("altitude_deg", "azimuth_deg"),
        "direction": PLACE,
        "is_up": FLAG,
        "windows": listed(_SUNLIT),
        "paths": listed(_PATH),
        "beams": listed(_BEAM),
        "patches": listed(_PATCH),
        "warnings": listed(TEXT),
    }
)
LIGHT = record(
    {
        "plane": TEXT,
        "total_lx": _NUMBERS,
        **dict.fromkeys(("standard_error_lx", "sky_standard_error_lx", "sun_standard_error_lx"), _ERRORS),
        "parts": record(dict.fromkeys(("sky", "sun_direct", "sun_redirected", "sun_interreflected"), _NUMBERS)),
        **_numbers("mean_lx", "least_lx", "most_lx"),
        **dict.fromkeys(("mean_standard_error_lx", "uniformity", "uniformity_standard_error"), maybe(NUMBER)),
        **dict.fromkeys(("worst_relative_error", "mean_relative_error"), maybe(NUMBER)),
        "rounds": INTEGER,
        "sun_rounds": INTEGER,
        "sun": record({**_numbers("altitude_deg", "azimuth_deg"), "is_up": FLAG}),
        "outside": record({**_numbers("diffuse_horizontal_lx", "direct_normal_lx"), "sky": TEXT}),
        "notes": listed(TEXT),
        "daylight_factor_percent": _NUMBERS,
        "daylight_factor_standard_error_percent": _ERRORS,
    }
)
