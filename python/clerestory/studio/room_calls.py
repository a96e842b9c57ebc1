"""Questions about a room: what it looks like, where the sun goes, how much light there is."""

from __future__ import annotations

import tomllib
from typing import Any

import tomli_w
from starlette.requests import Request
from starlette.routing import Route

from clerestory.errors import ClerestoryError
from clerestory.rules import one_of, positive
from clerestory.studio.requests import Asked, asking, known, needed
from clerestory.studio.room_answers import scene_of
from clerestory.studio.room_asked import asked_room
from clerestory.studio.room_kinds import room_kinds
from clerestory.studio.room_light import light_of, sun_of
from clerestory.studio.room_numbers import whole
from clerestory.studio.room_path_answers import paths_of
from clerestory.studio.room_planes import plane_sensors
from clerestory.studio.room_sky import direction_is_up, moment_of
from clerestory.studio.room_sun_answers import altitude_azimuth, asked_site, checked_angles, moment
from clerestory.studio.room_sun_answers import sun_of as sun_course
from clerestory.studio.room_work import bare

#: Bases that the studio computes in, and how many rounds a job may take.
BASES = ("tregenza145", "reinhart577", "reinhart2305")
_MOST_ROUNDS = 4096


def kinds(_: Request, asked: Asked) -> dict[str, Any]:
    """Sliders, glazings, skies, and the room shown first."""
    known(asked, ())
    return room_kinds()


def scene(request: Request, asked: Asked) -> dict[str, Any]:
    """A room as it is drawn."""
    known(asked, ("room", "variant", "planes", "spacing_m"))
    room = asked_room(request.app.state, asked)
    return scene_of(room, asked.get("variant"), asked.get("planes"), asked.get("spacing_m"))


def sun(_: Request, asked: Asked) -> dict[str, Any]:
    """Where the sun stands at a site, through the day and the year."""
    known(asked, ("site", "day_of_year", "hour"))
    return sun_course(asked_site(needed(asked, "site")), needed(asked, "day_of_year"), needed(asked, "hour"))


def paths(request: Request, asked: Asked) -> dict[str, Any]:
    """The sun's way through the windows of a room."""
    known(asked, ("room", "variant", "day_of_year", "hour", "altitude_deg", "azimuth_deg", "density"))
    room = asked_room(request.app.state, asked)
    if "altitude_deg" in asked or "azimuth_deg" in asked:
        altitude, azimuth = checked_angles(asked.get("altitude_deg"), asked.get("azimuth_deg"))
    else:
        if room.site is None:
            raise ClerestoryError("room must have a [site], or altitude_deg and azimuth_deg be given")
        now = moment(room.site, needed(asked, "day_of_year"), needed(asked, "hour"))
        altitude, azimuth = (float(one[0]) for one in altitude_azimuth(room.site, [now]))
    return paths_of(
        room.room(asked.get("variant")), altitude_deg=altitude, azimuth_deg=azimuth, density=asked.get("density")
    )


def light(request: Request, asked: Asked) -> dict[str, Any]:
    """Illuminance of a plane at a time."""
    known(asked, ("key", "day_of_year", "hour", "sky", "sun_rounds"))
    shelf = request.app.state.room_shelf
    kept = shelf.get(needed(asked, "key"))
    now = moment_of(kept.asked, needed(asked, "sky"), needed(asked, "day_of_year"), needed(asked, "hour"))
    return light_of(shelf, kept, now, asked.get("sun_rounds"))


def to_toml(request: Request, asked: Asked) -> dict[str, Any]:
    """A room as the text of its file, which ``clerestory room FILE.toml`` and ``read_room`` read."""
    known(asked, ("room",))
    room = asked_room(request.app.state, asked)
    room.room()
    try:
        return {"text": tomli_w.dumps(room.tables)}
    except (TypeError, ValueError) as error:
        raise ClerestoryError(f"tables must be those of a TOML file: {error}") from None


def from_toml(request: Request, asked: Asked) -> dict[str, Any]:
    """The tables of a room from the text of its file."""
    known(asked, ("text",))
    text = needed(asked, "text")
    if not isinstance(text, str):
        raise ClerestoryError(f"text must be that of a TOML file, got {type(text).__name__}")
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ClerestoryError(f"text must be that of a TOML file: {error}") from None
    room = asked_room(request.app.state, {"room": {"tables": tables}})
    room.room()
    return {"tables": room.tables}


def asked_job(request: Request, asked: Asked) -> dict[str, Any]:
    """What the job "room" does: checked before it waits in line."""
    known(asked, ("room", "variant", "surface", "spacing_m", "basis", "target_relative_error", "max_rounds"))
    state = request.app.state
    room = asked_room(state, asked)
    variant = asked.get("variant")
    sensors, _ = plane_sensors(room.room(variant), asked.get("surface"), asked.get("spacing_m"))
    basis = one_of("basis", asked.get("basis", "reinhart577"), BASES)
    kept = state.room_shelf.place(room, variant, sensors, basis)
    return {
        "root": str(room.root),
        "folder": str(room.folder),
        "tables": room.tables,
        "variant": variant,
        "sensors": sensors,
        "basis": basis,
        "key": kept.key,
        "kept": bare(kept.pool),
        "target_relative_error": positive("target_relative_error", asked.get("target_relative_error", 0.02)),
        "max_rounds": whole("max_rounds", asked.get("max_rounds", _MOST_ROUNDS), 2, _MOST_ROUNDS),
    }


def asked_sun_job(request: Request, asked: Asked) -> dict[str, Any]:
    """What the job "room_sun" does."""
    known(asked, ("key", "day_of_year", "hour", "sky", "target_relative_error", "max_rounds"))
    shelf = request.app.state.room_shelf
    kept = shelf.get(needed(asked, "key"))
    now = moment_of(kept.asked, needed(asked, "sky"), needed(asked, "day_of_year"), needed(asked, "hour"))
    if not direction_is_up(now):
        raise ClerestoryError("hour must be one of sunshine for this, got one without")
    sun = sun_of(now)
    return {
        "root": str(kept.asked.root),
        "folder": str(kept.asked.folder),
        "tables": kept.asked.tables,
        "variant": kept.variant,
        "sensors": kept.sensors,
        "key": kept.key,
        "sun": sun,
        "kept": bare(shelf.sun(kept, sun)),
        "target_relative_error": positive("target_relative_error", asked.get("target_relative_error", 0.05)),
        "max_rounds": whole("max_rounds", asked.get("max_rounds", 1024), 2, _MOST_ROUNDS),
    }


def heard(state: Any, kind: str, arguments: dict[str, Any], partial: Any) -> Any:
    """Keeps the pass that a job sends, and tells the page how good all are together."""
    shelf, pooled = state.room_shelf, (partial["batch"], partial["cpu_seconds"])
    if kind == "room_sun":
        shelf.add_sun(arguments["key"], tuple(arguments["sun"]), partial["number"], pooled)
    else:
        shelf.add(arguments["key"], partial["number"], pooled)
    return partial["told"]


ROUTES = [
    Route("/api/room/kinds", asking(kinds), methods=["POST"]),
    Route("/api/room/scene", asking(scene), methods=["POST"]),
    Route("/api/room/sun", asking(sun), methods=["POST"]),
    Route("/api/room/paths", asking(paths), methods=["POST"]),
    Route("/api/room/light", asking(light), methods=["POST"]),
    Route("/api/room/toml", asking(to_toml), methods=["POST"]),
    Route("/api/room/read", asking(from_toml), methods=["POST"]),
]
