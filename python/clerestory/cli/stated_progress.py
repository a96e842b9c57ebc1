"""Bars that say in words how far each piece of long work is."""

from __future__ import annotations

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn


def stated_progress(console: Console, *, hidden: bool) -> Progress:
    """Bars on ``console``, gone when all is done; each task has a field ``state`` for its words."""
    return Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.fields[state]}"),
        TimeElapsedColumn(),
        console=console,
        disable=hidden,
        transient=True,
    )
