"""What is told of a job of each kind, as JSON Schema, so that a program can rely on it."""

from __future__ import annotations

from collections.abc import Mapping

from clerestory.studio.doors.fields import Field, Fields, shape_of
from clerestory.studio.doors.shapes import INTEGER, NUMBER, TEXT, Shape, listed, maybe, record, word
from clerestory.studio.jobs.kinds import Kind

STATES = ("waiting", "running", "done", "failed", "cancelled")


def asked_fields(name: str, kind: Kind) -> Fields:
    """The fields that a job of a kind is asked with, its kind among them."""
    return {"kind": Field(word(name), "Kind of the job"), **kind.fields}


def job_shape(name: str, kind: Kind) -> Shape:
    """What is told of one job, by its own call and as the data of each event."""
    return record(_told(name, kind))


def listed_shape(name: str, kind: Kind) -> Shape:
    """What the list of jobs tells of one."""
    asked = {
        "asked": {**shape_of(asked_fields(name, kind)), "description": "What it was asked with, defaults filled in"},
        "asked_at": {**TEXT, "description": "When, as ISO 8601, UTC"},
        "followers": {**INTEGER, "description": "Who reads its events now"},
    }
    return record(_told(name, kind) | asked)


def _told(name: str, kind: Kind) -> dict[str, Shape]:
    return {
        "job": TEXT,
        "kind": word(name),
        "state": word(*STATES),
        "done": {**NUMBER, "description": "How far it is, of `total`"},
        "total": {**NUMBER, "description": "0 while it is not known"},
        "partial": {**maybe(kind.partial), "description": "What there is so far; null once it is over"},
        "result": {**maybe(kind.result), "description": "What there is in the end; null until it is done"},
        "errors": listed(record({"field": maybe(TEXT), "message": TEXT})),
    }


def schemas(kinds: Mapping[str, Kind]) -> dict[str, Shape]:
    """The shapes of all kinds by name, and `Job` and `ListedJob`, which are one of them."""
    made: dict[str, Shape] = {}
    for whole, shape in (("Job", job_shape), ("ListedJob", listed_shape)):
        made |= {_name(name, whole): shape(name, kind) for name, kind in kinds.items()}
        mapping = {name: f"#/components/schemas/{_name(name, whole)}" for name in kinds}
        made[whole] = {
            "oneOf": [{"$ref": one} for one in mapping.values()],
            "discriminator": {"propertyName": "kind", "mapping": mapping},
        }
    return made


def _name(kind: str, whole: str) -> str:
    return whole.replace("Job", "".join(part.capitalize() for part in kind.split("_")) + "Job")
