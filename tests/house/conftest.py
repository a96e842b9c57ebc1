"""What the rules of the house are applied to: the project's own files."""

import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MADE = {".venv", "target", "out", "dist", "build", "site", "node_modules", "__pycache__"}
MADE |= {".git", ".pytest_cache", ".ruff_cache", ".mypy_cache", ".hypothesis"}


@pytest.fixture(scope="session")
def root() -> Path:
    """The folder of the project."""
    return ROOT


@pytest.fixture(scope="session")
def files(root: Path) -> list[Path]:
    """Every file of the project: tracked, or new and not ignored; without git, all but what the jobs make."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
    if (root / ".git").exists() and shutil.which("git"):
        listed = subprocess.run(command, cwd=root, capture_output=True, check=True, text=True).stdout.split("\0")
        paths = {root / name for name in listed if name}
    else:
        paths = {path for path in root.rglob("*") if not MADE & set(path.relative_to(root).parts)}
    return sorted(path for path in paths if path.is_file())


@pytest.fixture(scope="session")
def texts(files: list[Path]) -> dict[Path, str]:
    """Every file that holds text, by path."""
    found = {}
    for path in files:
        content = path.read_bytes()
        if b"\0" not in content[:8192]:
            found[path] = content.decode("utf-8", "replace")
    return found
