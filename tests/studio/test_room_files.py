"""Files that tables of a room name are read within the studio's folder alone."""

import copy
import json
import os
import struct
from pathlib import Path
from typing import Any

import pytest
from tests.studio.test_room_calls import WHEN, ask, refused

from clerestory.studio.room import asked as room_asked
from clerestory.studio.room.kinds import start_tables

OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def naming(kind: str, file: Any) -> dict[str, Any]:
    """The room shown first with a table that names a file."""
    tables = copy.deepcopy(start_tables())
    if kind == "mesh":
        tables["mesh"] = [{"file": file, "material": 0.5}]
    elif kind == "radiance":
        tables["radiance"] = [{"file": file}]
    elif kind == "weather":
        tables["weather"] = {"file": file}
        del tables["site"]
    elif kind == "room":
        tables = {"room": file, "name": "a year"}
    else:
        tables["glazings"]["glass"] = {"file": file} | ({"kind": "bsdf"} if kind == "bsdf" else {})
    return {"tables": tables}


ENDINGS = {"mesh": "obj", "radiance": "rad", "weather": "epw", "room": "toml", "bsdf": "xml", "panel": "toml"}


@pytest.mark.parametrize("kind", ENDINGS)
def test_no_table_leads_out_of_the_folder(rooms: Any, room_folder: Path, kind: str) -> None:
    name = f"secret.{ENDINGS[kind]}"
    outside = room_folder.parent / name
    outside.write_text("SECRET")
    link = room_folder / f"link-{name}"
    if not link.is_symlink():
        link.symlink_to(outside)
    for file in (
        f"../{name}",
        f"sub/../../{name}",
        str(outside),
        link.name,
        "/etc/passwd",
        "C:\\boot.ini",
        "",
        7,
        None,
    ):
        answer = rooms.post("/api/room/scene", json={"room": naming(kind, file)})
        assert answer.status_code == 422, (file, answer.text)
        fault = answer.json()["errors"][0]["message"]
        assert "must be a file of the studio's folder" in fault, fault
        assert "SECRET" not in fault
        job = rooms.post("/api/jobs", json={"kind": "room", "room": naming(kind, file)})
        assert job.status_code == 422


def test_rooms_and_skies_of_files_stay_within_too(rooms: Any, room_folder: Path) -> None:
    (room_folder.parent / "room.toml").write_text("name = 'SECRET'")
    for path in ("../room.toml", str(room_folder.parent / "room.toml"), "none.toml", "sub"):
        assert refused(rooms, "scene", room={"path": path})["field"] == "path"
    # a file of the folder that leads out
    (room_folder / "leads-out.toml").write_text("[[mesh]]\nfile = '../secret.obj'\nmaterial = 0.5\n")
    assert "file of [[mesh]] 1" in refused(rooms, "scene", room={"path": "leads-out.toml"})["message"]


def test_a_mesh_of_the_folder_is_read_and_read_again_when_it_changes(rooms: Any, room_folder: Path) -> None:
    mesh = room_folder / "sub" / "table.obj"
    mesh.write_text(OBJ)
    told = ask(rooms, "scene", room=naming("mesh", "sub/table.obj"))
    before = next(one for one in told["surfaces"] if one["name"].startswith("table"))
    assert before["triangles"] == [[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]]
    mesh.write_text(OBJ.replace("v 1 0 0", "v 2 0 0"))
    os.utime(mesh, (1e9, 1e9))
    told = ask(rooms, "scene", room=naming("mesh", "sub/table.obj"))
    assert next(one for one in told["surfaces"] if one["name"].startswith("table"))["triangles"][0][3] == 2.0


def test_a_gltf_names_no_file_outside(rooms: Any, room_folder: Path) -> None:
    (room_folder.parent / "secret.bin").write_bytes(b"0" * 64)
    for uri in ("../secret.bin", "%2e%2e/secret.bin", "/etc/passwd", 7):
        (room_folder / "room.gltf").write_text(json.dumps({"buffers": [{"uri": uri, "byteLength": 64}]}))
        fault = refused(rooms, "scene", room=naming("mesh", "room.gltf"))["message"]
        assert "studio's folder" in fault or "plainly" in fault, fault
    scene = json.dumps({"images": [{"uri": "../secret.png"}]}).encode()
    head = b"glTF" + struct.pack("<IIII", 2, 20 + len(scene), len(scene), 0x4E4F534A)
    (room_folder / "room.glb").write_bytes(head + scene)
    assert "images of" in refused(rooms, "scene", room=naming("mesh", "room.glb"))["message"]
    (room_folder / "room.gltf").write_text("no glTF")
    assert "must be a glTF file" in refused(rooms, "scene", room=naming("mesh", "room.gltf"))["message"]


def test_too_many_triangles_are_refused(rooms: Any, room_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(room_asked, "MOST_TRIANGLES", 30)
    (room_folder / "fine.obj").write_text(OBJ.replace("1 0 0", "1.5 0 0"))
    assert "at most 30 triangles" in refused(rooms, "scene", room=naming("mesh", "fine.obj"))["message"]


def test_the_folder_lists_what_a_room_takes(rooms: Any) -> None:
    files = {one["path"]: one["kind"] for one in rooms.post("/api/about", json={}).json()["files"]}
    assert files["USA_FL_Miami.Intl.AP.722020_TMY3.epw"] == "weather"
    assert files["classroom.toml"] == "toml"
    ask(rooms, "paths", room={"path": "classroom.toml"}, **WHEN)
