"""Starts the studio and opens its page."""

from __future__ import annotations

import socket
import threading
import webbrowser
from typing import Any

from clerestory.errors import ClerestoryError
from clerestory.studio.settings import Settings


def serve(settings: Settings, *, opens: bool, tell: Any = print) -> None:
    """Serves until Ctrl-C.

    Parameters
    ----------
    settings : Settings
    opens : bool
        Whether to open the page in the browser.
    tell : callable, default print
        Told of the address.

    Raises
    ------
    ClerestoryError
        If the extra is not installed, the page is not built, or the port is taken.
    """
    try:
        import uvicorn

        from clerestory.studio.app import NO_PAGE, PAGE, make_app
    except ModuleNotFoundError as missing:
        raise ClerestoryError(
            f"the studio must have its extra ({missing.name} is missing): pip install 'clerestory[studio]'"
        ) from None
    if not (PAGE / "index.html").is_file():
        raise ClerestoryError(NO_PAGE)
    listener = _listener(settings)
    port = int(listener.getsockname()[1])
    url = settings.url(port)
    tell(f"clerestory studio: {url}\nfiles of {settings.folder}; Ctrl-C ends it", flush=True)
    if opens:
        opening = threading.Timer(0.5, webbrowser.open, (url,))
        opening.daemon = True
        opening.start()
    config = uvicorn.Config(
        make_app(settings),
        log_level="warning",
        access_log=False,
        server_header=False,
        ws="none",
        timeout_graceful_shutdown=2,
        timeout_keep_alive=30,
    )
    uvicorn.Server(config).run(sockets=[listener])


def _listener(settings: Settings) -> socket.socket:
    family = socket.AF_INET6 if ":" in settings.host else socket.AF_INET
    listener = socket.socket(family, socket.SOCK_STREAM)
    try:
        if hasattr(socket, "SO_EXCLUSIVEADDRUSE"):
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_EXCLUSIVEADDRUSE, 1)
        else:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((settings.host, settings.port))
        # whoever comes before the server is ready waits in line
        listener.listen(128)
    except OSError as error:
        listener.close()
        raise ClerestoryError(
            f"port {settings.port} of {settings.host} must be free, got: {error.strerror}; try --port 0"
        ) from None
    return listener
