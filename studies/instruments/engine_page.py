"""What engines draw of an export, in a Chromium without a card, by their own loaders.

three.js is of `web/`, the others of `engine_pages/package.json`: `npm install` in that folder.
"""

from __future__ import annotations

import base64
import io
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from studies.instruments.browser import chromium, launched, wait_until

_ROOT = Path(__file__).parents[2]
_PAGES = Path(__file__).parent / "engine_pages"
THREE = _ROOT / "web" / "node_modules" / "three"
_SOFTWARE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
# By name, the page that draws with an engine, and the package that it needs.
ENGINES = {
    "three.js": ("three.html", THREE),
    "Babylon.js": ("babylon.html", _PAGES / "node_modules" / "babylonjs-loaders"),
    "Filament": ("filament.html", _PAGES / "node_modules" / "filament"),
    "PlayCanvas": ("playcanvas.html", _PAGES / "node_modules" / "playcanvas"),
}


@dataclass(frozen=True)
class Light:
    """What lights a page: an even sky, and parallel rays.

    Attributes:
        sky: radiance from everywhere.
        sun: irradiance across the rays.
        to_sun: where they come from.
    """

    sky: float = 1.0
    sun: float = 0.0
    to_sun: tuple[float, float, float] = (0.0, 0.0, 1.0)


class _Files(SimpleHTTPRequestHandler):
    """A folder, the engines beside it, an environment, and the page of one."""

    extensions_map = SimpleHTTPRequestHandler.extensions_map | {
        ".js": "text/javascript",
        ".wasm": "application/wasm",
    }
    environment: Path | None = None
    page = ""

    def translate_path(self, path: str) -> str:
        """The file of an address."""
        if path.startswith("/three/"):
            return str(THREE / path.removeprefix("/three/").partition("?")[0])
        if path.startswith("/engines/"):
            return str(_PAGES / "node_modules" / path.removeprefix("/engines/").partition("?")[0])
        if path == "/environment.exr" and self.environment is not None:
            return str(self.environment)
        return super().translate_path(path)

    def do_GET(self) -> None:
        """Answers with the page or a file."""
        if self.path != "/":
            super().do_GET()
            return
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write((_PAGES / self.page).read_bytes())

    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing of requests."""


class EnginePage:
    """A page that draws files of a folder."""

    def __init__(self, page: Any, has_environment: bool) -> None:
        self._page, self._has_environment = page, has_environment

    def draw(
        self,
        file: str,
        eye: Sequence[float] = (0.0, 0.0, 5.0),
        target: Sequence[float] = (0.0, 0.0, 0.0),
        *,
        half: float = 0.0,
        degrees: float = 0.0,
        side: int = 128,
        light: Light = Light(),
    ) -> tuple[list[str], NDArray[np.uint8]]:
        """The names of its meshes, and a picture [side, side, 3], sRGB.

        Args:
            file: its path in the folder: a .glb; for three.js also a .usdz, or a `material.js`, which is put
                on a square.
            eye, target: where the camera stands and looks, metres.
            half: of parallel rays, in three.js alone, half the height of what is seen, metres, and of the
                square.
            degrees: else the field of view.
            side: pixels.
            light: without an environment.
        """
        given = {
            "file": f"/{file}",
            "eye": [*eye],
            "target": [*target],
            "half": half,
            "degrees": degrees,
            "side": side,
            "environment": self._has_environment,
            "sky": light.sky,
            "sun": light.sun,
            "toSun": [*light.to_sun],
        }
        found = self._page.evaluate("(given) => window.draw(given)", given)
        picture = Image.open(io.BytesIO(base64.b64decode(found["picture"]))).convert("RGB")
        return found["names"], np.asarray(picture)


def missing(engine: str = "three.js") -> str:
    """What is not installed that the page of an engine needs; "" where all is there."""
    if chromium() is None:
        return "chromium is not installed"
    if ENGINES[engine][1].is_dir():
        return ""
    folder = _ROOT / "web" if engine == "three.js" else _PAGES
    return f"npm install was not done in {folder.relative_to(_ROOT)}"


@contextmanager
def engine_page(
    folder: Path, seconds: float, environment: Path | None = None, engine: str = "three.js"
) -> Iterator[EnginePage]:
    """The page of an engine, in a Chromium of its own.

    Args:
        folder: of the files that are drawn.
        seconds: to wait at most until it is there.
        environment: an .exr that lights what three.js draws; without, light is as `draw` is told.
        engine: a name of `ENGINES`.

    Raises:
        RuntimeError: Chromium is not installed.
    """
    from playwright.sync_api import sync_playwright

    handler = type("Files", (_Files,), {"environment": environment, "page": ENGINES[engine][0]})
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(handler, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        with sync_playwright() as started, launched(started, _SOFTWARE) as browser:
            page = browser.new_page()
            page.goto(f"http://127.0.0.1:{server.server_address[1]}/")
            wait_until(page, "window.ready", seconds)
            yield EnginePage(page, environment is not None)
    finally:
        server.shutdown()
        server.server_close()
