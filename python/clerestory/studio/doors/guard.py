"""Who may ask the studio, and how much a request may hold: checked before anything else."""

from __future__ import annotations

import hmac
import ipaddress
import socket
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs, urlencode, urlsplit

from starlette.datastructures import Headers
from starlette.responses import RedirectResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from clerestory.studio.answers import refused
from clerestory.studio.settings import LOOPBACK_NAMES, Settings

#: Paths that take whole files.
UPLOADS = ("/api/bsdf", "/api/result")
_COOKIE = "clerestory_token"
_HEADERS = {
    # the page loads nothing from elsewhere and no other page may frame it
    "content-security-policy": "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
    "connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'",
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "x-frame-options": "DENY",
}


class TooLargeError(Exception):
    """A body longer than its limit."""


class Guard:
    """Refuses a foreign Host or Origin, a missing token and a body that is too large; adds safe headers.

    A page of another site can make a browser send requests to this machine, under a name that resolves to 127.0.0.1 if
    it likes: the Host header then is that name, and the Origin that page.
    """

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self.app, self.settings = app, settings

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            if scope["type"] == "lifespan":
                await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        wrong = self._wrong(headers, scope)
        if wrong is not None:
            await refused(wrong[0], wrong[1])(scope, receive, send)
            return
        given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]
        if self.settings.token is not None:
            if scope["path"] == "/" and hmac.compare_digest(given.encode(), self.settings.token.encode()):
                await self._let_in(scope, receive, send)
                return
            if not self._has_token(headers):
                message = "a token is needed: open the address that the studio printed when it started"
                await refused(401, message)(scope, receive, send)
                return
        limit = self.settings.most_upload_bytes if scope["path"] in UPLOADS else self.settings.most_request_bytes
        length = headers.get("content-length", "0")
        if not length.isascii() or not length.isdigit() or int(length) > limit:
            await refused(413, f"a request must hold at most {limit} bytes, got {length[:24]}")(scope, receive, send)
            return
        taken, answered = 0, False

        async def counted() -> Message:
            nonlocal taken
            message = await receive()
            taken += len(message.get("body", b""))
            if taken > limit:
                raise TooLargeError
            return message

        async def dressed(message: Message) -> None:
            nonlocal answered
            if message["type"] == "http.response.start":
                answered = True
                own = [(name.encode(), value.encode()) for name, value in _HEADERS.items()]
                message = {**message, "headers": [*message["headers"], *own]}
            await send(message)

        try:
            await self.app(scope, counted, dressed)
        except TooLargeError:
            if not answered:
                await refused(413, f"a request must hold at most {limit} bytes, got more")(scope, receive, send)

    def _wrong(self, headers: Headers, scope: Scope) -> tuple[int, str] | None:
        hosts = headers.getlist("host")
        if len(hosts) != 1 or not self._is_own(_host_name(hosts[0])):
            return 403, "the Host of a request must be the studio's own"
        origin = headers.get("origin")
        if origin is not None:
            parts = urlsplit(origin)
            if parts.scheme not in ("http", "https") or parts.netloc.lower() != hosts[0].lower():
                return 403, "the Origin of a request must be the studio's own page"
        if headers.get("sec-fetch-site") in ("cross-site", "same-site") and scope["path"] != "/":
            return 403, "only the studio's own page may ask"
        return None

    def _is_own(self, name: str) -> bool:
        settings = self.settings
        if name in (settings.host.lower(), *LOOPBACK_NAMES):
            return True
        if not settings.is_everywhere:
            return False
        try:
            ipaddress.ip_address(name)
        except ValueError:
            return name == socket.gethostname().lower()
        return True

    def _has_token(self, headers: Headers) -> bool:
        scheme, _, given = headers.get("authorization", "").partition(" ")
        if scheme.lower() != "bearer":
            try:
                morsel = SimpleCookie(headers.get("cookie", "")).get(_COOKIE)
            except CookieError:
                morsel = None
            given = "" if morsel is None else morsel.value
        return hmac.compare_digest(given.encode(), str(self.settings.token).encode())

    async def _let_in(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Keeps the token in a cookie, out of the address and of the browser's history."""
        rest = parse_qs(scope["query_string"].decode("latin-1"))
        rest.pop("token", None)
        answer = RedirectResponse("/" + (f"?{urlencode(rest, doseq=True)}" if rest else ""), status_code=303)
        answer.set_cookie(_COOKIE, str(self.settings.token), httponly=True, samesite="strict", path="/")
        await answer(scope, receive, send)


def _host_name(host: str) -> str:
    """The name of a Host header, without its port."""
    try:
        return (urlsplit(f"//{host}").hostname or "").lower()
    except ValueError:
        return ""
