"""A window: a planar polygon with a glazing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from clerestory.glazing import Glazing, check_glazing
from clerestory.room.surface import Outline, as_outline, check_name
from clerestory.rules import Points, number, vector


@dataclass(frozen=True, kw_only=True)
class Window:
    """A planar polygon with a glazing.

    Parameters
    ----------
    name : str
        Of its own in the room.
    outline_m : array_like, shape (n, 3) [m]
        Corners anticlockwise as seen from the room: the right-hand normal points inwards.
    glazing : Glazing
        A pane, a panel, a stack.
    wall : str, optional
        Name of the surface that the window is cut out of. Without it the window stands free or fills a hole that the
        wall has already.
    up : tuple of 3 floats, optional
        What is up for the glazing: its y axis is the part of this in the window's plane. Default the world's z, and
        north for a horizontal window.
    """

    name: str
    outline_m: Outline
    glazing: Glazing
    wall: str | None = None
    up: tuple[float, float, float] | None = None

    def __post_init__(self) -> None:
        name = check_name(self.name)
        object.__setattr__(self, "outline_m", as_outline(f"outline_m of {name!r}", self.outline_m))
        check_glazing(f"glazing of {name!r}", self.glazing)
        if self.wall is not None:
            check_name(self.wall)
        if self.up is not None:
            object.__setattr__(self, "up", vector(f"up of {name!r}", self.up))

    def tilted(self, tilt_deg: float) -> Window:
        """The window turned about its top edge, out of its wall.

        Parameters
        ----------
        tilt_deg : float
            Positive swings the lower edge into the room.

        Returns
        -------
        Window
            Free of its wall, which keeps its hole. The top edge is the line through the two highest corners.
        """
        angle = np.radians(number("tilt_deg", tilt_deg))
        corners = np.array(self.outline_m)
        inwards = normal_of(corners)
        first, second = sorted(np.argsort(-corners[:, 2], kind="stable")[:2])
        hinge = corners[second] - corners[first]
        # along × down points into the room, so that a positive turn brings the lower edge in
        along = hinge / np.linalg.norm(hinge)
        if np.dot(np.cross(along, [0.0, 0.0, -1.0]), inwards) < 0.0:
            along = -along
        arm = corners - corners[first]
        turned = (
            arm * np.cos(angle)
            + np.cross(along, arm) * np.sin(angle)
            + np.outer(arm @ along, along) * (1.0 - np.cos(angle))
        )
        return Window(name=self.name, outline_m=as_outline("outline_m", corners[first] + turned), glazing=self.glazing)


def normal_of(corners: Points) -> Points:
    """Unit right-hand normal of a planar polygon, by Newell's sum."""
    total: Points = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    length = np.linalg.norm(total)
    return total / length if length > 0.0 else total
