"""The editor's server: its page, and what that cannot do by itself."""

from __future__ import annotations

import asyncio
import hmac
import ipaddress
import json
import secrets
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlsplit

import anyio
from starlette.applications import Starlette
from starlette.datastructures import URL
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import ClientDisconnect, HTTPConnection, Request
from starlette.responses import JSONResponse, PlainTextResponse, RedirectResponse, Response, StreamingResponse
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from loomlight.core.errors import LoomlightError
from loomlight.fabric.fabric import Fabric
from loomlight.viewer.answers import ANSWERS, answer
from loomlight.viewer.limited_reader import MAX_MESH, MAX_UPLOAD, DraftReader, MeshReader
from loomlight.viewer.photo_capture import MAX_PHOTO, capture_lines, width_and_light
from loomlight.viewer.picture import MAX_BYTES
from loomlight.viewer.picture_worker import PictureMaker
from loomlight.viewer.session import gallery_pictures, session

# The largest draft with a loom plan and colours of every thread, as JSON.
_MAX_FABRIC = 64 << 20
# 64 shafts, half of them lifted, at each of 16384 picks are half of these.
_MAX_VALUES = 1_000_000
# Larger files are read by a process of their own: small ones take hundredths of a second, and need not wait.
_LARGE_FILE = 128 << 10
# Processes for small and for large files.
_READERS = (2, 1)

Endpoint = Callable[[Request], Awaitable[Response]]


def editor_app(client: Path, fabric: Fabric | str | None, access: Access) -> Starlette:
    """The application, for any ASGI server.

    Args:
        client: the folder of the built page.
        fabric: what the page shows first; see `session`.

    Raises:
        InputError: no such fabric.
    """
    first = session(fabric, has_python=True, token=access.token)
    readers = [[DraftReader() for _ in range(count)] for count in _READERS]
    tailor, tailors = [MeshReader()], anyio.CapacityLimiter(1)
    lanes = [anyio.CapacityLimiter(count) for count in _READERS]
    bakery = anyio.CapacityLimiter(1)
    maker = PictureMaker()

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        yield
        for drafts in (each for idle in readers for each in idle):
            drafts.close()
        for meshes in tailor:
            meshes.close()
        maker.close()

    async def get_session(request: Request) -> Response:
        return JSONResponse(first, headers={"cache-control": "no-store"})

    async def read_draft(request: Request) -> Response:
        content = await read_body(request, MAX_UPLOAD)
        name, lane = request.query_params.get("name", "draft.wif"), int(len(content) > _LARGE_FILE)
        draft = await anyio.to_thread.run_sync(_read, readers[lane], content, name, limiter=lanes[lane])
        return Response(draft, media_type="application/json")

    async def read_mesh(request: Request) -> Response:
        content = await read_body(request, MAX_MESH)
        name = request.query_params.get("name", "mesh.obj")
        mesh = await anyio.to_thread.run_sync(_read, tailor, content, name, limiter=tailors)
        return Response(mesh, media_type="application/octet-stream")

    async def make(request: Request) -> Response:
        asked = await _json_object(request)
        made = await anyio.to_thread.run_sync(answer, request.url.path.strip("/"), asked, limiter=bakery)
        disposition = f"attachment; filename*=UTF-8''{quote(made.name or '')}"
        headers = {} if made.name is None else {"content-disposition": disposition}
        return Response(made.content, media_type=made.media_type, headers=headers)

    async def draw(request: Request) -> Response:
        content = await read_body(request, MAX_BYTES)

        async def watch() -> None:
            while (await request.receive())["type"] != "http.disconnect":
                pass
            maker.stop(request)  # nobody waits for the picture

        watching = asyncio.create_task(watch())
        try:
            png = await anyio.to_thread.run_sync(maker.picture, content, request)
        finally:
            watching.cancel()
        return Response(png, media_type="image/png", headers={"content-encoding": "identity"})

    async def read_photo(request: Request) -> Response:
        asked = request.query_params
        width_mm, light = width_and_light(asked.get("width_mm", ""), asked.get("light", "flash"))
        content = await read_body(request, MAX_PHOTO)
        lines = capture_lines(content, asked.get("name", "photo.jpg"), width_mm, light)
        # Compressed, lines would wait for each other.
        return StreamingResponse(
            lines, media_type="application/x-ndjson", headers={"content-encoding": "identity"}
        )

    return Starlette(
        routes=[
            Route("/api/session", _answered(get_session)),
            Route("/api/wif", _answered(read_draft), methods=["POST"]),
            Route("/api/mesh", _answered(read_mesh), methods=["POST"]),
            Route("/api/picture", _answered(draw), methods=["POST"]),
            Route("/api/capture", _answered(read_photo), methods=["POST"]),
            *(Route(f"/{place}", _answered(make), methods=["POST"]) for place in ANSWERS),
            Route("/api/{rest:path}", _answered(_unknown), methods=["GET", "POST"]),
            Mount("/gallery", StaticFiles(directory=gallery_pictures())),
            Mount("/", StaticFiles(directory=client, html=True)),
        ],
        middleware=[Middleware(Guard, access=access), Middleware(GZipMiddleware, minimum_size=2000)],
        exception_handlers={Exception: _defect},
        lifespan=lifespan,
    )


def _read(idle: list[Any], content: bytes, name: str) -> bytes:
    """The answer of one of the readers that have nothing to do."""
    reader = idle.pop()
    try:
        return reader.read(content, name)
    finally:
        idle.append(reader)


async def _unknown(request: Request) -> Response:
    raise HTTPException(404, f"There is no {request.url.path[:200]} here.")


def _answered(endpoint: Endpoint) -> Endpoint:
    """An endpoint whose faults are answered in one sentence: `{"error": …}`."""

    async def answer(request: Request) -> Response:
        try:
            return await endpoint(request)
        except LoomlightError as error:
            return JSONResponse({"error": str(error)}, 422)
        except HTTPException as error:
            return JSONResponse({"error": error.detail}, error.status_code, error.headers)
        except UploadTooLargeError as error:
            return TooLargeResponse(error)
        except ClientDisconnect:  # nobody is there to read an answer
            return Response(status_code=499)

    return answer


async def _defect(request: Request, error: Exception) -> Response:
    return JSONResponse(
        {"error": f"The server failed ({type(error).__name__}); this is a defect of loomlight."}, 500
    )


async def _json_object(request: Request) -> dict[str, Any]:
    body = await read_body(request, _MAX_FABRIC)
    # Counted first: the parser holds the interpreter, so nobody is answered meanwhile, in a thread neither.
    if body.count(b",") > _MAX_VALUES:
        raise HTTPException(413, f"The request holds more than the {_MAX_VALUES:,} values that a fabric may.")
    try:
        values = json.loads(body)
    except (ValueError, RecursionError) as error:
        raise HTTPException(400, f"The request is no JSON: {error}.") from error
    if not isinstance(values, dict):
        raise HTTPException(400, "The request is JSON, but no object.")
    return values


# ------------------------------------------------------------------------------------------------ who may ask
# Who may ask: a token where the server is not on loopback, and no page of another site.
#
# On loopback any process of the machine may ask, but not a web page that another site serves: its requests
# carry that site's `Origin`, or, where its name was bound to this address, that name as `Host`.


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


# ----------------------------------------------------------------------------------------- bodies of requests
# Bodies of requests, read up to a limit: what is longer is refused before it is read.


# How long the rest of a refused upload is thrown away: a connection that is closed while the other side still
# sends loses the answer on its way.
_DRAIN_SECONDS = 10.0
# How long a body may take: 64 MiB at some 4 Mbit/s.
BODY_SECONDS = 120.0


class UploadTooLargeError(Exception):
    """A body is longer than its limit; the message is one sentence.

    Attributes:
        has_more: whether the rest of the body is still on its way.
    """

    def __init__(self, sentence: str, has_more: bool) -> None:
        super().__init__(sentence)
        self.has_more = has_more


async def read_body(request: Request, limit: int, seconds: float = BODY_SECONDS) -> bytes:
    """The body of a request; never more than `limit` bytes, and a part of it, are kept.

    Raises:
        UploadTooLargeError: its length is announced as more, or it turns out to be more.
        ClientDisconnect: the connection was cut.
        HTTPException: it did not come whole within `seconds`.
    """
    try:
        async with asyncio.timeout(seconds):
            return await _read_body(request, limit)
    except TimeoutError as error:
        sentence = f"The upload did not arrive within {seconds:g} s."
        raise HTTPException(408, sentence, {"connection": "close"}) from error


async def _read_body(request: Request, limit: int) -> bytes:
    announced = request.headers.get("content-length", "")
    if announced.isdecimal() and int(announced) > limit:
        raise UploadTooLargeError(_sentence(f" of {int(announced) / 2**20:.0f} MiB", limit), True)
    body = bytearray()
    has_more = True
    while has_more:
        message = await request.receive()
        if message["type"] != "http.request":
            raise ClientDisconnect
        has_more = message.get("more_body", False)
        body += message.get("body", b"")
        if len(body) > limit:
            raise UploadTooLargeError(_sentence("", limit), has_more)
    return bytes(body)


def _sentence(size: str, limit: int) -> str:
    return f"The upload{size} is larger than the {limit >> 20} MiB that the server takes."


class TooLargeResponse(JSONResponse):
    """The answer to an upload that is too large: sent at once, before the rest of it is thrown away."""

    def __init__(self, error: UploadTooLargeError) -> None:
        # Compression would hold the answer back until the end.
        headers = {"connection": "close", "content-encoding": "identity"}
        super().__init__({"error": str(error)}, 413, headers)
        self._has_more = error.has_more

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers, then reads on for a while."""
        await send({"type": "http.response.start", "status": self.status_code, "headers": self.raw_headers})
        await send({"type": "http.response.body", "body": self.body, "more_body": True})
        if self._has_more:
            await _drain(receive)
        await send({"type": "http.response.body", "body": b"", "more_body": False})


async def _drain(receive: Receive) -> None:
    try:
        async with asyncio.timeout(_DRAIN_SECONDS):
            while (message := await receive())["type"] == "http.request" and message.get("more_body", False):
                pass
    except TimeoutError:
        pass
