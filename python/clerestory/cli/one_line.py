"""A mistake in the words of a command itself: one line, as for every other mistake."""

from __future__ import annotations

import sys
from typing import Any

from typer.core import TyperGroup

from clerestory.cli.mistakes import EXIT_CODE


class OneLineGroup(TyperGroup):
    """A group that tells of an unknown option or a word that is no number in one line."""

    def main(self, *args: Any, **options: Any) -> Any:
        """Runs the command; ends the process as a shell expects, unless ``standalone_mode`` is False."""
        if not options.pop("standalone_mode", True):
            return super().main(*args, **{**options, "standalone_mode": False})
        try:
            code = super().main(*args, **{**options, "standalone_mode": False})
        except Exception as error:
            message = getattr(error, "format_message", None)
            if message is None:
                raise
            # help, printed for want of words, is no mistake to tell in a line
            if type(error).__name__ == "NoArgsIsHelpError":
                print(message())
                sys.exit(EXIT_CODE)
            context = getattr(error, "ctx", None)
            way_out = f"; see {context.command_path} --help" if context is not None else ""
            print(f"clerestory: {' '.join(message().split()).rstrip('.')}{way_out}", file=sys.stderr)
            sys.exit(EXIT_CODE)
        sys.exit(code if isinstance(code, int) else 0)
