"""Computes every case in full and writes docs/validation.md with its figures."""

from __future__ import annotations

import sys
import time
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT))

from tests.validation.cases import CASES, FOLDER, claim  # noqa: E402

from clerestory import __version__  # noqa: E402
from clerestory.plots.style import styled  # noqa: E402

IMAGES = ROOT / "docs" / "images" / "validation"
HEAD = f"""# Shown to be right

Written by `make validate`, Clerestory {__version__}. Each section is a case in `tests/validation`: its question, where
the answer comes from, how far off it may be and why, and what was found. `make test` tries every case on fewer panels
and directions.

Measured transmittance of laser-cut and prismatic panels is not at hand, so nothing here claims agreement with a
laboratory but for clear glass. To compare with a measurement of your own: `clerestory panel … --measured FILE.csv`.
"""


def section(case: str) -> tuple[str, bool]:
    """The section of one case, and whether all it claims holds."""
    began = time.perf_counter()
    found = claim(case, thorough=True)
    with styled():
        found.figure.savefig(IMAGES / f"{case}.png", dpi=100, metadata={"Software": None})
    title, _, text = (FOLDER / case / "README.md").read_text(encoding="utf-8").removeprefix("# ").partition("\n")
    rows = "\n".join(measured.row for measured in found.measured)
    table = f"| measured | value | limit | |\n|---|---|---|---|\n{rows}"
    holds = all(measured.holds for measured in found.measured)
    print(f"{case:20} {'holds' if holds else 'FAILS'} {time.perf_counter() - began:7.1f} s", flush=True)
    return f"\n## {title}\n{text}\n{table}\n\n![{title}](images/validation/{case}.png)\n", holds


def main() -> int:
    """Writes the page; 1 if a claim fails."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    sections = [section(case) for case in CASES]
    page = ROOT / "docs" / "validation.md"
    draft = page.with_suffix(".md.part")
    draft.write_text(HEAD + "".join(text for text, _ in sections), encoding="utf-8")
    draft.replace(page)
    print(f"wrote {page.relative_to(ROOT)}")
    return 0 if all(holds for _, holds in sections) else 1


if __name__ == "__main__":
    sys.exit(main())
