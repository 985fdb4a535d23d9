"""The widget of `loomlight.view`: the editor's page in a frame, and Python in place of its server.

`widget.js` carries requests as messages: "ask" is their number, "place" one of the server's routes.
"""

from __future__ import annotations

import gzip
import json
import os
from functools import cache
from pathlib import Path
from typing import Any

import anywidget
import traitlets

from loomlight.core.errors import LoomlightError
from loomlight.fabric.fabric import Fabric
from loomlight.sources.load import fabric_of_path
from loomlight.viewer.answers import ANSWERS, answer
from loomlight.viewer.client import client_folder
from loomlight.viewer.limited_reader import DraftReader, MeshReader
from loomlight.viewer.messages import fabric_json, fabric_of_json
from loomlight.viewer.session import first_fabric, session


class ClothWidget(anywidget.AnyWidget):
    """The live editor; its `fabric` follows the page, and the page follows it.

    Attributes:
        fabric: what the page shows; observe it for edits, set it to show another. A path or a name is read.
        height: of the page, pixels.
    """

    _esm = (Path(__file__).parent / "widget.js").read_text(encoding="utf-8")
    fabric = traitlets.Any()
    height = traitlets.Int(620, min=200, max=5000).tag(sync=True)

    def __init__(self, fabric: Fabric | str | os.PathLike[str] | None = None, height: int = 620) -> None:
        self._from_view: str | None = None
        self._drafts, self._meshes = DraftReader(), MeshReader()
        _page()  # a page that cannot be built is told here
        super().__init__(fabric=first_fabric() if fabric is None else fabric, height=height)
        self.on_msg(lambda _, asked, buffers: self._answer(asked, buffers))

    @traitlets.validate("fabric")
    def _read(self, proposal: Any) -> Fabric:
        given = proposal["value"]
        return given if isinstance(given, Fabric) else fabric_of_path(given)

    @traitlets.observe("fabric")
    def _show(self, change: Any) -> None:
        """Sends the fabric to all views but the one that made it."""
        self.send({"fabric": fabric_json(self.fabric), "by": self._from_view})

    def _answer(self, asked: dict[str, Any], buffers: list[memoryview]) -> None:
        """Answers one request of a view; faults of what it sent are answered in a sentence."""
        body = bytes(buffers[0]) if buffers else b""
        try:
            status, content = 200, self._content(asked, body)
        except LoomlightError as error:
            status, content = 422, json.dumps({"error": str(error)}).encode()
        self.send({"view": asked["view"], "answer": asked["ask"], "status": status}, [content])

    def _content(self, asked: dict[str, Any], body: bytes) -> bytes:
        place, _, name = str(asked["place"]).partition("?name=")
        if place == "page":
            return _page()
        if place == "api/session":
            return json.dumps(_without_pictures(session(self.fabric, has_python=True))).encode()
        if place == "api/wif":
            return self._drafts.read(body, name)
        if place == "api/mesh":
            return self._meshes.read(body, name)
        if place == "api/fabric":
            self._from_view = str(asked["view"])
            try:
                self.fabric = fabric_of_json(json.loads(body))
            finally:
                self._from_view = None
            return b"{}"
        return answer(place, json.loads(body)).content if place in ANSWERS else b"null"


@cache
def _page() -> bytes:
    """The page as one file, compressed."""
    return gzip.compress((client_folder() / "widget.html").read_bytes())


def _without_pictures(first: dict[str, Any]) -> dict[str, Any]:
    """A session whose gallery is drawn by the page: a notebook serves no pictures."""
    return first | {"gallery": [entry | {"picture": None} for entry in first["gallery"]]}
