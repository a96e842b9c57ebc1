"""How long a picture takes while many drag at once, for docs/benchmarks.md: ``dragging.py [clients] [seconds] [word]``.

Each client asks one kind of question up to 20 times a second, another value each time, as a hand on a slider does, and
waits for the answer before it asks again. One studio on this machine alone, asked by this one program beside it.
"""

from __future__ import annotations

import asyncio
import copy
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from datetime import date, timedelta
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import httpx

from clerestory import panel_from_dict

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "benches" / "peers"))
from benchmark_page import machine, put_section  # noqa: E402

HEADING = "## The studio while twenty drag at once"
EVERY_S = 0.05
#: The 95th percentile that a question answered while one drags is to stay under [ms].
AIM_MS = 300.0
IDEAL = {"kind": "laser-cut", "spacing_mm": 6.0, "thickness_mm": 6.0}
PRISM = {"kind": "prismatic", "pitch_mm": 4.0, "lower_deg": 45.0, "upper_deg": 80.0, "base_mm": 3.0}
CLEAR = {"kind": "cie", "sky_type": 12, "luminous_turbidity": 4.0}
#: The question that is asked while two long jobs run beside.
BUSY = "panel, section, while two BSDFs of prisms are computed"
CLASSROOM, WEATHER = ROOT / "examples" / "classroom", "USA_FL_Miami.Intl.AP.722020_TMY3.epw"
ROUGH_YEAR = """[calculation]
suns = "reinhart577"
rounds = 2
nodes = 256
window_samples = 32
sun_rounds = 2
"""
#: What a client asks in its turn: path and body, of the turn and the number of the client.
Question = Callable[[int, int], tuple[str, dict[str, Any]]]
TEXT = """Milliseconds from question to answer, while 20 clients ask the same kind of question up to 20 times a second,
another value each time, and each waits for its answer. The server and the 20 clients share the cores of the machine;
CPU ms are the server's own for each answer. A page drops all but the newest of its questions while the hand moves."""


def moved(turn: int, client: int) -> float:
    """A value between 0 and 1 that no other turn of any client has."""
    return (0.618034 * (1 + turn) + 0.0137 * client) % 1.0


async def asked(client: httpx.AsyncClient, path: str, body: dict[str, Any]) -> Any:
    """The answer to one question."""
    answer = await client.post(path, json=body)
    answer.raise_for_status()
    return answer.json()


async def done(client: httpx.AsyncClient, **body: Any) -> Any:
    """The result of a job."""
    key = (await asked(client, "/api/jobs", body))["job"]
    while (state := (await client.get(f"/api/jobs/{key}")).json())["state"] in ("waiting", "running"):
        await asyncio.sleep(0.1)
    assert state["state"] == "done", state
    return state["result"]


async def year_questions(client: httpx.AsyncClient, folder: Path) -> dict[str, Question]:
    """Those about a year of the classroom, whose numbers come of few rays: the answers are as large as of many."""
    shutil.copy(CLASSROOM / WEATHER, folder)
    text = (CLASSROOM / "year.toml").read_text(encoding="utf-8").partition("[calculation]")[0] + ROUGH_YEAR
    (folder / "year.toml").write_text(text, encoding="utf-8")
    path = (await done(client, kind="year", path="year.toml"))["path"]
    told = await asked(client, "/api/result/open", {"path": path})
    key, metrics = told["key"], [one["key"] for one in told["metrics"]]
    sensors = sum(one["count"] for one in told["planes"])
    first = date.fromisoformat((await asked(client, "/api/result/carpet", {"key": key}))["days"][0])

    def any_hour(turn: int, one: int) -> dict[str, Any]:
        hour = int(8760 * moved(turn, one))
        day = first + timedelta(days=hour // 24)
        return {"key": key, "day": day.isoformat(), "hour": hour % 24 + 0.5}

    return {
        "year, plan of a quantity": lambda turn, one: (
            "/api/result/plan",
            {"key": key, "metric": metrics[(turn + one) % len(metrics)]},
        ),
        "year, plan of an hour": lambda turn, one: ("/api/result/hour", any_hour(turn, one)),
        "year, carpet of a place": lambda turn, one: (
            "/api/result/carpet",
            {"key": key, "series": "sensor", "sensor": int(sensors * moved(turn, one))},
        ),
        "year, months of a place": lambda turn, one: (
            "/api/result/months",
            {"key": key, "series": "sensor", "sensor": int(sensors * moved(turn, one))},
        ),
    }


async def questions(client: httpx.AsyncClient, folder: Path, only: list[str]) -> dict[str, Question]:
    """The kinds of questions that are asked while one drags, on things that are opened first."""
    panel_from_dict(IDEAL).bsdf().to_xml(folder / "panel.xml")
    klems = (await asked(client, "/api/bsdf/open", {"path": "panel.xml"}))["key"]
    start = (await asked(client, "/api/room/kinds", {}))["start"]
    plane = start["sensors"][0].get("name", "work plane")
    light = (await done(client, kind="room", room={"tables": start}, surface=plane))["key"]

    def of_panel(path: str, panel: dict[str, Any], size: str) -> Question:
        return lambda turn, one: (
            path,
            {"panel": panel | {size: panel[size] * (1.0 + 0.5 * moved(turn, one))}, "elevation_deg": 40.0},
        )

    def deeper(turn: int, one: int) -> dict[str, Any]:
        tables = copy.deepcopy(start)
        tables["shoebox"]["depth_m"] = 5.0 + 3.0 * moved(turn, one)
        return {"tables": tables}

    def of_light(sky: dict[str, Any]) -> Question:
        return lambda turn, one: (
            "/api/room/light",
            {"key": light, "day_of_year": 172, "hour": 8.0 + 8.0 * moved(turn, one), "sky": sky},
        )

    return {
        "panel, section: ideal cuts": of_panel("/api/panel/section", IDEAL, "spacing_mm"),
        "panel, section: cuts of 0.3 mm": of_panel("/api/panel/section", IDEAL | {"cut_width_mm": 0.3}, "spacing_mm"),
        "panel, section: prisms": of_panel("/api/panel/section", PRISM, "pitch_mm"),
        "panel, numbers: ideal cuts": of_panel("/api/panel/lobes", IDEAL, "spacing_mm"),
        "BSDF, Klems discs": lambda turn, one: (
            "/api/bsdf/discs",
            {"key": klems, "elevation_deg": 80.0 * moved(turn, one)},
        ),
        "room, another depth": lambda turn, one: ("/api/room/scene", {"room": deeper(turn, one)}),
        "room, the sun's way": lambda turn, one: (
            "/api/room/paths",
            {"room": {"tables": start}, "day_of_year": 172, "hour": 8.0 + 8.0 * moved(turn, one)},
        ),
        "room, the sun's place": lambda turn, one: (
            "/api/room/sun",
            {"site": start["site"], "day_of_year": 172, "hour": 8.0 + 8.0 * moved(turn, one)},
        ),
        "room, light of an overcast sky": of_light({"kind": "overcast"}),
        "room, light of sky and sun": of_light(CLEAR),
        **(await year_questions(client, folder) if not only or any("year" in one for one in only) else {}),
        BUSY: of_panel("/api/panel/section", IDEAL, "spacing_mm"),
    }


class Hand:
    """One client: a connection that is kept, and no more work than a question takes to send."""

    def __init__(self, url: str) -> None:
        parts = urlsplit(url)
        self.host, self.port = str(parts.hostname), int(parts.port or 80)

    async def __aenter__(self) -> Hand:
        self.reader, self.writer = await asyncio.open_connection(self.host, self.port)
        return self

    async def __aexit__(self, *_: object) -> None:
        self.writer.close()

    async def ask(self, path: str, body: dict[str, Any]) -> None:
        """Asks a question and waits for the whole of its answer."""
        content = json.dumps(body).encode()
        head = f"POST {path} HTTP/1.1\r\nHost: {self.host}:{self.port}\r\nContent-Length: {len(content)}\r\n\r\n"
        self.writer.write(head.encode() + content)
        told = (await self.reader.readuntil(b"\r\n\r\n")).decode("latin-1").lower()
        assert told.startswith("http/1.1 200"), told
        found = re.search(r"content-length: (\d+)", told)
        assert found, told
        await self.reader.readexactly(int(found[1]))


async def drag(url: str, ask: Question, number: int, until: float) -> list[float]:
    """Seconds that each answer took."""
    took = []
    turn = 0
    async with Hand(url) as hand:
        while (begun := time.perf_counter()) < until:
            turn += 1
            await hand.ask(*ask(turn, number))
            took.append(time.perf_counter() - begun)
            await asyncio.sleep(max(0.0, EVERY_S - took[-1]))
    return took


def cpu_s(process: int) -> float:
    """CPU seconds of a process so far, all threads together; 0 where the system does not tell."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


async def measured(url: str, process: int, folder: Path, clients: int, seconds: float, only: list[str]) -> list[str]:
    """A row of the table for each kind of question."""
    rows = []
    async with httpx.AsyncClient(base_url=url, timeout=60.0) as client:
        for name, ask in (await questions(client, folder, only)).items():
            if only and not any(one in name for one in only):
                continue
            jobs = []
            if name == BUSY:
                for size in (2.0, 3.0):
                    asked = {"kind": "klems", "panel": PRISM | {"pitch_mm": size}}
                    jobs.append((await client.post("/api/jobs", json=asked)).json()["job"])
            await drag(url, ask, 999, time.perf_counter() + 0.3)
            before, until = cpu_s(process), time.perf_counter() + seconds
            parts = await asyncio.gather(*(drag(url, ask, number, until) for number in range(clients)))
            took = sorted(one for part in parts for one in part)
            cpu_ms = (cpu_s(process) - before) / len(took) * 1e3
            median, late = (took[min(len(took) - 1, int(share * len(took)))] * 1e3 for share in (0.5, 0.95))
            verdict = "yes" if late < AIM_MS else "no"
            rows.append(
                f"| {name} | {len(took) / seconds:.0f} | {cpu_ms:.1f} | {median:.0f} | {late:.0f} | {verdict} |"
            )
            print(rows[-1], flush=True)
            for job in jobs:
                await client.delete(f"/api/jobs/{job}")
    return rows


def section(clients: int, seconds: float, only: list[str]) -> str:
    """The section of docs/benchmarks.md."""
    where = machine()
    with tempfile.TemporaryDirectory(prefix="clerestory-") as folder:
        command = [sys.executable, "-c", "from clerestory.cli import app; app()", "studio", "--no-open", "--port", "0"]
        studio = subprocess.Popen([*command, "--folder", folder], stdout=subprocess.PIPE, text=True)
        try:
            assert studio.stdout is not None
            found = re.search(r"http://\S+", studio.stdout.readline())
            assert found, "the studio did not start"
            rows = asyncio.run(measured(found[0], studio.pid, Path(folder), clients, seconds, only))
        finally:
            studio.terminate()
            studio.wait(10)
    head = [
        "| question | answers a second | CPU ms each | median | 95th percentile | under 300 ms |",
        "|---|---|---|---|---|---|",
    ]
    return "\n".join([HEADING, "", f"On {where}.", "", TEXT, "", *head, *rows, ""])


def main() -> None:
    """Puts the section into the page in the place of the last one; asked for some questions only, prints them."""
    numbers = [float(one) for one in sys.argv[1:3] if re.fullmatch(r"[\d.]+", one)]
    clients, seconds = int(numbers[0]) if numbers else 20, numbers[1] if len(numbers) > 1 else 5.0
    only = [one for one in sys.argv[1:] if not re.fullmatch(r"[\d.]+", one)]
    made = section(min(clients, 100), min(seconds, 60.0), only)
    if not only:
        put_section(HEADING, made)


if __name__ == "__main__":
    main()
