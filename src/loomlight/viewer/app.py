"""The editor's server: its page, and what that cannot do by itself."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any
from urllib.parse import quote

import anyio
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from loomlight.core.errors import LoomlightError
from loomlight.fabric.fabric import Fabric
from loomlight.viewer.access import Access, Guard
from loomlight.viewer.answers import ANSWERS, answer
from loomlight.viewer.draft_reader import MAX_UPLOAD, DraftReader
from loomlight.viewer.picture import MAX_BYTES
from loomlight.viewer.picture_worker import PictureMaker
from loomlight.viewer.session import gallery_pictures, session
from loomlight.viewer.uploads import TooLargeResponse, UploadTooLargeError, read_body

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
    lanes = [anyio.CapacityLimiter(count) for count in _READERS]
    bakery = anyio.CapacityLimiter(1)
    maker = PictureMaker()

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        yield
        for reader in (each for idle in readers for each in idle):
            reader.close()
        maker.close()

    async def get_session(request: Request) -> Response:
        return JSONResponse(first, headers={"cache-control": "no-store"})

    async def read_draft(request: Request) -> Response:
        content = await read_body(request, MAX_UPLOAD)
        name, lane = request.query_params.get("name", "draft.wif"), int(len(content) > _LARGE_FILE)
        draft = await anyio.to_thread.run_sync(_read, readers[lane], content, name, limiter=lanes[lane])
        return Response(draft, media_type="application/json")

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

    return Starlette(
        routes=[
            Route("/api/session", _answered(get_session)),
            Route("/api/wif", _answered(read_draft), methods=["POST"]),
            Route("/api/picture", _answered(draw), methods=["POST"]),
            *(Route(f"/{place}", _answered(make), methods=["POST"]) for place in ANSWERS),
            Route("/api/{rest:path}", _answered(_unknown), methods=["GET", "POST"]),
            Mount("/gallery", StaticFiles(directory=gallery_pictures())),
            Mount("/", StaticFiles(directory=client, html=True)),
        ],
        middleware=[Middleware(Guard, access=access), Middleware(GZipMiddleware, minimum_size=2000)],
        exception_handlers={Exception: _defect},
        lifespan=lifespan,
    )


def _read(idle: list[DraftReader], content: bytes, name: str) -> bytes:
    """JSON of a draft, by one of the readers that have nothing to do."""
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
