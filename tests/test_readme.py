"""What README.md shows works as shown."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

README = (Path(__file__).parents[1] / "README.md").read_text()
PYTHON = re.findall(r"^```python\n(.*?)^```", README, re.MULTILINE | re.DOTALL)
COMMANDS = re.findall(r"^clerestory .*$", "\n".join(re.findall(r"^```sh\n(.*?)^```", README, re.M | re.S)), re.M)


def run(command: list[str], folder: Path) -> None:
    environment = os.environ | {"MPLBACKEND": "agg"}
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, timeout=600, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_readme_shows_both_ways_in() -> None:
    assert PYTHON
    assert COMMANDS


@pytest.mark.parametrize("block", PYTHON)
def test_python_of_the_readme_runs(block: str, tmp_path: Path) -> None:
    run([sys.executable, "-c", block], tmp_path)


@pytest.mark.parametrize("command", COMMANDS)
def test_commands_of_the_readme_run(command: str, tmp_path: Path) -> None:
    scripts = Path(sys.executable).parent
    run([str(scripts / "clerestory"), *shlex.split(command, comments=True)[1:]], tmp_path)
