"""What three.js draws of an export, in a Chromium without a card, by its own loaders."""

from __future__ import annotations

import base64
import io
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from studies.instruments.browser import chromium, launched, wait_until

_ROOT = Path(__file__).parents[2]
THREE = _ROOT / "web" / "node_modules" / "three"
_SOFTWARE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
# Three's environments are turned against ours by a quarter: -z is in the middle of ours.
_PAGE = """<!doctype html><meta charset="utf-8">
<script type="importmap">{"imports":
  {"three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/"}}</script>
<script type="module">
import * as THREE from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { USDLoader } from 'three/addons/loaders/USDLoader.js';
window.draw = async ({ file, eye, target, half, degrees, side, environment }) => {
  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(side, side);
  renderer.toneMapping = THREE.NoToneMapping;
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xd8d8d8);
  let object;
  if (file.endsWith('.glb')) object = (await new GLTFLoader().loadAsync(file)).scene;
  else if (file.endsWith('.js')) {
    const { clothMaterial } = await import(file);
    const material = await clothMaterial(THREE, { metresPerUv: 2 * half });
    object = new THREE.Mesh(new THREE.PlaneGeometry(2 * half, 2 * half), material);
  } else object = await new USDLoader().loadAsync(file);
  scene.add(object);
  if (environment) {
    scene.environment = await new EXRLoader().loadAsync('/environment.exr');
    scene.environmentRotation.y = -Math.PI / 2;
  } else {
    const ones = new Float32Array(4 * 8 * 4).fill(1);
    scene.environment = new THREE.DataTexture(ones, 8, 4, THREE.RGBAFormat, THREE.FloatType);
    scene.environment.needsUpdate = true;
  }
  scene.environment.mapping = THREE.EquirectangularReflectionMapping;
  const camera = half
    ? new THREE.OrthographicCamera(-half, half, half, -half, 0.01, 100)
    : new THREE.PerspectiveCamera(degrees, 1, 0.01, 100);
  camera.position.set(...eye);
  camera.lookAt(...target);
  const names = [];
  object.traverse((each) => {
    if (!each.isMesh) return;
    names.push(each.name);
    for (const value of Object.values(each.material)) if (value?.isTexture) value.anisotropy = 16;
  });
  renderer.render(scene, camera);
  const picture = renderer.domElement.toDataURL().split(',')[1];
  renderer.dispose();
  return { names, picture };
};
window.ready = true;
</script>"""


class _Files(SimpleHTTPRequestHandler):
    """A folder, three.js beside it, an environment, and the page."""

    extensions_map = SimpleHTTPRequestHandler.extensions_map | {".js": "text/javascript"}
    environment: Path | None = None

    def translate_path(self, path: str) -> str:
        """The file of an address."""
        if path.startswith("/three/"):
            return str(THREE / path.removeprefix("/three/").partition("?")[0])
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
        self.wfile.write(_PAGE.encode())

    def log_message(self, format: str, *arguments: object) -> None:
        """Says nothing of requests."""


class ThreePage:
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
    ) -> tuple[list[str], NDArray[np.uint8]]:
        """The names of its meshes, and a picture [side, side, 3], sRGB.

        Args:
            file: its path in the folder: a .glb, a .usdz, or a `material.js`, which is put on a square.
            eye, target: where the camera stands and looks, metres.
            half: of parallel rays, half the height of what is seen, metres, and of the square.
            degrees: else the field of view.
            side: pixels.
        """
        given = {
            "file": f"/{file}",
            "eye": [*eye],
            "target": [*target],
            "half": half,
            "degrees": degrees,
            "side": side,
            "environment": self._has_environment,
        }
        found = self._page.evaluate("(given) => window.draw(given)", given)
        picture = Image.open(io.BytesIO(base64.b64decode(found["picture"]))).convert("RGB")
        return found["names"], np.asarray(picture)


def missing() -> str:
    """What is not installed that the page needs; "" where all is there."""
    if chromium() is None:
        return "chromium is not installed"
    return "" if THREE.is_dir() else "the packages of web/ are not installed"


@contextmanager
def three_page(folder: Path, seconds: float, environment: Path | None = None) -> Iterator[ThreePage]:
    """The page, in a Chromium of its own.

    Args:
        folder: of the files that are drawn.
        seconds: to wait at most until it is there.
        environment: an .exr that lights what is drawn; white light from everywhere without.

    Raises:
        RuntimeError: Chromium is not installed.
    """
    from playwright.sync_api import sync_playwright

    handler = type("Files", (_Files,), {"environment": environment})
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(handler, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        with sync_playwright() as started, launched(started, _SOFTWARE) as browser:
            page = browser.new_page()
            page.goto(f"http://127.0.0.1:{server.server_address[1]}/")
            wait_until(page, "window.ready", seconds)
            yield ThreePage(page, environment is not None)
    finally:
        server.shutdown()
        server.server_close()
