"""The fields that a question has: declared once, checked and described from that."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from clerestory.studio.doors.shapes import Shape, fit, maybe, record

_NEEDED = object()


@dataclass(frozen=True)
class Field:
    """One field of a question: its shape, and a sentence with its unit.

    Parameters
    ----------
    shape : Shape
        Whether it can be read at all. What makes sense is the API's dataclasses' to say.
    tells : str
        What it is, with its unit.
    default : any, optional
        Without one the field must be given. One that may be left out may be null too: the default then stands in its
        place, or with a default of None the field is not there.
    example : any, optional
        A value that is answered, for a reader who tries the call.
    """

    shape: Shape
    tells: str
    default: Any = _NEEDED
    example: Any = None

    @property
    def is_needed(self) -> bool:
        """Whether it must be given."""
        return self.default is _NEEDED

    @property
    def described(self) -> Shape:
        """The shape with its sentence, for a reader."""
        told: Shape = {"description": self.tells}
        if self.example is not None:
            told["examples"] = [self.example]
        if self.is_needed:
            return {**self.shape, **told}
        if self.default is not None:
            told["default"] = self.default
        return {**maybe(self.shape), **told}


Fields = Mapping[str, Field]


def shape_of(fields: Fields) -> Shape:
    """The table that holds the fields."""
    needed = {name: field.described for name, field in fields.items() if field.is_needed}
    others = {name: field.described for name, field in fields.items() if not field.is_needed}
    return record(needed, also=others)


def checked(fields: Fields, asked: dict[str, Any]) -> dict[str, Any]:
    """What was asked, with defaults in place of what was left out.

    Raises
    ------
    MisshapenError
        If a field is unknown, missing, or has not its shape.
    """
    fit("", asked, shape_of(fields))
    starts = {name: one.default for name, one in fields.items() if not one.is_needed and one.default is not None}
    return starts | {name: value for name, value in asked.items() if value is not None or fields[name].is_needed}
