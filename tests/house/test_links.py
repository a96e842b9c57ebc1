"""Links between the project's pages hold, headings included."""

import re
from pathlib import Path
from urllib.parse import unquote

FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)|<(?:img|a)[^>]*?\s(?:src|href)=\"([^\"]+)\"")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$", re.MULTILINE)


def anchors(text: str) -> set[str]:
    """The anchors that a page's headings make: lower case, hyphens for spaces, no punctuation."""
    made: set[str] = set()
    for heading in HEADING.findall(FENCE.sub("", text)):
        words = re.sub(r"\]\([^)]*\)", "", heading)
        slug = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        made.add(next(name for n in range(len(text)) if (name := f"{slug}-{n}" if n else slug) not in made))
    return made


def test_relative_links_lead_somewhere(root: Path, texts: dict[Path, str]) -> None:
    broken, followed = [], 0
    for page, text in texts.items():
        if page.suffix != ".md":
            continue
        for match in LINK.finditer(CODE.sub("", FENCE.sub("", text))):
            link = match[1] or match[2]
            if re.match(r"[a-z]+:", link):
                continue
            followed += 1
            name, _, anchor = unquote(link).partition("#")
            target = (page.parent / name).resolve() if name else page
            if not target.exists():
                broken.append(f"{page.relative_to(root)}: {link}")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text()):
                broken.append(f"{page.relative_to(root)}: {link} (no such heading)")
    assert not broken, "\n".join(broken)
    assert followed, "no link was found: the pattern is broken"


def test_anchors_follow_headings() -> None:
    assert anchors("# Results *change*\n## A [b](c.md), d\n## A b, d\n") == {"results-change", "a-b-d", "a-b-d-1"}
