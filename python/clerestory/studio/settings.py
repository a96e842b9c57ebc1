"""Where the studio listens, what it may read, and how much it does for one page."""

from __future__ import annotations

import ipaddress
import secrets
from dataclasses import dataclass, field
from pathlib import Path

from clerestory.errors import ClerestoryError

LOOPBACK_NAMES = ("127.0.0.1", "localhost", "::1")


@dataclass(frozen=True, kw_only=True)
class Settings:
    """How one studio runs.

    Parameters
    ----------
    folder : path, default the present one
        The only folder whose files the page can open.
    host : str, default "127.0.0.1"
        Address to listen on. Anything but this machine itself needs a token, which is made if none is given.
    port : int, 0..65535, default 8765
        0 takes a free one.
    token : str, optional
        What every request must carry; of 8 characters or more.
    most_upload_bytes, most_request_bytes : int
        Of a file dropped on the page, and of any other request.
    most_jobs : int
        Long jobs that may wait or run at once.
    workers : int
        Processes that do long jobs.
    most_seconds : float
        After which a long job is stopped.

    Raises
    ------
    ClerestoryError
        If the folder is none, the port out of its range or the token too short.
    """

    folder: Path = field(default_factory=Path.cwd)
    host: str = "127.0.0.1"
    port: int = 8765
    token: str | None = None
    most_upload_bytes: int = 64 * 2**20
    most_request_bytes: int = 2**20
    most_jobs: int = 32
    workers: int = 2
    most_seconds: float = 900.0

    def __post_init__(self) -> None:
        folder = Path(self.folder).expanduser().resolve()
        if not folder.is_dir():
            raise ClerestoryError(f"folder must be a folder that exists, got {str(self.folder)!r}; make it first")
        object.__setattr__(self, "folder", folder)
        if not 0 <= self.port <= 65535:
            raise ClerestoryError(f"port must lie in 0..65535, got {self.port}; 0 takes a free one")
        if self.token is not None and (len(self.token) < 8 or not self.token.isascii() or not self.token.isprintable()):
            raise ClerestoryError("token must have 8 plain characters or more; leave it out to have one made")
        if self.token is None and not self.is_local:
            object.__setattr__(self, "token", secrets.token_urlsafe(24))

    @property
    def is_local(self) -> bool:
        """Whether only programs of this machine can reach the studio."""
        if self.host in LOOPBACK_NAMES:
            return True
        try:
            return ipaddress.ip_address(self.host).is_loopback
        except ValueError:
            return False

    @property
    def is_everywhere(self) -> bool:
        """Whether it listens on every address of the machine."""
        return self.host in ("0.0.0.0", "::", "")

    def url(self, port: int | None = None) -> str:
        """Address of the page, with its token."""
        host = "127.0.0.1" if self.is_everywhere else self.host
        shown = f"[{host}]" if ":" in host else host
        return f"http://{shown}:{port or self.port}/" + (f"?token={self.token}" if self.token else "")
