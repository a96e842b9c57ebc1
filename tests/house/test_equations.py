"""Every equation that code or prose cites stands in docs/theory, numbered."""

import re
from collections import Counter
from pathlib import Path

CITED_FILE = re.compile(r"\btheory/([\w-]+\.md)")
CITED = re.compile(r"\btheory/([\w-]+\.md),?\s+eqs?\.\s*(\d+(?:(?:\s*[–,-]\s*|\s+and\s+|,\s+and\s+)\d+)*)")
TAG = re.compile(r"\\tag\{(\d+)\}")
# a citation may run over a line of comment
LINE_BREAK = re.compile(r"\s*\n\s*(?:///|//!|//|#|\*)?\s*")


def numbers(listed: str) -> set[int]:
    """``1, 3–5 and 7`` as {1, 3, 4, 5, 7}."""
    found = set()
    for part in re.split(r"\s*,\s*(?:and\s+)?|\s+and\s+", listed):
        ends = [int(end) for end in re.split(r"\s*[–-]\s*", part)]
        found |= set(range(ends[0], ends[-1] + 1))
    return found


def test_lists_and_ranges_are_understood() -> None:
    assert numbers("4") == {4}
    assert numbers("1, 3–5 and 7") == {1, 3, 4, 5, 7}
    text = LINE_BREAK.sub(" ", "(theory/interface.md,\n    /// eqs. 2–5; Hecht)")
    assert CITED.findall(text) == [("interface.md", "2–5")]


def test_every_cited_equation_exists(root: Path, texts: dict[Path, str]) -> None:
    theory = {path.name: set(map(int, TAG.findall(path.read_text()))) for path in (root / "docs/theory").glob("*.md")}
    missing, cited = [], 0
    for path, text in texts.items():
        if path.suffix not in {".rs", ".py", ".pyi", ".md", ".ts", ".tsx"} or path == Path(__file__):
            continue
        text = LINE_BREAK.sub(" ", text)
        where = path.relative_to(root)
        missing += [f"{where}: docs/theory/{name}" for name in CITED_FILE.findall(text) if name not in theory]
        for name, listed in CITED.findall(text):
            cited += 1
            absent = numbers(listed) - theory.get(name, set())
            missing += [f"{where}: docs/theory/{name} has no eq. {number}" for number in sorted(absent)]
    assert not missing, "\n".join(missing)
    assert cited, "no citation was found: the pattern is broken"


def test_equation_numbers_are_unique_and_consecutive(root: Path) -> None:
    for path in (root / "docs/theory").glob("*.md"):
        tags = Counter(map(int, TAG.findall(path.read_text())))
        assert sorted(tags.elements()) == list(range(1, len(tags) + 1)), f"{path.name}: {sorted(tags.elements())}"
