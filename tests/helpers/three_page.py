"""What three.js draws of a file, in a Chromium without a card: by its own loaders, in white light."""

from __future__ import annotations

import base64
import io
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from studies.instruments.browser import chromium, launched, wait_until
from tests.limits import HANG

ROOT = Path(__file__).parents[2]
THREE = ROOT / "web" / "node_modules" / "three"
SIDE = 128
# Looks down z at what is in x and y from -half to half. Of a module there is a square of that size.
_PAGE = """<!doctype html><meta charset="utf-8">
<script type="importmap">{"imports":
  {"three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/"}}</script>
<script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { USDLoader } from 'three/addons/loaders/USDLoader.js';
window.draw = async (file, x, y, half, side) => {
  const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
  renderer.setSize(side, side);
  renderer.toneMapping = THREE.NoToneMapping;
  const scene = new THREE.Scene();
  let object;
  if (file.endsWith('.glb')) object = (await new GLTFLoader().loadAsync(file)).scene;
  else if (file.endsWith('.js')) {
    const { clothMaterial } = await import(file);
    const material = await clothMaterial(THREE, { metresPerUv: 2 * half });
    object = new THREE.Mesh(new THREE.PlaneGeometry(2 * half, 2 * half), material);
  } else object = await new USDLoader().loadAsync(file);
  scene.add(object);
  const ones = new Float32Array(4 * 8 * 4).fill(1);
  const white = new THREE.DataTexture(ones, 8, 4, THREE.RGBAFormat, THREE.FloatType);
  white.mapping = THREE.EquirectangularReflectionMapping;
  white.needsUpdate = true;
  scene.environment = white;
  const camera = new THREE.OrthographicCamera(-half, half, half, -half, 0.01, 10);
  camera.position.set(x, y, 5);
  camera.lookAt(x, y, 0);
  camera.updateProjectionMatrix();
  renderer.render(scene, camera);
  const names = [];
  object.traverse((each) => { if (each.isMesh) names.push(each.name); });
  return { names, picture: renderer.domElement.toDataURL().split(',')[1] };
};
window.ready = true;
</script>"""


class _Files(SimpleHTTPRequestHandler):
    """A folder, three.js beside it, and the page."""

    extensions_map = SimpleHTTPRequestHandler.extensions_map | {".js": "text/javascript"}

    def translate_path(self, path: str) -> str:
        if path.startswith("/three/"):
            return str(THREE / path.removeprefix("/three/").partition("?")[0])
        return super().translate_path(path)

    def do_GET(self) -> None:
        if self.path != "/":
            super().do_GET()
            return
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(_PAGE.encode())

    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing of requests."""


class ThreePage:
    """A page that draws files of a folder."""

    def __init__(self, page: Any) -> None:
        self._page = page

    def draw(
        self, file: str, at: tuple[float, float] = (0.0, 0.0), half: float = 0.05
    ) -> tuple[list[str], NDArray[np.float64]]:
        """The names of its meshes, and sRGB [128, 128, 3], 0 to 1, of a square seen against z.

        Args:
            file: its path in the folder: a .glb, a .usdz, or a `material.js`, which is put on the square.
            at: the middle of the square, metres.
            half: half its side, metres.
        """
        found = self._page.evaluate("(given) => window.draw(...given)", [f"/{file}", *at, half, SIDE])
        picture = Image.open(io.BytesIO(base64.b64decode(found["picture"]))).convert("RGB")
        return found["names"], np.asarray(picture) / 255


@contextmanager
def three_page(folder: Path) -> Iterator[ThreePage]:
    """The page, in a Chromium of its own; the test is skipped without Chromium, Playwright or three.js."""
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if chromium() is None or not THREE.is_dir():
        pytest.skip("chromium or the packages of web/ are not installed")
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Files, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        with (
            playwright.sync_playwright() as started,
            launched(started, ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")) as browser,
        ):
            page = browser.new_page()
            page.goto(f"http://127.0.0.1:{server.server_address[1]}/")
            wait_until(page, "window.ready", HANG)
            yield ThreePage(page)
    finally:
        server.shutdown()
        server.server_close()
