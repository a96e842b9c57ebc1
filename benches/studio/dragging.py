"""How long a picture takes while many drag at once: ``python benches/studio/dragging.py [clients] [seconds]``.

Each client asks for the section of an ideal laser-cut panel 20 times a second, a new spacing each time, as a hand on a
slider does, and waits for the answer before it asks again. A studio on this machine alone; nothing else is asked.
"""

import asyncio
import re
import subprocess
import sys
import time

import httpx

EVERY_S = 0.05


async def drag(client: httpx.AsyncClient, number: int, until: float) -> list[float]:
    """Seconds that each picture took."""
    took = []
    turn = 0
    while (begun := time.perf_counter()) < until:
        turn += 1
        panel = {"kind": "laser-cut", "spacing_mm": 4.0 + 0.013 * (turn % 200) + 0.0007 * number, "thickness_mm": 6.0}
        asked = {"panel": panel, "elevation_deg": 40.0, "azimuth_deg": 0.0}
        answer = await client.post("/api/panel/section", json=asked)
        answer.raise_for_status()
        took.append(time.perf_counter() - begun)
        await asyncio.sleep(max(0.0, EVERY_S - took[-1]))
    return took


async def load(url: str, clients: int, seconds: float) -> list[float]:
    """All of them at once."""
    limits = httpx.Limits(max_connections=clients)
    async with httpx.AsyncClient(base_url=url, timeout=30.0, limits=limits) as client:
        await drag(client, 0, time.perf_counter() + 0.5)
        until = time.perf_counter() + seconds
        parts = await asyncio.gather(*(drag(client, number, until) for number in range(clients)))
    return sorted(one for part in parts for one in part)


def main() -> None:
    clients = min(int(sys.argv[1]) if len(sys.argv) > 1 else 20, 100)
    seconds = min(float(sys.argv[2]) if len(sys.argv) > 2 else 5.0, 60.0)
    command = [sys.executable, "-c", "from clerestory.cli import app; app()", "studio", "--no-open", "--port", "0"]
    studio = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        assert studio.stdout is not None
        found = re.search(r"http://\S+", studio.stdout.readline())
        assert found, "the studio did not start"
        took = asyncio.run(load(found[0], clients, seconds))
    finally:
        studio.terminate()
        studio.wait(10)
    at = {
        name: took[min(len(took) - 1, int(share * len(took)))] * 1e3 for name, share in (("median", 0.5), ("p95", 0.95))
    }
    print(f"{clients} clients, {len(took) / seconds:.0f} pictures a second: ", end="")
    print(", ".join(f"{name} {value:.0f} ms" for name, value in at.items()) + f", slowest {took[-1] * 1e3:.0f} ms")


if __name__ == "__main__":
    main()
