"""docs/benchmarks.md, which several benches write together: one makes the page, each of the others a section of it."""

from __future__ import annotations

import os
import platform
from pathlib import Path

from clerestory.saving import write_text

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "benchmarks.md"


def machine() -> str:
    """The processor, its cores and the system."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    model = next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), platform.processor())
    load = f", load {os.getloadavg()[0]:.1f} while it ran" if hasattr(os, "getloadavg") else ""
    return f"{model}, {os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}{load}"


def put_page(text: str) -> None:
    """Writes the page anew, whole or not at all."""
    write_text(PAGE, text)
    print(f"wrote {PAGE.relative_to(ROOT)}")


def put_section(heading: str, made: str) -> None:
    """Puts a section, which begins with its heading, in the place of the one before, or at the end of the page."""
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(heading)
    following = rest.find("\n## ")
    after = rest[following:] if following >= 0 else ""
    put_page(before.rstrip("\n") + "\n\n" + made + after)
