"""Bodies of requests, read up to a limit: what is longer is refused before it is read."""

from __future__ import annotations

import asyncio

from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse
from starlette.types import Receive, Scope, Send

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
