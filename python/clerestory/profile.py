"""The cross-section of a panel: facets between media, repeating upwards."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from clerestory import _native
from clerestory.array_rules import known_keys
from clerestory.errors import ClerestoryError
from clerestory.rules import number, one_of, positive

if TYPE_CHECKING:
    from clerestory.drawing.line import Face, Outline

Point = tuple[float, float]

#: Straight facets for a curve that is no circular arc.
CURVE_CHORDS = 32


@dataclass(frozen=True, slots=True, kw_only=True)
class Facet:
    """A straight line or circular arc of a cross-section, with a medium on either hand.

    Parameters
    ----------
    start, end : (z, y) [mm]
        z goes across the sheet from the outside to the room, y up.
    left, right : int, 0..255
        Media on the way from start to end; 0 is the air outside.
    bulge : float, -1..1, default 0
        Tangent of a quarter of the angle an arc sweeps, above 0 anticlockwise seen with z to the right and y up, as in
        DXF; 0 is straight, 1 a half circle.
    film : int, optional
        Medium of a gap of no width between two faces of one medium: the ideal laser cut has 0.
    """

    start: Point
    end: Point
    left: int
    right: int
    bulge: float = 0.0
    film: int | None = None

    def __post_init__(self) -> None:
        for name in ("start", "end"):
            object.__setattr__(self, name, _point(name, getattr(self, name)))
        object.__setattr__(self, "bulge", number("bulge", self.bulge))
        for name in ("left", "right", "film"):
            value = getattr(self, name)
            if name == "film" and value is None:
                continue
            if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not 0 <= value <= 255:
                raise ClerestoryError(f"{name} must be the number of a medium, 0 to 255, got {value!r}; 0 is the air")
            object.__setattr__(self, name, int(value))

    def to_dict(self) -> dict[str, Any]:
        """Plain values for TOML or JSON; what is left at its default is left out."""
        written: dict[str, Any] = {
            "start": list(self.start),
            "end": list(self.end),
            "left": self.left,
            "right": self.right,
        }
        if self.bulge != 0.0:
            written["bulge"] = self.bulge
        if self.film is not None:
            written["film"] = self.film
        return written


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile:
    """A cross-section that repeats upwards, checked: facets meet only at their ends and agree about the media.

    Parameters
    ----------
    pitch_mm : float, greater than 0 [mm]
        Height after which it repeats.
    facets : sequence of Facet
        Of one period. They may reach into the next: only all copies together must fit.

    Raises
    ------
    ClerestoryError
        If facets cross, the media around a vertex do not agree (the outline does not close), or a side faces several
        media; the message names the facet by its number from 1.

    Notes
    -----
    To draw one, :meth:`from_outlines`, :meth:`from_faces`, :meth:`from_svg_path` and :func:`read_profile` are
    shorter: they find the media by themselves.
    """

    pitch_mm: float
    facets: tuple[Facet, ...]
    native: _native.Profile = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "pitch_mm", number("pitch_mm", self.pitch_mm))
        object.__setattr__(self, "facets", _facets(self.facets))
        ends = [(*facet.start, *facet.end) for facet in self.facets]
        native = _native.Profile.drawn(
            ends_mm=np.array(ends, dtype=np.float64).reshape(-1, 4),
            bulge=[facet.bulge for facet in self.facets],
            left=[facet.left for facet in self.facets],
            right=[facet.right for facet in self.facets],
            film=[-1 if facet.film is None else facet.film for facet in self.facets],
            pitch_mm=self.pitch_mm,
        )
        object.__setattr__(self, "native", native)

    def __reduce__(self) -> tuple[Any, ...]:
        return _made_again, (self.pitch_mm, self.facets)

    @classmethod
    def from_outlines(
        cls,
        outlines: Sequence[Outline | Sequence[Point]],
        *,
        pitch_mm: float,
        joins: Literal["vanish", "film"] = "vanish",
    ) -> Profile:
        """The profile of closed outlines, each of the material of one medium.

        Parameters
        ----------
        outlines : sequence of Outline, or of sequences of (z, y) for medium 1 [mm]
            Of one period; copies follow above and below. Where outlines lie in one another the innermost counts, so
            that one of medium 0 is a hole. All else is air.
        pitch_mm : float, greater than 0 [mm]
            Height after which the drawing repeats.
        joins : {"vanish", "film"}, default "vanish"
            What becomes of a line that has one medium on both sides, as where an outline touches its own copy: it
            vanishes, or is an air gap of no width (the ideal laser cut).

        Raises
        ------
        ClerestoryError
            If an outline has less than three points, or the profile breaks a rule of :class:`Profile`.

        Examples
        --------
        >>> bar = [(0, 0), (6, 0), (6, 3), (0, 3)]
        >>> len(Profile.from_outlines([bar], pitch_mm=3, joins="film").facets)
        3
        """
        from clerestory.drawing.line import Outline

        closed = [outline if isinstance(outline, Outline) else Outline(outline) for outline in outlines]
        return cls._arranged(closed, [], pitch_mm, None, joins)

    @classmethod
    def from_faces(
        cls,
        faces: Sequence[Face | Sequence[Point]],
        *,
        pitch_mm: float,
        between: Sequence[int] | None = None,
    ) -> Profile:
        """The profile of open lines that each rise by one pitch: the faces of a sheet.

        Parameters
        ----------
        faces : sequence of Face, or of sequences of (z, y) [mm]
            From bottom to top or from top to bottom, in any order; the end is the start one pitch on.
        pitch_mm : float, greater than 0 [mm]
        between : sequence of int, one more than faces, optional
            Media from the front to the back: before the first face, between each and the next, behind the last.
            Without it air and medium 1 alternate.

        Raises
        ------
        ClerestoryError
            If a line does not rise by one pitch, or the profile breaks a rule of :class:`Profile`.
        """
        from clerestory.drawing.line import Face

        lines = [face if isinstance(face, Face) else Face(face) for face in faces]
        return cls._arranged([], lines, pitch_mm, between, "vanish")

    @classmethod
    def from_svg_path(
        cls,
        data: str,
        *,
        pitch_mm: float,
        between: Sequence[int] | None = None,
        joins: Literal["vanish", "film"] = "vanish",
        curve_chords: int = CURVE_CHORDS,
    ) -> Profile:
        """The profile of SVG path data in mm, x across the sheet from the outside to the room, y down as ever in SVG.

        Parameters
        ----------
        data : str
            Closed subpaths are outlines of medium 1, as of :meth:`from_outlines`; open ones faces that rise by
            one pitch, as of :meth:`from_faces`. Circular arcs stay arcs.
        pitch_mm, joins, between
            As of those.
        curve_chords : int, at least 2, default 32
            Straight facets for each Bézier curve or elliptical arc.

        Raises
        ------
        ClerestoryError
            If the data cannot be read, a subpath neither closes nor rises by one pitch, or the profile breaks a rule.
        """
        from clerestory.drawing.svg import path_lines
        from clerestory.panels.optics import whole

        if not isinstance(data, str):
            raise ClerestoryError(f"data must be SVG path data, got {data!r}; try 'M0,0 H6 V-3 H0 Z'")
        lines = path_lines("data", data, medium=1, curve_chords=whole("curve_chords", curve_chords, 2))
        return cls._arranged(*lines, pitch_mm, between, joins)

    @classmethod
    def _arranged(
        cls,
        outlines: Sequence[Outline],
        faces: Sequence[Face],
        pitch_mm: float,
        between: Sequence[int] | None,
        joins: str,
    ) -> Profile:
        from clerestory.drawing.arrangement import arranged

        pitch = positive("pitch_mm", pitch_mm)
        return cls(
            pitch_mm=pitch, facets=tuple(arranged(outlines, faces, pitch_mm=pitch, between=between, joins=joins))
        )

    @classmethod
    def _of_native(cls, native: _native.Profile) -> Profile:
        ends, bulges, lefts, rights, films = native.facets()
        rows = zip(ends.tolist(), bulges, lefts, rights, films, strict=True)
        facets = tuple(
            Facet(start=(z0, y0), end=(z1, y1), left=left, right=right, bulge=bulge, film=None if film < 0 else film)
            for (z0, y0, z1, y1), bulge, left, right, film in rows
        )
        return cls(pitch_mm=native.pitch_mm, facets=facets)

    @property
    def depth_range_mm(self) -> tuple[float, float]:
        """Least and greatest z [mm]."""
        return self.native.depth_range_mm

    @property
    def is_straight(self) -> bool:
        """Whether no facet is an arc."""
        return self.native.is_straight

    @property
    def media_count(self) -> int:
        """How many media it names besides the air."""
        return self.native.highest_medium

    def flattened(self, chords: int) -> Profile:
        """The same with each arc drawn by so many straight facets, at least 2."""
        from clerestory.panels.optics import whole

        return Profile._of_native(self.native.flattened(whole("chords", chords, 2)))

    def to_dict(self) -> dict[str, Any]:
        """Plain values for TOML or JSON."""
        return {"pitch_mm": self.pitch_mm, "facets": [facet.to_dict() for facet in self.facets]}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Profile:
        """The profile of :meth:`to_dict`'s values; ClerestoryError for a key unknown or missing."""
        known_keys("profile", values, {"pitch_mm", "facets"}, {"pitch_mm", "facets"})
        return cls(pitch_mm=values["pitch_mm"], facets=values["facets"])


def read_profile(
    path: str | os.PathLike[str],
    *,
    pitch_mm: float,
    between: Sequence[int] | None = None,
    joins: Literal["vanish", "film"] = "vanish",
    layers: Mapping[str, int] | None = None,
    unit_mm: float | None = None,
    curve_chords: int = CURVE_CHORDS,
) -> Profile:
    """The profile of a drawing: an SVG or DXF file with one period of the cross-section.

    Parameters
    ----------
    path : path
        ``.svg``: every shape of the file, transforms applied; a plain unit is a mm, the attribute ``data-medium`` of a
        shape the number of the medium in it (1 without). ``.dxf``: polylines with bulges, lines, arcs and circles of
        the model space, lines and arcs joined where their ends meet; texts, dimensions and hatches are passed over.
        x goes across the sheet from the outside to the room.
    pitch_mm, between, joins
        Closed lines are outlines as of :meth:`Profile.from_outlines`, open ones faces as of
        :meth:`Profile.from_faces`.
    layers : mapping of str to int, optional
        DXF: medium inside the outlines of each layer; other layers are left out. Without it all layers are medium 1.
    unit_mm : float, optional [mm]
        DXF: length of a unit of the drawing; without it what the file says, mm if it says nothing.
    curve_chords : int, at least 2, default 32
        SVG: straight facets for each Bézier curve or elliptical arc.

    Raises
    ------
    ClerestoryError
        If the file cannot be read, holds what cannot be drawn, a line neither closes nor rises by one pitch, or the
        profile breaks a rule of :class:`Profile`; the message begins with the path.
    """
    from clerestory.drawing.dxf import dxf_lines
    from clerestory.drawing.svg import svg_lines
    from clerestory.panels.optics import whole

    where = Path(path)
    ending = where.suffix.lower()
    if ending not in (".svg", ".dxf"):
        raise ClerestoryError(f"path must end in .svg or .dxf, got {str(path)!r}; export the drawing as one")
    one_of("joins", joins, ("vanish", "film"))
    if ending == ".svg":
        lines = svg_lines(where, curve_chords=whole("curve_chords", curve_chords, 2))
    else:
        lines = dxf_lines(where, layers=layers, unit_mm=None if unit_mm is None else positive("unit_mm", unit_mm))
    try:
        return Profile._arranged(*lines, pitch_mm, between, joins)
    except ClerestoryError as error:
        raise ClerestoryError(f"{where}: {error}") from None


def _point(name: str, value: Any) -> Point:
    try:
        z, y = value
    except (TypeError, ValueError):
        raise ClerestoryError(f"{name} must be a point of two numbers (z, y), got {value!r}") from None
    return number(f"{name} z", z), number(f"{name} y", y)


def _facets(values: Iterable[Any]) -> tuple[Facet, ...]:
    """Facets, or the plain values of facets, as a tuple."""
    if isinstance(values, (str, Mapping)) or not isinstance(values, Iterable):
        raise ClerestoryError(f"facets must be a list of facets, got {values!r}")
    facets = []
    for place, value in enumerate(values, start=1):
        if isinstance(value, Mapping):
            known = {"start", "end", "left", "right", "bulge", "film"}
            known_keys(f"facet {place}", value, known, {"start", "end", "left", "right"})
            try:
                value = Facet(**value)
            except ClerestoryError as error:
                raise ClerestoryError(f"facet {place}: {error}") from None
        if not isinstance(value, Facet):
            raise ClerestoryError(f"facet {place} must be a Facet, got {value!r}")
        facets.append(value)
    return tuple(facets)


def _made_again(pitch_mm: float, facets: tuple[Facet, ...]) -> Profile:
    return Profile(pitch_mm=pitch_mm, facets=facets)
