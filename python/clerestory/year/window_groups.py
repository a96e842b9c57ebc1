"""A room with light through some of its windows alone, so that blinds can be closed group by group."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from clerestory.errors import ClerestoryError
from clerestory.room.material import Material
from clerestory.room.scene import Room
from clerestory.room.surface import Surface
from clerestory.year.settings import Blinds

WITHOUT_BLINDS = "without blinds"
"""What the windows are called that have none."""

BLACK = Material(diffuse_reflectance=0.0)


def groups_of(room: Room, blinds: Sequence[Blinds]) -> dict[str, tuple[str, ...]]:
    """Windows by group: those of each set of blinds, and those that have none.

    Raises
    ------
    ClerestoryError
        If blinds name no window of the room, or one twice.
    """
    known = [window.name for window in room.windows]
    left = list(known)
    groups: dict[str, tuple[str, ...]] = {}
    for one in blinds:
        for name in one.windows:
            if name not in known:
                raise ClerestoryError(f"windows of [[blinds]] must be of the room ({', '.join(known)}), got {name!r}")
            if name not in left:
                raise ClerestoryError(f"each window must have blinds once, got {name!r} twice")
            left.remove(name)
        groups[one.name] = one.windows
    if left:
        groups[WITHOUT_BLINDS] = tuple(left)
    return groups


def lit_through(room: Room, windows: Iterable[str]) -> Room:
    """The same room with its other windows closed by black surfaces.

    Parameters
    ----------
    room : Room
    windows : names of those that stay

    Returns
    -------
    Room
        The room itself if all stay.
    """
    keep = set(windows)
    closed = [window for window in room.windows if window.name not in keep]
    if not closed:
        return room
    surfaces = []
    for surface in room.surfaces:
        cut = [window.outline_m for window in closed if window.wall == surface.name]
        surfaces.append(replace(surface, holes_m=(*surface.holes_m, *cut)) if cut else surface)
    surfaces += [Surface(name=f"closed {window.name}", outline_m=window.outline_m, material=BLACK) for window in closed]
    return replace(
        room, surfaces=tuple(surfaces), windows=tuple(window for window in room.windows if window.name in keep)
    )
