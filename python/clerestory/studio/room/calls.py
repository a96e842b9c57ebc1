"""Questions about a room: what it looks like, where the sun goes, how much light there is."""

from __future__ import annotations

from typing import Any

import tomli_w
from starlette.requests import Request

from clerestory.errors import ClerestoryError
from clerestory.studio.doors.fields import Field
from clerestory.studio.doors.requests import Asked, call
from clerestory.studio.doors.shapes import FLAG, INTEGER, NUMBER, TABLE, TEXT, MisshapenError, listed, record
from clerestory.studio.room.answers import scene_of
from clerestory.studio.room.asked import asked_room
from clerestory.studio.room.kinds import room_kinds, start_tables
from clerestory.studio.room.light import light_of
from clerestory.studio.room.path_answers import paths_of
from clerestory.studio.room.shapes import KINDS, LIGHT, PATHS, SCENE, SUN
from clerestory.studio.room.sky import moment_of
from clerestory.studio.room.sun_answers import altitude_azimuth, asked_site, checked_angles, moment
from clerestory.studio.room.sun_answers import sun_of as sun_course
from clerestory.studio.toml_kinds import toml_of

_EXAMPLE = {"tables": start_tables()}
#: The room of a question, and which of its variants.
ROOM = Field(TABLE, "A room: `tables` as in its TOML file, or the `path` of a file of the folder", example=_EXAMPLE)
VARIANT = Field(TEXT, "Name of a variant of the room; without it the room as it stands", None)
DAY = Field(INTEGER, "Day of the year [1..365]", example=172)
HOUR = Field(NUMBER, "Hour on the wall clock of the site [h, 0..24]", example=11.0)
KEY = Field(TEXT, "What the job `room` gave")
SKY = Field(
    TABLE,
    "`kind` = cie (`sky_type`, `luminous_turbidity`), overcast, or weather (`path`)",
    example={"kind": "overcast"},
)


def kinds(_: Request, asked: Asked) -> dict[str, Any]:
    """Sliders, glazings, skies, and the room shown first."""
    return room_kinds()


def scene(request: Request, asked: Asked) -> dict[str, Any]:
    """A room as it is drawn."""
    room = asked_room(request.app.state, asked)
    return scene_of(room, asked.get("variant"), asked.get("planes"), asked.get("spacing_m"))


def sun(_: Request, asked: Asked) -> dict[str, Any]:
    """Where the sun stands at a site, through the day and the year."""
    return sun_course(asked_site(asked["site"]), asked["day_of_year"], asked["hour"], year=asked["year"])


def paths(request: Request, asked: Asked) -> dict[str, Any]:
    """The sun's way through the windows of a room."""
    room = asked_room(request.app.state, asked)
    if "altitude_deg" in asked or "azimuth_deg" in asked:
        altitude, azimuth = checked_angles(asked.get("altitude_deg"), asked.get("azimuth_deg"))
    else:
        if room.site is None:
            raise ClerestoryError("room must have a [site], or altitude_deg and azimuth_deg be given")
        if "day_of_year" not in asked or "hour" not in asked:
            raise MisshapenError("day_of_year", "day_of_year and hour must be given, or altitude_deg and azimuth_deg")
        now = moment(room.site, asked["day_of_year"], asked["hour"])
        altitude, azimuth = (float(one[0]) for one in altitude_azimuth(room.site, [now]))
    return paths_of(
        room.room(asked.get("variant")), altitude_deg=altitude, azimuth_deg=azimuth, density=asked.get("density")
    )


def light(request: Request, asked: Asked) -> dict[str, Any]:
    """Illuminance of a plane at a time."""
    shelf = request.app.state.room_shelf
    kept = shelf.get(asked["key"])
    now = moment_of(kept.asked, asked["sky"], asked["day_of_year"], asked["hour"])
    return light_of(shelf, kept, now, asked.get("sun_rounds"))


def to_toml(request: Request, asked: Asked) -> dict[str, Any]:
    """A room as the text of its file, which ``clerestory room FILE.toml`` and ``read_room`` read."""
    room = asked_room(request.app.state, asked)
    room.room()
    try:
        return {"text": tomli_w.dumps(room.tables)}
    except (TypeError, ValueError) as error:
        raise ClerestoryError(f"tables must be those of a TOML file: {error}") from None


def from_toml(request: Request, asked: Asked) -> dict[str, Any]:
    """The tables of a room from the text of its file."""
    tables = toml_of(asked["text"])
    room = asked_room(request.app.state, {"room": {"tables": tables}})
    room.room()
    return {"tables": room.tables}


_SITE = Field(
    TABLE,
    "`latitude_deg`, `longitude_deg`, `elevation_m` and `timezone`, as [site] of a room file",
    example=start_tables()["site"],
)
ROUTES = [
    call("/api/room/kinds", kinds, {}, gives=KINDS),
    call(
        "/api/room/scene",
        scene,
        {
            "room": ROOM,
            "variant": VARIANT,
            "planes": Field(listed(TEXT, most=16), "Planes to lay out; without it the room's own sensors", None),
            "spacing_m": Field(NUMBER, "Of sensors that lie on surfaces [m]", None),
        },
        gives=SCENE,
    ),
    call(
        "/api/room/sun",
        sun,
        {
            "site": _SITE,
            "day_of_year": DAY,
            "hour": HOUR,
            "year": Field(FLAG, "Whether to tell the seasons and the analemmas too", False),
        },
        gives=SUN,
    ),
    call(
        "/api/room/paths",
        paths,
        {
            "room": ROOM,
            "variant": VARIANT,
            "day_of_year": Field(DAY.shape, DAY.tells, None, example=172),
            "hour": Field(HOUR.shape, HOUR.tells, None, example=11.0),
            "altitude_deg": Field(NUMBER, "Of the sun instead of a time [°, -90..90]", None),
            "azimuth_deg": Field(NUMBER, "Of the sun instead of a time, clockwise from north [°]", None),
            "density": Field(INTEGER, "Points of each window from which paths are drawn [1..400]", None),
        },
        gives=PATHS,
        is_heavy=True,
    ),
    call(
        "/api/room/light",
        light,
        {
            "key": KEY,
            "day_of_year": DAY,
            "hour": HOUR,
            "sky": SKY,
            "sun_rounds": Field(INTEGER, "Of the sun's light, if less is known of it [4..64]", None),
        },
        gives=LIGHT,
        is_heavy=True,
    ),
    call("/api/room/toml", to_toml, {"room": ROOM}, gives=record({"text": TEXT})),
    call(
        "/api/room/read",
        from_toml,
        {"text": Field(TEXT, "Text of a room's or a year's TOML file", example=tomli_w.dumps(start_tables()))},
        gives=record({"tables": TABLE}),
    ),
]
