"""A user's mistake on the command line: one line on standard error, exit code 2."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

import typer

from clerestory.errors import ClerestoryError

EXIT_CODE = 2


@contextmanager
def mistakes_told() -> Iterator[None]:
    """Turns a ClerestoryError into its message and exit code 2; Ctrl-C into exit code 130."""
    try:
        yield
    except ClerestoryError as error:
        print(f"clerestory: {' '.join(str(error).split())}", file=sys.stderr)
        raise typer.Exit(EXIT_CODE) from None
    except KeyboardInterrupt:
        print("clerestory: stopped", file=sys.stderr)
        raise typer.Exit(130) from None
