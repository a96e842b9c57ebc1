"""A rectangular opening in a wall or roof of a shoebox room, divided into parts."""

from __future__ import annotations

from dataclasses import dataclass, field

from clerestory.errors import ClerestoryError
from clerestory.glazing import Glass, Glazing, Open, check_glazing
from clerestory.room.surface import Outline, check_name
from clerestory.rules import not_negative, number, one_of, positive, within

WALLS = ("facade", "back", "left", "right", "ceiling")
"""Sides of a shoebox that can be opened; left and right as seen from the facade into the room."""


@dataclass(frozen=True, kw_only=True)
class Part:
    """One glazing of a window, over its whole width.

    Parameters
    ----------
    glazing : Glazing
    height_m : float, optional
        Default: what the other parts leave. One part of a window may leave it out.
    tilt_deg : float, -90..90, default 0
        Hangs the glazing from its top edge, the lower edge swung into the room; the opening behind it then holds
        ``behind``.
    behind : Glazing, default Open()
        What the opening of a tilted part holds.
    """

    glazing: Glazing
    height_m: float | None = None
    tilt_deg: float = 0.0
    behind: Glazing = field(default_factory=Open)

    def __post_init__(self) -> None:
        check_glazing("glazing of a part", self.glazing)
        check_glazing("behind of a part", self.behind)
        within("tilt_deg of a part", self.tilt_deg, -90.0, 90.0)
        if self.height_m is not None:
            positive("height_m of a part", self.height_m)


@dataclass(frozen=True, kw_only=True)
class Opening:
    """A rectangular opening in a wall or the ceiling of a shoebox room.

    Parameters
    ----------
    width_m, height_m : float
        For the ceiling, height_m runs along the room's depth.
    sill_m : float, default 0.9
        Lower edge above the floor; for the ceiling, from the facade.
    wall : "facade", "back", "left", "right" or "ceiling", default "facade"
    left_m : float, optional
        From the left end of the wall, as seen from the room, to the opening; default centred. For the ceiling, from the
        left wall.
    parts : sequence of Part, default one of Glass(transmittance=0.88)
        From the top down.
    name : str, default "window"
        The parts of a divided window are called ``"name 1"``, ``"name 2"`` …
    """

    width_m: float
    height_m: float
    sill_m: float = 0.9
    wall: str = "facade"
    left_m: float | None = None
    parts: tuple[Part, ...] = (Part(glazing=Glass(transmittance=0.88)),)
    name: str = "window"

    def __post_init__(self) -> None:
        name = check_name(self.name)
        positive(f"width_m of {name!r}", self.width_m)
        positive(f"height_m of {name!r}", self.height_m)
        not_negative(f"sill_m of {name!r}", self.sill_m)
        one_of(f"wall of {name!r}", self.wall, WALLS)
        if self.left_m is not None:
            not_negative(f"left_m of {name!r}", self.left_m)
        object.__setattr__(self, "parts", tuple(self.parts))
        if not self.parts:
            raise ClerestoryError(f"parts of {name!r} must hold at least one, got none")
        self.part_heights_m()

    def part_heights_m(self) -> tuple[float, ...]:
        """Height of each part, from the top down [m]."""
        open_ended = [index for index, part in enumerate(self.parts) if part.height_m is None]
        given = sum(part.height_m for part in self.parts if part.height_m is not None)
        if len(open_ended) > 1:
            raise ClerestoryError(
                f"parts of {self.name!r} must all but one have a height_m, got {len(open_ended)} without"
            )
        rest = self.height_m - given
        tolerance = 1e-9 * self.height_m
        if (open_ended and rest <= tolerance) or (not open_ended and abs(rest) > tolerance):
            rule = "less than" if open_ended else "equal to"
            raise ClerestoryError(
                f"heights of the parts of {self.name!r} must add up to {rule} its height_m ({self.height_m:g}), "
                f"got {given:g}"
            )
        return tuple(rest if part.height_m is None else number("height_m", part.height_m) for part in self.parts)

    def rectangles(self, length_m: float, height_m: float) -> tuple[tuple[float, float, float, float], ...]:
        """Left, bottom, right and top of each part, from the wall's left lower corner as seen from the room.

        Raises
        ------
        ClerestoryError
            If the opening reaches beyond a wall of this length and height.
        """
        left = (length_m - self.width_m) / 2.0 if self.left_m is None else self.left_m
        slack = 1e-9
        if left < -slack or left + self.width_m > length_m + slack or self.sill_m + self.height_m > height_m + slack:
            raise ClerestoryError(
                f"window {self.name!r} must lie within its wall ({self.wall}, {length_m:g} by {height_m:g} m), "
                f"got {left:g}..{left + self.width_m:g} by {self.sill_m:g}..{self.sill_m + self.height_m:g} m"
            )
        tops, top = [], self.sill_m + self.height_m
        for height in self.part_heights_m():
            tops.append((left, top - height, left + self.width_m, top))
            top -= height
        return tuple(tops)


def rectangle(
    left_bottom: tuple[float, float, float], right: tuple[float, float, float], up: tuple[float, float, float]
) -> Outline:
    """Corners of a rectangle from one corner and its two edges."""
    (x, y, z), (a, b, c), (d, e, f) = left_bottom, right, up
    return ((x, y, z), (x + a, y + b, z + c), (x + a + d, y + b + e, z + c + f), (x + d, y + e, z + f))
