"""Who may ask: a token where the server is not on loopback, and no page of another site.

On loopback any process of the machine may ask, but not a web page that another site serves: its requests
carry that site's `Origin`, or, where its name was bound to this address, that name as `Host`.
"""

from __future__ import annotations

import hmac
import ipaddress
import secrets
from dataclasses import dataclass
from urllib.parse import urlsplit

from starlette.datastructures import URL
from starlette.requests import HTTPConnection
from starlette.responses import JSONResponse, PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

COOKIE = "loomlight-token"
HEADER = "x-loomlight-token"

# The page loads nothing from elsewhere; workers and pictures may come from memory.
SECURITY_HEADERS = {
    "content-security-policy": (
        "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
        "img-src 'self' data: blob:; connect-src 'self' data: blob:; worker-src 'self' blob:; "
        "frame-ancestors 'self'; base-uri 'self'; form-action 'none'"
    ),
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-resource-policy": "same-origin",
}


def is_loopback(host: str) -> bool:
    """Whether a host's name or address is of this machine alone."""
    if host.lower() == "localhost":
        return True
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False


@dataclass(frozen=True)
class Access:
    """Rules of access to a server.

    Attributes:
        loopback: it answers this machine alone, and requests must name it as such.
        token: that requests must carry, as a cookie, a header or `?token=`; None where none is needed.
    """

    loopback: bool
    token: str | None

    @classmethod
    def for_host(cls, host: str) -> Access:
        """Access of a server at `host`: a token of 256 bits unless it is a loopback address."""
        loopback = is_loopback(host)
        return cls(loopback, None if loopback else secrets.token_urlsafe(32))

    def refusal(self, connection: HTTPConnection) -> Response | None:
        """Error response to a request, or None if it is allowed."""
        host = connection.headers.get("host", "")
        origin = connection.headers.get("origin")
        try:
            named = urlsplit(f"//{host}").hostname or ""
        except ValueError:  # brackets around what is no address
            return _refused(400, f"The Host {host[:100]!r} of the request is no name or address.")
        try:
            foreign = origin is not None and urlsplit(origin).netloc != host
        except ValueError:
            said = (origin or "")[:100]
            return _refused(400, f"The Origin {said!r} of the request is no address of a page.")
        if self.loopback and not is_loopback(named):
            return _refused(403, f"This server answers this machine alone, not requests for {host[:100]!r}.")
        if foreign:
            return _refused(403, "This server answers its own page alone, not a page of another site.")
        if self.token is None:
            return None
        given = (
            connection.query_params.get("token"),
            connection.headers.get(HEADER),
            connection.cookies.get(COOKIE),
        )
        if any(hmac.compare_digest(each.encode(), self.token.encode()) for each in given if each):
            return None
        return _refused(401, "The token is missing or wrong: open the address that loomlight view printed.")


class Guard:
    """ASGI middleware: refuses what `Access` refuses, and adds headers that keep the page to itself."""

    def __init__(self, app: ASGIApp, access: Access) -> None:
        self._app = app
        self._access = access

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers one request."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        connection = HTTPConnection(scope)

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                message["headers"] = [
                    *message.get("headers", ()),
                    *((name.encode(), value.encode()) for name, value in SECURITY_HEADERS.items()),
                ]
            await send(message)

        response = self._access.refusal(connection) or self._without_token(connection)
        await (response or self._app)(scope, receive, send_with_headers)

    def _without_token(self, connection: HTTPConnection) -> Response | None:
        """For a page's address with the token: the same without it, which becomes a cookie."""
        if (
            self._access.token is None
            or "token" not in connection.query_params
            or connection.scope["method"] != "GET"
        ):
            return None
        place = URL(scope=connection.scope).remove_query_params("token")
        response = RedirectResponse(place.path + (f"?{place.query}" if place.query else ""), 303)
        response.set_cookie(COOKIE, self._access.token, httponly=True, samesite="strict")
        return response


def _refused(status: int, sentence: str) -> Response:
    if status == 401:
        return PlainTextResponse(sentence + "\n", status)
    return JSONResponse({"error": sentence}, status)
