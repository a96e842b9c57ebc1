"""The long jobs of a room as they are asked for: checked before they wait, kept as they come in."""

from __future__ import annotations

from typing import Any

from starlette.requests import Request

from clerestory.errors import ClerestoryError
from clerestory.rules import positive
from clerestory.studio.doors.fields import Field
from clerestory.studio.doors.requests import Asked
from clerestory.studio.doors.shapes import FLAG, INTEGER, NUMBER, TEXT, Shape, listed, maybe, record, word
from clerestory.studio.jobs.kinds import Kind
from clerestory.studio.room.asked import asked_room
from clerestory.studio.room.calls import DAY, HOUR, KEY, ROOM, SKY, VARIANT
from clerestory.studio.room.light import sun_of
from clerestory.studio.room.numbers import whole
from clerestory.studio.room.planes import plane_sensors
from clerestory.studio.room.sky import direction_is_up, moment_of
from clerestory.studio.room.work import bare

#: Bases that the studio computes in, and how many rounds a job may take.
BASES = ("tregenza145", "reinhart577", "reinhart2305")
_MOST_ROUNDS = 4096
#: Processor time of a first pass that makes it worth telling alone [s].
_SOON_S = 0.5

_ROOM_FIELDS = {
    "room": ROOM,
    "variant": VARIANT,
    "surface": Field(TEXT, "Name of a plane of the room; without it the first of its sensors", None),
    "spacing_m": Field(NUMBER, "Of sensors that lie on a surface [m]", None),
    "basis": Field(word(*BASES), "Patches of the sky", "reinhart577"),
    "target_relative_error": Field(NUMBER, "Standard error at the worst sensor under an overcast sky [1]", 0.02),
    "max_rounds": Field(INTEGER, "Where it gives up [2..4096]", _MOST_ROUNDS),
}
_SUN_FIELDS = {
    "key": KEY,
    "day_of_year": DAY,
    "hour": HOUR,
    "sky": SKY,
    "target_relative_error": Field(NUMBER, "Standard error of the sun's light at the worst sensor [1]", 0.05),
    "max_rounds": Field(INTEGER, "Where it gives up [2..4096]", 1024),
}
#: How good what there is is; errors are null where they are not known, or larger than any number.
_GOOD: dict[str, Shape] = {
    "key": {**TEXT, "description": "Of the coefficients, which other calls take"},
    "rounds": INTEGER,
    "passes": INTEGER,
    "worst_relative_error": {**maybe(NUMBER), "description": "Standard error at the worst sensor [1]"},
    "mean_relative_error": {**maybe(NUMBER), "description": "Its mean over the sensors [1]"},
    "cpu_seconds": NUMBER,
    "converged": {**FLAG, "description": "Whether the target is reached"},
}
_SUN_GOOD = _GOOD | dict.fromkeys(("altitude_deg", "azimuth_deg"), NUMBER)
_NOTES = {"notes": {**listed(TEXT), "description": "What the reader should know of it"}}


def asked_room_job(request: Request, asked: Asked) -> dict[str, Any]:
    """What the job "room" does: checked before it waits in line."""
    state = request.app.state
    room = asked_room(state, asked)
    variant = asked.get("variant")
    sensors, _ = plane_sensors(room.room(variant), asked.get("surface"), asked.get("spacing_m"))
    basis = asked["basis"]
    kept = state.room_shelf.plane(room, variant, sensors, basis)
    return {
        "root": str(room.root),
        "folder": str(room.folder),
        "tables": room.tables,
        "variant": variant,
        "sensors": sensors,
        "basis": basis,
        "key": kept.key,
        "kept": bare(kept.pool),
        "target_relative_error": positive("target_relative_error", asked["target_relative_error"]),
        "max_rounds": whole("max_rounds", asked["max_rounds"], 2, _MOST_ROUNDS),
    }


def asked_sun_job(request: Request, asked: Asked) -> dict[str, Any]:
    """What the job "room_sun" does."""
    shelf = request.app.state.room_shelf
    kept = shelf.get(asked["key"])
    now = moment_of(kept.asked, asked["sky"], asked["day_of_year"], asked["hour"])
    if not direction_is_up(now):
        raise ClerestoryError("hour must be one with sunshine to refine it, got one without")
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
        "target_relative_error": positive("target_relative_error", asked["target_relative_error"]),
        "max_rounds": whole("max_rounds", asked["max_rounds"], 2, _MOST_ROUNDS),
    }


def keep_pass(state: Any, arguments: Asked, partial: Any) -> Any:
    """Keeps the pass that a job sends, and tells the page how good all are together."""
    state.room_shelf.add(arguments["key"], partial["number"], (partial["batch"], partial["cpu_seconds"]))
    state.room_shelf.warn(arguments["key"], partial["told"]["notes"])
    # the scatter of one pass says nothing; it is waited for, unless that is long
    is_early = partial["told"]["passes"] < 2 and partial["cpu_seconds"] < _SOON_S
    return None if is_early else partial["told"]


def keep_sun_pass(state: Any, arguments: Asked, partial: Any) -> Any:
    """As `keep_pass`, of one sun."""
    pooled = (partial["batch"], partial["cpu_seconds"])
    state.room_shelf.add_sun(arguments["key"], arguments["sun"], partial["number"], pooled)
    return partial["told"]


KINDS: dict[str, Kind] = {
    "room": Kind(_ROOM_FIELDS, asked_room_job, record(_GOOD | _NOTES), record(_GOOD), heard=keep_pass, ends_alone=True),
    "room_sun": Kind(
        _SUN_FIELDS,
        asked_sun_job,
        record(_SUN_GOOD),
        record(_SUN_GOOD, also=_NOTES),
        heard=keep_sun_pass,
        ends_alone=True,
    ),
}
