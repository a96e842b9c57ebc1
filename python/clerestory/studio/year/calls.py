"""What is asked for when a year file is run from the page."""

from __future__ import annotations

from starlette.requests import Request

from clerestory.errors import ClerestoryError
from clerestory.studio.doors.fields import Field
from clerestory.studio.doors.folder import inside
from clerestory.studio.doors.requests import Asked
from clerestory.studio.doors.shapes import NUMBER, TEXT, maybe, record
from clerestory.studio.jobs.kinds import Kind
from clerestory.studio.year.work import stays_inside, where_to

_FIELDS = {"path": Field(TEXT, "Path of a year file in the studio's folder")}
_RUN = record(
    {
        "variant": {**TEXT, "description": "Label of the variant that is computed; empty where it is about none"},
        "what": {**TEXT, "description": "What is done now, in words"},
        "seconds_left": {**maybe(NUMBER), "description": "About how long it still takes [s]; null while not known"},
        "path": {**maybe(TEXT), "description": "Of the year.nc in the studio's folder, once it is written"},
    }
)


def check(request: Request, asked: Asked) -> Asked:
    """The arguments of the job, once its file and all that it names lie in the folder."""
    folder, path = request.app.state.settings.folder, asked["path"]
    file = inside(folder, path)
    if file.suffix.lower() != ".toml" or not file.is_file():
        raise ClerestoryError(f"path must be a year file (TOML) of the studio's folder, got {path!r}")
    stays_inside(folder, path)
    where_to(folder, path)
    return {"folder": str(folder), "path": path}


KINDS = {"year": Kind(_FIELDS, check, _RUN, _RUN, is_slow=True)}
