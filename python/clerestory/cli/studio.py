"""``clerestory studio``: the page on which panels, rooms and results are looked at."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from clerestory.cli.mistakes import mistakes_told


def studio(
    folder: Annotated[Path, typer.Option(help="The only folder whose files the page can open.")] = Path(),
    port: Annotated[int, typer.Option(help="To listen on; 0 takes a free one.")] = 8765,
    host: Annotated[
        str, typer.Option(help="Address to listen on. Other than this machine's own, requests need a token.")
    ] = "127.0.0.1",
    token: Annotated[
        str | None, typer.Option(help="That requests must carry. [default: none here, one is made for other hosts]")
    ] = None,
    opens: Annotated[bool, typer.Option("--open/--no-open", help="Open the page in the browser.")] = True,
) -> None:
    """See a panel bend the light, in the browser: a local page over the same engine. Ctrl-C ends it."""
    with mistakes_told():
        from clerestory.studio.server import serve
        from clerestory.studio.settings import Settings

        serve(Settings(folder=folder, host=host, port=port, token=token), opens=opens)
