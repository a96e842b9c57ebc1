"""A year of weather, and ways to spoil it."""

from collections.abc import Callable
from pathlib import Path

import pytest

from clerestory import Weather, read_epw

MIAMI = Path(__file__).parents[2] / "examples/classroom/USA_FL_Miami.Intl.AP.722020_TMY3.epw"
HEADER_LINES = 8


@pytest.fixture(scope="session")
def miami() -> Weather:
    """The typical year of Miami."""
    return read_epw(MIAMI)


@pytest.fixture
def spoiled(tmp_path: Path) -> Callable[..., Path]:
    """Writes the Miami file, its lines changed by a function, and gives its path."""

    def write(change: Callable[[list[str]], list[str]], encoding: str = "utf-8") -> Path:
        path = tmp_path / "spoiled.epw"
        path.write_bytes("\n".join(change(MIAMI.read_text().splitlines())).encode(encoding))
        return path

    return write


def row(month: int, day: int, hour: int) -> int:
    """Index of the line of an hour in a year without a leap day."""
    before = [0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334]
    return HEADER_LINES + (before[month - 1] + day - 1) * 24 + hour - 1


def with_field(line: str, field: int, value: object) -> str:
    """A row with another value in one field."""
    fields = line.split(",")
    fields[field] = str(value)
    return ",".join(fields)
