"""What is asked for when a year file is run from the page."""

from __future__ import annotations

from starlette.requests import Request

from clerestory.errors import ClerestoryError
from clerestory.studio.fields import Field
from clerestory.studio.folder import inside
from clerestory.studio.requests import Asked
from clerestory.studio.shapes import TEXT
from clerestory.studio.year_work import stays_inside, where_to

FIELDS = {"path": Field(TEXT, "Path of a year file in the studio's folder")}


def check(request: Request, asked: Asked) -> Asked:
    """The arguments of the job, once its file and all that it names lie in the folder."""
    folder, path = request.app.state.settings.folder, asked["path"]
    file = inside(folder, path)
    if file.suffix.lower() != ".toml" or not file.is_file():
        raise ClerestoryError(f"path must be a year file (TOML) of the studio's folder, got {path!r}")
    stays_inside(folder, path)
    where_to(folder, path)
    return {"folder": str(folder), "path": path}
